#include "study/simulate/detail/block_packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/plan_geometry.hpp"
#include "study/campaign/plan_polygon.hpp"

namespace clast::study_detail {
namespace {

/// Places where the block fits that are compared, and draws that are made to find them.
constexpr int kComparedPlaces = 60, kPlaceDraws = 1000;
/// A start may overlap the ground by this share of S, half of what the dynamics accepts.
constexpr double kStartOverlap = 0.5e-3;
/// Highest ground is looked for at so many points across a cell.
constexpr int kSamples = 3;

/// Highest ground in a cell.
/// @throws InputError  there is none somewhere in it
double highest_ground(const TerrainSurface& ground, std::int64_t i, std::int64_t j, double width) {
  const double sky = ground.extent().high.z() + ground.radius() + 1.0;
  double highest = -std::numeric_limits<double>::infinity();
  for (int a = 0; a < kSamples; ++a) {
    for (int b = 0; b < kSamples; ++b) {
      const double x = (static_cast<double>(i) + a / (kSamples - 1.0)) * width;
      const double y = (static_cast<double>(j) + b / (kSamples - 1.0)) * width;
      const std::optional<double> here = ground.height_at(x, y, sky);
      if (!here) {
        throw InputError("the polygon reaches beyond the terrain, or over a hole in it");
      }
      highest = std::max(highest, *here);
    }
  }
  return highest;
}

}  // namespace

BlockPacking::BlockPacking(const TerrainSurface& ground, std::span<const Vec2> outline,
                           double width)
    : width_(width) {
  check_has_area(outline);
  Bounds box;
  for (const Vec2& corner : outline) box.include({corner.x(), corner.y(), 0.0});
  const auto cell_of = [&](double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / width_));
  };
  first_i_ = cell_of(box.low.x());
  first_j_ = cell_of(box.low.y());
  columns_ = cell_of(box.high.x()) - first_i_ + 1;
  rows_ = cell_of(box.high.y()) - first_j_ + 1;
  for (std::int64_t j = first_j_; j < first_j_ + rows_; ++j) {
    for (std::int64_t i = first_i_; i < first_i_ + columns_; ++i) {
      const Vec2 centre = width_ * Vec2(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
      cells_.emplace_back();
      if (!is_inside(outline, centre)) continue;
      inside_.push_back(cells_.size() - 1);
      const double height = highest_ground(ground, i, j, width_);
      cells_.back() = Cell{height, height};
    }
  }
  if (inside_.empty()) throw InputError("the polygon is too narrow for any block");
}

void BlockPacking::clear() {
  for (const std::size_t at : inside_) cells_[at]->top = cells_[at]->ground;
}

const BlockPacking::Cell* BlockPacking::find(std::int64_t i, std::int64_t j) const {
  i -= first_i_;
  j -= first_j_;
  if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return nullptr;
  const std::optional<Cell>& cell = cells_[static_cast<std::size_t>(j * columns_ + i)];
  return cell ? &*cell : nullptr;
}

std::optional<double> BlockPacking::find_rest_height(std::span<const CoveredCell> covered,
                                                     std::int64_t move_i, std::int64_t move_j,
                                                     std::optional<double> thickness) const {
  double height = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();  // that the thickness allows
  for (const CoveredCell& cell : covered) {
    const Cell* below = find(cell.i + move_i, cell.j + move_j);
    if (!below) return std::nullopt;
    height = std::max(height, below->top - cell.lowest);
    if (thickness) highest = std::min(highest, below->ground + *thickness - cell.highest);
  }
  if (height > highest) return std::nullopt;
  return height;
}

std::optional<RigidState> BlockPacking::place(const RigidBody& body, const GroundOverlap& overlap,
                                              const Quat& orientation,
                                              std::optional<double> thickness, Random& random) {
  RigidState state;
  state.orientation = orientation.normalized();
  // The centre is in the middle of a cell.
  state.position = {0.5 * width_, 0.5 * width_, 0.0};
  const std::vector<CoveredCell> covered = compute_covered_cells(
      core_mesh(body.shape), body.shape.radius, state.world_from_body(), width_);
  struct Place {
    std::int64_t i = 0, j = 0;
    double height = 0.0;
    double above = std::numeric_limits<double>::infinity();
  } best;
  int found = 0;
  for (int draw = 0; draw < kPlaceDraws && found < kComparedPlaces; ++draw) {
    const auto at = static_cast<std::int64_t>(inside_[random.uniform_index(inside_.size())]);
    const std::int64_t i = first_i_ + at % columns_, j = first_j_ + at / columns_;
    const std::optional<double> height = find_rest_height(covered, i, j, thickness);
    if (!height) continue;
    ++found;
    const double above = *height - find(i, j)->ground;
    if (above < best.above) best = {i, j, *height, above};
  }
  if (found == 0) return std::nullopt;
  state.position +=
      Vec3(static_cast<double>(best.i) * width_, static_cast<double>(best.j) * width_, best.height);
  // Ground can be higher between the points that were looked at.
  const double allowed = kStartOverlap * body.size();
  for (double depth; (depth = overlap.max_overlap(state)) > allowed;) state.position.z() += depth;
  for (const CoveredCell& cell : covered) {
    const std::int64_t i = cell.i + best.i - first_i_, j = cell.j + best.j - first_j_;
    Cell& below = *cells_[static_cast<std::size_t>(j * columns_ + i)];
    below.top = std::max(below.top, cell.highest + state.position.z());
  }
  return state;
}

double BlockPacking::overlapping_area(const BlockPacking& other) const {
  std::size_t common = 0;
  for (const std::size_t cell : inside_) {
    const auto at = static_cast<std::int64_t>(cell);
    if (other.find(first_i_ + at % columns_, first_j_ + at / columns_)) ++common;
  }
  return static_cast<double>(common) * width_ * width_;
}

HeapExtent BlockPacking::heap_extent() const {
  HeapExtent filling;
  double sum = 0.0;
  for (const std::size_t at : inside_) {
    const double thickness = cells_[at]->top - cells_[at]->ground;
    sum += thickness;
    filling.largest_thickness = std::max(filling.largest_thickness, thickness);
  }
  const auto count = static_cast<double>(inside_.size());
  filling.area = count * width_ * width_;
  filling.mean_thickness = sum / count;
  return filling;
}

}  // namespace clast::study_detail
