#pragma once
/// Region of the photographed block.
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

/// Sphere around the block and adjacent ground.
struct PhotoRegion {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  bool from_ground =
      false;  ///< true if a block was found above a ground; false if estimated from the cameras
};

/// Finds the region of the block from the sparse points. The block is the one above the ground that
/// is nearest to the viewing centre of the cameras. Without a ground, the region is the sphere
/// about the viewing centre that most photos contain.
/// @throws InputError  for fewer than two photos, or cameras without a common viewing centre
PhotoRegion find_photo_region(const PhotoModel& model);

/// Returns the angle between two photos at the region's centre, rad.
double viewing_angle(const PhotoModel& model, const PhotoRegion& region, std::size_t first,
                     std::size_t second);

}  // namespace clast
