#pragma once
/// A calibration and the page beside its posterior.
#include <filesystem>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// NAME.html of the posterior NAME.h5.
/// @throws InputError  the posterior has that name itself
std::filesystem::path calibration_page_file(const std::filesystem::path& target);

/// @throws InputError  posterior or page can't be written, or are there and kept
void check_calibration_output(const std::filesystem::path& target, const CalibrateOptions& options);

/// `calibrate`, then the page. What can't be written is refused before anything runs.
/// @throws InputError  as both
Calibration calibrate_and_report(const CalibrationStudy& study, const std::filesystem::path& target,
                                const CalibrateOptions& options);

}  // namespace clast
