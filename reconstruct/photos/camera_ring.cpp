#include "reconstruct/photos/camera_ring.hpp"

#include <algorithm>
#include <cmath>

namespace clast {

CameraRing camera_ring(const PhotoScan& scan, const Pose& block_from_model) {
  CameraRing ring;
  const Vec3 middle = block_from_model * scan.cloud.region.centre;
  for (const Photo& photo : scan.model.photos) {
    const Vec3 out = block_from_model * photo.centre() - middle;
    ring.seats.push_back({photo.name, std::atan2(out.y(), out.x()),
                          std::atan2(out.z(), out.head<2>().norm()), out.norm(), 0, false});
  }
  for (const StereoPair& pair : scan.cloud.pairs) {
    ++ring.seats[pair.first].pairs;
    ++ring.seats[pair.second].pairs;
  }
  for (const std::size_t photo : scan.cloud.blurred) ring.seats[photo].blurred = true;
  std::vector<double> azimuths;
  for (const CameraSeat& seat : ring.seats) {
    if (seat.pairs > 0) azimuths.push_back(seat.azimuth);
  }
  ring.largest_gap = 2.0 * kPi;
  if (azimuths.empty()) return ring;
  std::sort(azimuths.begin(), azimuths.end());
  azimuths.push_back(azimuths.front() + 2.0 * kPi);
  ring.largest_gap = 0.0;
  for (std::size_t i = 1; i < azimuths.size(); ++i) {
    const double gap = azimuths[i] - azimuths[i - 1];
    if (gap <= ring.largest_gap) continue;
    ring.largest_gap = gap;
    const double half = 0.5 * (azimuths[i] + azimuths[i - 1]);
    ring.gap_middle = half > kPi ? half - 2.0 * kPi : half;
  }
  return ring;
}

}  // namespace clast
