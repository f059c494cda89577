#pragma once
/// The size of a scan: where it came from, and whether a rock block can have it.
#include <array>
#include <string>

#include "pipeline/scan_to_block.hpp"

namespace clast::pipeline_detail {

/// Refuses a size that no rock block has (over 20 m or under 1 mm), which is a wrong unit most of
/// the time. `box` is in metres.
/// @throws InputError  naming the unit that is probably meant
void check_scan_size(const Bounds& box, const std::string& id, const ScanToBlockOptions& options);

/// Refuses a mass over 10,000 t, which is a wrong unit or density most of the time.
/// @throws InputError  with the block's id
void check_block_mass(const Block& block, const ScanToBlockOptions& options);

/// How a scan got its size, as "key=value" for the record.
std::string format_scale_record(const ScanToBlockOptions& options);

/// Adds a note where a point that gave the scale lies far from all that was read.
void note_distant_scale_points(FieldScan& found, const std::array<Vec3, 2>& points);

}  // namespace clast::pipeline_detail
