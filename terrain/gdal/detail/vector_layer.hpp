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
using Transformation = std::unique_ptr<OGRCoordinateTransformation, TransformationDeleter>;

/// Opens a vector file.
/// @param what  "polygons", "lines"
/// @throws InputError  if it cannot be read
DatasetPointer open_feature_file(const std::filesystem::path& path, const std::string& what);

/// Finds the single layer with geometry; attribute tables, such as QGIS styles, are ignored.
/// @throws InputError  if there is none, or several
OGRLayer& find_geometry_layer(GDALDataset& dataset, const std::filesystem::path& path,
                              const std::string& what);

/// Makes the transformation from the layer's system to the terrain's; none if they agree or one is
/// unknown. GeoJSON without a system counts as WGS 84 degrees, but coordinates beyond degrees are
/// taken as map metres.
/// @throws InputError  if GDAL cannot transform between the systems
Transformation make_transformation(OGRLayer& layer, const std::string& crs,
                                   const std::filesystem::path& path);

/// Returns the geometry of a feature on the terrain's map, with arcs linearised to a thousandth of
/// their radius; null if it has none.
/// @throws InputError  if it cannot be transformed
std::unique_ptr<OGRGeometry> linearised_geometry(const OGRFeature& feature,
                                                 OGRCoordinateTransformation* transform,
                                                 const std::filesystem::path& path);

/// Formats the name of a feature as "lines.geojson: feature 3".
std::string feature_name(const OGRFeature& feature, const std::filesystem::path& path);

}  // namespace clast::terrain_detail
