#pragma once
/// Calibration that writes a page beside its posterior file.
#include <filesystem>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Returns the path of the page: NAME.html for the posterior NAME.h5.
/// @throws InputError  if the posterior has this name itself
std::filesystem::path calibration_page_file(const std::filesystem::path& target);

/// Checks that posterior and page can be written.
/// @throws InputError  if they cannot be written, or if they exist and must be kept
void check_calibration_output(const std::filesystem::path& target,
                              const CalibrationOptions& options);

/// Runs `calibrate` and writes the page. The output paths are checked before.
/// @throws InputError  if `calibrate` or `check_calibration_output` throws
Calibration calibrate_and_report(const CalibrationStudy& study, const std::filesystem::path& target,
                                 const CalibrationOptions& options);

}  // namespace clast
