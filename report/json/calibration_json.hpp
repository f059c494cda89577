#pragma once
/// A calibration as JSON.
#include <nlohmann/json.hpp>

#include "study/calibration/calibrate.hpp"

namespace clast {

/// Answer, findings, unknowns, figures and checks, as docs/formats.md lists them.
nlohmann::ordered_json calibration_json(const Calibration& calibration);

}  // namespace clast
