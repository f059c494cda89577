#pragma once
/// Decomposition of a body into convex parts that cover it and do not overlap.
#include <cstddef>
#include <optional>
#include <vector>

#include "particles/particle_body.hpp"
#include "particles/shape_errors.hpp"

namespace clast {

struct ConvexPartOptions {
  double added_volume = 0.01;  ///< volume of the parts beyond the body, relative to its volume
  std::size_t max_parts = 32;  ///< the division ends at this number, even above `added_volume`
  /// Largest number of vertices of a part, at least 16; default: no limit. A hull with more of them
  /// is replaced by a polyhedron that contains it, within the cell of the part.
  std::optional<std::size_t> max_vertices = {};

  void check() const;  ///< throws InputError naming the field and its value
};

struct ConvexParts {
  std::vector<TriangleMesh> parts;  ///< closed convex meshes in the frame of the body, m
  double added_volume = 0.0;        ///< relative to the volume of the mesh
};

/// Divides a body into convex parts.
///
/// Planes divide space into convex cells, and each part is the convex hull of the body within one
/// cell. So the parts cover the body without gaps and do not overlap. The part that adds most
/// volume is divided first, by the plane out of some tens after which the two hulls are smallest.
/// @throws GeometryError  if the mesh is open or its signed volume is not positive
ConvexParts split_into_convex_parts(const TriangleMesh& mesh,
                                    const ConvexPartOptions& options = {});

/// Returns the mass properties of parts that do not overlap.
MassProperties convex_part_mass_properties(const std::vector<TriangleMesh>& parts, double density);

/// Measures the errors of parts of a body whose `radius` is 0. Volume and inertia are exact. The
/// surface distance is the largest of samples at about 0.5 % of L: points of the body from the
/// outer surface of the parts, and points of that surface from the body.
ShapeErrors measure_part_errors(const ParticleBody& body, const std::vector<TriangleMesh>& parts);

}  // namespace clast
