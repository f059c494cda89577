#include "samples/deposit/point_grid.hpp"

namespace clast {

PointGrid::PointGrid(double cell) : cell_(cell), first_(1024, kNoIndex) {}

std::uint32_t PointGrid::add(const Vec3& point) {
  if (points_.size() >= first_.size()) grow();
  const auto index = static_cast<std::uint32_t>(points_.size());
  cells_.push_back(cell_of(point));
  std::uint32_t& first = first_[bucket(cells_.back())];
  points_.push_back(point);
  next_.push_back(first);
  first = index;
  return index;
}

void PointGrid::grow() {
  first_.assign(4 * first_.size(), kNoIndex);
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    std::uint32_t& first = first_[bucket(cells_[i])];
    next_[i] = first;
    first = i;
  }
}

}  // namespace clast
