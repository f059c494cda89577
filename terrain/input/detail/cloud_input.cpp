#include "terrain/input/detail/cloud_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "mesh/point_cloud.hpp"
#include "terrain/gdal/gdal_raster.hpp"
#include "terrain/input/detail/fill_values.hpp"
#include "terrain/input/detail/grid_holes.hpp"

namespace clast::terrain_detail {
namespace {

namespace fs = std::filesystem;

constexpr double kMaxCloudCells = 2e9;
constexpr std::uint32_t kMaxHeights = 64;  // kept per cell
constexpr double kPinholes = 3.0;          // cells: holes up to this are filled by default
constexpr long kOutlierReach = 2;          // cells on every side whose medians are compared
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Cells on multiples of their size that cover a plan box.
struct Cells {
  double size;
  Vec2 first;
  std::size_t columns, rows;

  Cells(const Vec2& low, const Vec2& high, double cell, const fs::path& path)
      : size(cell), first((low / cell).array().floor()) {
    const Vec2 count = (high / cell).array().floor() - first.array() + 1.0;
    if (!(count.prod() < kMaxCloudCells)) {
      throw InputError(path.string() + ": cells of " + format_significant(cell, 6) + " m over " +
                       format_significant((high - low).x(), 6) + " x " +
                       format_significant((high - low).y(), 6) +
                       " m are too many; use a larger `resolution`");
    }
    columns = static_cast<std::size_t>(count.x());
    rows = static_cast<std::size_t>(count.y());
  }
  std::size_t count() const { return columns * rows; }
  std::size_t at(const Vec3& point) const {
    const auto column = static_cast<std::size_t>(std::floor(point.x() / size) - first.x());
    const auto row = static_cast<std::size_t>(std::floor(point.y() / size) - first.y());
    return row * columns + column;
  }
  HeightGrid grid() const {
    return {.columns = columns,
            .rows = rows,
            .first_centre = (first + Vec2(0.5, 0.5)) * size,
            .cell_size = {size, size},
            .heights = std::vector<double>(count(), 0.0)};
  }
};

/// Selects points of a classified cloud by ASPRS class.
using Classes = std::array<bool, 256>;

/// Streams a cloud file repeatedly.
struct Cloud {
  CloudFile file;
  bool y_up = false;
  std::optional<Classes> kept = {};  ///< none: all points count

  template <class Take>  // Take(const Vec3&), on the map, z up
  CloudSummary each_point(const Take& take) const {
    return file.stream([&](const PointBatch& batch) {
      for (std::size_t i = 0; i < batch.points.size(); ++i) {
        if (kept && !(*kept)[batch.classes[i]]) continue;
        take(y_up ? y_up_to_z_up(batch.points[i]) : batch.points[i]);
      }
    });
  }
};

struct Survey {
  std::vector<Cloud> clouds;
  Bounds box;
  std::size_t points = 0;
};

/// Points of one class.
struct ClassSurvey {
  std::size_t points = 0;
  Bounds box;
  PointFillValueCheck heights = {};

  void include(const Vec3& point) {
    ++points;
    box.include(point);
    heights.include(point.z());
  }
  void include(const ClassSurvey& other) {
    if (other.points == 0) return;
    points += other.points;
    box.include(other.box.low);
    box.include(other.box.high);
    heights.include(other.heights);
  }
};

/// Vegetation, buildings, wires, towers and bridges (LAS 1.4 R15, table 17).
bool is_above_ground(std::size_t asprs_class) {
  return (asprs_class >= 3 && asprs_class <= 6) || (asprs_class >= 13 && asprs_class <= 17);
}

/// Classes that are ground: class 2; where no point has it, all but what is known to stand on the
/// ground. None: the cloud is not classified.
/// @throws InputError  nothing but what stands on the ground
std::optional<Classes> ground_classes(const std::vector<ClassSurvey>& by_class,
                                      const fs::path& path, std::vector<std::string>& notes) {
  constexpr std::size_t kUnclassified = 1;  // and never classified, 0
  Classes kept{};
  std::size_t left_out = 0, left = 0;
  std::string present;
  bool classified = false;
  const bool has_ground = by_class[kGroundClass].points > 0;
  for (std::size_t c = 0; c < by_class.size(); ++c) {
    if (by_class[c].points == 0) continue;
    classified = classified || c > kUnclassified;
    present += (present.empty() ? "" : ", ") + std::to_string(c);
    kept[c] = has_ground ? c == kGroundClass : !is_above_ground(c);
    (kept[c] ? left : left_out) += by_class[c].points;
  }
  if (!classified) return std::nullopt;
  if (has_ground) {
    if (left_out > 0) {
      notes.push_back(path.string() + ": " + std::to_string(left_out) +
                      " points not classed as ground were left out");
    }
    return kept;
  }
  const std::string problem =
      path.string() + ": its points have the classes " + present + ", and none is ground (2)";
  const std::string advice = "classify the ground first (pdal translate, filters.smrf)";
  if (left == 0) {
    throw InputError(problem + "; all are vegetation, buildings, wires or bridges: " + advice);
  }
  notes.push_back(problem + "; " + std::to_string(left_out) +
                  " points of vegetation, buildings, wires and bridges were left out and all other "
                  "points were used as ground: " +
                  advice);
  return kept;
}

/// Refuses a cloud that is not in metres on the map of those before it.
void check_cloud_map(const fs::path& path, const CloudSummary& summary, const Vec2& centre,
                     CloudGrid& result) {
  const LengthUnitRequirements metres{
      .conversion_command = "pdal translate, filters.reprojection, EPSG:CODE",
      .correction_command = "pdal translate, writers.las.a_srs=EPSG:CODE"};
  for (const std::string& note :
       check_length_units(path.string(), summary.unit_declarations, metres)) {
    result.notes.push_back(path.string() + ": " + note);
  }
  check_map_scale(path.string(), summary.crs, centre, metres.conversion_command);
  const std::string crs = normalised_crs(summary.crs);
  if (!result.crs.empty() && !crs.empty() && !is_same_crs(result.crs, crs)) {
    throw InputError(path.string() + ": is in " + reference_system_name(crs) +
                     ", the clouds before it in " + reference_system_name(result.crs) +
                     "; convert them to one map system");
  }
  if (!crs.empty()) result.crs = crs;
}

/// First reading: where the points are, how many, and whether ground is classed.
Survey surveyed(const TerrainOptions& options, CloudGrid& result) {
  Survey survey;
  for (const fs::path& path : options.surface) {
    Cloud cloud{.file = CloudFile(path, options.columns), .y_up = options.up == "y"};
    ClassSurvey all;
    std::vector<ClassSurvey> by_class(std::tuple_size_v<Classes>);
    const CloudSummary summary = cloud.file.stream([&](const PointBatch& batch) {
      for (std::size_t i = 0; i < batch.points.size(); ++i) {
        const Vec3 point = cloud.y_up ? y_up_to_z_up(batch.points[i]) : batch.points[i];
        all.include(point);
        if (!batch.classes.empty()) by_class[batch.classes[i]].include(point);
      }
    });
    check_cloud_map(path, summary, (all.box.low + all.box.high).head<2>() / 2.0, result);
    const auto note = [&](std::size_t count, const std::string& what) {
      if (count > 0) result.notes.push_back(path.string() + ": " + std::to_string(count) + what);
    };
    note(summary.withheld_points, " points flagged as noise or withheld were left out");
    note(summary.non_finite_points, " points without finite coordinates were left out");
    cloud.kept = ground_classes(by_class, path, result.notes);
    ClassSurvey kept = all;
    if (cloud.kept) {
      kept = {};
      for (std::size_t c = 0; c < by_class.size(); ++c) {
        if ((*cloud.kept)[c]) kept.include(by_class[c]);
      }
    }
    kept.heights.check(path);
    survey.points += kept.points;
    survey.box.include(kept.box.low);
    survey.box.include(kept.box.high);
    survey.clouds.push_back(std::move(cloud));
  }
  return survey;
}

/// About four points per cell over the plan box, rounded up to 1, 2 or 5 times a power of ten.
double default_cell(const Survey& survey) {
  const double area = (survey.box.high - survey.box.low).head<2>().prod();
  const double wanted = 2.0 * std::sqrt(area / static_cast<double>(survey.points));
  if (!(wanted > 0.0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * decade >= wanted * (1.0 - 1e-9)) return digit * decade;
  }
  return 10.0 * decade;
}

/// Linear between the sorted heights, as spreadsheets do it; `heights` are put in order.
double percentile_of(std::span<double> heights, double percentile) {
  std::sort(heights.begin(), heights.end());
  const double rank = percentile / 100.0 * static_cast<double>(heights.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  if (below + 1 >= heights.size()) return heights.back();
  return heights[below] + (rank - std::floor(rank)) * (heights[below + 1] - heights[below]);
}

/// Heights of the points of every cell, at most `kMaxHeights` of each.
struct CellHeights {
  std::vector<std::uint64_t> offsets;
  std::vector<double> heights;

  std::span<double> of(std::size_t cell) {
    return {heights.data() + offsets[cell], heights.data() + offsets[cell + 1]};
  }
};

CellHeights cell_heights(const Survey& survey, const Cells& cells,
                         const std::vector<std::uint32_t>& hits) {
  CellHeights result;
  result.offsets.assign(hits.size() + 1, 0);
  for (std::size_t c = 0; c < hits.size(); ++c) {
    result.offsets[c + 1] = result.offsets[c] + std::min(hits[c], kMaxHeights);
  }
  result.heights.resize(result.offsets.back());
  std::vector<std::uint32_t> seen(hits.size(), 0);
  for (const Cloud& cloud : survey.clouds) {
    cloud.each_point([&](const Vec3& point) {
      const std::size_t c = cells.at(point);
      const std::uint64_t k = seen[c]++, kept = std::min(hits[c], kMaxHeights);
      // The k-th of n goes to place k kept / n, and the last to come to a place stays there.
      result.heights[result.offsets[c] + k * kept / hits[c]] = point.z();
    });
  }
  return result;
}

/// Drops the heights that are farther than `distance` from the median of the cell medians around.
void drop_outliers(CellHeights& stored, const Cells& cells, double distance, const fs::path& path,
                   std::vector<std::string>& notes) {
  std::vector<double> medians(cells.count(), kUnknown);
  for (std::size_t c = 0; c < medians.size(); ++c) {
    if (!stored.of(c).empty()) medians[c] = percentile_of(stored.of(c), 50.0);
  }
  std::size_t low = 0, high = 0, write = 0;
  double farthest = 0.0;
  Vec3 farthest_at = Vec3::Zero();
  const long columns = static_cast<long>(cells.columns), rows = static_cast<long>(cells.rows);
  std::vector<double> around;
  for (std::size_t c = 0; c < medians.size(); ++c) {
    const std::uint64_t begin = stored.offsets[c], end = stored.offsets[c + 1];
    stored.offsets[c] = write;
    if (begin == end) continue;
    const long i = static_cast<long>(c) % columns, j = static_cast<long>(c) / columns;
    around.clear();
    for (long dj = -kOutlierReach; dj <= kOutlierReach; ++dj) {
      for (long di = -kOutlierReach; di <= kOutlierReach; ++di) {
        if (i + di < 0 || j + dj < 0 || i + di >= columns || j + dj >= rows) continue;
        const double median = medians[static_cast<std::size_t>((j + dj) * columns + i + di)];
        if (std::isfinite(median)) around.push_back(median);
      }
    }
    const double ground = percentile_of(around, 50.0);
    for (std::uint64_t k = begin; k < end; ++k) {
      const double off = stored.heights[k] - ground;
      if (std::abs(off) <= distance) {
        stored.heights[write++] = stored.heights[k];
        continue;
      }
      ++(off < 0.0 ? low : high);
      if (std::abs(off) <= farthest) continue;
      farthest = std::abs(off);
      const Vec2 centre =
          (cells.first + Vec2(0.5 + static_cast<double>(i), 0.5 + static_cast<double>(j))) *
          cells.size;
      farthest_at = {centre.x(), centre.y(), stored.heights[k]};
    }
  }
  stored.offsets.back() = write;
  if (write == 0) {
    throw InputError(path.string() + ": all points are outliers by more than " +
                     format_significant(distance, 6) + " m; use a larger `outliers`");
  }
  if (low + high == 0) return;
  notes.push_back(path.string() + ": " + std::to_string(low) + " points more than " +
                  format_significant(distance, 6) + " m below and " + std::to_string(high) +
                  " points above the surrounding ground were left out; the farthest, by " +
                  format_significant(farthest, 4) + " m, is near " + format_map_point(farthest_at));
}

std::string cell_value(const TerrainOptions& options) {
  if (!options.percentile) return "mean heights";
  if (*options.percentile == 0.0) return "lowest heights";
  return "percentile " + format_significant(*options.percentile, 4) + " of the heights";
}

void note_fill(const HoleFillReport& filled, double widest, CloudGrid& result,
               const fs::path& path) {
  if (filled.cells > 0) {
    result.notes.push_back(path.string() + ": " + std::to_string(filled.cells) +
                           " cells without points were filled from their surroundings, in " +
                           std::to_string(filled.holes) + " holes");
  }
  if (filled.remaining > 0) {
    result.notes.push_back(path.string() + ": " + std::to_string(filled.remaining) +
                           " holes wider than " + format_significant(widest, 6) +
                           " m were left open, the widest, " +
                           format_significant(filled.widest_remaining, 4) + " m, around " +
                           format_map_point(filled.widest_position));
  }
}

}  // namespace

HeightGrid make_covering_grid(const Vec2& low, const Vec2& high, double cell,
                              const fs::path& path) {
  HeightGrid grid = Cells(low, high, cell, path).grid();
  std::fill(grid.heights.begin(), grid.heights.end(), kUnknown);
  return grid;
}

HeightGrid grid_mean_heights(std::span<const Vec3> points, double cell, const fs::path& path) {
  Bounds box;
  for (const Vec3& point : points) box.include(point);
  const Cells cells(box.low.head<2>(), box.high.head<2>(), cell, path);
  HeightGrid grid = cells.grid();
  std::vector<std::uint32_t> hits(cells.count(), 0);
  for (const Vec3& point : points) {
    const std::size_t c = cells.at(point);
    grid.heights[c] += point.z();
    ++hits[c];
  }
  for (std::size_t c = 0; c < hits.size(); ++c) {
    grid.heights[c] = hits[c] > 0 ? grid.heights[c] / hits[c] : kUnknown;
  }
  return grid;
}

CloudGrid read_cloud_grid(const TerrainOptions& options) {
  CloudGrid result;
  const Survey survey = surveyed(options, result);
  const fs::path& path = options.surface.front();
  const double size = options.resolution.value_or(default_cell(survey));
  const Cells cells(survey.box.low.head<2>(), survey.box.high.head<2>(), size, path);
  result.notes.push_back(path.string() + ": " + std::to_string(survey.points) + " points, " +
                         cell_value(options) + " over cells of " + format_significant(size, 9) +
                         " m");
  HeightGrid& grid = result.grid;
  grid = cells.grid();
  std::vector<std::uint32_t> hits(cells.count(), 0);
  const bool lowest = options.percentile == 0.0;
  for (const Cloud& cloud : survey.clouds) {
    cloud.each_point([&](const Vec3& point) {
      const std::size_t c = cells.at(point);
      double& height = grid.heights[c];
      height = !lowest        ? height + point.z()
               : hits[c] == 0 ? point.z()
                              : std::min(height, point.z());
      ++hits[c];
    });
  }
  if (options.outliers || (options.percentile && !lowest)) {
    CellHeights stored = cell_heights(survey, cells, hits);
    if (options.outliers) drop_outliers(stored, cells, *options.outliers, path, result.notes);
    for (std::size_t c = 0; c < hits.size(); ++c) {
      const std::span<double> heights = stored.of(c);
      hits[c] = static_cast<std::uint32_t>(heights.size());
      if (heights.empty()) continue;
      if (options.percentile) {
        grid.heights[c] = percentile_of(heights, *options.percentile);
      } else {
        grid.heights[c] = 0.0;
        for (const double height : heights) grid.heights[c] += height;
      }
    }
  }
  for (std::size_t c = 0; c < hits.size(); ++c) {
    if (hits[c] == 0) {
      grid.heights[c] = kUnknown;
    } else if (!options.percentile) {
      grid.heights[c] /= hits[c];
    }
  }
  const double widest = options.fill.value_or(kPinholes * size);
  note_fill(fill_grid_holes(grid, widest), widest, result, path);
  return result;
}

}  // namespace clast::terrain_detail
