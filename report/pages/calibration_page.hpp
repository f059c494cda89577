#pragma once
/// Report of a calibration as one self-contained HTML page.
#include <string>

#include "study/calibrate/calibrate.hpp"

namespace clast {

std::string make_calibration_page(const Calibration& calibration);

}  // namespace clast
