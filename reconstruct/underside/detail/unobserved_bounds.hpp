#pragma once
/// Bounds of the volume and box sides of bodies with unobserved parts.
#include <optional>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"
#include "reconstruct/underside/underside.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast::reconstruct_detail {

/// Possible cavity or tunnel behind a closed hole whose rim bends inwards. Units of the mesh.
struct PossibleHollow {
  Vec3 position = Vec3::Zero();  ///< centre of the opening
  double width = 0.0;            ///< width of the opening
  double volume = 0.0;           ///< volume of the part of the body behind it that may be empty
  std::optional<Vec3> other_opening;  ///< centre of the other opening, for a tunnel
};

/// Bounds of volume and box sides, in units of the mesh. For the upper bounds, the unobserved part
/// continues the observed flanks. For the lower volume, it has indentations like the observed
/// surface, and possible cavities are excluded.
struct UnobservedPartBounds : VolumeBracket {
  std::vector<PossibleHollow> hollows;
};

/// Unobserved parts of a body, and known limits of its surface.
struct UnobservedParts {
  std::vector<bool> is_closure;  ///< one flag per triangle; true if it fills a hole
  std::optional<Plane> floor;    ///< plane below the body, normal up
  bool on_ground = false;        ///< true if the unobserved part faces the ground
  const SurfaceUncertainty* uncertainty =
      nullptr;  ///< uncertainty of the observed surface; null if it is exact
};

/// Computes bounds of the volume and box sides of a body. The upper volume is the sum of the
/// observed part and of the space behind its closures that is within the flank planes
/// (`fit_flank_planes`) and above the floor. Uncertainty of the observed surface widens the bounds.
/// See docs/theory.md.
/// @param closed  closed mesh with the closures, outward
UnobservedPartBounds bound_unobserved_parts(const TriangleMesh& closed,
                                            const UnobservedParts& parts);

/// Describes the possible cavities and tunnels, with position and width.
/// @param unit  m per unit of the mesh; positions are given in units of the mesh
std::vector<std::string> describe_hollows(const std::vector<PossibleHollow>& hollows, double unit);

}  // namespace clast::reconstruct_detail
