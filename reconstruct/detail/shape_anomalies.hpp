#pragma once
/// Detection of closed surfaces that probably do not bound a single rock.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/plane.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Sign that a closed surface is not a single rock.
struct ShapeAnomaly {
  enum class Kind {
    kShell,   ///< thin walls everywhere, as in a thickened surface; `size` is their thickness
    kHollow,  ///< much of the convex hull is empty; `size` is the depth of the deepest concavity
    kSlab,    ///< block with surrounding ground or turntable; `size` is the total width
    kSeam,    ///< two touching or connected bodies; `size` is the width of the seam
  };
  Kind kind = Kind::kShell;
  Vec3 position = Vec3::Zero();  ///< m
  double size = 0.0;             ///< m
  double fraction =
      0.0;  ///< kShell, kHollow: volume relative to that of the convex hull; kSeam: volume fraction
            ///< of the smaller body; kSlab: fraction of the plan area that is ground
  std::optional<Plane> seam =
      {};  ///< plane of the seam for kSeam, with its normal towards the smaller body
};

/// Finds signs that a closed body is not a single rock, at most one of each kind.
/// @param closed  outward, in metres
std::vector<ShapeAnomaly> find_shape_anomalies(const TriangleMesh& closed);

/// Formats an anomaly as a note that states appearance, position, size and advice.
/// @param format_file_position  formats a position in file coordinates
std::string format_shape_anomaly(
    const ShapeAnomaly& anomaly,
    const std::function<std::string(const Vec3&)>& format_file_position);

}  // namespace clast::reconstruct_detail
