#pragma once
/// Isotropic remeshing.
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Remeshes a closed surface with edges of about `edge_length`, by edge splits, collapses, flips
/// and tangential relaxation (Botsch & Kobbelt 2004). Finer details are lost. Deterministic.
/// @throws GeometryError  if the mesh is not a closed 2-manifold
/// @throws InputError  if the edge length is not positive, or so short that more than ten million
///                     triangles are needed
/// @cite botsch2004
TriangleMesh remesh_isotropic(const TriangleMesh& mesh, double edge_length);

}  // namespace clast
