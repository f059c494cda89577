#include "reconstruct/photos/photo_summary.hpp"

#include <algorithm>

namespace clast {

namespace {

/// Why the scale does not rest on a marker that was found; empty where it does.
std::string unused_reason(const PhotoScan& scan, int id) {
  if (!scan.scale) return "its size is not known";
  const std::vector<int>& misplaced = scan.scale->misplaced;
  if (std::find(misplaced.begin(), misplaced.end(), id) != misplaced.end()) {
    return "left out: its position differs from that on the board";
  }
  bool measured = false;
  for (const ComparedLength& measure : scan.scale->measures) {
    const bool its =
        std::find(measure.markers.begin(), measure.markers.end(), id) != measure.markers.end();
    if (its && measure.used) return "";
    measured = measured || its;
  }
  return measured ? "left out: its size disagrees with the others"
                  : "no distance to this marker is known";
}

}  // namespace

PhotoSummary summarise_photos(const PhotoScan& scan, const FieldBlock& block,
                              const std::string& up) {
  const Pose turned{Vec3::Zero(), Quat(Eigen::AngleAxisd(0.5 * kPi, Vec3::UnitX()))};
  const Pose block_from_model = up == "y" ? block.block_from_file * turned : block.block_from_file;
  PhotoSummary evidence{compute_camera_ring(scan, block_from_model),
                        count_surface_views(block.scan.mesh, scan, block_from_model),
                        {},
                        {}};
  for (const std::uint16_t min_views : kCoverageSteps) {
    evidence.coverage.push_back(
        {min_views, observed_fraction(block.scan.mesh, evidence.views.photos, min_views),
         observed_fraction(block.scan.mesh, evidence.views.pairs, min_views)});
  }
  for (const LocatedMarker& marker : scan.markers.markers) {
    const std::string reason = unused_reason(scan, marker.id);
    evidence.markers.push_back(
        {marker.id, marker.photos, marker.error, marker.side(), reason.empty(), reason});
  }
  for (const UnlocatedMarker& marker : scan.markers.unlocated) {
    evidence.markers.push_back(
        {marker.id, marker.photos, 0.0, 0.0, false,
         "too few photos show it completely and sharply, or they contradict each other"});
  }
  std::sort(evidence.markers.begin(), evidence.markers.end(),
            [](const MarkerUsage& a, const MarkerUsage& b) { return a.id < b.id; });
  return evidence;
}

}  // namespace clast
