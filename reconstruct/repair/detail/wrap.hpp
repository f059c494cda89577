#pragma once
/// Alpha wrapping, which encloses a faulty surface in a new closed mesh if other repairs fail.
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Parameters of the wrap, as fractions of the diagonal of the bounding box. The computing time is
/// proportional to their inverse square.
struct WrapParameters {
  double alpha;   ///< maximum width of cavities that the wrap bridges
  double offset;  ///< distance of the wrap from the surface
};

/// The fine wrap takes some seconds. The coarse wrap takes a tenth of that time; it shows if the
/// fine wrap can succeed.
inline constexpr WrapParameters kFineWrap{1.0 / 60.0, 1.0 / 1500.0},
    kCoarseWrap{1.0 / 20.0, 1.0 / 600.0};

/// Computes a closed 2-manifold without self-intersections around `closed`, at `parameters.offset`.
/// @param closed  surface without holes; the wrap would enter through holes
/// @throws GeometryError  if it has holes
/// @cite portaneri2022
TriangleMesh wrap_surface(const TriangleMesh& closed, const WrapParameters& parameters);

}  // namespace clast::reconstruct_detail
