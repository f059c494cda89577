#pragma once
/// Observed stops, surveyed in the field, against simulated ones.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/contrast.hpp"
#include "core/types.hpp"

namespace clast {

struct Comparison;

/// A block found in the field.
struct MeasuredStop {
  Vec2 place = Vec2::Zero();  ///< map, m
  std::optional<Vec2> start;  ///< where it was released; none: the mean of all release points
  std::string block;          ///< empty when not known
  std::string shape;          ///< compact or elongated, or empty
  double runout = 0.0;        ///< m, along downslope
  double lateral = 0.0;       ///< rad
};

/// The values that a quarter, a half and three quarters of a sample lie below.
struct Quartiles {
  double low = 0.0;
  double median = 0.0;
  double high = 0.0;
};

/// Shares of a sample of stops that lie before a runout, with 95 % intervals of each; without them
/// where all stops are of one realisation.
struct StopCurve {
  std::vector<double> runout;  ///< m, rising
  std::vector<double> share, low, high;
};

/// Measured stops of a group against the simulated deposits of the same group.
struct MeasuredGroup {
  std::size_t group = 0;  ///< into Comparison::groups
  std::size_t measured = 0;
  std::size_t simulated = 0;      ///< runs of the group that came to rest
  Summary runout, lateral;        ///< measured, m and rad
  Quartiles quartiles;            ///< of the measured runouts, m
  double simulated_runout = 0.0;  ///< mean, m
  Quartiles simulated_quartiles;
  /// Measured less simulated median, m. The test is that of the distance of the distributions,
  /// corrected for all groups; there is none where the runs are of one realisation.
  Contrast medians;
  double cliffs_delta = 0.0;  ///< measured against simulated runout
  double ks_distance = 0.0;
  std::optional<Interval> ks_interval;  ///< 95 %, of the distance; none of one realisation
  StopCurve curve, simulated_curve;
};

/// Fewer stops of a group say too little.
inline constexpr std::size_t kFewestMeasured = 5;

/// How field and simulation go together: more than chance where the interval of the medians
/// excludes zero, whatever the test says.
Verdict judge_agreement(const MeasuredGroup& group);

struct MeasuredStops {
  std::filesystem::path file;
  std::string sha256;
  std::vector<MeasuredStop> stops;
  std::vector<MeasuredGroup> groups;  ///< all, then blocks and shapes that the table names
};

/// Reads a table with columns x and y (m, map, z up), and optionally start_x and start_y, block and
/// shape. Names may end in a unit: x_m.
/// @throws InputError  no such file, no such columns, a place that is no number, no row
MeasuredStops read_measured_stops(const std::filesystem::path& file);

/// Runouts along the comparison's downslope direction, and the groups.
void compare_stops(const Comparison& comparison, MeasuredStops& measured);

}  // namespace clast
