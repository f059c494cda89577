#pragma once
/// Detection of blurred photos.
#include <vector>

#include "reconstruct/photos/photo_region.hpp"

namespace clast {

struct Sharpness {
  double relative = 1.0;  ///< relative to the median of the photos
  bool blurred = false;
};

/// Relative sharpness below which a photo is blurred.
inline constexpr double kBlurred = 0.25;

/// Measures sharpness in the region of the block: the energy of fine detail over that of the
/// slightly smoothed photo, in the direction where it is smallest, because a blurred photo loses
/// nothing by smoothing. Independent of lighting and nearly of content.
/// @param model  with files
std::vector<Sharpness> measure_sharpness(const PhotoModel& model, const PhotoRegion& region,
                                         unsigned threads = 1);

}  // namespace clast
