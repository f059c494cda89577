#pragma once
/// What is known of a block, as JSON.
#include <nlohmann/json.hpp>
#include <optional>

#include "classify/equilibria.hpp"
#include "library/block.hpp"

namespace clast {

/// {"stable": .., "unstable": .., "saddle": ..}, null where there are none.
nlohmann::ordered_json equilibria_json(const std::optional<Equilibria>& sides);

/// Everything known of a block, units in the names (docs/formats.md). An unscaled block's lengths
/// have keys that end in _units, its masses and moments are null.
nlohmann::ordered_json block_json(const Block& block);

}  // namespace clast
