#pragma once
/// The comparison as one self-contained HTML page: no script or picture from elsewhere.
#include <string>

#include "study/comparison.hpp"

namespace clast {

std::string html_report(const Comparison& comparison);

}  // namespace clast
