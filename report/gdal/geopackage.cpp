#include "report/gdal/geopackage.hpp"

#include <ogrsf_frmts.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/angle.hpp"
#include "report/gdal/detail/geopackage_file.hpp"
#include "report/maps/qgis_styles.hpp"
#include "report/tables/comparison_columns.hpp"
#include "study/compare/path_samples.hpp"

namespace clast {

using namespace report_detail;
namespace {

using Layer = GeoPackageLayer;

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
    FeaturePointer feature = layer.feature();
    set_feature_fields(*feature, columns, {comparison, row});
    layer.add(std::move(feature), OGRPoint(row.stop.x(), row.stop.y(), row.stop.z()));
  }
}

void write_crossings(Layer layer, const Comparison& comparison) {
  const auto columns = selected_columns(crossing_columns(), layer.fields());
  for (const BarrierCrossing& row : comparison.crossings) {
    FeaturePointer feature = layer.feature();
    set_feature_fields(*feature, columns, {comparison, row});
    layer.add(std::move(feature), OGRPoint(row.position.x(), row.position.y(), row.position.z()));
  }
}

void write_barriers(Layer layer, const Comparison& comparison) {
  const auto columns =
      selected_columns(barrier_table_columns(),
                       {"runs", "crossings", "probability", "height_p95_m", "total_energy_p95_j"});
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    const BarrierLine& barrier = comparison.lines[line];
    FeaturePointer feature = layer.feature();
    feature->SetField("name", barrier.name.c_str());
    for (const BarrierGroupStatistics& row : comparison.barriers) {
      const RunGroup& group = comparison.groups[row.group_index];
      if (row.line == line && group.kind == RunGroupKind::kAll && !group.file) {
        set_feature_fields(*feature, columns, row);
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
                        FeaturePointer feature = layer.feature();
                        set_feature_fields(*feature, columns, {comparison, row});
                        layer.add(std::move(feature), line);
                      });
}

void write_measured(Layer layer, const MeasuredStops& measured) {
  for (const MeasuredStop& stop : measured.stops) {
    FeaturePointer feature = layer.feature();
    feature->SetField("block", stop.block.c_str());
    feature->SetField("shape", stop.shape.c_str());
    feature->SetField("runout_m", stop.runout);
    feature->SetField("lateral_deg", stop.lateral * kDegreesPerRadian);
    layer.add(std::move(feature), OGRPoint(stop.position.x(), stop.position.y()));
  }
}

}  // namespace

void write_geopackage(const std::filesystem::path& path, const Comparison& comparison) {
  GeoPackageFile file(path, comparison.results.front().frame.crs);
  write_stops(file.add_layer("stops", wkbPoint25D,
                             with_run_fields({{"point", OFTInteger},
                                              {"orientation", OFTInteger},
                                              {"stop_reason", OFTString},
                                              {"duration_s", OFTReal},
                                              {"runout_m", OFTReal},
                                              {"lateral_deg", OFTReal},
                                              {"max_speed_m_s", OFTReal},
                                              {"mass_kg", OFTReal}})),
              comparison);
  write_crossings(file.add_layer("crossings", wkbPoint25D,
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
  write_barriers(file.add_layer("barriers", wkbLineString,
                                {{"name", OFTString},
                                 {"runs", OFTInteger64},
                                 {"crossings", OFTInteger64},
                                 {"probability", OFTReal},
                                 {"height_p95_m", OFTReal},
                                 {"total_energy_p95_j", OFTReal}}),
                 comparison);
  write_trajectories(file.add_layer("trajectories", wkbLineString25D,
                                    with_run_fields({{"stop_reason", OFTString},
                                                     {"runout_m", OFTReal},
                                                     {"max_speed_m_s", OFTReal},
                                                     {"max_energy_j", OFTReal}})),
                     comparison);
  if (comparison.measured) {
    write_measured(file.add_layer("measured", wkbPoint,
                                  {{"block", OFTString},
                                   {"shape", OFTString},
                                   {"runout_m", OFTReal},
                                   {"lateral_deg", OFTReal}}),
                   *comparison.measured);
  }
  std::vector<std::pair<std::string, std::string>> metadata;
  for (std::size_t i = 0; i < comparison.results.size(); ++i) {
    metadata.emplace_back("CAMPAIGN_SHA256_" + std::to_string(i + 1),
                          comparison.results[i].campaign_sha256);
  }
  file.commit(make_vector_styles(comparison), metadata);
}

}  // namespace clast
