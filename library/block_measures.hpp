#pragma once
/// What is computed from a stored block when it is asked for.
#include <map>
#include <optional>
#include <string>

#include "classify/box_convention.hpp"
#include "classify/equilibria.hpp"
#include "classify/roundness.hpp"
#include "library/block.hpp"

namespace clast {

/// The box of the rounded block by a convention.
OrientedBox block_box(const Block& block, BoxConvention convention);

/// Indices of the axes and of the surface, by name (docs/theory.md).
/// @param axes  of the block, by the box convention that is in use
std::map<std::string, double> block_indices(const Block& block, const Axes& axes);

/// None of a ball or a capsule, which rests on every side.
std::optional<Equilibria> block_equilibria(const Block& block);

/// Roundness of a rounded body on a mesh of this edge length, m.
Roundness body_roundness(const SpheroPolyhedron& body, double edge_length);
/// Roundness of the outer surface on a mesh of this edge length, m.
Roundness block_roundness(const Block& block, double edge_length);

}  // namespace clast
