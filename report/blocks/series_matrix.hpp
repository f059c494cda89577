#pragma once
/// Series of varied blocks as tables of pictures.
#include <span>
#include <string>

#include "library/block.hpp"

namespace clast::report_detail {

/// HTML: for each block that was stretched a table of its forms, S/L down and I/L across (S/I down
/// where that takes fewer rows); for each other kind of variation a table of blocks down and steps
/// across. Pictures are buttons of class "cell" with the number of the block in data-source.
/// Empty where no block is a variation (library/block_variation.hpp); drawn bodies are in no table.
std::string format_series_matrices(std::span<const Block* const> blocks);

}  // namespace clast::report_detail
