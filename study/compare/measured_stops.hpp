#pragma once
/// Comparison of observed and simulated stop positions.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/contrast.hpp"
#include "core/types.hpp"

namespace clast {

struct Comparison;

/// Stop position of a block observed in the field.
struct MeasuredStop {
  Vec2 position = Vec2::Zero();  ///< map coordinates, m
  std::optional<Vec2>
      start;             ///< release position; if empty, the mean of all release points is used
  std::string block;     ///< block id; empty if unknown
  std::string shape;     ///< "compact", "elongated" or empty
  double runout = 0.0;   ///< runout along the downslope direction, m
  double lateral = 0.0;  ///< lateral angle, rad
};

struct Quartiles {
  double low = 0.0;
  double median = 0.0;
  double high = 0.0;
};

/// Empirical distribution of runouts with pointwise 95 % confidence intervals.
struct RunoutDistributionCurve {
  std::vector<double> runout;  ///< runouts, ascending, m
  std::vector<double> fraction, low,
      high;  ///< fraction of stops with at most this runout, and limits of its interval
};

/// Observed stops of a group, compared with the simulated deposits of the same group.
struct MeasuredStopGroup {
  std::size_t group = 0;      ///< index into Comparison::groups
  std::size_t measured = 0;   ///< number of observed stops
  std::size_t simulated = 0;  ///< number of simulated runs at rest
  SampleSummary runout,
      lateral;          ///< statistics of the observed stops: runout, m, and lateral angle, rad
  Quartiles quartiles;  ///< quartiles of the observed runouts, m
  double simulated_runout = 0.0;  ///< mean of the simulated runouts, m
  Quartiles simulated_quartiles;
  /// Difference of the median runouts, observed minus simulated, m, with the p-value of a
  /// Kolmogorov-Smirnov test.
  Contrast medians;
  double cliffs_delta = 0.0;  ///< Cliff's delta of the observed against the simulated runouts
  double ks_distance = 0.0;
  std::optional<Interval>
      ks_interval;  ///< 95 % interval of `ks_distance`; empty for a single realisation
  RunoutDistributionCurve curve, simulated_curve;
};

/// Minimum number of observed stops for which a group is compared.
inline constexpr std::size_t kMinMeasuredStops = 5;

/// Returns the verdict on the agreement of observed and simulated runouts. They differ
/// significantly if the interval of the difference of the medians excludes zero.
ContrastVerdict judge_stop_agreement(const MeasuredStopGroup& group);

/// Observed stops of a file and their comparison by group.
struct MeasuredStops {
  std::filesystem::path file;
  std::string sha256;
  std::vector<MeasuredStop> stops;
  /// Comparisons by group: all stops, then blocks and shapes named in the table.
  std::vector<MeasuredStopGroup> groups;
};

/// Reads a table of observed stops with columns x and y (map coordinates, m), and optionally
/// start_x and start_y, block and shape.
/// @throws InputError  if the file or a column is missing, a coordinate is not a number, or there
///                     is no row
MeasuredStops read_measured_stops(const std::filesystem::path& file);

/// Computes the runouts of the observed stops and compares them with the simulated stops, by group.
void compare_measured_stops(const Comparison& comparison, MeasuredStops& measured);

}  // namespace clast
