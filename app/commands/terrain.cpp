#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "app/text_table.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

namespace {

struct TerrainArgs {
  std::vector<std::string> inputs;
  std::string zones;
  std::string output = "terrain.h5";
  std::string exported;
  std::string export_up = "z";
  bool json = false;
  TerrainOptions options;
};

/// Triangles and plan area of each zone.
struct ZoneExtent {
  std::size_t triangles = 0;
  double plan_area = 0.0;  ///< m^2
};

std::vector<ZoneExtent> zone_extents(const Terrain& terrain) {
  std::vector<ZoneExtent> zones(terrain.zone_names.size());
  for (std::size_t i = 0; i < terrain.surface.triangles.size(); ++i) {
    const auto& [a, b, c] = terrain.surface.triangles[i];
    const Vec3 ab = terrain.surface.vertices[b] - terrain.surface.vertices[a];
    const Vec3 ac = terrain.surface.vertices[c] - terrain.surface.vertices[a];
    ZoneExtent& zone = zones[terrain.zone[i]];
    ++zone.triangles;
    zone.plan_area += std::abs(ab.x() * ac.y() - ab.y() * ac.x()) / 2.0;
  }
  return zones;
}

void print_report(const Terrain& terrain) {
  const TerrainReport& report = terrain.report;
  const Bounds box = bounds(terrain.surface);
  const Vec3 low = terrain.frame.map(box.low);
  const Vec3 high = terrain.frame.map(box.high);
  std::cout << counted(terrain.surface.triangles.size(), "triangle") << " of "
            << report.triangles_read << " read, in " << counted(report.components, "piece")
            << " with " << counted(report.boundary_edges, "border edge") << "\n";
  TextTable extent{{"map m", "from", "to"}, {}};
  const char* names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    extent.rows.push_back({names[axis], with_decimals(low[axis], 2), with_decimals(high[axis], 2)});
  }
  std::cout << extent.text();
  if (!terrain.frame.crs.empty()) std::cout << "map system " << terrain.frame.crs << "\n";
  TextTable zones{{"zone", "triangles", "plan area m2"}, {}};
  const std::vector<ZoneExtent> extents = zone_extents(terrain);
  for (std::size_t i = 0; i < extents.size(); ++i) {
    zones.rows.push_back({terrain.zone_names[i], std::to_string(extents[i].triangles),
                          rounded(extents[i].plan_area)});
  }
  std::cout << zones.text();
  for (const std::string& note : report.notes) std::cout << "note: " << note << "\n";
}

nlohmann::ordered_json report_json(const Terrain& terrain) {
  using Json = nlohmann::ordered_json;
  const TerrainReport& report = terrain.report;
  const Bounds box = bounds(terrain.surface);
  const Vec3 low = terrain.frame.map(box.low);
  const Vec3 high = terrain.frame.map(box.high);
  Json zones = Json::array();
  const std::vector<ZoneExtent> extents = zone_extents(terrain);
  for (std::size_t i = 0; i < extents.size(); ++i) {
    zones.push_back({{"zone", terrain.zone_names[i]},
                     {"triangles", extents[i].triangles},
                     {"plan_area_m2", extents[i].plan_area}});
  }
  return {{"triangles", terrain.surface.triangles.size()},
          {"triangles_read", report.triangles_read},
          {"welded_vertices", report.welded_vertices},
          {"dropped_degenerate", report.dropped_degenerate},
          {"dropped_duplicates", report.dropped_duplicates},
          {"turned_triangles", report.turned_triangles},
          {"boundary_edges", report.boundary_edges},
          {"components", report.components},
          {"low_m", {low.x(), low.y(), low.z()}},
          {"high_m", {high.x(), high.y(), high.z()}},
          {"crs", terrain.frame.crs},
          {"zones", zones},
          {"sources", terrain.sources},
          {"notes", report.notes}};
}

void make_terrain(TerrainArgs args) {
  args.options.surface.assign(args.inputs.begin(), args.inputs.end());
  args.options.zones = split_list(args.zones);
  check_usage([&] { args.options.check(); });
  const Terrain terrain = read_terrain(args.options);
  write_terrain(args.output, terrain);
  if (!args.exported.empty()) export_terrain(args.exported, terrain, args.export_up);
  if (args.json) {
    std::cout << report_json(terrain).dump(2) << "\n";
    return;
  }
  print_report(terrain);
  std::cout << args.output << ": written\n";
  if (!args.exported.empty()) std::cout << args.exported << ": written\n";
}

}  // namespace

void add_terrain(CLI::App& app) {
  const auto args = std::make_shared<TerrainArgs>();
  CLI::App* command = app.add_subcommand(
      "terrain", "Check surveyed ground with its zones and make it ready for simulation");
  command
      ->add_option("inputs", args->inputs,
                   "Meshes (stl, obj, ply, ...), one raster (GeoTIFF, asc, ...), clouds (las, pcd, "
                   "xyz, txt, "
                   "csv, pts), or one terrain file (h5)")
      ->required()
      ->type_name("INPUT");
  command->add_option("-o,--output", args->output, "Terrain file")
      ->type_name("FILE")
      ->capture_default_str();
  command
      ->add_option(
          "--zones", args->zones,
          "Ground zones: a name for each mesh, comma-separated, or one raster of class numbers, "
          "named as in zones.asc:1=blue,2=gray, or one GeoJSON, GeoPackage or Shapefile "
          "of polygons with a property \"zone\"; default: one zone, ground")
      ->type_name("LIST|FILE");
  command->add_option("--up", args->options.up, "Axis of the inputs that points up: y or z")
      ->check(up_axis())
      ->type_name("AXIS")
      ->capture_default_str();
  command
      ->add_option("--resolution", args->options.resolution,
                   "Cell size for clouds and resampled rasters, m")
      ->check(positive_number())
      ->type_name("M");
  CLI::Option* exported =
      command
          ->add_option("--export", args->exported,
                       "Also write the surface for viewing: stl, ply, obj, vtp, glb or tif")
          ->type_name("FILE");
  command->add_option("--export-up", args->export_up, "Up axis of the export: z or y")
      ->check(up_axis())
      ->needs(exported)
      ->type_name("AXIS")
      ->capture_default_str();
  command->add_flag("--json", args->json, "Print the report as JSON");
  command->footer(
      "Examples:\n"
      "  clast terrain blue.stl gray.stl red.stl --zones blue,gray,red --up y -o quarry.h5\n"
      "  clast terrain dem.tif --zones zones.geojson -o slope.h5 --export slope.vtp");
  command->callback([args] { make_terrain(*args); });
}

}  // namespace clast
