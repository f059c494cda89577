#pragma once
/// Indices of the whole surface of a block, not of three axes.
#include <map>
#include <span>
#include <string>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Wadell's true sphericity, pi^(1/3) (6 V)^(2/3) / A: the area of the sphere of equal volume over
/// that of the body; 1 for a sphere. @cite wadell1932
/// @param volume  m^3; area in m^2; both positive
double true_sphericity(double volume, double area);

/// Volume of the rounded body over that of its convex hull; 1 for a convex body.
/// @param volume  of the rounded body, m^3
/// @throws GeometryError  the core's vertices enclose no volume
double convexity(const SpheroPolyhedron& body, double volume);

/// Eigenvalues f1 >= f2 >= f3 of (1/A) integral of n n^T over the rounded surface, n the outward
/// normal; they add up to 1. @cite bagi2020
struct SurfaceOrientation {
  Vec3 eigenvalues = Vec3::Zero();

  double compactness() const { return eigenvalues[2] / eigenvalues[0]; }
  double flakiness() const { return (eigenvalues[0] - eigenvalues[1]) / eigenvalues[0]; }
  double rodness() const { return (eigenvalues[1] - eigenvalues[2]) / eigenvalues[0]; }
};

/// Closed form: faces, cylinders over convex edges, strips lost at reflex edges, and the spherical
/// parts, whose normals cover the sphere once. Exact for a convex core.
/// @throws GeometryError  core open or inconsistently oriented (a lone vertex is a ball and fine)
SurfaceOrientation surface_orientation(const SpheroPolyhedron& body);

/// One index of a block's surface.
struct SurfaceIndex {
  const char* name;     ///< as in tables and JSON
  const char* formula;  ///< V volume, A area, f1 >= f2 >= f3 of the orientation
  const char* source;   ///< key in docs/references.bib; empty for a plain ratio
};

/// Every index of this file, in the order it is listed in docs/theory.md.
std::span<const SurfaceIndex> surface_index_definitions();

/// The values of all by name. Those of the orientation are absent where tunnels narrower than the
/// rounding leave it without a meaning.
/// @param volume  of the rounded body, m^3; area in m^2
/// @throws GeometryError  what `convexity` throws
std::map<std::string, double> surface_indices(const SpheroPolyhedron& body, double volume,
                                              double area);

}  // namespace clast
