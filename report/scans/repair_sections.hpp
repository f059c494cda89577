#pragma once
/// What was repaired on a scan, as sections of its page.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "report/scans/scan_pictures.hpp"

namespace clast::report_detail {

/// Tables of the defects and of the holes, with counts, sizes and places.
/// @param cloud      the scan was points, and the report is of the surface fitted to them
/// @param open_side  the scan had a side that nobody saw, which was filled in
/// @param unit       of lengths, as it is written
std::string format_repair_section(const RepairReport& report, bool cloud = false, bool open_side = false,
                           const std::string& unit = "m");

/// The numbers of those tables where they have a place: "1", "2" ... for defects, "H1" ... for the
/// largest holes.
std::vector<PositionMark> find_repair_marks(const RepairReport& report);

/// Bounds of an underside that nobody saw.
std::string format_underside_section(const Underside& side, const std::string& unit = "m");

}  // namespace clast::report_detail
