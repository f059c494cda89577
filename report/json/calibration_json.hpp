#pragma once
/// Calibrations and studies as JSON.
#include <nlohmann/json.hpp>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Returns main result, findings, unknowns, statistics and checks of a calibration.
nlohmann::ordered_json calibration_json(const Calibration& calibration);

/// Returns design, sites, unknowns and observed statistics of a study.
nlohmann::ordered_json study_json(const CalibrationStudy& study);

}  // namespace clast
