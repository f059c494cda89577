#pragma once
/// What readers of polygons and lines share of GDAL. For .cpp files only.
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

/// A file of features.
/// @param what  "polygons", "lines"
/// @throws InputError  unreadable
DatasetPointer open_feature_file(const std::filesystem::path& path, const std::string& what);

/// Its one layer with geometry. Tables without, as of the styles that QGIS keeps in a GeoPackage,
/// do not count.
/// @throws InputError  none, or several
OGRLayer& find_geometry_layer(GDALDataset& dataset, const std::filesystem::path& path,
                              const std::string& what);

/// From the layer's system to the terrain's; none when they agree or one is unknown. GeoJSON that
/// names no system counts as WGS 84 degrees, but is often written in map metres: numbers beyond
/// degrees are taken as they are.
/// @throws InputError  systems that GDAL can't bring together
Transformation make_transformation(OGRLayer& layer, const std::string& crs,
                                   const std::filesystem::path& path);

/// The geometry of a feature on the terrain's map, arcs as chords that stay within a thousandth of
/// their radius; null where it has none.
/// @throws InputError  it can't be projected
std::unique_ptr<OGRGeometry> linearised_geometry(const OGRFeature& feature,
                                                 OGRCoordinateTransformation* transform,
                                                 const std::filesystem::path& path);

/// "lines.geojson: feature 3"
std::string feature_name(const OGRFeature& feature, const std::filesystem::path& path);

}  // namespace clast::terrain_detail
