#pragma once
/// Blocks as text for a terminal.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/text_table.hpp"
#include "library/block.hpp"

namespace clast {

/// One line: id, vertices, size, volume, mass, classes, deviation.
std::string format_block_line(const Block& block);

/// A row per block. Lengths of unscaled blocks are marked "u".
TextTable block_table(std::span<const Block* const> blocks);
/// Which of the blocks are unscaled, and why; empty where none is.
std::string describe_unscaled(std::span<const Block* const> blocks);

/// Names and what stands behind them, in the order they are to be read.
using NamedValues = std::vector<std::array<std::string, 2>>;

/// What the table leaves out.
NamedValues describe_block(const Block& block);

}  // namespace clast
