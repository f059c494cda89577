#include "report/maps/gis_layers.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/output_file.hpp"
#include "core/version.hpp"
#include "report/maps/detail/gdal_output.hpp"
#include "study/path_samples.hpp"

namespace clast {

using namespace report_detail;
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
    }
  }

  Feature feature() const { return Feature(OGRFeature::CreateFeature(layer_->GetLayerDefn())); }
  void add(Feature feature, const OGRGeometry& geometry) {
    feature->SetGeometry(&geometry);
    check_written(layer_->CreateFeature(feature.get()) == OGRERR_NONE, target_, "layer " + name_);
  }

 private:
  std::filesystem::path target_;
  std::string name_;
  OGRLayer* layer_ = nullptr;
};

void set_run(OGRFeature& feature, const RunRow& row) {
  feature.SetField("file", static_cast<int>(row.file + 1));
  feature.SetField("run", static_cast<int>(row.record->run));
  feature.SetField("block", row.block->id.c_str());
  feature.SetField("class", row.block->sneed_folk.c_str());
  feature.SetField("shape", row.block->garcia.c_str());
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
  for (const RunRow& row : comparison.rows) {
    if (!row.stop.allFinite()) continue;  // a failed run may have no place
    const ReleaseResult& result = row.record->result;
    Feature feature = layer.feature();
    set_run(*feature, row);
    feature->SetField("point", static_cast<int>(row.record->point));
    feature->SetField("orientation", static_cast<int>(row.record->orientation));
    feature->SetField("stop_reason", name_of(result.stop_reason).c_str());
    feature->SetField("duration_s", result.duration);
    feature->SetField("runout_m", row.runout);
    feature->SetField("lateral_deg", row.lateral * 180.0 / kPi);
    feature->SetField("max_speed_m_s", result.max_speed);
    feature->SetField("mass_kg", row.block->mass);
    layer.add(std::move(feature), OGRPoint(row.stop.x(), row.stop.y(), row.stop.z()));
  }
}

void write_crossings(Layer layer, const Comparison& comparison) {
  for (const CrossingRow& row : comparison.crossings) {
    const Crossing& crossing = *row.crossing;
    Feature feature = layer.feature();
    set_run(*feature, comparison.rows[row.row]);
    feature->SetField("barrier", comparison.lines[row.barrier].name.c_str());
    feature->SetField("direction", comparison.lines[row.barrier].direction(crossing).c_str());
    feature->SetField("counted", row.counted ? 1 : 0);
    feature->SetField("time_s", crossing.time);
    feature->SetField("height_m", crossing.height);
    feature->SetField("clearance_m", crossing.clearance);
    feature->SetField("speed_m_s", crossing.velocity.norm());
    feature->SetField("translational_energy_j", crossing.translational_energy);
    feature->SetField("rotational_energy_j", crossing.rotational_energy);
    feature->SetField("rotation_rate_rad_s", crossing.angular_velocity.norm());
    layer.add(std::move(feature), OGRPoint(row.position.x(), row.position.y(), row.position.z()));
  }
}

void write_barriers(Layer layer, const Comparison& comparison) {
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    const BarrierLine& barrier = comparison.lines[line];
    Feature feature = layer.feature();
    feature->SetField("name", barrier.name.c_str());
    for (const BarrierGroup& group : comparison.barriers) {
      if (group.line != line || comparison.groups[group.group_index].kind != GroupKind::kAll ||
          comparison.groups[group.group_index].file) {
        continue;
      }
      feature->SetField("runs", static_cast<GIntBig>(group.started));
      feature->SetField("crossings", static_cast<GIntBig>(group.crossed));
      feature->SetField("probability", group.probability);
      if (group.crossed > 0) {
        feature->SetField("height_p95_m", group.height.p95);
        feature->SetField("total_energy_p95_j", group.total.p95);
      }
    }
    OGRLineString geometry;
    for (const Vec2& point : barrier.through) geometry.addPoint(point.x(), point.y());
    layer.add(std::move(feature), geometry);
  }
}

/// The way of every run with a stored trajectory, as a line through its frames.
void write_trajectories(Layer layer, const Comparison& comparison) {
  for_each_trajectory(
      comparison, [&](std::size_t index, const Trajectory& trajectory, const TerrainSurface&) {
        const RunRow& row = comparison.rows[index];
        if (trajectory.states.size() < 2) return;
        const Vec3& origin = comparison.results[row.file].frame.origin;
        OGRLineString line;
        for (const RigidState& state : trajectory.states) {
          const Vec3 place = origin + state.position;
          line.addPoint(place.x(), place.y(), place.z());
        }
        Feature feature = layer.feature();
        set_run(*feature, row);
        feature->SetField("stop_reason", name_of(row.record->result.stop_reason).c_str());
        feature->SetField("runout_m", row.runout);
        feature->SetField("max_speed_m_s", row.record->result.max_speed);
        feature->SetField("max_energy_j", row.record->contacts.max_energy);
        layer.add(std::move(feature), line);
      });
}

void write_measured(Layer layer, const MeasuredStops& measured) {
  for (const MeasuredStop& stop : measured.stops) {
    Feature feature = layer.feature();
    feature->SetField("block", stop.block.c_str());
    feature->SetField("shape", stop.shape.c_str());
    feature->SetField("runout_m", stop.runout);
    feature->SetField("lateral_deg", stop.lateral * 180.0 / kPi);
    layer.add(std::move(feature), OGRPoint(stop.place.x(), stop.place.y()));
  }
}

}  // namespace

void write_geopackage(const std::filesystem::path& path, const Comparison& comparison) {
  const QuietGdal quiet;
  CPLErrorReset();
  GDALAllRegister();
  OutputFile output(path);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  check_written(driver != nullptr, path, "a GeoPackage: this GDAL has no GPKG driver");
  // OutputFile has made an empty file to claim the name; GDAL refuses to create over it.
  std::error_code ignored;
  std::filesystem::remove(output.temporary(), ignored);
  Dataset dataset(
      driver->Create(output.temporary().string().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  check_written(dataset != nullptr, path, "a GeoPackage");

  const OGRSpatialReference crs = reference_of(comparison.results.front().frame.crs);
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
