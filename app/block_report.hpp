#pragma once
/// What is printed of a block.
#include <nlohmann/json.hpp>
#include <string>

#include "classify/box_convention.hpp"
#include "library/block.hpp"

namespace clast {

/// The box of the rounded block by a convention.
OrientedBox block_box(const Block& block, BoxConvention convention);

/// Everything known of a block, units in the names (docs/formats.md).
nlohmann::ordered_json block_json(const Block& block);

/// One line: id, vertices, size, volume, mass, classes, deviation.
std::string block_line(const Block& block);

}  // namespace clast
