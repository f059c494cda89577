#pragma once
/// Triangulation of points from image observations.
#include <optional>
#include <vector>

#include "reconstruct/photos/photo_model.hpp"

namespace clast::photos_detail {

/// Observation of a point in a photo, given by photo index and pixel.
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

/// Triangulates the point on which most observations agree to within `max_reprojection_error`
/// pixels. Candidates are triangulated from all pairs of observations, or from an even selection.
/// The best one is refined by least squares over its inliers. Empty if no two observations agree.
std::optional<TriangulatedPoint> triangulate(const PhotoModel& model,
                                             const std::vector<ImageObservation>& observations,
                                             double max_reprojection_error);

}  // namespace clast::photos_detail
