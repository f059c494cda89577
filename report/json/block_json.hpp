#pragma once
/// Blocks as JSON.
#include <nlohmann/json.hpp>
#include <optional>

#include "classify/equilibria.hpp"
#include "library/block.hpp"

namespace clast {

/// Returns the numbers of static equilibria of a block by kind as JSON. Null if `sides` is empty.
nlohmann::ordered_json equilibria_json(const std::optional<StaticEquilibriumCounts>& sides);

/// Returns all data of a block as JSON, with units in the keys (docs/formats.md).
nlohmann::ordered_json block_json(const Block& block);

}  // namespace clast
