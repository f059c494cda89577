#include "terrain/input/detail/fill_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast::terrain_detail {
namespace {

// Heights beyond are none.
constexpr double kHighest = 12000.0;      // m
constexpr double kUsualNoData = -9999.0;  // m, deep under any slope
/// Sizes of the numbers that programs write where there is no height.
constexpr std::array<double, 17> kFillSizes = {0.0,    99.0,   99.9,   99.99,   100.0,  500.0,
                                               999.0,  999.9,  999.99, 999.999, 1000.0, 1111.0,
                                               5000.0, 9999.0, 9999.9, 9999.99, 10000.0};
/// The sea is at 0, with cliffs that are lower than this, m.
constexpr double kMaxCliffHeight = 100.0;
/// A lowest or highest height counts as repeated from so many cells on.
constexpr std::size_t kRepeated = 4;
/// Steps around fill over the mean step between cells.
constexpr double kStepRatio = 10.0;

bool is_usual_fill(double value) {
  // Most positive numbers are heights as any other.
  if (value > 0.0 && value != 999.0 && value != 9999.0) return false;
  return std::any_of(kFillSizes.begin(), kFillSizes.end(),
                     [&](double fill) { return std::abs(std::abs(value) - fill) <= 1e-6 * fill; });
}

/// Cells of one value, and what surrounds them.
struct FillCells {
  std::size_t count = 0;
  std::size_t first = 0;      ///< index of a cell
  std::vector<double> steps;  ///< to heights of other values beside them, m
};

/// Heights other than those of the candidates.
struct OtherHeights {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::size_t count = 0;
  double step_sum = 0.0;
  std::size_t steps = 0;

  double mean_step() const { return steps > 0 ? step_sum / static_cast<double>(steps) : 0.0; }
  /// Distance of a value outside the range; 0 inside.
  double gap(double value) const { return std::max({low - value, value - high, 0.0}); }
};

using Candidates = std::map<double, FillCells>;

Candidates fill_candidates(const HeightGrid& grid) {
  Candidates found;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double height : grid.heights) {
    if (!std::isfinite(height)) continue;
    low = std::min(low, height);
    high = std::max(high, height);
  }
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    const double height = grid.heights[i];
    if (!std::isfinite(height)) continue;
    if (height != low && height != high && !is_usual_fill(height)) continue;
    FillCells& cells = found[height == 0.0 ? 0.0 : height];
    if (cells.count++ == 0) cells.first = i;
  }
  std::erase_if(found, [](const auto& candidate) {
    return !is_usual_fill(candidate.first) && candidate.second.count < kRepeated;
  });
  return found;
}

/// Fills the steps around the candidates.
OtherHeights survey_steps(const HeightGrid& grid, Candidates& candidates) {
  OtherHeights others;
  const auto cells_of = [&](double height) -> FillCells* {
    const auto found = candidates.find(height);
    return found == candidates.end() ? nullptr : &found->second;
  };
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    const double here = grid.heights[i];
    if (!std::isfinite(here)) continue;
    FillCells* const fill = cells_of(here);
    if (!fill) {
      ++others.count;
      others.low = std::min(others.low, here);
      others.high = std::max(others.high, here);
    }
    const auto visit = [&](std::size_t beside) {
      const double there = grid.heights[beside];
      if (!std::isfinite(there)) return;
      FillCells* const other_fill = cells_of(there);
      const double step = std::abs(there - here);
      if (!fill && !other_fill) {
        others.step_sum += step;
        ++others.steps;
      } else if (fill && !other_fill) {
        fill->steps.push_back(step);
      } else if (other_fill && !fill) {
        other_fill->steps.push_back(step);
      }
    };
    if (i % grid.columns + 1 < grid.columns) visit(i + 1);
    if (i + grid.columns < grid.heights.size()) visit(i + grid.columns);
  }
  return others;
}

std::string with_number(std::string advice, const std::string& number) {
  for (std::size_t at; (at = advice.find("NUMBER")) != std::string::npos;) {
    advice.replace(at, 6, number);
  }
  return advice;
}

std::string cell_place(const HeightGrid& grid, std::size_t cell) {
  const Vec2 centre = grid.centre(cell % grid.columns, cell / grid.columns);
  return format_map_point({centre.x(), centre.y(), grid.heights[cell]});
}

/// Numbers that are heights nowhere, however few or many there are.
void refuse_impossible(const HeightGrid& grid, const std::filesystem::path& path,
                       const DeclaredFillValue& rules) {
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    const double height = grid.heights[i];
    if (!std::isfinite(height) || (std::abs(height) <= kHighest && height != kUsualNoData)) {
      continue;
    }
    const std::string number = format_significant(height, 9);
    throw InputError(path.string() + ": the height at " + cell_place(grid, i) +
                     " m is not a height on Earth. If " + number + " stands for no data, " +
                     with_number(rules.advice, number));
  }
}

/// True if a fill value is too far from all other heights to be one of them.
/// @param gap  to the nearest of the others, m
bool is_far(double value, double gap, double span) {
  return gap > span && (value != 0.0 || gap > kMaxCliffHeight);
}

}  // namespace

void PointFillValueCheck::include(double height) {
  if (is_usual_fill(height)) {
    ++fills_[height == 0.0 ? 0.0 : height];
    return;
  }
  low_ = std::min(low_, height);
  high_ = std::max(high_, height);
}

void PointFillValueCheck::include(const PointFillValueCheck& other) {
  for (const auto& [value, count] : other.fills_) fills_[value] += count;
  low_ = std::min(low_, other.low_);
  high_ = std::max(high_, other.high_);
}

void PointFillValueCheck::check(const std::filesystem::path& path) const {
  if (!(low_ <= high_)) return;
  for (const auto& [value, count] : fills_) {
    const double gap = std::max({low_ - value, value - high_, 0.0});
    if (!is_far(value, gap, high_ - low_)) continue;
    const std::string number = format_significant(value, 9);
    throw InputError(path.string() + ": " + format_count(count, "point has", "points have") +
                     " the height " + number + " m, " + format_significant(gap, 4) + " m " +
                     (value < low_ ? "below" : "above") + " all others. If " + number +
                     " stands for no data, leave out the points with that height");
  }
}

std::vector<std::string> check_fill_values(const HeightGrid& grid,
                                           const std::filesystem::path& path,
                                           const DeclaredFillValue& rules) {
  refuse_impossible(grid, path, rules);
  std::vector<std::string> notes;
  Candidates candidates = fill_candidates(grid);
  const OtherHeights others = survey_steps(grid, candidates);
  if (!(others.low <= others.high)) return notes;
  for (auto& [value, cells] : candidates) {
    const double gap = others.gap(value);
    std::vector<double>& steps = cells.steps;
    std::sort(steps.begin(), steps.end());
    const double median = steps.empty() ? gap : steps[steps.size() / 2];
    const bool far = is_far(value, gap, others.high - others.low);
    const bool stepped = cells.count <= others.count && median > kStepRatio * others.mean_step();
    if (!(is_usual_fill(value) && far) && !stepped) continue;
    const std::string number = format_significant(value, 9);
    const std::string text =
        path.string() + ": " + format_count(cells.count, "cell has", "cells have") +
        " the height " + number + " m, " +
        (gap > 0.0 ? format_significant(gap, 4) + " m " + (value < others.low ? "below" : "above") +
                         " all others"
                   : format_significant(median, 4) + " m from those of the neighbouring cells") +
        ", one at " + cell_place(grid, cells.first) + ". If " + number + " stands for no data, " +
        with_number(rules.advice, number);
    if (is_usual_fill(value) && far && !rules.declared) throw InputError(text);
    notes.push_back(text);
  }
  return notes;
}

}  // namespace clast::terrain_detail
