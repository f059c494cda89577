#pragma once
/// How large and how small a body with unseen parts may be.
#include <optional>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"
#include "reconstruct/underside/underside.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast::reconstruct_detail {

/// A closure whose rim turns into the body: the mouth of a cavity, or of a tunnel, whose walls were
/// not seen. In the units of the mesh.
struct PossibleHollow {
  Vec3 position = Vec3::Zero();  ///< middle of the mouth
  double width = 0.0;            ///< of the mouth
  double volume = 0.0;           ///< of the body straight behind it, which may be empty
  std::optional<Vec3> beyond;    ///< middle of the mouth at the other end, if there is one
};

/// Bounds of a body whose seen flanks continue as they are, in units of the mesh. The lower volume
/// has closures that are dented as the seen surface is, and excludes what may be hollow.
struct UnobservedBounds : VolumeBracket {
  std::vector<PossibleHollow> hollows;
};

/// What is known of a body beside its seen surface.
struct UnobservedParts {
  std::vector<bool> closure;   ///< of each triangle: it fills a hole
  std::optional<Plane> floor;  ///< the body lies above it; normal up
  bool on_ground = false;      ///< the unseen part is on the side of the ground
  const SurfaceUncertainty* uncertainty = nullptr;  ///< of the seen surface; null: that is exact
};

/// The upper volume is that of the seen part with all that lies behind its closures, as seen from
/// its middle, and within the planes of its flanks (`fit_flank_planes`) and above the floor. See
/// docs/theory.md. A margin widens the bounds of volume and sides.
/// @param closed  outward, with the closures
UnobservedBounds bound_unobserved_parts(const TriangleMesh& closed, const UnobservedParts& parts);

/// A note on each hollow: that a tunnel or a cavity may be there, where, and of what width.
/// @param unit  m per unit of the mesh; places are given in that unit, as in all notes on a scan
std::vector<std::string> describe_hollows(const std::vector<PossibleHollow>& hollows, double unit);

}  // namespace clast::reconstruct_detail
