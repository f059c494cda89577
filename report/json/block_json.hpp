#pragma once
/// What is known of a block, as JSON.
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "classify/box_convention.hpp"
#include "library/block.hpp"

namespace clast {

/// The box of the rounded block by a convention.
OrientedBox block_box(const Block& block, BoxConvention convention);

/// Indices of the axes and of the surface, by name (docs/theory.md).
/// @param axes  of the block, by the box convention that is in use
std::map<std::string, double> block_indices(const Block& block, const Axes& axes);

/// {"stable": .., "unstable": .., "saddle": ..} of the block on a flat ground.
nlohmann::ordered_json equilibria_json(const Block& block);

/// Roundness of the outer surface on a mesh of this edge length, m, and what it was measured on.
nlohmann::ordered_json roundness_json(const Block& block, double edge_length);

/// Everything known of a block, units in the names (docs/formats.md). An unscaled block's lengths
/// have keys that end in _units, its masses and moments are null.
nlohmann::ordered_json block_json(const Block& block);

}  // namespace clast
