#pragma once
/// The comparison as one self-contained HTML page: no script or picture from elsewhere.
#include <string>

#include "study/compare/map_rasters.hpp"
#include "study/compare/profiles.hpp"
#include "study/compare/realisation_deposits.hpp"

namespace clast::report_detail {

/// @param bins      `profiles` of the comparison
/// @param paths     `path_rasters` of it
/// @param deposits  `realisation_deposits` of it
std::string comparison_page(const Comparison& comparison, const std::vector<ProfileBin>& bins,
                            const MapRasters& paths, const RealisationDeposits& deposits);

}  // namespace clast::report_detail
