#pragma once
/// Field observations and the summary statistics that describe them.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/calibrate/release_outcome.hpp"

namespace clast {

/// Summary statistic of a sample of releases, observed or simulated.
struct SummaryStatistic {
  enum class Kind {
    kMeanStopPosition,     ///< mean stop position along the path, m
    kStopDeviation,        ///< standard deviation of the stop positions, m
    kStopQuantile,         ///< quantile `level` of the stop positions along the path, m
    kFractionBeyond,       ///< fraction of stops beyond the position `level` along the path
    kMeanLateralPosition,  ///< mean lateral stop position, positive to the right of the path, m
    kPassedFraction,       ///< fraction of releases that pass the barrier
    kMeanSpeed,            ///< mean speed of the blocks at the barrier or moment, m/s
    kMeanAngularSpeed,     ///< mean angular speed, rad/s
    kMeanHeight,           ///< mean height of the centre above the ground, m
    kMeanEnergy,           ///< mean kinetic energy, J
    kMeanScarDepth,        ///< mean depth of the impact scars, m
  };
  Kind kind = Kind::kMeanStopPosition;
  double level = 0.0;
  std::string name;  ///< "mean_place_m", "p90_place_m", "beyond_40_m", "mean_speed_m_s"
  double observed = 0.0;
  /// Standard error of the observed value. If empty, it is estimated from the number of field
  /// releases.
  std::optional<double> error;
  /// Standard error of the measurement, in addition to the sampling error.
  double measurement_error = 0.0;
};

/// Stop position of a block relative to its start, m: distance along the downslope path, and
/// lateral distance to its right.
struct StopPosition {
  double along = 0.0;
  double lateral = 0.0;
};

/// Field observation at one site: statistics of stop positions, of barrier passages, or of the
/// motion after an impact or a time.
struct Observation {
  std::string name;
  std::size_t site = 0;  ///< index into CalibrationStudy::sites
  bool fitted = true;    ///< true if used for the calibration; false if held out for validation
  std::string shape;     ///< shape of the observed blocks; empty for all shapes
  std::string block;     ///< id of the observed block; empty for all blocks
  std::string barrier;   ///< name of the barrier; empty for other observations
  std::filesystem::path table;  ///< table of stops or trajectories; empty if there is none
  std::string sha256;           ///< digest of the table
  /// True if positions are measured from the start given in each table row; false if they are
  /// measured from the mean of the release points.
  bool measured_from_own_start = false;
  std::size_t releases = 0;  ///< number of field releases; 0 if unknown
  /// Number of field releases from each start position; empty if all start positions differ.
  std::vector<std::size_t> clusters;
  std::vector<SummaryStatistic> statistics;
  std::optional<ObservedMoment> moment = {};
  std::string release = {};  ///< name of the release set; empty for all
};

/// Returns the impacts and times at which states are observed at a site, unique and ascending.
std::vector<ObservedMoment> observed_moments(const std::vector<Observation>& observations,
                                             std::size_t site);

/// Outcome of one simulated release that an observation uses: stop position, or state at a barrier,
/// impact or time.
struct SelectedOutcome {
  std::uint32_t point = 0;  ///< index of the release point
  double along = 0.0, lateral = 0.0;
  OutcomeAtMoment at;  ///< state at the barrier, impact or time
};

/// Selects the simulated releases of a member that an observation describes.
/// @throws InputError  if the site has no such block, shape, release set or barrier, or if states
///                     at that impact or time were not recorded
std::vector<SelectedOutcome> select_outcomes(const Observation& observation,
                                             const SiteDescription& site,
                                             std::span<const ReleaseOutcome> outcomes);

/// Checks that a member has enough releases of the observed blocks to estimate the scatter of their
/// statistics.
/// @throws InputError  if there are fewer than `kMinSelectedOutcomes` releases; names the
///                     observation
void check_outcome_count(const Observation& observation, std::span<const SelectedOutcome> seen);
/// Minimum number of releases of the observed blocks per member.
inline constexpr std::size_t kMinSelectedOutcomes = 8;

/// Returns a stop position relative to the start from which an observation measures.
StopPosition stop_position_of(const Observation& observation, const SiteDescription& site,
                              const Vec2& start, const Vec2& stop);

/// Computes a summary statistic of a sample of releases. NaN if undefined, such as the mean speed
/// if no block passed.
/// @param sample  indices into `seen`; may contain repetitions
double compute_statistic(const SummaryStatistic& statistic, std::span<const SelectedOutcome> seen,
                         std::span<const std::size_t> sample);

double compute_statistic(const SummaryStatistic& statistic, std::span<const StopPosition> stops);

}  // namespace clast
