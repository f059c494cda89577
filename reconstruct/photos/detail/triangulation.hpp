#pragma once
/// Triangulation of points from image observations.
#include <optional>
#include <vector>

#include "reconstruct/photos/photo_model.hpp"

namespace clast::photos_detail {

/// Observation of a point in a photo.
struct ImageObservation {
  std::size_t photo = 0;
  Vec2 pixel = Vec2::Zero();
};

struct TriangulatedPoint {
  Vec3 position = Vec3::Zero();
  std::vector<bool> is_inlier;  ///< per observation
  std::size_t inlier_count = 0;
  double squared_error = 0.0;  ///< sum over the inliers, px^2
};

/// Triangulates the point on which most observations agree to `largest_error` pixels, starting from
/// all pairs (or an even selection), followed by least squares over the inliers. Empty if no two
/// agree.
std::optional<TriangulatedPoint> triangulate(const PhotoModel& model,
                                             const std::vector<ImageObservation>& observations,
                                             double largest_error);

}  // namespace clast::photos_detail
