#pragma once
/// A block in a line of text.
#include <string>

#include "library/block.hpp"

namespace clast {

/// The mass in kg, and "-" of an unscaled block, which has none.
std::string mass_text(const Block& block);
/// What lengths of the block are in: "m", or "u" for the unit of an unscaled block's model.
std::string length_unit_of(const Block& block);

/// One line: id, vertices, size, volume, mass, classes, deviation.
std::string block_line(const Block& block);

}  // namespace clast
