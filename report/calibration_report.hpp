#pragma once
/// Calibration that writes a report page beside its posterior file.
#include <filesystem>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Returns the path of the report page of a calibration: NAME.html for the posterior file NAME.h5.
/// @throws InputError  if the posterior file has that name itself
std::filesystem::path calibration_page_file(const std::filesystem::path& target);

/// Checks that posterior file and report page can be written.
/// @throws InputError  if they cannot be written, or if they exist and must be kept
void check_calibration_output(const std::filesystem::path& target,
                              const CalibrationOptions& options);

/// Runs a calibration and writes its report page.
/// @throws InputError  if `run_calibration` or `check_calibration_output` throws
Calibration calibrate_and_report(const CalibrationStudy& study, const std::filesystem::path& target,
                                 const CalibrationOptions& options);

}  // namespace clast
