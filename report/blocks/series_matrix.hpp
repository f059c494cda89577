#pragma once
/// Tables of thumbnails for series of varied blocks.
#include <span>
#include <string>

#include "library/block.hpp"

namespace clast::report_detail {

/// Formats a table for each stretched block with S/L down and I/L across (S/I down if that needs
/// fewer rows), and one for each other kind of variation with blocks down and steps across. Images
/// are buttons of class "cell" with the block number in data-source. Empty if no block is a
/// variation (library/block_variation.hpp); sampled bodies are omitted.
std::string format_series_matrices(std::span<const Block* const> blocks);

}  // namespace clast::report_detail
