#pragma once
/// Calibrations and studies as JSON.
#include <nlohmann/json.hpp>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Returns answer, findings, unknowns, statistics and checks (docs/formats.md).
nlohmann::ordered_json calibration_json(const Calibration& calibration);

/// Returns design, sites, unknowns and observed statistics.
nlohmann::ordered_json study_json(const CalibrationStudy& study);

}  // namespace clast
