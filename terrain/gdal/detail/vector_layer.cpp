#include "terrain/gdal/detail/vector_layer.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/files/input_file.hpp"
#include "mesh/reference_system.hpp"

namespace clast::terrain_detail {

DatasetPointer open_feature_file(const std::filesystem::path& path, const std::string& what) {
  check_input_file(path);
  DatasetPointer dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  if (!dataset || dataset->GetLayerCount() < 1) {
    throw InputError(path.string() + ": holds no " + what + " that GDAL can read (" +
                     GdalSession::last_message() + "); save them as GeoJSON or GeoPackage");
  }
  return dataset;
}

OGRLayer& find_geometry_layer(GDALDataset& dataset, const std::filesystem::path& path,
                              const std::string& what) {
  std::vector<OGRLayer*> layers;
  std::string names;
  for (int i = 0; i < dataset.GetLayerCount(); ++i) {
    OGRLayer* layer = dataset.GetLayer(i);
    if (!layer || layer->GetGeomType() == wkbNone) continue;
    layers.push_back(layer);
    names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
  }
  if (layers.empty()) {
    throw InputError(path.string() + ": holds no layer of " + what +
                     "; save them as GeoJSON or GeoPackage");
  }
  if (layers.size() > 1) {
    throw InputError(path.string() + ": " + std::to_string(layers.size()) + " layers (" + names +
                     "); save the one with the " + what + " by itself (ogr2ogr ONE.gpkg " +
                     path.filename().string() + " LAYER)");
  }
  return *layers.front();
}

TransformationPointer make_transformation(OGRLayer& layer, const std::string& crs,
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
  TransformationPointer result(OGRCreateCoordinateTransformation(&source, &to));
  if (!result) {
    throw InputError(path.string() + ": can't be brought into the terrain's coordinate system (" +
                     GdalSession::last_message() + "); save it in " + reference_system_name(crs));
  }
  return result;
}

std::unique_ptr<OGRGeometry> linearised_geometry(const OGRFeature& feature,
                                                 OGRCoordinateTransformation* transform,
                                                 const std::filesystem::path& path) {
  constexpr double kStep = 2.0;  // degrees of an arc to a chord
  const OGRGeometry* stored = feature.GetGeometryRef();
  if (!stored) return nullptr;
  std::unique_ptr<OGRGeometry> geometry(
      stored->hasCurveGeometry() ? stored->getLinearGeometry(kStep) : stored->clone());
  if (geometry && transform && geometry->transform(transform) != OGRERR_NONE) {
    throw InputError(feature_name(feature, path) + " can't be projected (" +
                     GdalSession::last_message() + "); check its coordinates and its map system");
  }
  return geometry;
}

std::string feature_name(const OGRFeature& feature, const std::filesystem::path& path) {
  return path.string() + ": feature " + std::to_string(feature.GetFID());
}

}  // namespace clast::terrain_detail
