#pragma once
/// Calibrations and studies as JSON.
#include <nlohmann/json.hpp>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Returns results, unknown parameters, statistics and checks of a calibration as JSON.
nlohmann::ordered_json calibration_json(const Calibration& calibration);

/// Returns design, sites, unknown parameters and observed statistics of a calibration study as
/// JSON.
nlohmann::ordered_json study_json(const CalibrationStudy& study);

}  // namespace clast
