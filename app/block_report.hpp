#pragma once
/// What is printed of a block.
#include <nlohmann/json.hpp>
#include <string>

#include "library/block.hpp"

namespace clast {

/// Everything known of a block, units in the names (docs/formats.md).
nlohmann::ordered_json block_json(const Block& block);

/// One line: id, vertices, size, volume, mass, classes, deviation.
std::string block_line(const Block& block);

}  // namespace clast
