#pragma once
/// What was observed in the field, as figures that simulations have too.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/calibrate/release_outcome.hpp"

namespace clast {

/// A figure of a sample of releases.
struct Figure {
  enum class Kind {
    kMeanPlace,   ///< of the stops along the path, m
    kStdPlace,    ///< their standard deviation, m
    kPlace,       ///< the place along the path that the share `level` of the stops lies before, m
    kBeyond,      ///< share of the stops beyond the place `level`
    kMeanAside,   ///< of the stops to the right of the path, m
    kPassed,      ///< share of the releases that pass the barrier
    kMeanSpeed,   ///< of those that pass, m/s
    kMeanSpin,    ///< rad/s
    kMeanHeight,  ///< of the centre above ground, m
    kMeanEnergy,  ///< J
    kMeanDepth,   ///< of the scars, m
  };
  Kind kind = Kind::kMeanPlace;
  double level = 0.0;
  std::string name;  ///< "mean_place_m", "p90_place_m", "beyond_40_m", "mean_speed_m_s"
  double observed = 0.0;
  /// Standard error of the observed value, where it is stated; none: that of a sample of the
  /// observation's size.
  std::optional<double> error;
  /// Standard error of measuring the value of a sample, on top of the scatter of such samples.
  double measuring_error = 0.0;
};

/// A stop in the field, along the path and to the right of it, m.
struct StopPosition {
  double along = 0.0;
  double aside = 0.0;
};

/// Stops, passages of a barrier, or what blocks of one site did at a moment: after an impact, or so
/// long after their release.
struct Observation {
  std::string name;
  std::size_t site = 0;         ///< into CalibrationStudy::sites
  bool fitted = true;           ///< else it is kept, to judge the prediction by
  std::string shape;            ///< of these blocks only; empty: any
  std::string block;            ///< ... with this id
  std::string barrier;          ///< empty: stops, or a moment
  std::filesystem::path table;  ///< of stops or trajectories, as it was read; empty: none
  std::string sha256;           ///< of the table
  /// Each stop has a start of its own in the table: places are counted from there, of simulated
  /// stops from theirs; else all from the middle of the release points.
  bool from_own_start = false;
  std::size_t releases = 0;  ///< in the field; 0 where only values with errors are known
  /// Numbers of field releases that share a start; empty: each has one of its own.
  std::vector<std::size_t> clusters;
  std::vector<Figure> figures;
  std::optional<Moment> moment = {};
  std::string release = {};  ///< of blocks of this release set only; empty: any
};

/// The moments of a site that are observed, each once, rising.
std::vector<Moment> observed_moments(const std::vector<Observation>& observations,
                                     std::size_t site);

/// A release as an observation sees it: stops by their place, the rest by what was measured.
struct Seen {
  std::uint32_t point = 0;  ///< releases of one share its ground
  double along = 0.0, aside = 0.0;
  OutcomeAtMoment at;  ///< the barrier or moment
};

/// The releases of a member that the observation is of.
/// @throws InputError  the site has no such block, shape, release set or barrier, or
///                     its members were simulated without the moment
std::vector<Seen> select_outcomes(const Observation& observation, const SiteDescription& site,
                          std::span<const ReleaseOutcome> outcomes);

/// Makes sure that a member has releases enough of the observed blocks to know their scatter by.
/// @throws InputError  fewer than `kFewestSeen`; the observation and how many
void check_enough(const Observation& observation, std::span<const Seen> seen);
inline constexpr std::size_t kFewestSeen = 8;

/// Where a stop lies for the observation.
StopPosition stop_position_of(const Observation& observation, const SiteDescription& site, const Vec2& start,
                      const Vec2& stop);

/// Of a sample that is given by places in `seen`, as often as they stand there; not a number where
/// it has none: a mean speed of no passage, a spread of one stop.
double compute_statistic(const Figure& figure, std::span<const Seen> seen,
                 std::span<const std::size_t> sample);

/// Of a field sample of stops.
double compute_statistic(const Figure& figure, std::span<const StopPosition> stops);

}  // namespace clast
