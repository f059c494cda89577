#pragma once
/// Blurred photos.
#include <vector>

#include "reconstruct/photos/photo_region.hpp"

namespace clast {

/// How sharp a photo is beside the others.
struct Sharpness {
  double relative = 1.0;  ///< of the median of the photos
  bool blurred = false;
};

/// Below this share of the median a photo is blurred.
inline constexpr double kBlurred = 0.25;

/// The energy of fine detail over that of the same photo slightly smoothed, where it shows the
/// block, along the direction where that is least: a photo that was smooth already loses nothing.
/// Independent of light, and nearly of what is seen.
/// @param model  with files
std::vector<Sharpness> measure_sharpness(const PhotoModel& model, const PhotoRegion& region,
                                    unsigned threads = 1);

}  // namespace clast
