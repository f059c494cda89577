#pragma once
/// Runs a calibration: simulates the members of its design, and infers the unknowns.
#include <filesystem>
#include <vector>

#include "core/progress.hpp"
#include "study/calibrate/posterior_file.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

struct CalibrateOptions {
  unsigned threads = 0;  ///< 0: one per core; changes no bit of the result
  /// Takes over members that an interrupted calibration of the same design left beside the target,
  /// or a finished one in it, which may have had other observations; without any it begins.
  bool resume = false;
  bool replace = false;  ///< a posterior in the target is replaced; else it is kept
  /// The members of one of several alone are simulated: nothing is inferred, and the file holds no
  /// posterior. Given back as `parts`, the files of all shards are joined.
  Shard shard = {};
  /// Files of shards: their members are taken over, and none is simulated.
  std::vector<std::filesystem::path> parts = {};
  /// The members are shared among its processes, each of which calls; none: this one alone.
  ProcessTeam* team = nullptr;
  /// Called after each member of each site. What it throws ends the calibration; members until then
  /// are kept.
  ProgressCallback progress = {};
};

/// A finished calibration.
struct Calibration {
  CalibrationStudy study;
  StoredCalibration stored;
  CalibrationPosterior posterior;
  std::filesystem::path file;
};

/// Members that are simulated, until all are: target + ".part".
std::filesystem::path calibration_journal_path(const std::filesystem::path& target);

/// Of several processes the one that leads.
/// @throws InputError       the target can't be written or holds what is kept; what is resumed or
///                          joined is of another design; a member is in no part; inputs that do not
///                          fit
/// @throws SimulationError  a member whose runs fail
Calibration calibrate(const CalibrationStudy& study, const std::filesystem::path& target,
                      const CalibrateOptions& options = {});

/// What the other processes of `options.team` do meanwhile.
/// @throws Error  of their own, or that of another process
void serve_calibration(const CalibrationStudy& study, const CalibrateOptions& options);

/// What a calibration simulates with.
struct CalibrationBackend {
  std::vector<SiteDescription> sites;
  std::vector<std::string> inputs;  ///< "path sha256"
  MemberSimulator simulate;
  std::string physics_digest = {};  ///< of what it simulates with
};
/// The same with any simulator.
Calibration calibrate_with(const CalibrationBackend& simulator, const CalibrationStudy& study,
                           const std::filesystem::path& target,
                           const CalibrateOptions& options = {});

}  // namespace clast
