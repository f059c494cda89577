#include "reconstruct/deposit/detail/scan_extent.hpp"

#include <utility>

#include "mesh/triangle_mesh.hpp"
#include "shapes/convex_outline.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kBorderWidth = 3.0;   ///< in spacings
constexpr double kCutExtent = 0.4;     ///< extent of a cut over the diameter of the surface
constexpr double kFlankOutward = 0.6;  ///< mean outward component of the normals of a flank

/// Diagonal of the bounding box of points in plan, m.
class PlanExtent {
 public:
  void include(const Vec2& point) {
    low_ = low_.cwiseMin(point);
    high_ = high_.cwiseMax(point);
  }
  double diagonal() const { return (high_ - low_).norm(); }

 private:
  Vec2 low_ = Vec2::Constant(1e300), high_ = Vec2::Constant(-1e300);
};

}  // namespace

ScanExtent::ScanExtent(std::span<const Vec3> points) {
  Bounds box;
  std::vector<Vec2> plan;
  plan.reserve(points.size());
  for (const Vec3& p : points) {
    box.include(p);
    plan.emplace_back(p.head<2>());
  }
  middle_ = 0.5 * (box.low + box.high);
  outline_ = convex_hull_2d(std::move(plan));
}

bool ScanExtent::border_cuts(std::span<const SurfaceSample> surface, double spacing) const {
  if (outline_.size() < 3) return false;
  PlanExtent all, cut;
  double outward = 0.0;
  std::size_t count = 0;
  for (const SurfaceSample& s : surface) all.include(s.position.head<2>());
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const Vec2& from = outline_[i];
    const Vec2 side = outline_[(i + 1) % outline_.size()] - from;
    const Vec2 normal = Vec2(side.y(), -side.x()).normalized();
    for (const SurfaceSample& s : surface) {
      const Vec2 offset = s.position.head<2>() - from;
      const double along = offset.dot(side) / side.squaredNorm();
      if (normal.dot(offset) < -kBorderWidth * spacing || along < 0.0 || along > 1.0) continue;
      cut.include(s.position.head<2>());
      outward += normal.dot(s.normal.head<2>());
      ++count;
    }
  }
  return count > 0 && cut.diagonal() > kCutExtent * all.diagonal() &&
         outward < kFlankOutward * static_cast<double>(count);
}

}  // namespace clast::reconstruct_detail
