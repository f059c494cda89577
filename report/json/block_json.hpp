#pragma once
/// Blocks as JSON.
#include <nlohmann/json.hpp>
#include <optional>

#include "classify/equilibria.hpp"
#include "library/block.hpp"

namespace clast {

/// Returns the number of equilibria of each kind: {"stable": .., "unstable": .., "saddle": ..}.
/// Null if `sides` is empty.
nlohmann::ordered_json equilibria_json(const std::optional<StaticEquilibriumCounts>& sides);

/// Returns all data of a block, with units in the keys (docs/formats.md). For unscaled blocks, keys
/// of lengths end in _units, and mass and moments are null.
nlohmann::ordered_json block_json(const Block& block);

}  // namespace clast
