#pragma once
/// A calibration, and what it is asked, as JSON.
#include <nlohmann/json.hpp>

#include "study/calibrate/calibrate.hpp"

namespace clast {

/// Answer, findings, unknowns, figures and checks, as docs/formats.md lists them.
nlohmann::ordered_json calibration_json(const Calibration& calibration);

/// Design, sites, unknowns and observed figures.
nlohmann::ordered_json study_json(const CalibrationStudy& study);

}  // namespace clast
