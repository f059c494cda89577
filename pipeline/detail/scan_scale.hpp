#pragma once
/// Scale of a scan: origin and plausibility.
#include <array>
#include <string>

#include "pipeline/scan_to_block.hpp"

namespace clast::pipeline_detail {

/// Checks the size of a scan; sizes over 20 m or under 1 mm are mostly wrong units. `box` is in
/// metres.
/// @throws InputError  naming the probable unit
void check_scan_size(const Bounds& box, const std::string& id, const ScanToBlockOptions& options);

/// Checks the mass of a block; masses over 10,000 t are mostly wrong units or densities.
/// @throws InputError  with the block's id
void check_block_mass(const Block& block, const ScanToBlockOptions& options);

/// Formats the origin of the scale as "key=value" for the record.
std::string format_scale_record(const ScanToBlockOptions& options);

/// Adds a note if a point used for the scale is far from the scan.
void note_distant_scale_points(FieldScan& found, const std::array<Vec3, 2>& points);

}  // namespace clast::pipeline_detail
