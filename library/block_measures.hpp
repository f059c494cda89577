#pragma once
/// Measures of a block that are not stored but computed on request.
#include <map>
#include <optional>
#include <string>

#include "classify/box_convention.hpp"
#include "classify/equilibria.hpp"
#include "classify/roundness.hpp"
#include "library/block.hpp"

namespace clast {

/// Computes the box of the rounded block according to a convention.
OrientedBox block_box(const Block& block, BoxConvention convention);

/// Computes the form and surface indices of a block (docs/theory.md). Returns their values by name.
/// @param axes  axes of the block for the box convention in use
std::map<std::string, double> block_indices(const Block& block, const Axes& axes);

/// Counts the static equilibria of a block. Empty for balls and capsules.
std::optional<StaticEquilibriumCounts> block_equilibria(const Block& block);

/// Computes the roundness of a rounded body.
/// @param edge_length  edge length of the mesh on which it is measured, m
Roundness body_roundness(const SpheroPolyhedron& body, double edge_length);
/// Computes the roundness of the outer surface of a block.
/// @param edge_length  edge length of the mesh on which it is measured, m
Roundness block_roundness(const Block& block, double edge_length);

}  // namespace clast
