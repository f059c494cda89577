#pragma once
/// Indices of the whole surface of a block, not of three axes.
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

}  // namespace clast
