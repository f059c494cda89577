#pragma once
/// Field observations, reduced to summary statistics that are also computed for simulations.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/calibrate/release_outcome.hpp"

namespace clast {

/// Summary statistic of a sample of releases.
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
  /// Standard error of the observed value as stated in the study. If empty, it is estimated for a
  /// sample of the observation's size.
  std::optional<double> error;
  /// Standard error of the measurement, added to the scatter due to sampling.
  double measurement_error = 0.0;
};

/// Stop position relative to the start, m: along the downslope path and to the right of it.
struct StopPosition {
  double along = 0.0;
  double lateral = 0.0;
};

/// Observation at one site. Its statistics describe stops, barrier passages, or states of blocks at
/// a moment (after an impact, or at a time after release).
struct Observation {
  std::string name;
  std::size_t site = 0;         ///< index into CalibrationStudy::sites
  bool fitted = true;           ///< true: used for the calibration; false: held out for validation
  std::string shape;            ///< only blocks of this shape; empty for all
  std::string block;            ///< only the block with this id; empty for all
  std::string barrier;          ///< name of the barrier; empty for stops and moments
  std::filesystem::path table;  ///< table of stops or trajectories; empty if there is none
  std::string sha256;           ///< digest of the table
  /// True if the table gives a start for each stop. Positions are then measured from these starts;
  /// otherwise, from the mean of the release points.
  bool measured_from_own_start = false;
  std::size_t releases =
      0;  ///< number of field releases; 0 if only values with stated errors are known
  /// Number of field releases from each start position. Empty if all start positions differ.
  std::vector<std::size_t> clusters;
  std::vector<SummaryStatistic> statistics;
  std::optional<ObservedMoment> moment = {};
  std::string release = {};  ///< only blocks of this release set; empty for all
};

/// Returns the observed moments of a site, unique and ascending.
std::vector<ObservedMoment> observed_moments(const std::vector<Observation>& observations,
                                             std::size_t site);

/// Outcome of a release for an observation: stop position, or state at the barrier or moment.
struct SelectedOutcome {
  std::uint32_t point = 0;  ///< release point; releases of one point share its ground
  double along = 0.0, lateral = 0.0;
  OutcomeAtMoment at;  ///< state at the barrier or moment
};

/// Selects the releases of a member that belong to an observation.
/// @throws InputError  if the site has no such block, shape, release set or barrier, or its members
///                     were simulated without the moment
std::vector<SelectedOutcome> select_outcomes(const Observation& observation,
                                             const SiteDescription& site,
                                             std::span<const ReleaseOutcome> outcomes);

/// Checks that a member has enough releases of the observed blocks to estimate their scatter.
/// @throws InputError  if there are fewer than `kMinSelectedOutcomes`; names observation and number
void check_outcome_count(const Observation& observation, std::span<const SelectedOutcome> seen);
/// Minimum number of selected releases per member, for `check_outcome_count`.
inline constexpr std::size_t kMinSelectedOutcomes = 8;

/// Stop position relative to the origin that an observation uses (see `measured_from_own_start`).
StopPosition stop_position_of(const Observation& observation, const SiteDescription& site,
                              const Vec2& start, const Vec2& stop);

/// Computes a statistic of a sample. NaN if undefined, such as the mean speed if no block passed.
/// @param sample  indices into `seen`; may contain repetitions
double compute_statistic(const SummaryStatistic& statistic, std::span<const SelectedOutcome> seen,
                         std::span<const std::size_t> sample);

double compute_statistic(const SummaryStatistic& statistic, std::span<const StopPosition> stops);

}  // namespace clast
