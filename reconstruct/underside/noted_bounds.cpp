#include "reconstruct/underside/noted_bounds.hpp"

#include <algorithm>
#include <vector>

#include "mesh/weld.hpp"
#include "reconstruct/cloud/outliers.hpp"
#include "reconstruct/underside/detail/unobserved_bounds.hpp"
#include "shapes/oriented_box.hpp"

namespace clast::reconstruct_detail {

namespace {

/// A place farther off the surface as read than this share of its diagonal was not scanned.
constexpr double kOnSurface = 1e-3;
/// A place between points that is farther from the nearest than so many spacings was not scanned:
/// the narrow end that a cloud has no points of may be closed by a few triangles hardly larger.
constexpr double kGap = 1.5;
/// A volume has no lower bound below this share of the best one.
constexpr double kMinVolumeLeft = 0.01;
/// Bounds closer to the volume, and to all sides, than these shares are not stated.
constexpr double kWorthStating = 0.005, kSidesWorthStating = 0.0075;
/// A cone on a whole side is three times as high as a slab of the same volume.
constexpr double kPointed = 3.0;

/// Widens the bounds by the volume difference of a copy of the surface.
void widen_for_copies(VolumeBracket& bounds, const RepairReport& report) {
  if (!bounds.sides || report.duplicates.empty()) return;
  const double below = report.volume_below / bounds.estimated_volume,
               above = report.volume_above / bounds.estimated_volume;
  bounds.sides->lower *= std::max(kMinVolumeLeft, 1.0 - kPointed * below);
  bounds.sides->upper *= 1.0 + kPointed * above;
}

bool worth_stating(const VolumeBracket& bounds, const Vec3& sides) {
  if (!bounds.upper_volume || !bounds.sides) return true;
  const double open = kWorthStating * bounds.estimated_volume;
  return bounds.estimated_volume - bounds.lower_volume > open ||
         *bounds.upper_volume - bounds.estimated_volume > open ||
         ((sides - bounds.sides->lower).array() > kSidesWorthStating * sides.array()).any() ||
         ((bounds.sides->upper - sides).array() > kSidesWorthStating * sides.array()).any();
}

std::vector<bool> mark_closures(const ClosedScan& scan) {
  std::vector<bool> closure(scan.surface.triangles.size(), false);
  if (scan.scanned == nullptr) return closure;
  for (std::size_t t = 0; t < closure.size(); ++t) {
    const auto& [a, b, c] = scan.surface.triangles[t];
    const std::vector<Vec3>& at = scan.surface.vertices;
    closure[t] = !scan.scanned->contains((at[a] + at[b] + at[c]) / 3.0);
  }
  return closure;
}

std::string assumption_of(const ClosedScan& scan, const RepairReport& report) {
  if (!report.duplicates.empty()) return "one of the copies of the surface is the rock";
  if (scan.uncertainty != nullptr)
    return "between the points the surface continues like the surrounding surface";
  return "behind a filled gap the surface continues like the surrounding surface";
}

}  // namespace

ScannedSurface::ScannedSurface(const TriangleMesh& raw) : surface_(weld_vertices(raw, 0.0)) {
  if (!surface_.triangles.empty()) tree_.emplace(surface_);
  reach_ = kOnSurface * bounds(surface_).diagonal();
}

ScannedSurface::ScannedSurface(std::span<const Vec3> points)
    : points_(points), spacings_(compute_local_spacings(points)) {}

bool ScannedSurface::contains(const Vec3& position) const {
  if (points_) {
    const PointTree::Neighbour near = points_->nearest_neighbours(position, 1)[0];
    return near.distance <= kGap * spacings_[near.point];
  }
  return tree_ && tree_->closest_point(position).squared_distance <= reach_ * reach_;
}

std::optional<VolumeBracketWithNotes> compute_closed_scan_bracket(const ClosedScan& scan,
                                                                  const RepairReport& report) {
  const std::vector<bool> closure = mark_closures(scan);
  const bool exact = std::find(closure.begin(), closure.end(), true) == closure.end();
  if (exact && scan.uncertainty == nullptr && report.duplicates.empty()) return std::nullopt;
  const UnobservedPartBounds found =
      bound_unobserved_parts(scan.surface, {closure, {}, false, scan.uncertainty});
  VolumeBracketWithNotes bounds{scaled(found, scan.unit),
                                describe_hollows(found.hollows, scan.unit)};
  bounds.lower_volume =
      std::max(std::min(bounds.lower_volume, bounds.estimated_volume - report.volume_below),
               kMinVolumeLeft * bounds.estimated_volume);
  if (bounds.upper_volume) {
    bounds.upper_volume =
        std::max(*bounds.upper_volume, bounds.estimated_volume + report.volume_above);
  }
  bounds.filled_fraction = report.filled_fraction;
  bounds.assumption = assumption_of(scan, report);
  widen_for_copies(bounds, report);
  if (!worth_stating(bounds, scan.unit * smallest_box(scan.surface.vertices).lengths)) {
    return std::nullopt;
  }
  return bounds;
}

VolumeBracket compute_underside_bracket(const Underside& side, const RepairReport& report) {
  VolumeBracket bounds = side;
  bounds.lower_volume =
      std::max(side.lower_volume - report.volume_below, kMinVolumeLeft * side.estimated_volume);
  if (bounds.upper_volume) *bounds.upper_volume += report.volume_above;
  widen_for_copies(bounds, report);
  return bounds;
}

}  // namespace clast::reconstruct_detail
