#pragma once
/// Tables of thumbnails for series of varied blocks.
#include <span>
#include <string>

#include "library/block.hpp"

namespace clast::report_detail {

/// Formats tables of thumbnails of varied blocks as HTML. A stretched block has a table with rows
/// by S/L and columns by I/L. Other kinds of variation have a table with one row per block and one
/// column per step. Empty if no block is a variation.
std::string format_series_matrices(std::span<const Block* const> blocks);

}  // namespace clast::report_detail
