#include "library/block_measures.hpp"

#include <algorithm>
#include <cmath>

#include "classify/surface_indices.hpp"
#include "mesh/isotropic_remeshing.hpp"
#include "shapes/outer_surface.hpp"

namespace clast {
namespace {

/// Fraction of the edge length; larger facets of a rounded surface would count as faces with edges.
constexpr double kFacetFraction = 0.7;
constexpr double kMinSegments = 4.0, kMaxSegments = 24.0;

/// Pieces of a quarter turn that are so short that a mesh of this edge length sees them as round.
int skin_segments(double radius, double edge_length) {
  const double pieces = 0.5 * kPi * radius / (kFacetFraction * edge_length);
  return static_cast<int>(std::ceil(std::clamp(pieces, kMinSegments, kMaxSegments)));
}

}  // namespace

OrientedBox block_box(const Block& block, BoxConvention convention) {
  if (convention == BoxConvention::kSmallest) return block.box;  // stored
  return box_by_convention(block.body, block.principal, convention);
}

std::map<std::string, double> block_indices(const Block& block, const Axes& axes) {
  std::map<std::string, double> indices = form_indices(axes);
  indices.merge(surface_indices(block.body, block.mass.volume, block.area));
  return indices;
}

std::optional<StaticEquilibriumCounts> block_equilibria(const Block& block) {
  if (block.body.faces.empty()) return std::nullopt;
  return count_static_equilibria(block.body, block.mass.centre);
}

Roundness body_roundness(const SpheroPolyhedron& body, double edge_length) {
  // A core's own surface has none of the rounding; nor may the skin cross itself at reflex edges.
  return roundness(remesh_isotropic(
      outer_surface_mesh(body, skin_segments(body.radius, edge_length)), edge_length));
}

Roundness block_roundness(const Block& block, double edge_length) {
  if (block.from_core) return body_roundness(block.body, edge_length);
  return roundness(remesh_isotropic(block.surface, edge_length));
}

}  // namespace clast
