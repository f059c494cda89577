#pragma once
/// Calibration: simulation of the design's members and inference of the unknowns.
#include <filesystem>
#include <vector>

#include "core/progress.hpp"
#include "study/calibrate/posterior_file.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

struct CalibrateOptions {
  unsigned threads = 0;  ///< 0: one per core; does not affect the result
  /// If true, members of an interrupted or finished calibration of the same design are reused; the
  /// observations may differ. Without any, the calibration starts from the beginning.
  bool resume = false;
  bool replace =
      false;  ///< an existing posterior in the target is replaced; otherwise it is an error
  /// Only the members of this shard are simulated; nothing is inferred, and the file has no
  /// posterior. `parts` joins the files of all shards.
  Shard shard = {};
  /// Files of shards whose members are joined; no member is simulated.
  std::vector<std::filesystem::path> parts = {};
  /// Processes that share the members, all of which call; null: this process alone.
  ProcessTeam* team = nullptr;
  /// Called after each member of each site. Its exceptions end the calibration; finished members
  /// are kept.
  ProgressCallback progress = {};
};

/// Study, members and posterior of a finished calibration.
struct Calibration {
  CalibrationStudy study;
  StoredCalibration stored;
  CalibrationPosterior posterior;
  std::filesystem::path file;
};

/// Returns the path of the journal of simulated members: target + ".part".
std::filesystem::path calibration_journal_path(const std::filesystem::path& target);

/// Runs a calibration; in a team, on the leader.
/// @throws InputError  if the target cannot be written or must be kept; resumed or joined members
///                     have another design; a member is in no part; or inputs are inconsistent
/// @throws SimulationError  if a member's runs fail
Calibration calibrate(const CalibrationStudy& study, const std::filesystem::path& target,
                      const CalibrateOptions& options = {});

/// Simulates members for the leader; for the other processes of `options.team`.
/// @throws Error  of this process or of another one
void serve_calibration(const CalibrationStudy& study, const CalibrateOptions& options);

/// Simulator of a calibration with its sites and inputs.
struct CalibrationBackend {
  std::vector<SiteDescription> sites;
  std::vector<std::string> inputs;  ///< "path sha256"
  MemberSimulator simulate;
  std::string physics_digest = {};  ///< of the simulator
};
/// Runs a calibration with any simulator; see `calibrate`.
Calibration calibrate_with(const CalibrationBackend& simulator, const CalibrationStudy& study,
                           const std::filesystem::path& target,
                           const CalibrateOptions& options = {});

}  // namespace clast
