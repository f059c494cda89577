#pragma once
/// GeoPackages and their layers. For .cpp files only.
#include <ogrsf_frmts.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/files/output_file.hpp"
#include "core/files/table.hpp"
#include "report/maps/layer_style.hpp"
#include "terrain/gdal/detail/gdal_session.hpp"

namespace clast::report_detail {

struct FeatureDestroyer {
  void operator()(OGRFeature* feature) const { OGRFeature::DestroyFeature(feature); }
};
using FeaturePointer = std::unique_ptr<OGRFeature, FeatureDestroyer>;

/// Layer of a GeoPackage that is being filled.
class GeoPackageLayer {
 public:
  using Field = std::pair<const char*, OGRFieldType>;

  /// Adds a layer to a dataset.
  /// @param target  file name for messages
  /// @throws InputError  if GDAL cannot write the layer
  GeoPackageLayer(GDALDataset& dataset, const std::filesystem::path& target, const char* name,
                  const OGRSpatialReference& crs, OGRwkbGeometryType type,
                  const std::vector<Field>& fields);

  const std::vector<std::string>& fields() const { return fields_; }
  FeaturePointer feature() const {
    return FeaturePointer(OGRFeature::CreateFeature(layer_->GetLayerDefn()));
  }
  /// Adds a feature.
  /// @throws InputError  if GDAL cannot write it
  void add(FeaturePointer feature, const OGRGeometry& geometry);

 private:
  std::filesystem::path target_;
  std::string name_;
  std::vector<std::string> fields_;
  OGRLayer* layer_ = nullptr;
};

/// Sets the field of a feature that has the name of a column; texts, counts and finite numbers.
void set_feature_field(OGRFeature& feature, const std::string& name, const TableCell& cell);

/// Sets the fields that are columns of a table. An empty cell is a field that is not set.
template <class Row>
void set_feature_fields(OGRFeature& feature, const TableColumns<Row>& columns, const Row& row) {
  for (const TableColumn<Row>& column : columns) {
    set_feature_field(feature, column.name, column.value(row));
  }
}

/// GeoPackage that appears whole or not at all. Equal contents give equal files.
class GeoPackageFile {
 public:
  /// Begins a file.
  /// @param crs  "EPSG:25832" or WKT; if empty, the layers have a local system in metres
  /// @throws InputError  if GDAL cannot write the file, or `rules` do not allow to replace one
  GeoPackageFile(const std::filesystem::path& target, const std::string& crs,
                 const OverwritePolicy& rules = {});

  GeoPackageLayer add_layer(const char* name, OGRwkbGeometryType type,
                            const std::vector<GeoPackageLayer::Field>& fields) {
    return {*dataset_, target_, name, crs_, type, fields};
  }
  /// Adds the styles, completes the file and renames it to its target.
  /// @param metadata  keys and values beside the program version
  /// @throws InputError  if GDAL cannot write the file
  void commit(const std::vector<LayerStyle>& styles,
              const std::vector<std::pair<std::string, std::string>>& metadata = {});

 private:
  void check(bool done) const { terrain_detail::check_written(done, target_, "a GeoPackage"); }

  std::filesystem::path target_;
  terrain_detail::GdalSession session_;
  CPLConfigOptionSetter date_;
  OutputFile output_;
  terrain_detail::DatasetPointer dataset_;
  OGRSpatialReference crs_;
};

}  // namespace clast::report_detail
