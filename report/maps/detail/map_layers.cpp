#include "report/maps/detail/map_layers.hpp"

#include <bit>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "report/charts/palette.hpp"
#include "report/html/packed_numbers.hpp"
#include "report/maps/map_style.hpp"
#include "report/scene/stored_runs.hpp"

namespace clast::report_detail {
namespace {

using Json = nlohmann::ordered_json;

/// Rounds to 13 binary digits (0.01 %), because invisible bits would be most of what a page cannot
/// compress. Whole numbers up to 8192 are exact.
float visible_on_map(float value) {
  constexpr std::uint32_t kHidden = 0x7ff, kHalf = 0x400;
  if (!std::isfinite(value)) return NAN;
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(value) + kHalf) & ~kHidden);
}

/// Values of a layer on a grid that is coarser by a whole number.
struct Joined {
  std::uint32_t columns = 0, rows = 0, factor = 1;
  std::vector<float> value;
};

Joined joined(const MapRasterSet& rasters, const RasterLayer& layer) {
  const double cells = static_cast<double>(rasters.columns) * rasters.rows;
  Joined grid;
  grid.factor = static_cast<std::uint32_t>(
      std::ceil(std::sqrt(std::max(1.0, cells / static_cast<double>(kMaxMapCells)))));
  grid.columns = (rasters.columns + grid.factor - 1) / grid.factor;
  grid.rows = (rasters.rows + grid.factor - 1) / grid.factor;
  grid.value.assign(std::size_t{grid.columns} * grid.rows, NAN);
  for (std::uint32_t row = 0; row < rasters.rows; ++row) {
    for (std::uint32_t column = 0; column < rasters.columns; ++column) {
      const float value = layer.values[std::size_t{row} * rasters.columns + column];
      float& cell =
          grid.value[std::size_t{row / grid.factor} * grid.columns + column / grid.factor];
      if (std::isfinite(value) && !(cell >= value)) cell = value;
    }
  }
  return grid;
}

Json layer_json(const MapRasterSet& rasters, const RasterLayer& layer, const ColourScale& style,
                const Vec2& origin) {
  Joined grid = joined(rasters, layer);
  for (float& value : grid.value) value = visible_on_map(value);
  Json colours = Json::array();
  for (const Rgb& colour : style.colours) colours.push_back(format_colour(colour));
  const double width = rasters.cell_size * grid.factor;
  const double top = rasters.corner.y() + rasters.cell_size * rasters.rows - origin.y();
  return {{"name", layer.name},
          {"title", style.title},
          {"meaning", layer.meaning},
          {"unit", style.unit},
          {"unit_size", style.unit_size},
          {"breaks", style.breaks},
          {"numbers", style.numbers},
          {"colours", colours},
          {"columns", grid.columns},
          {"x0", rasters.corner.x() - origin.x() + 0.5 * width},
          {"y0", top - 0.5 * width},
          {"cell", width},
          {"values", encode_packed_array<float>(grid.value)}};
}

/// Corners of a path of which none is nearer to the one before than `step`.
void append_path(const Trajectory& trajectory, const Vec2& shift, double step,
                 std::vector<float>& x, std::vector<float>& y) {
  Vec2 last = Vec2::Constant(INFINITY);
  for (std::size_t k = 0; k < trajectory.states.size(); ++k) {
    const Vec2 place = trajectory.states[k].position.head<2>() + shift;
    const bool is_last = k + 1 == trajectory.states.size();
    if (!is_last && (place - last).norm() < step) continue;
    x.push_back(static_cast<float>(place.x()));
    y.push_back(static_cast<float>(place.y()));
    last = place;
  }
  x.push_back(NAN);
  y.push_back(NAN);
}

Json paths_json(const Comparison& comparison, const RunsWithTrajectories& stored,
                const Vec2& origin) {
  constexpr double kSteps = 1500.0;  // over the longer side of what the runs cover
  Bounds box;
  for (const RunRow& row : comparison.rows) {
    box.include(row.start);
    if (row.stop.allFinite()) box.include(row.stop);
  }
  const double step = (box.high - box.low).head<2>().maxCoeff() / kSteps;
  struct Lines {
    std::vector<float> x, y;
  };
  std::map<std::string, Lines> by_class;
  const std::size_t count = std::min(kMaxMapPaths, stored.rows.size());
  for (std::size_t i = 0; i < count; ++i) {
    const RunRow& row = comparison.rows[stored.rows[i * stored.rows.size() / count]];
    Lines& lines = by_class[row.block->garcia];
    append_path(stored.trajectory(row),
                comparison.results[row.file].frame.origin.head<2>() - origin, step, lines.x,
                lines.y);
  }
  Json paths = Json::array();
  for (const auto& [garcia, lines] : by_class) {
    paths.push_back({{"name", garcia},
                     {"colour", class_colour(garcia)},
                     {"x", encode_packed_array<float>(lines.x)},
                     {"y", encode_packed_array<float>(lines.y)}});
  }
  return paths;
}

}  // namespace

MapLayerData make_map_layer_data(const Comparison& comparison,
                                 const std::vector<const MapRasterSet*>& rasters,
                                 const Vec2& origin, bool with_paths) {
  Json layers = Json::array(), paths = Json::array();
  for (const MapRasterSet* grid : rasters) {
    const std::vector<ColourScale> styles = choose_colour_scales(*grid);
    for (std::size_t i = 0; i < grid->layers.size(); ++i) {
      layers.push_back(layer_json(*grid, grid->layers[i], styles[i], origin));
    }
  }
  MapLayerData result;
  if (with_paths) {
    const RunsWithTrajectories stored = find_runs_with_trajectories(comparison);
    result.stored_paths = stored.rows.size();
    result.paths = std::min(kMaxMapPaths, stored.rows.size());
    paths = paths_json(comparison, stored, origin);
  }
  result.json = Json{
      {"origin", {origin.x(), origin.y()}},
      {"path_opacity", kPathOpacity},
      {"layers", layers},
      {"paths",
       paths}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  return result;
}

}  // namespace clast::report_detail
