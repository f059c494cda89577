#pragma once
/// Region of the photographed block.
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

/// Sphere around the block and adjacent ground.
struct PhotoRegion {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  bool from_ground =
      false;  ///< a block was found above a ground; false: estimated from the cameras
};

/// Finds the block above the ground near the cameras' viewing centre in the sparse points. Without
/// ground, uses the sphere about the viewing centre that most photos contain.
/// @throws InputError  if there are fewer than two photos, or cameras without a common viewing
///                     centre
PhotoRegion find_photo_region(const PhotoModel& model);

/// Returns the angle between two photos at the region's centre, rad.
double viewing_angle(const PhotoModel& model, const PhotoRegion& region, std::size_t first,
                     std::size_t second);

}  // namespace clast
