#include "report/scans/unobserved_surface.hpp"

namespace clast::report_detail {

UnobservedSurface::UnobservedSurface(const FieldBlock& block, const TriangleMesh& read)
    : block_(block), reach_(kNewSurfaceDistance * bounds(block.scan.mesh).diagonal()) {
  if (!read.triangles.empty()) scanned_ = std::make_unique<TriangleTree>(read);
  if (block.underside) {
    best_ = std::make_unique<TriangleTree>(block.underside->best_estimate);
  }
}

bool UnobservedSurface::contains(std::uint32_t triangle) {
  if (answers_.empty()) answers_.assign(block_.scan.mesh.triangles.size(), -1);
  signed char& answer = answers_[triangle];
  if (answer < 0) answer = is_unobserved(triangle) ? 1 : 0;
  return answer == 1;
}

bool UnobservedSurface::contains(const Vec3& place) {
  if (!surface_) surface_ = std::make_unique<TriangleTree>(block_.scan.mesh);
  surface_hint_ = surface_->closest_point(place, surface_hint_).triangle;
  return contains(surface_hint_);
}

bool UnobservedSurface::is_unobserved(std::uint32_t triangle) {
  const TriangleMesh& mesh = block_.scan.mesh;
  const auto& [a, b, c] = mesh.triangles[triangle];
  if (block_.in_deposit && !block_.in_deposit->is_observed.empty()) {
    const std::vector<bool>& is_observed = block_.in_deposit->is_observed;
    return is_observed[a] + is_observed[b] + is_observed[c] < 2;
  }
  const Vec3 middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
  if (best_) {
    best_hint_ = best_->closest_point(middle, best_hint_).triangle;
    if (best_hint_ >= block_.underside->first_filling) return true;
  }
  if (!scanned_) return false;
  const auto closest = scanned_->closest_point(middle, scan_hint_);
  scan_hint_ = closest.triangle;
  return closest.squared_distance > reach_ * reach_;
}

}  // namespace clast::report_detail
