#pragma once
/// Sections of a block's page about repairs.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "report/scans/scan_pictures.hpp"

namespace clast::report_detail {

/// Formats tables of defects and holes with counts, sizes and positions.
/// @param cloud  true if the surface was fitted to a point cloud
/// @param open_side  true if the scan had an unobserved side that was filled
/// @param unit  displayed unit of lengths
std::string format_repair_section(const RepairReport& report, bool cloud = false,
                                  bool open_side = false, const std::string& unit = "m");

/// Returns the numbered positions in the tables of `format_repair_section`: "1", "2", ... for
/// defects, and "H1", ... for the largest holes.
std::vector<PositionMark> find_repair_marks(const RepairReport& report);

/// Formats the bounds of an unobserved underside.
std::string format_underside_section(const Underside& side, const std::string& unit = "m");

}  // namespace clast::report_detail
