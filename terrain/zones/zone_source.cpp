#include "terrain/zones/zone_source.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "mesh/plan_geometry.hpp"
#include "mesh/reference_system.hpp"
#include "mesh/triangle_geometry.hpp"
#include "terrain/gdal/gdal_raster.hpp"
#include "terrain/gdal/zone_polygons.hpp"
#include "terrain/plan_clip.hpp"
#include "terrain/plan_index.hpp"
#include "terrain/zones/detail/zone_rules.hpp"
#include "terrain/zones/zone_cut.hpp"

namespace clast::terrain_detail {
namespace {

constexpr std::size_t kMaxZones = 65535;
constexpr double kUpright = 1e-6;  // of plan area in area, under which the centroid decides

/// Plan areas by label.
using Shares = std::vector<std::pair<std::uint32_t, double>>;

void add_share(Shares& shares, std::uint32_t label, double area) {
  for (auto& [known, sum] : shares) {
    if (known == label) {
      sum += area;
      return;
    }
  }
  shares.emplace_back(label, area);
}

/// The place of a name among the labels, where it is put if it is new.
std::uint32_t label_of_name(std::vector<std::string>& labels, const std::string& name) {
  const auto known = std::find(labels.begin(), labels.end(), name);
  const auto label = static_cast<std::uint32_t>(known - labels.begin());
  if (known == labels.end()) labels.push_back(name);
  return label;
}

/// Zone of the plan, as an index into `labels`.
struct ZoneMap {
  std::vector<std::string> labels;
  PlanBox extent;                                   ///< on the map
  std::function<std::uint32_t(const Vec2&)> at;     ///< kNoIndex where nothing is
  std::function<Shares(const PlanTriangle&)> over;  ///< of a triangle on the map
  std::vector<std::array<Vec2, 2>> borders;         ///< of polygons
};

/// Labels of the classes of a zone raster.
std::map<long, std::uint32_t> classes_of(const HeightGrid& grid, const ZoneFile& source,
                                         ZoneMap& map) {
  std::map<long, std::uint32_t> label_of;
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    const double value = grid.heights[i];
    if (std::isnan(value)) continue;
    const Vec2 centre = grid.centre(i % grid.columns, i / grid.columns);
    if (value != std::round(value) || std::abs(value) > 1e9) {
      throw InputError(source.path.string() + ": " + format_significant(value, 6) + " at " +
                       format_map_point({centre.x(), centre.y(), 0.0}) +
                       "; a zone raster holds whole class numbers");
    }
    const auto [entry, is_new] = label_of.emplace(static_cast<long>(value), 0);
    if (!is_new || source.names.empty() || source.names.contains(entry->first)) continue;
    throw InputError(source.path.string() + ": class " + std::to_string(entry->first) + " at " +
                     format_map_point({centre.x(), centre.y(), 0.0}) + " has no name; add " +
                     std::to_string(entry->first) + "=NAME to the zones");
  }
  for (auto& [number, label] : label_of) {
    label = label_of_name(map.labels,
                          source.names.empty() ? std::to_string(number) : source.names.at(number));
  }
  return label_of;
}

/// Labels on the cells of a raster.
class LabelGrid {
 public:
  LabelGrid(std::vector<std::uint32_t> cells, const HeightGrid& grid)
      : cells_(std::move(cells)),
        corner_(grid.first_centre - grid.cell_size / 2.0),
        step_(grid.cell_size),
        columns_(static_cast<long>(grid.columns)),
        rows_(static_cast<long>(grid.rows)) {}

  std::uint32_t at(const Vec2& point) const {
    const auto [i, j] = column_and_row(point);
    return label(i, j);
  }

  Shares over(const PlanTriangle& triangle) const {
    PlanBox box;
    for (const Vec2& point : triangle) box.include(point);
    const auto [low_i, low_j] = column_and_row(box.low);
    const auto [high_i, high_j] = column_and_row(box.high);
    Shares shares;
    for (long j = std::max(low_j, 0L); j <= std::min(high_j, rows_ - 1); ++j) {
      for (long i = std::max(low_i, 0L); i <= std::min(high_i, columns_ - 1); ++i) {
        const std::uint32_t here = label(i, j);
        if (here == kNoIndex) continue;
        const Vec2 low =
            corner_ + step_.cwiseProduct(Vec2(static_cast<double>(i), static_cast<double>(j)));
        const Vec2 high = low + step_;
        const std::array<Vec2, 4> cell = {low, Vec2(high.x(), low.y()), high,
                                          Vec2(low.x(), high.y())};
        const double area = clipped_area(cell, triangle);
        if (area > 0.0) add_share(shares, here, area);
      }
    }
    return shares;
  }

 private:
  std::uint32_t label(long i, long j) const {
    return i < 0 || j < 0 || i >= columns_ || j >= rows_
               ? kNoIndex
               : cells_[static_cast<std::size_t>(j * columns_ + i)];
  }
  std::pair<long, long> column_and_row(const Vec2& point) const {
    const Vec2 cell = (point - corner_).cwiseQuotient(step_).array().floor();
    const Vec2 within = cell.cwiseMax(-1e9).cwiseMin(1e9);
    return {static_cast<long>(within.x()), static_cast<long>(within.y())};
  }

  std::vector<std::uint32_t> cells_;
  Vec2 corner_, step_;
  long columns_, rows_;
};

ZoneMap raster_zones(const ZoneFile& source, const std::string& crs) {
  const Raster raster = read_raster(source.path);
  if (!crs.empty() && !raster.crs.empty() && !is_same_crs(crs, raster.crs)) {
    throw InputError(source.path.string() + ": is in " + reference_system_name(raster.crs) +
                     ", the ground in " + reference_system_name(crs) +
                     "; reproject one (gdalwarp -t_srs)");
  }
  const HeightGrid& grid = raster.grid;
  ZoneMap map;
  const std::map<long, std::uint32_t> label_of = classes_of(grid, source, map);
  std::vector<std::uint32_t> cells(grid.heights.size(), kNoIndex);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!std::isnan(grid.heights[i])) cells[i] = label_of.at(static_cast<long>(grid.heights[i]));
  }
  map.extent.include(grid.first_centre - grid.cell_size / 2.0);
  map.extent.include(grid.centre(grid.columns, grid.rows) - grid.cell_size / 2.0);
  const auto labels = std::make_shared<const LabelGrid>(std::move(cells), grid);
  map.at = [labels](const Vec2& point) { return labels->at(point); };
  map.over = [labels](const PlanTriangle& triangle) { return labels->over(triangle); };
  return map;
}

ZoneMap polygon_zones(const ZoneFile& source, const std::string& crs) {
  std::vector<ZonePolygon> polygons = read_zone_polygons(source.path, crs);
  ZoneMap map;
  std::vector<std::uint32_t> label_of;
  std::vector<PlanBox> sides;
  for (const ZonePolygon& polygon : polygons) {
    label_of.push_back(label_of_name(map.labels, polygon.zone));
    map.extent.include(polygon.low);
    map.extent.include(polygon.high);
    for (const std::vector<Vec2>& ring : polygon.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        map.borders.push_back({a, b});
        sides.emplace_back();
        sides.back().include(a);
        sides.back().include(b);
      }
    }
  }
  map.at = [polygons, label_of](const Vec2& point) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      if (polygons[i].contains(point)) return label_of[i];
    }
    return kNoIndex;
  };
  map.over = [polygons, label_of, at = map.at,
              index = PlanIndex(sides)](const PlanTriangle& triangle) {
    PlanBox box;
    for (const Vec2& point : triangle) box.include(point);
    Shares shares;
    if (index.boxes_near(box).empty()) {
      const std::uint32_t label = at((triangle[0] + triangle[1] + triangle[2]) / 3.0);
      if (label != kNoIndex) shares.emplace_back(label, signed_area(triangle));
      return shares;
    }
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const ZonePolygon& polygon = polygons[i];
      if ((polygon.low.array() > box.high.array()).any() ||
          (polygon.high.array() < box.low.array()).any()) {
        continue;
      }
      double area = 0.0;
      for (const std::vector<Vec2>& ring : polygon.rings) area += clipped_area(ring, triangle);
      if (area > 0.0) add_share(shares, label_of[i], area);
    }
    return shares;
  };
  return map;
}

void cut_borders(Terrain& terrain, const ZoneMap& map) {
  std::vector<std::array<Vec2, 2>> borders = map.borders;
  for (std::array<Vec2, 2>& border : borders) {
    for (Vec2& end : border) end -= terrain.frame.origin.head<2>();
  }
  const std::size_t added = insert_edges_along_segments(terrain.surface, borders);
  if (added > 0) {
    terrain.report.notes.push_back("cutting the zone borders into the ground added " +
                                   std::to_string(added) + " triangles");
  }
}

/// Ground that no zone is for.
struct Bare {
  std::size_t triangles = 0;
  double area = 0.0;       ///< in plan, m^2
  double partial = 0.0;    ///< the rest of triangles that are covered by more than half, m^2
  Vec3 at = Vec3::Zero();  ///< the first, on the map
};

void refuse_bare(const Bare& bare, const Terrain& terrain, const std::string& who,
                 const std::string& advice) {
  if (bare.triangles == 0) return;
  throw GeometryError(who + ": leaves " + std::to_string(bare.triangles) + " of " +
                      std::to_string(terrain.surface.triangles.size()) + " triangles (" +
                      format_significant(bare.area, 6) +
                      " m2 in plan) without a zone, the first at " + format_map_point(bare.at) +
                      "; " + advice);
}

/// Numbers for the labels that are used, in their order.
/// @param who  gave the labels, for messages
void number_zones(Terrain& terrain, const std::vector<std::string>& labels,
                  const std::vector<std::uint32_t>& label, const std::string& who) {
  std::vector<bool> used(labels.size(), false);
  for (const std::uint32_t l : label) used[l] = true;
  std::vector<std::uint16_t> number(labels.size(), 0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!used[i]) continue;
    with_error_context(who, [&] { check_zone_name(labels[i]); });
    number[i] = static_cast<std::uint16_t>(terrain.zone_names.size());
    terrain.zone_names.push_back(labels[i]);
  }
  for (const std::uint32_t l : label) terrain.zone.push_back(number[l]);
}

void check_extent(const ZoneMap& map, const Terrain& terrain, const ZoneFile& source) {
  const Bounds box = bounds(terrain.surface);
  const Vec3 low = terrain.frame.to_map(box.low), high = terrain.frame.to_map(box.high);
  if ((map.extent.low.array() <= high.head<2>().array()).all() &&
      (map.extent.high.array() >= low.head<2>().array()).all()) {
    return;
  }
  const auto span = [](const Vec2& from, const Vec2& to) {
    return "x " + format_significant(from.x(), 9) + " to " + format_significant(to.x(), 9) +
           ", y " + format_significant(from.y(), 9) + " to " + format_significant(to.y(), 9);
  };
  throw InputError(source.path.string() + ": the zones lie at " +
                   span(map.extent.low, map.extent.high) + ", the ground at " +
                   span(low.head<2>(), high.head<2>()) +
                   "; convert both to one map system (zones in z-up map coordinates)");
}

}  // namespace

void assign_zones(Terrain& terrain, const ZoneFile& source, bool cut) {
  const ZoneMap map = is_polygon_file(source.path) ? polygon_zones(source, terrain.frame.crs)
                                                   : raster_zones(source, terrain.frame.crs);
  if (map.labels.size() > kMaxZones) {
    throw InputError(source.path.string() + ": " + std::to_string(map.labels.size()) +
                     " zones are too many; give a raster of classes, not of heights");
  }
  check_extent(map, terrain, source);
  if (cut) cut_borders(terrain, map);
  const TriangleMesh& mesh = terrain.surface;
  std::vector<std::uint32_t> label(mesh.triangles.size(), kNoIndex);
  Bare bare;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 area = doubled_area_vector(mesh, mesh.triangles[t]);
    const Vec3 middle = terrain.frame.to_map(centroid(mesh, mesh.triangles[t]));
    const double plan = std::abs(area.z()) / 2.0;
    double covered = 0.0;
    if (std::abs(area.z()) < kUpright * area.norm()) {
      label[t] = map.at(middle.head<2>());
    } else {
      PlanTriangle triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle[k] = terrain.frame.to_map(mesh.vertices[mesh.triangles[t][k]]).head<2>();
      }
      if (area.z() < 0.0) std::swap(triangle[1], triangle[2]);
      double most = 0.0;
      for (const auto& [zone, share] : map.over(triangle)) {
        covered += share;
        if (share > most || (share == most && zone < label[t])) {
          most = share;
          label[t] = zone;
        }
      }
      if (covered < 0.5 * plan) label[t] = kNoIndex;
    }
    if (label[t] == kNoIndex) {
      if (bare.triangles++ == 0) bare.at = middle;
      bare.area += std::max(0.0, plan - covered);
    } else {
      bare.partial += std::max(0.0, plan - covered);
    }
  }
  refuse_bare(bare, terrain, source.path.string(), "extend the zones or reduce the ground");
  if (bare.partial > 1e-6) {
    terrain.report.notes.push_back(
        source.path.string() + ": " + format_significant(bare.partial, 3) +
        " m2 outside the zones were given the zone of the rest of their triangle");
  }
  number_zones(terrain, map.labels, label, source.path.string());
}

void assign_zones(Terrain& terrain, const std::vector<std::string>& texts) {
  const std::vector<ZoneRule> rules = parse_zone_rules(texts);
  std::vector<std::string> labels;
  std::vector<std::uint32_t> label_of;
  for (const ZoneRule& rule : rules) {
    label_of.push_back(label_of_name(labels, rule.zone));
  }
  const TriangleMesh& mesh = terrain.surface;
  std::vector<std::uint32_t> label(mesh.triangles.size(), kNoIndex);
  Bare bare;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 area = doubled_area_vector(mesh, mesh.triangles[t]);
    const Vec3 middle = terrain.frame.to_map(centroid(mesh, mesh.triangles[t]));
    const double slope = std::atan2(area.head<2>().norm(), area.z());
    for (std::size_t r = 0; r < rules.size() && label[t] == kNoIndex; ++r) {
      if (rules[r].applies(slope, middle.z())) label[t] = label_of[r];
    }
    if (label[t] != kNoIndex) continue;
    if (bare.triangles++ == 0) bare.at = middle;
    bare.area += std::abs(area.z()) / 2.0;
  }
  refuse_bare(bare, terrain, "the zone rules", "end them with NAME=else");
  number_zones(terrain, labels, label, "the zone rules");
}

}  // namespace clast::terrain_detail
