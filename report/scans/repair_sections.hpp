#pragma once
/// Sections of a block's page about repairs.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "report/scans/scan_pictures.hpp"

namespace clast::report_detail {

/// Formats the section on the repair of a scan: tables of defects and holes.
/// @param cloud  true if the surface was fitted to a point cloud
/// @param open_side  true if the scan had an unobserved side that was filled
/// @param unit  displayed unit of lengths
std::string format_repair_section(const RepairReport& report, bool cloud = false,
                                  bool open_side = false, const std::string& unit = "m");

/// Finds the labelled positions of repaired defects ("1", "2", ...) and of the largest holes ("H1",
/// ...).
std::vector<PositionMark> find_repair_marks(const RepairReport& report);

/// Formats the section on the unobserved underside of a scan, with bounds of its volume.
std::string format_underside_section(const Underside& side, const std::string& unit = "m");

}  // namespace clast::report_detail
