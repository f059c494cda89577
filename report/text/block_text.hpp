#pragma once
/// Terminal output of blocks.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/text_table.hpp"
#include "library/block.hpp"

namespace clast {

/// Formats a block as one line of text: id, vertices, size, volume, mass, classes and deviation.
std::string format_block_line(const Block& block);

/// Makes a table with one row per block. Lengths of unscaled blocks are marked "u".
TextTable make_block_table(std::span<const Block* const> blocks);
/// Describes which blocks are unscaled and why. Empty if all blocks are scaled.
std::string describe_unscaled_blocks(std::span<const Block* const> blocks);

using NamedValues = std::vector<std::array<std::string, 2>>;

/// Returns details of a block as pairs of name and value.
NamedValues describe_block(const Block& block);

}  // namespace clast
