#pragma once
/// Runs a calibration: simulates the members of its design, and infers the unknowns.
#include <filesystem>

#include "core/progress.hpp"
#include "study/calibration/posterior_file.hpp"

namespace clast {

struct CalibrateOptions {
  unsigned threads = 0;  ///< 0: one per core; changes no bit of the result
  /// Takes over members that an interrupted calibration of the same design left beside the target,
  /// or a finished one in it, which may have had other observations; without any it begins.
  bool resume = false;
  bool replace = false;  ///< a posterior in the target is replaced; else it is kept
  /// Called after each member of each site. What it throws ends the calibration; members until then
  /// are kept.
  Progress progress = {};
};

/// A finished calibration.
struct Calibration {
  CalibrationStudy study;
  StoredCalibration stored;
  CalibrationPosterior posterior;
  std::filesystem::path file;
};

/// Members that are simulated, until all are: target + ".part".
std::filesystem::path partial_calibration(const std::filesystem::path& target);

/// @throws InputError       the target can't be written or holds what is kept; what is resumed is
///                          of another design; inputs that do not fit
/// @throws SimulationError  a member whose runs fail
Calibration calibrate(const CalibrationStudy& study, const std::filesystem::path& target,
                      const CalibrateOptions& options = {});

/// What a calibration simulates with.
struct CalibrationSimulator {
  std::vector<SiteFacts> sites;
  std::vector<std::string> inputs;  ///< "path sha256"
  MemberSimulator simulate;
};
/// The same with any simulator.
Calibration calibrate_with(const CalibrationSimulator& simulator, const CalibrationStudy& study,
                           const std::filesystem::path& target,
                           const CalibrateOptions& options = {});

}  // namespace clast
