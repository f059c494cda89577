#pragma once
/// Alpha wrapping as the last repair method.
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Wrap parameters as fractions of the diagonal. The cost grows with their inverse square.
struct WrapParameters {
  double alpha;   ///< width of bridged cavities
  double offset;  ///< distance of the wrap from the surface
};

/// The fine wrap takes some seconds; the coarse one a tenth of it, and shows whether the fine one
/// is worthwhile.
inline constexpr WrapParameters kFineWrap{1.0 / 60.0, 1.0 / 1500.0},
    kCoarseWrap{1.0 / 20.0, 1.0 / 600.0};

/// Computes a closed 2-manifold without self-intersections around `closed`, at a distance given by
/// `parameters`.
/// @param closed  without holes, through which the wrap would enter
/// @throws GeometryError  if it has holes
/// @cite portaneri2022
TriangleMesh wrap_surface(const TriangleMesh& closed, const WrapParameters& parameters);

}  // namespace clast::reconstruct_detail
