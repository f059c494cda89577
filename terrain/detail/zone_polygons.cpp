#include "terrain/detail/zone_polygons.hpp"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "terrain/detail/gdal_session.hpp"
#include "terrain/detail/raw_surface.hpp"

namespace clast::detail {
namespace {

struct DestroyFeature {
  void operator()(OGRFeature* feature) const { OGRFeature::DestroyFeature(feature); }
};
struct DestroyTransformation {
  void operator()(OGRCoordinateTransformation* t) const {
    OGRCoordinateTransformation::DestroyCT(t);
  }
};
using Transformation = std::unique_ptr<OGRCoordinateTransformation, DestroyTransformation>;

/// From the layer's system to the terrain's; none when they agree or one is unknown. GeoJSON that
/// names no system counts as WGS 84 degrees, but is often written in map metres: numbers beyond
/// degrees are taken as they are.
Transformation transformation(OGRLayer& layer, const std::string& crs,
                              const std::filesystem::path& path) {
  const OGRSpatialReference* from = layer.GetSpatialRef();
  OGREnvelope extent;
  if (!from || crs.empty() || layer.GetExtent(&extent) != OGRERR_NONE) return nullptr;
  const bool degrees = std::max(std::abs(extent.MinX), std::abs(extent.MaxX)) <= 180.0 &&
                       std::max(std::abs(extent.MinY), std::abs(extent.MaxY)) <= 90.0;
  if (from->IsGeographic() && !degrees) return nullptr;
  OGRSpatialReference to;
  if (to.SetFromUserInput(crs.c_str()) != OGRERR_NONE || to.IsSame(from)) return nullptr;
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference source(*from);
  source.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  Transformation result(OGRCreateCoordinateTransformation(&source, &to));
  if (!result) {
    throw InputError(path.string() + ": can't be brought into the terrain's coordinate system (" +
                     GdalSession::message() + "); save it in " + crs.substr(0, 40));
  }
  return result;
}

void add_rings(const OGRPolygon& polygon, ZonePolygon& zone) {
  for (const OGRLinearRing* ring : polygon) {
    std::vector<Vec2> points;
    for (int i = 0; i < ring->getNumPoints(); ++i)
      points.emplace_back(ring->getX(i), ring->getY(i));
    zone.rings.push_back(std::move(points));
  }
}

std::string feature_name(const OGRFeature& feature, const std::filesystem::path& path) {
  return path.string() + ": feature " + std::to_string(feature.GetFID());
}

ZonePolygon polygon_of(const OGRFeature& feature, int field, OGRCoordinateTransformation* transform,
                       const std::filesystem::path& path) {
  ZonePolygon result;
  if (feature.IsFieldSetAndNotNull(field)) result.zone = feature.GetFieldAsString(field);
  if (result.zone.empty()) {
    throw InputError(feature_name(feature, path) + " has an empty property \"zone\"");
  }
  const OGRGeometry* stored = feature.GetGeometryRef();
  const std::unique_ptr<OGRGeometry> geometry(stored ? stored->clone() : nullptr);
  if (geometry && transform && geometry->transform(transform) != OGRERR_NONE) {
    throw InputError(feature_name(feature, path) + " can't be projected (" +
                     GdalSession::message() + ")");
  }
  const OGRwkbGeometryType type = geometry ? wkbFlatten(geometry->getGeometryType()) : wkbUnknown;
  if (type == wkbPolygon) {
    add_rings(*geometry->toPolygon(), result);
  } else if (type == wkbMultiPolygon) {
    for (const OGRPolygon* part : *geometry->toMultiPolygon()) add_rings(*part, result);
  } else {
    throw InputError(feature_name(feature, path) + " (zone \"" + result.zone + "\") is a " +
                     (geometry ? geometry->getGeometryName() : "feature without geometry") +
                     "; zones must be polygons");
  }
  result.low = Vec2::Constant(1e300);
  result.high = -result.low;
  for (const std::vector<Vec2>& ring : result.rings) {
    for (const Vec2& point : ring) {
      if (!point.allFinite()) {
        throw InputError(feature_name(feature, path) + " has a corner that is not a number");
      }
      result.low = result.low.cwiseMin(point);
      result.high = result.high.cwiseMax(point);
    }
  }
  return result;
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
  const DatasetPointer dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  if (!dataset || dataset->GetLayerCount() < 1) {
    throw InputError(path.string() + ": holds no polygons that GDAL can read (" +
                     GdalSession::message() + ")");
  }
  if (dataset->GetLayerCount() > 1) {
    throw InputError(path.string() + ": " + std::to_string(dataset->GetLayerCount()) +
                     " layers; save the one with the zones by itself");
  }
  OGRLayer& layer = *dataset->GetLayer(0);
  const int field = layer.GetLayerDefn()->GetFieldIndex("zone");
  if (field < 0) {
    throw InputError(path.string() + ": its features have no property \"zone\" (there are: " +
                     field_names(*layer.GetLayerDefn()) + ")");
  }
  const Transformation transform = transformation(layer, crs, path);
  std::vector<ZonePolygon> polygons;
  layer.ResetReading();
  while (const std::unique_ptr<OGRFeature, DestroyFeature> feature{layer.GetNextFeature()}) {
    polygons.push_back(polygon_of(*feature, field, transform.get(), path));
  }
  if (polygons.empty()) throw InputError(path.string() + ": holds no polygons");
  return polygons;
}

bool is_polygon_file(const std::filesystem::path& path) {
  static const std::set<std::string> kKnown = {".geojson", ".json", ".gpkg", ".shp"};
  return kKnown.contains(extension_of(path));
}

}  // namespace clast::detail
