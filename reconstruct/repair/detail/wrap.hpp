#pragma once
/// The last resort: a surface around a surface.
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// How closely a wrap follows, as shares of the diagonal. Its cost goes with the square.
struct WrapParameters {
  double alpha;   ///< width of the hollows that are bridged
  double offset;  ///< of the wrap from the surface
};

/// The first takes some seconds; the second a tenth of that, and shows whether the first is worth
/// it.
inline constexpr WrapParameters kFineWrap{1.0 / 60.0, 1.0 / 1500.0},
    kCoarseWrap{1.0 / 20.0, 1.0 / 600.0};

/// A closed 2-manifold without crossings around `closed`, not much farther outside of it than
/// `parameters` say.
/// @param closed  without holes: through a hole the wrap would creep inside and double the surface
/// @throws GeometryError  it has holes
/// @cite portaneri2022
TriangleMesh wrap_surface(const TriangleMesh& closed, const WrapParameters& parameters);

}  // namespace clast::reconstruct_detail
