#include "report/gdal/detail/geopackage_file.hpp"

#include <cmath>

#include "core/version.hpp"
#include "report/gdal/detail/style_table.hpp"

namespace clast::report_detail {

using terrain_detail::check_written;

GeoPackageLayer::GeoPackageLayer(GDALDataset& dataset, const std::filesystem::path& target,
                                 const char* name, const OGRSpatialReference& crs,
                                 OGRwkbGeometryType type, const std::vector<Field>& fields)
    : target_(target), name_(name) {
  // The description keeps GeoPackage from guessing; the layer copies the reference.
  layer_ = dataset.CreateLayer(name, const_cast<OGRSpatialReference*>(&crs), type, nullptr);
  check_written(layer_ != nullptr, target_, "layer " + name_);
  for (const Field& field : fields) {
    OGRFieldDefn definition(field.first, field.second);
    check_written(layer_->CreateField(&definition) == OGRERR_NONE, target_, "layer " + name_);
    fields_.push_back(field.first);
  }
}

void GeoPackageLayer::add(FeaturePointer feature, const OGRGeometry& geometry) {
  feature->SetGeometry(&geometry);
  check_written(layer_->CreateFeature(feature.get()) == OGRERR_NONE, target_, "layer " + name_);
}

void set_feature_field(OGRFeature& feature, const std::string& name, const TableCell& cell) {
  if (const auto* count = std::get_if<std::uint64_t>(&cell)) {
    feature.SetField(name.c_str(), static_cast<GIntBig>(*count));
  } else if (const auto* text = std::get_if<std::string>(&cell)) {
    feature.SetField(name.c_str(), text->c_str());
  } else if (const double number = std::get<double>(cell); std::isfinite(number)) {
    feature.SetField(name.c_str(), number);
  }
}

GeoPackageFile::GeoPackageFile(const std::filesystem::path& target, const std::string& crs,
                               const OverwritePolicy& rules)
    : target_(target),
      // Else the time of writing stands in the file, and equal runs give different ones.
      date_("OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z", false),
      output_(target, rules),
      crs_(terrain_detail::make_spatial_reference(crs)) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  check_written(driver != nullptr, target_, "a GeoPackage: this GDAL has no GPKG driver");
  // OutputFile has made an empty file to claim the name; GDAL refuses to create over it.
  std::error_code ignored;
  std::filesystem::remove(output_.temporary_path(), ignored);
  dataset_.reset(
      driver->Create(output_.temporary_path().string().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  check(dataset_ != nullptr);
  check(dataset_->StartTransaction() == OGRERR_NONE);
}

void GeoPackageFile::commit(const std::vector<LayerStyle>& styles,
                            const std::vector<std::pair<std::string, std::string>>& metadata) {
  add_layer_style_table(*dataset_, target_, styles);
  check(dataset_->CommitTransaction() == OGRERR_NONE);
  dataset_->SetMetadataItem("PROGRAM", (std::string("clast ") + version()).c_str());
  for (const auto& [key, value] : metadata) {
    dataset_->SetMetadataItem(key.c_str(), value.c_str());
  }
  CPLErrorReset();
  dataset_.reset();
  check(CPLGetLastErrorType() < CE_Failure);
  output_.commit();
}

}  // namespace clast::report_detail
