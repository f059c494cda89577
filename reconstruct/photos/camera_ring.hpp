#pragma once
/// Camera positions around a block.
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "reconstruct/photos/photo_scan.hpp"

namespace clast {

struct CameraPosition {
  std::string name;
  double azimuth = 0.0;    ///< from x towards y, -pi to pi, rad
  double elevation = 0.0;  ///< angle above the horizontal, rad
  double distance = 0.0;   ///< distance from the centre of the block, m
  std::size_t pairs = 0;   ///< number of stereo pairs that contain this photo
  bool blurred = false;
};

/// Azimuth range without a camera whose photo was used for stereo.
struct AzimuthGap {
  std::size_t first = 0, second = 0;  ///< indices of the cameras at its ends
  double from = 0.0;                  ///< azimuth of the first camera, rad
  double width = 0.0;                 ///< rad
};

/// Width above which azimuth gaps between cameras are reported, rad. Photos should be 10 to 15
/// degrees apart.
inline constexpr double kWideAzimuthGap = 20.0 * kRadiansPerDegree;

struct CameraRing {
  Vec3 block_centre = Vec3::Zero();     ///< centre of the block, in its frame
  std::vector<CameraPosition> cameras;  ///< one entry per photo, in their order
  std::vector<AzimuthGap> gaps;         ///< wider than `kWideAzimuthGap`, in order of azimuth
  double largest_gap = 0.0;             ///< width of the largest gap, rad; 2 pi without cameras
  double gap_azimuth = 0.0;             ///< azimuth of the centre of the largest gap, rad
};

/// Computes the positions of the cameras around a block, and the gaps between them.
/// @param block_from_model  transform from the camera model to the frame of the block, z up
CameraRing compute_camera_ring(const PhotoScan& scan, const Pose& block_from_model);

}  // namespace clast
