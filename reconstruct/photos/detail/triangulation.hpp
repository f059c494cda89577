#pragma once
/// Places in space from places in photos.
#include <optional>
#include <vector>

#include "reconstruct/photos/photo_model.hpp"

namespace clast::photos_detail {

/// A place that was seen in a photo.
struct ImageObservation {
  std::size_t photo = 0;
  Vec2 pixel = Vec2::Zero();
};

struct TriangulatedPoint {
  Vec3 position = Vec3::Zero();
  std::vector<bool> is_inlier;  ///< of each sighting
  std::size_t inlier_count = 0;
  double squared_error = 0.0;  ///< summed over those, px^2
};

/// The place that most sightings agree with to `largest_error` pixels, found from every pair of
/// them (of an even choice of pairs where there are many), then by least squares over those that
/// agree. None: no two agree.
std::optional<TriangulatedPoint> triangulate(const PhotoModel& model,
                                             const std::vector<ImageObservation>& observations,
                                             double largest_error);

}  // namespace clast::photos_detail
