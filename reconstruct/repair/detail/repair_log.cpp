#include "reconstruct/repair/detail/repair_log.hpp"

#include <algorithm>
#include <utility>

#include "core/number_text.hpp"

namespace clast::reconstruct_detail {

Vec3 RepairLog::to_reported_frame(const Vec3& local) const {
  const Vec3 there = local + origin_;
  return reported_place_ ? reported_place_(there) : there;
}

std::string RepairLog::format_position(const Vec3& local) const {
  return format_point(to_reported_frame(local));
}

void RepairLog::add_defect(DefectKind kind, std::size_t count, double area,
                           std::optional<Vec3> where, double size) {
  if (count == 0) return;
  if (where) where = to_reported_frame(*where);
  report.defects.push_back({kind, count, area / area_as_read, size, where});
}

void RepairLog::add_defect(DefectKind kind, const RepairChange& change) {
  add_defect(kind, change.count, change.area, change.position);
}

void RepairLog::add_duplicate(const DuplicateSurface& copy) {
  report.duplicates.push_back(copy);
  // One of the copies is the rock: the farthest from the one kept bounds it.
  report.volume_below = std::max(report.volume_below, -copy.volume_change);
  report.volume_above = std::max(report.volume_above, copy.volume_change);
}

void RepairLog::flip_orientation() {
  std::swap(report.volume_below, report.volume_above);
  for (FilledHole& hole : report.holes) std::swap(hole.volume_below, hole.volume_above);
}

void RepairLog::finish() {
  double filled = 0.0;
  for (const FilledHole& hole : report.holes) filled += hole.area_fraction;
  if (!report.holes.empty()) {
    report.defects.push_back({DefectKind::kHole, report.holes.size(), filled,
                              report.holes[0].radius, report.holes[0].centre});
  }
  std::stable_sort(report.defects.begin(), report.defects.end(),
                   [](const Defect& a, const Defect& b) { return a.kind < b.kind; });
}

}  // namespace clast::reconstruct_detail
