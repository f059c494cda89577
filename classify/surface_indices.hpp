#pragma once
/// Shape indices of the whole surface of a block.
#include <map>
#include <span>
#include <string>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Returns Wadell's true sphericity, pi^(1/3) (6 V)^(2/3) / A: area of the sphere of equal volume
/// over the area of the body; 1 for a sphere. @cite wadell1932
/// @param volume  m^3; area in m^2; both positive
double true_sphericity(double volume, double area);

/// Returns the volume of the rounded body over that of its convex hull; 1 for convex bodies.
/// @param volume  of the rounded body, m^3
/// @throws GeometryError  if the core's vertices are coplanar
double convexity(const SpheroPolyhedron& body, double volume);

/// Orientation tensor of the surface: eigenvalues f1 >= f2 >= f3 of (1/A) integral of n n^T over
/// the rounded surface with outward normal n; their sum is 1. @cite bagi2020
struct OrientationTensor {
  Vec3 eigenvalues = Vec3::Zero();

  double compactness() const { return eigenvalues[2] / eigenvalues[0]; }
  double flakiness() const { return (eigenvalues[0] - eigenvalues[1]) / eigenvalues[0]; }
  double rodness() const { return (eigenvalues[1] - eigenvalues[2]) / eigenvalues[0]; }
};

/// Computes the orientation tensor in closed form from faces, cylinders over convex edges, strips
/// lost at reflex edges, and spherical parts, whose normals cover the sphere once. Exact for convex
/// cores.
/// @throws GeometryError  if the core is open or inconsistently oriented (a lone vertex is a ball
///                        and valid)
OrientationTensor orientation_tensor(const SpheroPolyhedron& body);

struct SurfaceIndex {
  const char* name;     ///< as in tables and JSON
  const char* formula;  ///< V volume, A area, f1 >= f2 >= f3 of the orientation tensor
  const char* source;   ///< key in docs/references.bib; empty for a plain ratio
};

/// Returns all indices in the order of docs/theory.md.
std::span<const SurfaceIndex> surface_index_definitions();

/// Computes all indices by name. Those of the orientation tensor are missing if tunnels narrower
/// than the rounding make it meaningless.
/// @param volume  of the rounded body, m^3; area in m^2
/// @throws GeometryError  as `convexity`
std::map<std::string, double> surface_indices(const SpheroPolyhedron& body, double volume,
                                              double area);

}  // namespace clast
