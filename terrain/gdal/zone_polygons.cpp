#include "terrain/gdal/zone_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "mesh/plan_geometry.hpp"
#include "terrain/gdal/detail/vector_layer.hpp"
#include "terrain/raw_surface.hpp"

namespace clast::terrain_detail {
namespace {

void add_rings(const OGRPolygon& polygon, ZonePolygon& zone) {
  for (const OGRLinearRing* ring : polygon) {
    std::vector<Vec2> points;
    for (int i = 0; i < ring->getNumPoints(); ++i)
      points.emplace_back(ring->getX(i), ring->getY(i));
    const bool is_outline = ring == polygon.getExteriorRing();
    if ((signed_area(points) > 0.0) != is_outline) std::reverse(points.begin(), points.end());
    zone.rings.push_back(std::move(points));
  }
}

/// A polygon as GDAL has it, on the map of the terrain, and as we have it.
struct ReadPolygon {
  ZonePolygon polygon;
  std::unique_ptr<OGRGeometry> geometry;
};

std::string zone_of(const OGRFeature& feature, int field, const std::filesystem::path& path) {
  std::string zone;
  if (feature.IsFieldSetAndNotNull(field)) {
    // Blanks around a name are not seen in a table.
    zone = feature.GetFieldAsString(field);
    zone.erase(0, zone.find_first_not_of(" \t"));
    zone.erase(zone.find_last_not_of(" \t") + 1);
  }
  if (!zone.empty()) return zone;
  throw InputError(feature_name(feature, path) +
                   " has an empty property \"zone\"; give the zone a name");
}

/// @param zone  empty: the polygon has none
ReadPolygon polygon_of(const OGRFeature& feature, const std::string& zone,
                       OGRCoordinateTransformation* transform, const std::filesystem::path& path) {
  ZonePolygon result;
  result.zone = zone;
  const std::string named = zone.empty() ? "" : " (zone \"" + zone + "\")";
  std::unique_ptr<OGRGeometry> geometry = linearised_geometry(feature, transform, path);
  const OGRwkbGeometryType type = geometry ? wkbFlatten(geometry->getGeometryType()) : wkbUnknown;
  if (type == wkbPolygon) {
    add_rings(*geometry->toPolygon(), result);
  } else if (type == wkbMultiPolygon) {
    for (const OGRPolygon* part : *geometry->toMultiPolygon()) add_rings(*part, result);
  } else {
    throw InputError(
        feature_name(feature, path) + named + " is a " +
        (geometry ? geometry->getGeometryName() : "feature without geometry") +
        (zone.empty() ? "; an outline must be a polygon" : "; zones must be polygons"));
  }
  result.low = Vec2::Constant(1e300);
  result.high = -result.low;
  for (const std::vector<Vec2>& ring : result.rings) {
    for (const Vec2& point : ring) {
      if (!point.allFinite()) {
        throw InputError(feature_name(feature, path) +
                         " has a corner that is not a number; correct it, or draw it again");
      }
      result.low = result.low.cwiseMin(point);
      result.high = result.high.cwiseMax(point);
    }
  }
  if (!geometry->IsValid()) {
    throw InputError(feature_name(feature, path) + named + " crosses itself (" +
                     GdalSession::last_message() +
                     "); repair it, for example with \"Fix geometries\" of QGIS");
  }
  return {std::move(result), std::move(geometry)};
}

/// Overlaps narrower than this are what digitising leaves, m.
constexpr double kSlop = 0.01;

void check_overlaps(const std::vector<ReadPolygon>& polygons, const std::filesystem::path& path) {
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (std::size_t j = i + 1; j < polygons.size(); ++j) {
      const ZonePolygon &one = polygons[i].polygon, &two = polygons[j].polygon;
      if (one.zone == two.zone || (one.low.array() > two.high.array()).any() ||
          (two.low.array() > one.high.array()).any()) {
        continue;
      }
      const std::unique_ptr<OGRGeometry> common(
          polygons[i].geometry->Intersection(polygons[j].geometry.get()));
      if (!common || common->IsEmpty()) continue;
      const double area = OGR_G_Area(OGRGeometry::ToHandle(common.get()));
      OGREnvelope box;
      common->getEnvelope(&box);
      if (area <= kSlop * std::hypot(box.MaxX - box.MinX, box.MaxY - box.MinY)) continue;
      OGRPoint inside;
      common->Centroid(&inside);
      throw InputError(path.string() + ": zones \"" + one.zone + "\" and \"" + two.zone +
                       "\" overlap on " + format_significant(area, 4) + " m2 around " +
                       format_map_point({inside.getX(), inside.getY(), 0.0}) +
                       "; cut one of the polygons");
    }
  }
}

std::string field_names(OGRFeatureDefn& fields) {
  std::string names;
  for (int i = 0; i < fields.GetFieldCount(); ++i) {
    names += (i > 0 ? ", " : "") + std::string(fields.GetFieldDefn(i)->GetNameRef());
  }
  return names.empty() ? "none" : names;
}

}  // namespace

bool ZonePolygon::contains(const Vec2& point) const {
  if ((point.array() < low.array()).any() || (point.array() > high.array()).any()) return false;
  bool inside = false;
  for (const std::vector<Vec2>& ring : rings) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      // Ends in a fixed order, so that polygons on either side of an edge compute the same number.
      const bool rising = ring[i].y() < ring[j].y();
      const Vec2 &a = rising ? ring[i] : ring[j], &b = rising ? ring[j] : ring[i];
      if ((a.y() > point.y()) == (b.y() > point.y())) continue;
      const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (point.x() < x) inside = !inside;
    }
  }
  return inside;
}

std::vector<ZonePolygon> read_zone_polygons(const std::filesystem::path& path,
                                            const std::string& crs) {
  const GdalSession session;
  const DatasetPointer dataset = open_feature_file(path, "polygons");
  OGRLayer& layer = find_geometry_layer(*dataset, path, "polygons");
  const int field = layer.GetLayerDefn()->GetFieldIndex("zone");
  if (field < 0) {
    throw InputError(path.string() + ": its features have no property \"zone\" (there are: " +
                     field_names(*layer.GetLayerDefn()) + "); add it, with the name of each zone");
  }
  const TransformationPointer transform = make_transformation(layer, crs, path);
  std::vector<ReadPolygon> read;
  layer.ResetReading();
  while (const FeaturePointer feature{layer.GetNextFeature()}) {
    read.push_back(polygon_of(*feature, zone_of(*feature, field, path), transform.get(), path));
  }
  check_overlaps(read, path);
  std::vector<ZonePolygon> polygons;
  for (ReadPolygon& each : read) polygons.push_back(std::move(each.polygon));
  if (polygons.empty()) {
    throw InputError(path.string() + ": holds no polygons; draw one around each zone");
  }
  return polygons;
}

std::vector<ZonePolygon> read_outline_polygons(const std::filesystem::path& path,
                                               const std::string& crs) {
  const GdalSession session;
  const DatasetPointer dataset = open_feature_file(path, "polygons");
  OGRLayer& layer = find_geometry_layer(*dataset, path, "polygons");
  const TransformationPointer transform = make_transformation(layer, crs, path);
  std::vector<ZonePolygon> outlines;
  layer.ResetReading();
  while (const FeaturePointer feature{layer.GetNextFeature()}) {
    outlines.push_back(polygon_of(*feature, "", transform.get(), path).polygon);
  }
  if (outlines.empty()) throw InputError(path.string() + ": holds no polygons; draw one");
  return outlines;
}

bool is_polygon_file(const std::filesystem::path& path) {
  static const std::set<std::string> kKnown = {".geojson", ".json", ".gpkg", ".shp"};
  return kKnown.contains(lower_case_extension(path));
}

}  // namespace clast::terrain_detail
