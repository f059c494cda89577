#pragma once
/// Field observations as summary statistics that simulations provide, too.
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
    kMeanPlace,   ///< mean stop position along the path, m
    kStdPlace,    ///< standard deviation of the stop positions, m
    kPlace,       ///< quantile `level` of the stop positions along the path, m
    kBeyond,      ///< fraction of stops beyond position `level`
    kMeanAside,   ///< mean lateral stop position, positive to the right of the path, m
    kPassed,      ///< fraction of releases that pass the barrier
    kMeanSpeed,   ///< mean over passing blocks, m/s
    kMeanSpin,    ///< rad/s
    kMeanHeight,  ///< height of the centre above the ground, m
    kMeanEnergy,  ///< J
    kMeanDepth,   ///< depth of the impact scars, m
  };
  Kind kind = Kind::kMeanPlace;
  double level = 0.0;
  std::string name;  ///< "mean_place_m", "p90_place_m", "beyond_40_m", "mean_speed_m_s"
  double observed = 0.0;
  /// Stated standard error of the observed value; empty: that of a sample of the observation's
  /// size.
  std::optional<double> error;
  /// Standard error of the measurement, in addition to the sampling scatter.
  double measuring_error = 0.0;
};

/// Stop position along the path and lateral to it (positive to the right), m.
struct StopPosition {
  double along = 0.0;
  double aside = 0.0;
};

/// Observation: stops, barrier passages, or states of blocks at a moment (after an impact, or at a
/// time after release) of one site.
struct Observation {
  std::string name;
  std::size_t site = 0;         ///< index into CalibrationStudy::sites
  bool fitted = true;           ///< false: held out to validate the prediction
  std::string shape;            ///< only blocks of this shape; empty: any
  std::string block;            ///< only blocks with this id; empty: any
  std::string barrier;          ///< empty for stops and moments
  std::filesystem::path table;  ///< table of stops or trajectories; empty if there is none
  std::string sha256;           ///< of the table
  /// True if each stop has its own start in the table: positions are measured from the starts;
  /// otherwise from the mean of the release points.
  bool from_own_start = false;
  std::size_t releases = 0;  ///< number of field releases; 0 if only values with errors are known
  /// Indices of the shared starts of field releases; empty: all starts differ.
  std::vector<std::size_t> clusters;
  std::vector<SummaryStatistic> figures;
  std::optional<Moment> moment = {};
  std::string release = {};  ///< only blocks of this release set; empty: any
};

/// Returns the observed moments of a site, unique and ascending.
std::vector<Moment> observed_moments(const std::vector<Observation>& observations,
                                     std::size_t site);

/// Outcome of a release as an observation uses it: its stop position, or its state at the barrier
/// or moment.
struct SelectedOutcome {
  std::uint32_t point = 0;  ///< release point; releases of one point share its ground
  double along = 0.0, aside = 0.0;
  OutcomeAtMoment at;  ///< state at the barrier or moment
};

/// Selects the releases of a member that belong to an observation.
/// @throws InputError  if the site has no such block, shape, release set or barrier, or its members
///                     were simulated without the moment
std::vector<SelectedOutcome> select_outcomes(const Observation& observation,
                                             const SiteDescription& site,
                                             std::span<const ReleaseOutcome> outcomes);

/// Checks that a member has enough releases of the observed blocks to estimate their scatter.
/// @throws InputError  if there are fewer than `kMinSelectedOutcomes`; names the observation and
/// the number
void check_enough(const Observation& observation, std::span<const SelectedOutcome> seen);
/// Minimum number of selected releases per member.
inline constexpr std::size_t kMinSelectedOutcomes = 8;

/// Computes the stop position that an observation uses.
StopPosition stop_position_of(const Observation& observation, const SiteDescription& site,
                              const Vec2& start, const Vec2& stop);

/// Computes a statistic of a sample, given by indices into `seen` with repetitions; NaN if
/// undefined, such as the mean speed of no passage or the deviation of one stop.
double compute_statistic(const SummaryStatistic& figure, std::span<const SelectedOutcome> seen,
                         std::span<const std::size_t> sample);

double compute_statistic(const SummaryStatistic& figure, std::span<const StopPosition> stops);

}  // namespace clast
