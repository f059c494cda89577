#pragma once
/// Checks of the scale of a scan, and record of its origin.
#include <array>
#include <string>

#include "pipeline/scan_to_block.hpp"

namespace clast::pipeline_detail {

/// Checks the size of a scan. Sizes over 20 m or under 1 mm are mostly due to wrong units.
/// @param box  bounding box, m
/// @throws InputError  if the size is implausible; names the probable unit
void check_scan_size(const Bounds& box, const std::string& id, const ScanToBlockOptions& options);

/// Checks the mass of a block. Masses over 10,000 t are mostly due to wrong units or densities.
/// @throws InputError  if the mass is implausible; names the block
void check_block_mass(const Block& block, const ScanToBlockOptions& options);

/// Formats the origin of the scale as "key=value" for `BlockSource::options`.
std::string format_scale_record(const ScanToBlockOptions& options);

/// Adds a note if one of the points that define the scale is far from the scan.
void note_distant_scale_points(FieldScan& found, const std::array<Vec3, 2>& points);

}  // namespace clast::pipeline_detail
