#pragma once
/// Where photos were taken from, for the page about a block.
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "reconstruct/photos/photo_scan.hpp"

namespace clast {

/// A camera as seen from the block.
struct CameraPosition {
  std::string name;
  double azimuth = 0.0;    ///< from x towards y, -pi to pi, rad
  double elevation = 0.0;  ///< above the horizon, rad
  double distance = 0.0;   ///< from the middle of the block, m
  std::size_t pairs = 0;   ///< in which the photo was compared
  bool blurred = false;
};

/// A stretch of azimuth without a compared photo.
struct AzimuthGap {
  std::size_t first = 0, second = 0;  ///< seats at its ends
  double from = 0.0;                  ///< azimuth of the first, rad
  double width = 0.0;                 ///< rad
};

/// Wider ones are named: photos are best 10 to 15 degrees apart.
inline constexpr double kWideAzimuthGap = 20.0 * kRadiansPerDegree;

struct CameraRing {
  Vec3 middle = Vec3::Zero();     ///< of the block, in its frame
  std::vector<CameraPosition> cameras;  ///< in order of the photos
  std::vector<AzimuthGap> gaps;      ///< wider than `kWideAzimuthGap`, in order of azimuth
  double largest_gap = 0.0;       ///< of azimuth without a compared photo, rad; 2 pi with none
  double gap_azimuth = 0.0;        ///< azimuth in its middle, rad
};

/// @param block_from_model  to the frame of the block, z up, from that of the cameras
CameraRing compute_camera_ring(const PhotoScan& scan, const Pose& block_from_model);

}  // namespace clast
