#pragma once
/// Calibration of unknown campaign parameters from field observations. A member is one simulated
/// set of values of the unknown parameters.
#include <filesystem>
#include <vector>

#include "core/progress.hpp"
#include "study/calibrate/posterior_file.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

struct CalibrationOptions {
  unsigned threads = 0;  ///< number of threads; 0: one per core; does not affect the result
  /// True if the members that an earlier calibration simulated are reused. Only its observations
  /// may differ from those of this calibration.
  bool resume = false;
  /// True if an existing posterior file is replaced; otherwise, it is an error.
  bool replace = false;
  /// Subset of the members to simulate; by default, all. A file with a subset has no posterior.
  /// `parts` joins such files.
  Shard shard = {};
  /// Posterior files of all shards, whose members are joined. If not empty, no member is simulated.
  std::vector<std::filesystem::path> parts = {};
  /// Processes that share the simulation of the members; null for a single process.
  ProcessTeam* team = nullptr;
  /// Function called after each member of each site. If it throws, the calibration ends and
  /// simulated members are kept.
  ProgressCallback progress = {};
};

/// Result of a calibration: study, simulated members and posterior.
struct Calibration {
  CalibrationStudy study;
  StoredCalibration stored;
  CalibrationPosterior posterior;
  std::filesystem::path file;
};

/// Returns the path of the journal of simulated members: target + ".part".
std::filesystem::path calibration_journal_path(const std::filesystem::path& target);

/// Runs a calibration: simulates the members and infers the unknown parameters. In a team of
/// processes, only the leader calls this function.
/// @throws InputError  if the target cannot be written or replaced, if reused or joined members
///                     were simulated with other sites, unknowns, numbers of members or releases,
///                     inputs or program, if a member is missing, or if inputs are inconsistent
/// @throws SimulationError  if a member's runs fail
Calibration run_calibration(const CalibrationStudy& study, const std::filesystem::path& target,
                            const CalibrationOptions& options = {});

/// Simulates members that the leader of the team sends. Called by all other processes of the team.
/// @throws Error  if a member fails in this process or in another one
void simulate_members_for_leader(const CalibrationStudy& study, const CalibrationOptions& options);

/// Simulator that a calibration calls for each member, with its sites and input files.
struct CalibrationBackend {
  std::vector<SiteDescription> sites;
  std::vector<std::string> inputs;  ///< input files, each as "path sha256"
  MemberSimulator simulate;
  std::string physics_digest = {};  ///< digest of the simulated physics; empty if unknown
};
/// Runs a calibration whose members are simulated by `simulator`.
Calibration run_calibration_with(const CalibrationBackend& simulator, const CalibrationStudy& study,
                                 const std::filesystem::path& target,
                                 const CalibrationOptions& options = {});

}  // namespace clast
