#pragma once
/// The comparison as one self-contained HTML page: no script or picture from elsewhere.
#include <string>

#include "study/profiles.hpp"

namespace clast::report_detail {

/// @param bins  `profiles` of the comparison
std::string comparison_page(const Comparison& comparison, const std::vector<ProfileBin>& bins);

}  // namespace clast::report_detail
