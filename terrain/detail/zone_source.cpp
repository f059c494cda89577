#include "terrain/detail/zone_source.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.hpp"
#include "terrain/detail/gdal_raster.hpp"
#include "terrain/detail/zone_polygons.hpp"

namespace clast::detail {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::size_t kMostZones = 65535;

/// What lies over a place, as an index into `labels`; kNone where nothing does.
struct ZoneMap {
  std::vector<std::string> labels;
  std::function<std::uint32_t(const Vec3&)> at;
};

ZoneMap raster_zones(const ZoneFile& source, const std::string& crs,
                     std::vector<std::string>& notes) {
  Raster raster = read_raster(source.path);
  if (!crs.empty() && !raster.crs.empty() && !same_crs(crs, raster.crs)) {
    throw InputError(source.path.string() + ": is in " + raster.crs.substr(0, 60) +
                     ", the ground in " + crs.substr(0, 60) + "; reproject one (gdalwarp -t_srs)");
  }
  notes.insert(notes.end(), raster.notes.begin(), raster.notes.end());
  std::map<long, std::uint32_t> label_of;
  for (std::size_t i = 0; i < raster.grid.heights.size(); ++i) {
    const double value = raster.grid.heights[i];
    if (std::isnan(value)) continue;
    const Vec2 centre = raster.grid.centre(i % raster.grid.columns, i / raster.grid.columns);
    if (value != std::round(value) || std::abs(value) > 1e9) {
      throw InputError(source.path.string() + ": " + std::to_string(value) + " at " +
                       place({centre.x(), centre.y(), 0.0}) +
                       "; a zone raster holds whole class numbers");
    }
    const auto [entry, is_new] = label_of.emplace(static_cast<long>(value), 0);
    if (!is_new || source.names.empty() || source.names.contains(entry->first)) continue;
    throw InputError(source.path.string() + ": class " + std::to_string(entry->first) + " at " +
                     place({centre.x(), centre.y(), 0.0}) + " has no name; add " +
                     std::to_string(entry->first) + "=NAME to the zones");
  }
  ZoneMap map;
  for (auto& [number, label] : label_of) {
    const std::string name =
        source.names.empty() ? std::to_string(number) : source.names.at(number);
    const auto known = std::find(map.labels.begin(), map.labels.end(), name);
    label = static_cast<std::uint32_t>(known - map.labels.begin());
    if (known == map.labels.end()) map.labels.push_back(name);
  }
  map.at = [grid = std::move(raster.grid), label_of](const Vec3& point) {
    const Vec2 cell = ((point.head<2>() - grid.first).cwiseQuotient(grid.step)).array() + 0.5;
    if (!(cell.x() >= 0.0 && cell.y() >= 0.0 && cell.x() < static_cast<double>(grid.columns) &&
          cell.y() < static_cast<double>(grid.rows))) {
      return kNone;
    }
    const double value = grid.heights[static_cast<std::size_t>(cell.y()) * grid.columns +
                                      static_cast<std::size_t>(cell.x())];
    return std::isnan(value) ? kNone : label_of.at(static_cast<long>(value));
  };
  return map;
}

ZoneMap polygon_zones(const ZoneFile& source, const std::string& crs) {
  const std::vector<ZonePolygon> polygons = read_zone_polygons(source.path, crs);
  ZoneMap map;
  std::vector<std::uint32_t> label_of;
  for (const ZonePolygon& polygon : polygons) {
    const auto known = std::find(map.labels.begin(), map.labels.end(), polygon.zone);
    label_of.push_back(static_cast<std::uint32_t>(known - map.labels.begin()));
    if (known == map.labels.end()) map.labels.push_back(polygon.zone);
  }
  map.at = [polygons, label_of, labels = map.labels, path = source.path](const Vec3& point) {
    std::uint32_t found = kNone;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      if (label_of[i] == found || !polygons[i].contains(point.head<2>())) continue;
      if (found != kNone) {
        throw InputError(path.string() + ": zones \"" + labels[found] + "\" and \"" +
                         labels[label_of[i]] + "\" overlap at " + place(point) +
                         "; cut one of the polygons");
      }
      found = label_of[i];
    }
    return found;
  };
  return map;
}

}  // namespace

void assign_zones(Terrain& terrain, const ZoneFile& source) {
  const ZoneMap map = is_polygon_file(source.path)
                          ? polygon_zones(source, terrain.frame.crs)
                          : raster_zones(source, terrain.frame.crs, terrain.report.notes);
  if (map.labels.size() > kMostZones) {
    throw InputError(source.path.string() + ": " + std::to_string(map.labels.size()) +
                     " zones; is it a raster of heights?");
  }
  const TriangleMesh& mesh = terrain.surface;
  std::vector<std::uint32_t> label(mesh.triangles.size());
  std::vector<bool> used(map.labels.size(), false);
  std::size_t bare = 0;
  double bare_area = 0.0;
  Vec3 bare_at = Vec3::Zero();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 centroid = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
    const Vec3 on_map = terrain.frame.map(centroid);
    label[t] = map.at(on_map);
    if (label[t] != kNone) {
      used[label[t]] = true;
      continue;
    }
    if (bare++ == 0) bare_at = on_map;
    const Vec3 ab = mesh.vertices[b] - mesh.vertices[a], ac = mesh.vertices[c] - mesh.vertices[a];
    bare_area += std::abs(ab.x() * ac.y() - ab.y() * ac.x()) / 2.0;
  }
  if (bare > 0) {
    throw GeometryError(source.path.string() + ": leaves " + std::to_string(bare) + " of " +
                        std::to_string(mesh.triangles.size()) + " triangles (" +
                        std::to_string(bare_area) + " m2 in plan) without a zone, the first at " +
                        place(bare_at) + "; extend the zones or cut the ground");
  }
  std::vector<std::uint16_t> number(map.labels.size(), 0);
  for (std::size_t i = 0; i < map.labels.size(); ++i) {
    if (!used[i]) continue;
    number[i] = static_cast<std::uint16_t>(terrain.zone_names.size());
    terrain.zone_names.push_back(map.labels[i]);
  }
  for (const std::uint32_t l : label) terrain.zone.push_back(number[l]);
}

}  // namespace clast::detail
