#pragma once
/// Detection of blurred photos.
#include <vector>

#include "reconstruct/photos/photo_region.hpp"

namespace clast {

struct Sharpness {
  double relative = 1.0;  ///< sharpness relative to the median over the photos
  bool blurred = false;
};

/// Relative sharpness below which a photo is classified as blurred.
inline constexpr double kBlurredSharpness = 0.25;

/// Measures the sharpness of each photo in the region of the block. It is the energy of fine detail
/// relative to that of the slightly smoothed photo, in the direction where this ratio is smallest.
/// It does not depend on lighting and hardly depends on content.
/// @param model  camera model whose photo files are located
std::vector<Sharpness> measure_sharpness(const PhotoModel& model, const PhotoRegion& region,
                                         unsigned threads = 1);

}  // namespace clast
