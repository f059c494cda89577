#pragma once
/// Where the block is that photos were taken of.
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

/// A ball around the block and a strip of the ground about it.
struct PhotoRegion {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  bool from_ground = false;  ///< a block was found on a ground; else a guess
};

/// The block that stands on the ground near where the cameras look, found in the sparse points as
/// in any cloud. Where these show no ground, the ball about the place that the cameras look at that
/// most photos hold whole.
/// @throws InputError  fewer than two photos, or cameras that don't look at one place
PhotoRegion find_photo_region(const PhotoModel& model);

/// The angle between two photos at the region's centre, rad.
double viewing_angle(const PhotoModel& model, const PhotoRegion& region, std::size_t first,
                     std::size_t second);

}  // namespace clast
