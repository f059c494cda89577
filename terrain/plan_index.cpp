#include "terrain/plan_index.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kMaxIndexCells = 4e7;

}  // namespace

PlanIndex::PlanIndex(std::span<const PlanBox> boxes) {
  if (boxes.empty()) return;
  for (const PlanBox& box : boxes) {
    extent_.include(box.low);
    extent_.include(box.high);
  }
  const Vec2 span = (extent_.high - extent_.low).cwiseMax(1e-9);
  const double cells = std::clamp(static_cast<double>(boxes.size()) / 2.0, 1.0, kMaxIndexCells);
  size_ = std::max(std::sqrt(span.prod() / cells), span.maxCoeff() / 30000.0);
  columns_ = static_cast<long>(span.x() / size_) + 1;
  rows_ = static_cast<long>(span.y() / size_) + 1;
  offsets_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  const auto each_cell = [&](const PlanBox& box, const auto& visit) {
    const Range cells_hit = range(box);
    for (long row = cells_hit.first_row; row <= cells_hit.last_row; ++row) {
      for (long column = cells_hit.first_column; column <= cells_hit.last_column; ++column) {
        visit(static_cast<std::size_t>(row * columns_ + column));
      }
    }
  };
  for (const PlanBox& box : boxes) {
    each_cell(box, [&](std::size_t cell) { ++offsets_[cell + 1]; });
  }
  for (std::size_t cell = 0; cell + 1 < offsets_.size(); ++cell) {
    offsets_[cell + 1] += offsets_[cell];
  }
  numbers_.resize(offsets_.back());
  std::vector<std::uint64_t> next(offsets_.begin(), offsets_.end() - 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    each_cell(boxes[i], [&](std::size_t cell) { numbers_[next[cell]++] = i; });
  }
}

PlanIndex::Range PlanIndex::range(const PlanBox& box) const {
  const auto cell = [&](double value, double corner, long count) {
    return static_cast<long>(
        std::clamp(std::floor((value - corner) / size_), 0.0, static_cast<double>(count - 1)));
  };
  return {cell(box.low.x(), extent_.low.x(), columns_),
          cell(box.high.x(), extent_.low.x(), columns_), cell(box.low.y(), extent_.low.y(), rows_),
          cell(box.high.y(), extent_.low.y(), rows_)};
}

std::span<const std::uint32_t> PlanIndex::boxes_near(const Vec2& point) const {
  if (offsets_.empty() || (point.array() < extent_.low.array()).any() ||
      (point.array() > extent_.high.array()).any()) {
    return {};
  }
  const Range home = range({point, point});
  const auto cell = static_cast<std::size_t>(home.first_row * columns_ + home.first_column);
  return {numbers_.data() + offsets_[cell], numbers_.data() + offsets_[cell + 1]};
}

std::vector<std::uint32_t> PlanIndex::boxes_near(const PlanBox& box) const {
  std::vector<std::uint32_t> found;
  if (offsets_.empty() || (box.high.array() < extent_.low.array()).any() ||
      (box.low.array() > extent_.high.array()).any()) {
    return found;
  }
  const Range cells = range(box);
  for (long row = cells.first_row; row <= cells.last_row; ++row) {
    for (long column = cells.first_column; column <= cells.last_column; ++column) {
      const auto cell = static_cast<std::size_t>(row * columns_ + column);
      found.insert(found.end(), numbers_.begin() + static_cast<std::ptrdiff_t>(offsets_[cell]),
                   numbers_.begin() + static_cast<std::ptrdiff_t>(offsets_[cell + 1]));
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<PlanBox> plan_boxes(const TriangleMesh& mesh) {
  std::vector<PlanBox> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) boxes[t].include(mesh.vertices[v].head<2>());
  }
  return boxes;
}

std::optional<double> height_on_triangle(const TriangleMesh& mesh, std::uint32_t triangle,
                                         const Vec2& at) {
  const auto& [ia, ib, ic] = mesh.triangles[triangle];
  const Vec3& a = mesh.vertices[ia];
  const Vec3 ab = mesh.vertices[ib] - a, ac = mesh.vertices[ic] - a;
  const Vec2 plan_ab = ab.head<2>(), plan_ac = ac.head<2>(), plan_at = at - a.head<2>();
  const double area = cross(plan_ab, plan_ac);
  if (area == 0.0) return std::nullopt;
  const double v = cross(plan_at, plan_ac) / area, w = cross(plan_ab, plan_at) / area;
  constexpr double kEdge = -1e-12;  // points on an edge belong to both sides
  if (v < kEdge || w < kEdge || v + w > 1.0 - kEdge) return std::nullopt;
  return a.z() + v * ab.z() + w * ac.z();
}

}  // namespace clast::terrain_detail
