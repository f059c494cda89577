#pragma once
/// Sections of a block's page about repairs.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "report/scans/scan_pictures.hpp"

namespace clast::report_detail {

/// Formats tables of defects and holes with counts, sizes and positions.
/// @param cloud  the report is about the surface fitted to a point cloud
/// @param open_side  the scan had an unobserved side that was filled
/// @param unit  of lengths, as displayed
std::string format_repair_section(const RepairReport& report, bool cloud = false,
                                  bool open_side = false, const std::string& unit = "m");

/// Returns the numbered positions of those tables: "1", "2" ... for defects, "H1" ... for the
/// largest holes.
std::vector<PositionMark> find_repair_marks(const RepairReport& report);

/// Formats the bounds of an unobserved underside.
std::string format_underside_section(const Underside& side, const std::string& unit = "m");

}  // namespace clast::report_detail
