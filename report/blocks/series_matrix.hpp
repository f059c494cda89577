#pragma once
/// Tables of thumbnails for series of varied blocks.
#include <span>
#include <string>

#include "library/block.hpp"

namespace clast::report_detail {

/// Formats the tables as HTML. For each stretched block, a table has one row per S/L (or S/I, if
/// that needs fewer rows) and one column per I/L. For each other kind of variation, a table has one
/// row per block and one column per step. Images are buttons of class "cell" with the block number
/// in data-source. Sampled bodies are omitted. Empty if no block is a variation
/// (library/block_variation.hpp).
std::string format_series_matrices(std::span<const Block* const> blocks);

}  // namespace clast::report_detail
