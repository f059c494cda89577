#pragma once
/// Places in space from places in photos.
#include <optional>
#include <vector>

#include "reconstruct/photos/photo_model.hpp"

namespace clast::photos_detail {

/// A place that was seen in a photo.
struct Sighting {
  std::size_t photo = 0;
  Vec2 pixel = Vec2::Zero();
};

struct Triangulated {
  Vec3 place = Vec3::Zero();
  std::vector<bool> agrees;  ///< of each sighting
  std::size_t agreeing = 0;
  double squared_error = 0.0;  ///< summed over those, px^2
};

/// The place that most sightings agree with to `largest_error` pixels, found from every pair of
/// them (of an even choice of pairs where there are many), then by least squares over those that
/// agree. None: no two agree.
std::optional<Triangulated> triangulated(const PhotoModel& model,
                                         const std::vector<Sighting>& sightings,
                                         double largest_error);

}  // namespace clast::photos_detail
