#pragma once
/// Markers that no photo shows.
#include "reconstruct/photos/photo_markers.hpp"

namespace clast {

/// A square of a side about a place, seen in twelve photos.
inline LocatedMarker made_up_marker(int id, const Vec3& centre, double side = 0.4) {
  LocatedMarker result{id, {}, 12, 0.1};
  const std::array<Vec2, 4> at = {Vec2(-0.5, 0.5), Vec2(0.5, 0.5), Vec2(0.5, -0.5),
                                  Vec2(-0.5, -0.5)};
  for (std::size_t k = 0; k < 4; ++k) {
    result.corners[k] = centre + side * Vec3(at[k].x(), at[k].y(), 0.0);
  }
  return result;
}

}  // namespace clast
