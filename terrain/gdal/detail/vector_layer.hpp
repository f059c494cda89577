#pragma once
/// GDAL helpers for reading polygons and lines. For .cpp files only.
#include <ogrsf_frmts.h>

#include <filesystem>
#include <memory>
#include <string>

#include "terrain/gdal/detail/gdal_session.hpp"

namespace clast::terrain_detail {

struct FeatureDeleter {
  void operator()(OGRFeature* feature) const { OGRFeature::DestroyFeature(feature); }
};
using FeaturePointer = std::unique_ptr<OGRFeature, FeatureDeleter>;

struct TransformationDeleter {
  void operator()(OGRCoordinateTransformation* t) const {
    OGRCoordinateTransformation::DestroyCT(t);
  }
};
using TransformationPointer = std::unique_ptr<OGRCoordinateTransformation, TransformationDeleter>;

/// Opens a vector file.
/// @param what  kind of features for messages: "polygons" or "lines"
/// @throws InputError  if it cannot be read
DatasetPointer open_feature_file(const std::filesystem::path& path, const std::string& what);

/// Finds the only layer with geometry. Attribute tables, such as QGIS styles, are ignored.
/// @throws InputError  if no layer or several layers have geometry
OGRLayer& find_geometry_layer(GDALDataset& dataset, const std::filesystem::path& path,
                              const std::string& what);

/// Makes the transformation from the layer's coordinate system to that of the terrain; null if they
/// are equal or one is unknown. GeoJSON without a system is in WGS 84 degrees. If its coordinates
/// are too large for degrees, they are taken as metres in the terrain's system.
/// @throws InputError  if GDAL cannot transform between the systems
TransformationPointer make_transformation(OGRLayer& layer, const std::string& crs,
                                          const std::filesystem::path& path);

/// Returns the geometry of a feature in the terrain's coordinate system; null if it has none. Arcs
/// are replaced by lines that deviate by at most a thousandth of the radius.
/// @throws InputError  if it cannot be transformed
std::unique_ptr<OGRGeometry> linearised_geometry(const OGRFeature& feature,
                                                 OGRCoordinateTransformation* transform,
                                                 const std::filesystem::path& path);

/// Formats the name of a feature as "lines.geojson: feature 3".
std::string feature_name(const OGRFeature& feature, const std::filesystem::path& path);

}  // namespace clast::terrain_detail
