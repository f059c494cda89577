#pragma once
/// Bounds of bodies with unobserved parts.
#include <optional>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"
#include "reconstruct/underside/underside.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast::reconstruct_detail {

/// Possible cavity or tunnel: a closure whose rim turns into the body. In units of the mesh.
struct PossibleHollow {
  Vec3 position = Vec3::Zero();  ///< centre of the opening
  double width = 0.0;            ///< of the opening
  double volume = 0.0;           ///< of the body behind it, which may be empty
  std::optional<Vec3> beyond;    ///< centre of the opening at the other end, if there is one
};

/// Bounds of a body whose observed flanks continue, in units of the mesh. The lower volume assumes
/// indentations of the closures like those of the observed surface, and excludes possible cavities.
struct UnobservedBounds : VolumeBracket {
  std::vector<PossibleHollow> hollows;
};

/// Knowledge of a body besides its observed surface.
struct UnobservedParts {
  std::vector<bool> closure;                        ///< per triangle: fills a hole
  std::optional<Plane> floor;                       ///< the body is above it; normal up
  bool on_ground = false;                           ///< the unobserved part faces the ground
  const SurfaceUncertainty* uncertainty = nullptr;  ///< of the observed surface; null if exact
};

/// Bounds the volume and sides. The upper volume is the observed part plus the space behind its
/// closures, seen from its centre, within the flank planes (`fit_flank_planes`) and above the floor
/// (docs/theory.md). Uncertainty widens the bounds.
/// @param closed  outward, with the closures
UnobservedBounds bound_unobserved_parts(const TriangleMesh& closed, const UnobservedParts& parts);

/// Describes each possible cavity or tunnel with position and width.
/// @param unit  m per unit of the mesh, in which positions are given
std::vector<std::string> describe_hollows(const std::vector<PossibleHollow>& hollows, double unit);

}  // namespace clast::reconstruct_detail
