#pragma once
/// The HDF5 file of a calibration. Schema: docs/formats.md.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/posterior.hpp"
#include "study/campaign/posterior_draws.hpp"

namespace clast {

/// What is stored of a calibration, finished or interrupted.
struct StoredCalibration {
  std::vector<std::string> inputs;  ///< "path sha256" of all files that were read
  /// What decides the simulations: sites, unknowns, design and program version, not observations.
  std::string design_sha256;
  /// Of the program that simulated the members; empty: some are of an older one.
  std::string physics_digest = {};
  std::vector<std::vector<bool>> done;  ///< of each site, each member: is it simulated?
  CalibrationRuns runs;
};

/// Writes runs and, where there is one, the posterior.
/// @throws InputError  as `OutputFile`
void write_posterior(const std::filesystem::path& target, const CalibrationStudy& study,
                     const StoredCalibration& stored, const CalibrationPosterior* posterior,
                     const OverwritePolicy& rules);

/// The simulations that a file holds, finished or not.
/// @throws InputError  missing, no posterior, damaged, or of a newer schema
StoredCalibration read_calibration_runs(const std::filesystem::path& file);

}  // namespace clast
