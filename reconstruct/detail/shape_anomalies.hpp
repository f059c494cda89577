#pragma once
/// Closed bodies that do not look like one rock.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/plane.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// A sign that a closed surface bounds something else than one rock.
struct ShapeAnomaly {
  enum class Kind {
    kShell,   ///< thin walls all over: a surface that was given a thickness; `size`: the thickness
    kHollow,  ///< much less than the convex hull is filled; `size`: depth of the deepest hollow
    kSlab,    ///< a block with the ground, or the turntable, around it; `size`: width of the whole
    kSeam,    ///< two bodies that touch, or are joined by a bridge; `size`: width of the seam
  };
  Kind kind = Kind::kShell;
  Vec3 position = Vec3::Zero();  ///< m
  double size = 0.0;             ///< m
  double fraction = 0.0;  ///< kShell, kHollow: volume over that of the convex hull; kSeam: volume
                          ///< of the smaller body; kSlab: plan area of the ground
  std::optional<Plane> seam = {};  ///< kSeam: normal towards the smaller body
};

/// Finds what makes a closed body doubtful, at most one of each kind.
/// @param closed  outward, in metres
std::vector<ShapeAnomaly> find_shape_anomalies(const TriangleMesh& closed);

/// Formats a doubt as a note on the scan: what it looks like, where, how large, what to do.
/// @param format_file_position  formats a place as it is in the scan's file
std::string format_shape_anomaly(
    const ShapeAnomaly& anomaly,
    const std::function<std::string(const Vec3&)>& format_file_position);

}  // namespace clast::reconstruct_detail
