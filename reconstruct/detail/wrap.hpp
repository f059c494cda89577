#pragma once
/// The last resort: a surface around a surface.
#include "shapes/triangle_mesh.hpp"

namespace clast::detail {

/// A closed 2-manifold without crossings around `closed`, up to a hundredth of its diagonal outside
/// of it; hollows narrower than a sixtieth of the diagonal are bridged.
/// @param closed  without holes: through a hole the wrap would creep inside and double the surface
/// @throws GeometryError  it has holes
/// @cite portaneri2022
TriangleMesh wrapped(const TriangleMesh& closed);

}  // namespace clast::detail
