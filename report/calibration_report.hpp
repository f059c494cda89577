#pragma once
/// Calibration with a page beside its posterior file.
#include <filesystem>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Returns NAME.html for the posterior NAME.h5.
/// @throws InputError  if the posterior has that name itself
std::filesystem::path calibration_page_file(const std::filesystem::path& target);

/// Checks that posterior and page can be written.
/// @throws InputError  if they cannot, or exist and must be kept
void check_calibration_output(const std::filesystem::path& target, const CalibrateOptions& options);

/// Runs `calibrate` and writes the page. Output paths are checked before the runs.
/// @throws InputError  as `calibrate` and `check_calibration_output`
Calibration calibrate_and_report(const CalibrationStudy& study, const std::filesystem::path& target,
                                 const CalibrateOptions& options);

}  // namespace clast
