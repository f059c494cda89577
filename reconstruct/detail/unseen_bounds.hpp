#pragma once
/// How large and how small a body with unseen parts may be.
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/block_bounds.hpp"
#include "reconstruct/surface_margin.hpp"
#include "reconstruct/underside.hpp"

namespace clast::reconstruct_detail {

/// Bounds of a body whose seen flanks continue as they are, m^3 and m.
struct UnseenBounds {
  double best_volume = 0.0;            ///< of the surface as it is closed
  double lower_volume = 0.0;           ///< with a closure that is dented as the seen surface is
  std::optional<double> upper_volume;  ///< none: too large a part is unseen
  std::optional<SideBounds> sides;     ///< none without an upper volume
};

/// What is known of a body beside its seen surface.
struct UnseenParts {
  std::vector<bool> closure;              ///< of each triangle: it fills a hole
  std::optional<Plane> floor;             ///< the body lies above it; normal up
  const SurfaceMargin* margin = nullptr;  ///< of the seen surface; null: that is exact
};

/// The upper volume is that of the seen part with all that lies behind its closures, as seen from
/// its middle, and within the planes of its flanks (`flank_planes`) and above the floor. See
/// docs/theory.md. A margin widens the bounds of volume and sides.
/// @param closed  outward, with the closures
UnseenBounds unseen_bounds(const TriangleMesh& closed, const UnseenParts& parts);

}  // namespace clast::reconstruct_detail
