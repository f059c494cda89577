#pragma once
/// Calibration: simulates the members of the design and infers the unknowns from observations. A
/// member is one set of values of the unknowns.
#include <filesystem>
#include <vector>

#include "core/progress.hpp"
#include "study/calibrate/posterior_file.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

struct CalibrationOptions {
  unsigned threads = 0;  ///< number of threads; 0: one per core; does not affect the result
  /// If true, members of an interrupted or finished calibration of the same design are reused. Its
  /// observations may differ. If there are none, the calibration starts from the beginning.
  bool resume = false;
  bool replace = false;  ///< if true, an existing posterior in the target is replaced; otherwise,
                         ///< it is an error
  /// Only the members of this shard are simulated. The unknowns are not inferred, so the file has
  /// no posterior. Use `parts` to join the files of all shards.
  Shard shard = {};
  /// Files of shards whose members are joined. If not empty, no member is simulated.
  std::vector<std::filesystem::path> parts = {};
  /// Processes that share the simulation of the members; each of them calls the functions below. If
  /// null, this process runs alone.
  ProcessTeam* team = nullptr;
  /// Called after each member of each site. An exception ends the calibration; members are kept.
  ProgressCallback progress = {};
};

/// Study, members and posterior of a calibration.
struct Calibration {
  CalibrationStudy study;
  StoredCalibration stored;
  CalibrationPosterior posterior;
  std::filesystem::path file;
};

/// Returns the path of the journal of simulated members: target + ".part".
std::filesystem::path calibration_journal_path(const std::filesystem::path& target);

/// Runs a calibration. If `options.team` is set, only its leader calls this function.
/// @throws InputError  if the target cannot be written or must be kept, if resumed or joined
///                     members have another design, if a member is in none of the parts, or if
///                     inputs are inconsistent
/// @throws SimulationError  if a member's runs fail
Calibration run_calibration(const CalibrationStudy& study, const std::filesystem::path& target,
                            const CalibrationOptions& options = {});

/// Simulates members for the leader of `options.team`. Called by all other processes of the team.
/// @throws Error  if a member fails in this process or in another one
void simulate_members_for_leader(const CalibrationStudy& study, const CalibrationOptions& options);

/// Simulator of a calibration with its sites and inputs.
struct CalibrationBackend {
  std::vector<SiteDescription> sites;
  std::vector<std::string> inputs;  ///< "path sha256"
  MemberSimulator simulate;
  std::string physics_digest = {};  ///< digest of all that determines the results of the simulator
};
/// Runs a calibration with any simulator; see `calibrate`.
Calibration run_calibration_with(const CalibrationBackend& simulator, const CalibrationStudy& study,
                                 const std::filesystem::path& target,
                                 const CalibrationOptions& options = {});

}  // namespace clast
