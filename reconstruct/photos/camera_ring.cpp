#include "reconstruct/photos/camera_ring.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clast {

CameraRing compute_camera_ring(const PhotoScan& scan, const Pose& block_from_model) {
  CameraRing ring;
  ring.block_centre = block_from_model * scan.cloud.region.centre;
  for (const Photo& photo : scan.model.photos) {
    const Vec3 out = block_from_model * photo.centre() - ring.block_centre;
    ring.cameras.push_back({photo.name, std::atan2(out.y(), out.x()),
                            std::atan2(out.z(), out.head<2>().norm()), out.norm(), 0, false});
  }
  for (const StereoPair& pair : scan.cloud.pairs) {
    ++ring.cameras[pair.first].pairs;
    ++ring.cameras[pair.second].pairs;
  }
  for (const std::size_t photo : scan.cloud.blurred) ring.cameras[photo].blurred = true;
  std::vector<std::size_t> compared;  // seats by azimuth
  for (std::size_t i = 0; i < ring.cameras.size(); ++i) {
    if (ring.cameras[i].pairs > 0) compared.push_back(i);
  }
  ring.largest_gap = 2.0 * kPi;
  if (compared.empty()) return ring;
  std::sort(compared.begin(), compared.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(ring.cameras[a].azimuth, a) < std::pair(ring.cameras[b].azimuth, b);
  });
  ring.largest_gap = 0.0;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const bool last = i + 1 == compared.size();
    const std::size_t first = compared[i], second = last ? compared.front() : compared[i + 1];
    const double from = ring.cameras[first].azimuth;
    const double width = ring.cameras[second].azimuth + (last ? 2.0 * kPi : 0.0) - from;
    if (width > kWideAzimuthGap) ring.gaps.push_back({first, second, from, width});
    if (width <= ring.largest_gap) continue;
    ring.largest_gap = width;
    const double half = from + 0.5 * width;
    ring.gap_azimuth = half > kPi ? half - 2.0 * kPi : half;
  }
  return ring;
}

}  // namespace clast
