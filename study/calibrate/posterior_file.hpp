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
  std::vector<std::string> inputs;  ///< "path sha256" of all files that were read
  /// Digest of the simulation inputs: sites, unknowns, design, program version; not observations.
  std::string design_sha256;
  /// Physics digest of the program. Empty if an older program simulated some of the members.
  std::string physics_digest = {};
  std::vector<std::vector<bool>> done;  ///< by site, then member: true if simulated
  CalibrationRuns runs;
};

/// Writes the members, and the posterior if it is not null.
/// @throws InputError  if the file cannot be written (see `OutputFile`)
void write_posterior(const std::filesystem::path& target, const CalibrationStudy& study,
                     const StoredCalibration& stored, const CalibrationPosterior* posterior,
                     const OverwritePolicy& rules);

/// Reads the members of a finished or interrupted calibration.
/// @throws InputError  if the file is missing, not a posterior file, damaged, or of a newer schema
StoredCalibration read_calibration_runs(const std::filesystem::path& file);

}  // namespace clast
