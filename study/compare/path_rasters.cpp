#include "study/compare/path_rasters.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/nice_number.hpp"
#include "study/compare/path_samples.hpp"

namespace clast {
namespace {

constexpr double kCells = 400.0;
constexpr double kNarrowestCell = 0.5;  ///< m

struct LargestInCell {
  double energy = 0.0;
  double speed = 0.0;
  double height = -INFINITY;
};
struct Passed {
  std::vector<double> energy, height;
  double speed = 0.0;
};

/// A cell suits where the runs began and ended; how far they strayed is not known before.
double path_cell_size(const Comparison& comparison) {
  Bounds box;
  for (const RunRow& row : comparison.rows) {
    if (row.start.allFinite()) box.include(row.start);
    if (row.stop.allFinite()) box.include(row.stop);
  }
  const double longer = (box.high - box.low).head<2>().maxCoeff();
  return std::max(kNarrowestCell, longer > 0.0 ? round_up_to_nice_number(longer / kCells) : 0.0);
}

/// Shares of the straight way between two places at which it enters another cell, ascending.
std::vector<double> entries(const Vec2& from, const Vec2& to, double size) {
  std::vector<double> shares;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = std::min(from[axis], to[axis]), high = std::max(from[axis], to[axis]);
    for (double line = std::ceil(low / size); line * size < high; ++line) {
      shares.push_back((line * size - from[axis]) / (to[axis] - from[axis]));
    }
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

/// The largest values of one run in the cells it comes over.
class CellsOfRun {
 public:
  CellsOfRun(const Vec2& origin, double size) : origin_(origin), size_(size) {}

  /// Takes the next place of the run, to which its values change evenly.
  void go_to(const PathSample& sample) {
    if (before_) {
      PathSample last = *before_;
      for (const double share : entries(place(last), place(sample), size_)) {
        const PathSample entered = between(*before_, sample, share);
        cross(last, entered);
        last = entered;
      }
      cross(last, sample);
    }
    cross(sample, sample);
    before_ = sample;
  }
  const std::map<MapCell, LargestInCell>& cells() const { return cells_; }

 private:
  Vec2 place(const PathSample& sample) const { return sample.position.head<2>() + origin_; }

  static PathSample between(const PathSample& a, const PathSample& b, double share) {
    return {a.position + share * (b.position - a.position), std::lerp(a.speed, b.speed, share),
            std::lerp(a.energy, b.energy, share), std::lerp(a.height, b.height, share)};
  }
  /// The way between two places of one cell.
  void cross(const PathSample& from, const PathSample& to) {
    const Vec2 middle = 0.5 * (place(from) + place(to)) / size_;
    LargestInCell& here =
        cells_[{std::llround(std::floor(middle.y())), std::llround(std::floor(middle.x()))}];
    for (const PathSample* end : {&from, &to}) {
      here.energy = std::max(here.energy, end->energy);
      here.speed = std::max(here.speed, end->speed);
      if (std::isfinite(end->height)) here.height = std::max(here.height, end->height);
    }
  }

  Vec2 origin_;
  double size_;
  std::optional<PathSample> before_;
  std::map<MapCell, LargestInCell> cells_;
};

std::map<MapCell, Passed> cell_passages(const Comparison& comparison, double size) {
  std::map<MapCell, Passed> cells;
  for_each_trajectory(comparison, [&](std::size_t index, const Trajectory& trajectory,
                                      const TerrainSurface& ground) {
    const RunRow& row = comparison.rows[index];
    CellsOfRun run(comparison.results[row.file].frame.origin.head<2>(), size);
    for_each_path_sample(trajectory, *row.block, ground, 0.5 * size,
                         [&](const PathSample& sample) { run.go_to(sample); });
    for (const auto& [cell, largest] : run.cells()) {
      Passed& passed = cells[cell];
      passed.energy.push_back(largest.energy);
      if (std::isfinite(largest.height)) passed.height.push_back(largest.height);
      passed.speed = std::max(passed.speed, largest.speed);
    }
  });
  return cells;
}

}  // namespace

MapRasterSet compute_path_rasters(const Comparison& comparison) {
  MapRasterSet rasters;
  rasters.cell_size = path_cell_size(comparison);
  const std::map<MapCell, Passed> cells = cell_passages(comparison, rasters.cell_size);
  if (cells.empty()) return rasters;
  std::vector<MapCell> covered;
  for (const auto& [cell, passed] : cells) covered.push_back(cell);
  rasters = rasterize_cells(
      covered, rasters.cell_size,
      {{"Reach_probability", "fraction of the runs that pass the cell", {}},
       {"Nr_passages", "runs that pass the cell", {}},
       {"E_mean", "mean over runs of the largest kinetic energy in the cell, J", {}},
       {"E_95", "95 % quantile over runs of the largest kinetic energy in the cell, J", {}},
       {"E_max", "largest kinetic energy in the cell, J", {}},
       {"Ph_95", "95 % quantile over runs of the largest height of the centre above ground, m", {}},
       {"V_max", "largest speed of the centre in the cell, m/s", {}}});
  const double started = static_cast<double>(comparison.rows.size());
  for (const auto& [cell, passed] : cells) {
    const std::size_t at = rasters.index(cell);
    const SampleSummary energy = summarise_sample(passed.energy);
    const double count = static_cast<double>(passed.energy.size());
    const double height = passed.height.empty() ? NAN : summarise_sample(passed.height).p95;
    const double values[] = {count / started, count,  energy.mean, energy.p95,
                             energy.max,      height, passed.speed};
    for (std::size_t i = 0; i < rasters.layers.size(); ++i) {
      rasters.layers[i].values[at] = static_cast<float>(values[i]);
    }
  }
  return rasters;
}

}  // namespace clast
