#pragma once
/// Blocks as JSON.
#include <nlohmann/json.hpp>
#include <optional>

#include "classify/equilibria.hpp"
#include "library/block.hpp"

namespace clast {

/// Returns {"stable": .., "unstable": .., "saddle": ..}; null if there are no equilibria.
nlohmann::ordered_json equilibria_json(const std::optional<Equilibria>& sides);

/// Returns all data of a block, with units in the keys (docs/formats.md). Lengths of unscaled
/// blocks have keys ending in _units, their masses and moments are null.
nlohmann::ordered_json block_json(const Block& block);

}  // namespace clast
