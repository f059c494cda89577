#include "reconstruct/photos/camera_ring.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clast {

CameraRing camera_ring(const PhotoScan& scan, const Pose& block_from_model) {
  CameraRing ring;
  ring.middle = block_from_model * scan.cloud.region.centre;
  for (const Photo& photo : scan.model.photos) {
    const Vec3 out = block_from_model * photo.centre() - ring.middle;
    ring.seats.push_back({photo.name, std::atan2(out.y(), out.x()),
                          std::atan2(out.z(), out.head<2>().norm()), out.norm(), 0, false});
  }
  for (const StereoPair& pair : scan.cloud.pairs) {
    ++ring.seats[pair.first].pairs;
    ++ring.seats[pair.second].pairs;
  }
  for (const std::size_t photo : scan.cloud.blurred) ring.seats[photo].blurred = true;
  std::vector<std::size_t> compared;  // seats by azimuth
  for (std::size_t i = 0; i < ring.seats.size(); ++i) {
    if (ring.seats[i].pairs > 0) compared.push_back(i);
  }
  ring.largest_gap = 2.0 * kPi;
  if (compared.empty()) return ring;
  std::sort(compared.begin(), compared.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(ring.seats[a].azimuth, a) < std::pair(ring.seats[b].azimuth, b);
  });
  ring.largest_gap = 0.0;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const bool last = i + 1 == compared.size();
    const std::size_t first = compared[i], second = last ? compared.front() : compared[i + 1];
    const double from = ring.seats[first].azimuth;
    const double width = ring.seats[second].azimuth + (last ? 2.0 * kPi : 0.0) - from;
    if (width > kWideGap) ring.gaps.push_back({first, second, from, width});
    if (width <= ring.largest_gap) continue;
    ring.largest_gap = width;
    const double half = from + 0.5 * width;
    ring.gap_middle = half > kPi ? half - 2.0 * kPi : half;
  }
  return ring;
}

}  // namespace clast
