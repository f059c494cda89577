#include "report/gdal/geopackage.hpp"

#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/angle.hpp"
#include "core/files/output_file.hpp"
#include "core/version.hpp"
#include "report/gdal/detail/style_table.hpp"
#include "report/maps/qgis_styles.hpp"
#include "report/tables/comparison_columns.hpp"
#include "study/compare/path_samples.hpp"
#include "terrain/gdal/detail/gdal_session.hpp"

namespace clast {

using namespace report_detail;
using namespace terrain_detail;
namespace {

struct FeatureDestroyer {
  void operator()(OGRFeature* feature) const { OGRFeature::DestroyFeature(feature); }
};
using Feature = std::unique_ptr<OGRFeature, FeatureDestroyer>;

/// One layer being filled.
class Layer {
 public:
  using Field = std::pair<const char*, OGRFieldType>;

  Layer(GDALDataset& dataset, const std::filesystem::path& target, const char* name,
        const OGRSpatialReference* crs, OGRwkbGeometryType type, const std::vector<Field>& fields)
      : target_(target), name_(name) {
    // The description keeps GeoPackage from guessing; the layer copies the reference.
    layer_ = dataset.CreateLayer(name, const_cast<OGRSpatialReference*>(crs), type, nullptr);
    check_written(layer_ != nullptr, target_, "layer " + name_);
    for (const Field& field : fields) {
      OGRFieldDefn definition(field.first, field.second);
      check_written(layer_->CreateField(&definition) == OGRERR_NONE, target_, "layer " + name_);
      fields_.push_back(field.first);
    }
  }

  const std::vector<std::string>& fields() const { return fields_; }
  Feature feature() const { return Feature(OGRFeature::CreateFeature(layer_->GetLayerDefn())); }
  void add(Feature feature, const OGRGeometry& geometry) {
    feature->SetGeometry(&geometry);
    check_written(layer_->CreateFeature(feature.get()) == OGRERR_NONE, target_, "layer " + name_);
  }

 private:
  std::filesystem::path target_;
  std::string name_;
  std::vector<std::string> fields_;
  OGRLayer* layer_ = nullptr;
};

/// Fields that are columns of a table. An empty cell is a field that is not set.
template <class Row>
void set_fields(OGRFeature& feature, const TableColumns<Row>& columns, const Row& row) {
  for (const TableColumn<Row>& column : columns) {
    const TableCell cell = column.value(row);
    const char* name = column.name.c_str();
    if (const auto* count = std::get_if<std::uint64_t>(&cell)) {
      feature.SetField(name, static_cast<GIntBig>(*count));
    } else if (const auto* text = std::get_if<std::string>(&cell)) {
      feature.SetField(name, text->c_str());
    } else if (const double number = std::get<double>(cell); std::isfinite(number)) {
      feature.SetField(name, number);
    }
  }
}

const std::vector<Layer::Field> kRunFields = {{"file", OFTInteger},
                                              {"run", OFTInteger},
                                              {"block", OFTString},
                                              {"class", OFTString},
                                              {"shape", OFTString}};

std::vector<Layer::Field> with_run_fields(const std::vector<Layer::Field>& more) {
  std::vector<Layer::Field> fields = kRunFields;
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

void write_stops(Layer layer, const Comparison& comparison) {
  const auto columns = selected_columns(run_columns(), layer.fields());
  for (const RunRow& row : comparison.rows) {
    if (!row.stop.allFinite()) continue;  // a failed run may have no place
    Feature feature = layer.feature();
    set_fields(*feature, columns, {comparison, row});
    layer.add(std::move(feature), OGRPoint(row.stop.x(), row.stop.y(), row.stop.z()));
  }
}

void write_crossings(Layer layer, const Comparison& comparison) {
  const auto columns = selected_columns(crossing_columns(), layer.fields());
  for (const BarrierCrossing& row : comparison.crossings) {
    Feature feature = layer.feature();
    set_fields(*feature, columns, {comparison, row});
    layer.add(std::move(feature), OGRPoint(row.position.x(), row.position.y(), row.position.z()));
  }
}

void write_barriers(Layer layer, const Comparison& comparison) {
  const auto columns =
      selected_columns(barrier_table_columns(),
                       {"runs", "crossings", "probability", "height_p95_m", "total_energy_p95_j"});
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    const BarrierLine& barrier = comparison.lines[line];
    Feature feature = layer.feature();
    feature->SetField("name", barrier.name.c_str());
    for (const BarrierGroupStatistics& row : comparison.barriers) {
      const RunGroup& group = comparison.groups[row.group_index];
      if (row.line == line && group.kind == RunGroupKind::kAll && !group.file) {
        set_fields(*feature, columns, row);
      }
    }
    OGRLineString geometry;
    for (const Vec2& point : barrier.vertices) geometry.addPoint(point.x(), point.y());
    layer.add(std::move(feature), geometry);
  }
}

/// The way of every run with a stored trajectory, as a line through its frames.
void write_trajectories(Layer layer, const Comparison& comparison) {
  const auto columns = selected_columns(run_columns(), layer.fields());
  for_each_trajectory(comparison,
                      [&](std::size_t index, const Trajectory& trajectory, const TerrainSurface&) {
                        const RunRow& row = comparison.rows[index];
                        if (trajectory.states.size() < 2) return;
                        const Vec3& origin = comparison.results[row.file].frame.origin;
                        OGRLineString line;
                        for (const RigidState& state : trajectory.states) {
                          const Vec3 place = origin + state.position;
                          line.addPoint(place.x(), place.y(), place.z());
                        }
                        Feature feature = layer.feature();
                        set_fields(*feature, columns, {comparison, row});
                        layer.add(std::move(feature), line);
                      });
}

void write_measured(Layer layer, const MeasuredStops& measured) {
  for (const MeasuredStop& stop : measured.stops) {
    Feature feature = layer.feature();
    feature->SetField("block", stop.block.c_str());
    feature->SetField("shape", stop.shape.c_str());
    feature->SetField("runout_m", stop.runout);
    feature->SetField("lateral_deg", stop.lateral * kDegreesPerRadian);
    layer.add(std::move(feature), OGRPoint(stop.position.x(), stop.position.y()));
  }
}

}  // namespace

void write_geopackage(const std::filesystem::path& path, const Comparison& comparison) {
  const GdalSession session;
  // Else the time of writing stands in the file, and equal runs give different ones.
  const CPLConfigOptionSetter date("OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z", false);
  OutputFile output(path);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  check_written(driver != nullptr, path, "a GeoPackage: this GDAL has no GPKG driver");
  // OutputFile has made an empty file to claim the name; GDAL refuses to create over it.
  std::error_code ignored;
  std::filesystem::remove(output.temporary_path(), ignored);
  DatasetPointer dataset(
      driver->Create(output.temporary_path().string().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  check_written(dataset != nullptr, path, "a GeoPackage");

  const OGRSpatialReference crs = make_spatial_reference(comparison.results.front().frame.crs);
  const OGRSpatialReference* reference = &crs;

  check_written(dataset->StartTransaction() == OGRERR_NONE, path, "a GeoPackage");
  write_stops(Layer(*dataset, path, "stops", reference, wkbPoint25D,
                    with_run_fields({{"point", OFTInteger},
                                     {"orientation", OFTInteger},
                                     {"stop_reason", OFTString},
                                     {"duration_s", OFTReal},
                                     {"runout_m", OFTReal},
                                     {"lateral_deg", OFTReal},
                                     {"max_speed_m_s", OFTReal},
                                     {"mass_kg", OFTReal}})),
              comparison);
  write_crossings(Layer(*dataset, path, "crossings", reference, wkbPoint25D,
                        with_run_fields({{"barrier", OFTString},
                                         {"direction", OFTString},
                                         {"counted", OFTInteger},
                                         {"time_s", OFTReal},
                                         {"height_m", OFTReal},
                                         {"clearance_m", OFTReal},
                                         {"speed_m_s", OFTReal},
                                         {"translational_energy_j", OFTReal},
                                         {"rotational_energy_j", OFTReal},
                                         {"rotation_rate_rad_s", OFTReal}})),
                  comparison);
  write_barriers(Layer(*dataset, path, "barriers", reference, wkbLineString,
                       {{"name", OFTString},
                        {"runs", OFTInteger64},
                        {"crossings", OFTInteger64},
                        {"probability", OFTReal},
                        {"height_p95_m", OFTReal},
                        {"total_energy_p95_j", OFTReal}}),
                 comparison);
  write_trajectories(Layer(*dataset, path, "trajectories", reference, wkbLineString25D,
                           with_run_fields({{"stop_reason", OFTString},
                                            {"runout_m", OFTReal},
                                            {"max_speed_m_s", OFTReal},
                                            {"max_energy_j", OFTReal}})),
                     comparison);
  if (comparison.measured) {
    write_measured(Layer(*dataset, path, "measured", reference, wkbPoint,
                         {{"block", OFTString},
                          {"shape", OFTString},
                          {"runout_m", OFTReal},
                          {"lateral_deg", OFTReal}}),
                   *comparison.measured);
  }
  add_layer_style_table(*dataset, path, make_vector_styles(comparison));
  check_written(dataset->CommitTransaction() == OGRERR_NONE, path, "a GeoPackage");
  dataset->SetMetadataItem("PROGRAM", (std::string("clast ") + version()).c_str());
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const std::string key = "CAMPAIGN_SHA256_" + std::to_string(file + 1);
    dataset->SetMetadataItem(key.c_str(), comparison.results[file].campaign_sha256.c_str());
  }
  CPLErrorReset();
  dataset.reset();
  check_written(CPLGetLastErrorType() < CE_Failure, path, "a GeoPackage");
  output.commit();
}

}  // namespace clast
