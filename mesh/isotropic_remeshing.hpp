#pragma once
/// A surface cut anew into triangles of even size.
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// The same closed surface in triangles whose edges are about `edge_length` long, by splits,
/// collapses, flips and shifts along the surface (Botsch & Kobbelt 2004); corners finer than that
/// are lost. Same input, same bits.
/// @throws GeometryError  the mesh is not a closed 2-manifold
/// @throws InputError     edge length not positive, or so short that it would take more than ten
///                        million triangles
/// @cite botsch2004
TriangleMesh remesh_isotropic(const TriangleMesh& mesh, double edge_length);

}  // namespace clast
