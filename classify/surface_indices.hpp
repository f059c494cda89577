#pragma once
/// Shape indices that depend on the whole surface of a block.
#include <map>
#include <span>
#include <string>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Returns Wadell's true sphericity pi^(1/3) (6 V)^(2/3) / A: area of the sphere of equal volume V
/// divided by the area A of the body. @cite wadell1932
/// @param volume  m^3, positive
/// @param area  m^2, positive
double true_sphericity(double volume, double area);

/// Returns the volume of the rounded body divided by that of its convex hull.
/// @param volume  volume of the rounded body, m^3
/// @throws GeometryError  if the core's vertices are coplanar
double convexity(const SpheroPolyhedron& body, double volume);

/// Orientation tensor of the surface: (1/A) times the integral of n n^T over the rounded surface
/// with area A and outward normal n. Its eigenvalues are f1 >= f2 >= f3, with sum 1. @cite bagi2020
struct OrientationTensor {
  Vec3 eigenvalues = Vec3::Zero();

  double compactness() const { return eigenvalues[2] / eigenvalues[0]; }
  double flakiness() const { return (eigenvalues[0] - eigenvalues[1]) / eigenvalues[0]; }
  double rodness() const { return (eigenvalues[1] - eigenvalues[2]) / eigenvalues[0]; }
};

/// Computes the orientation tensor in closed form. It is the sum over faces, cylinders at convex
/// edges and spherical parts, minus the strips lost at reflex edges. Exact for convex cores.
/// @throws GeometryError  if the core is open or inconsistently oriented; a single vertex is a
///                        valid core
OrientationTensor orientation_tensor(const SpheroPolyhedron& body);

struct SurfaceIndex {
  const char* name;     ///< name in tables and JSON
  const char* formula;  ///< formula with volume V, area A and the eigenvalues f1, f2 and f3
  const char* source;   ///< key in docs/references.bib; empty for simple ratios
};

/// Returns the definitions of all surface indices, in the order of docs/theory.md.
std::span<const SurfaceIndex> surface_index_definitions();

/// Computes all surface indices. Returns their values by name. Those of the orientation tensor are
/// omitted if tunnels narrower than the rounding make it meaningless.
/// @param volume  of the rounded body, m^3; area in m^2
/// @throws GeometryError  if the vertices of the core are coplanar
std::map<std::string, double> surface_indices(const SpheroPolyhedron& body, double volume,
                                              double area);

}  // namespace clast
