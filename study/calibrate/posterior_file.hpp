#pragma once
/// Posterior file of a calibration (HDF5). Schema: docs/formats.md.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/posterior.hpp"
#include "study/campaign/posterior_draws.hpp"

namespace clast {

/// Stored members of a finished or interrupted calibration.
struct StoredCalibration {
  std::vector<std::string> inputs;  ///< input files, each as "path sha256"
  /// Digest of all inputs of the simulation: sites, unknown parameters, design and program version.
  std::string design_sha256;
  /// Digest of the simulated physics (`physics_digest`); empty if unknown.
  std::string physics_digest = {};
  std::vector<std::vector<bool>> done;  ///< for each site, then member: true if it was simulated
  CalibrationRuns runs;
};

/// Writes a posterior file with the simulated members, and with the posterior if it is not null.
/// @throws InputError  if the file cannot be written (see `OutputFile`)
void write_posterior(const std::filesystem::path& target, const CalibrationStudy& study,
                     const StoredCalibration& stored, const CalibrationPosterior* posterior,
                     const OverwritePolicy& rules);

/// Reads the simulated members of a finished or interrupted calibration.
/// @throws InputError  if the file is missing, not a posterior file, damaged, or of a newer schema
StoredCalibration read_calibration_runs(const std::filesystem::path& file);

}  // namespace clast
