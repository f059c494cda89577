#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/text_table.hpp"
#include "library/block_ranges.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/plan_geometry.hpp"
#include "mesh/reference_system.hpp"
#include "report/maps/site_map.hpp"
#include "report/maps/svg_map.hpp"
#include "study/campaign/release_points.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_fit.hpp"
#include "terrain/terrain_input.hpp"
#include "terrain/terrain_ranges.hpp"

namespace clast {

namespace {

struct TerrainArgs {
  std::vector<std::string> inputs;
  std::string zones;
  std::string output = "terrain.h5";
  std::string exported;
  std::string export_up = "auto";
  double export_cell = 0.5;
  std::string breaklines;
  std::string columns;
  std::string picture;
  std::string releases;
  std::string barriers;
  double border_distance = 5.0;
  std::optional<double> block_size;
  bool json = false;
  bool replace = false;
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
    const std::vector<Vec3>& v = terrain.surface.vertices;
    ZoneExtent& zone = zones[terrain.zone[i]];
    ++zone.triangles;
    zone.plan_area += std::abs(twice_area(v[a].head<2>(), v[b].head<2>(), v[c].head<2>())) / 2.0;
  }
  return zones;
}

void print_report(const Terrain& terrain) {
  const TerrainReport& report = terrain.report;
  const Bounds box = bounds(terrain.surface);
  const Vec3 low = terrain.frame.to_map(box.low);
  const Vec3 high = terrain.frame.to_map(box.high);
  std::cout << format_count(terrain.surface.triangles.size(), "triangle") << " of "
            << report.triangles_read << " read, in " << format_count(report.components, "component")
            << " with " << format_count(report.boundary_edges, "border edge") << "\n";
  TextTable extent{{"map m", "from", "to"}, {}};
  const char* names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    extent.rows.push_back(
        {names[axis], format_decimals(low[axis], 2), format_decimals(high[axis], 2)});
  }
  std::cout << extent.text();
  if (!terrain.frame.crs.empty())
    std::cout << "map system " << reference_system_name(terrain.frame.crs) << "\n";
  TextTable zones{{"zone", "triangles", "plan area m2"}, {}};
  const std::vector<ZoneExtent> extents = zone_extents(terrain);
  for (std::size_t i = 0; i < extents.size(); ++i) {
    zones.rows.push_back({terrain.zone_names[i], std::to_string(extents[i].triangles),
                          format_rounded(extents[i].plan_area)});
  }
  std::cout << zones.text();
  for (const std::string& note : report.notes) {
    std::cout << "note: " << format_for_terminal(note) << "\n";
  }
}

nlohmann::ordered_json report_json(const Terrain& terrain) {
  using Json = nlohmann::ordered_json;
  const TerrainReport& report = terrain.report;
  const Bounds box = bounds(terrain.surface);
  const Vec3 low = terrain.frame.to_map(box.low);
  const Vec3 high = terrain.frame.to_map(box.high);
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
          {"dropped_degenerate", report.removed_degenerate},
          {"dropped_duplicates", report.removed_duplicates},
          {"turned_triangles", report.flipped_triangles},
          {"closed_cracks", report.closed_cracks},
          {"filled_holes", report.filled_holes},
          {"open_holes", report.open_holes},
          {"levelled_spikes", report.levelled_spikes},
          {"dropped_pieces", report.removed_components},
          {"slivers", report.slivers},
          {"boundary_edges", report.boundary_edges},
          {"components", report.components},
          {"low_m", {low.x(), low.y(), low.z()}},
          {"high_m", {high.x(), high.y(), high.z()}},
          {"crs", terrain.frame.crs},
          {"zones", zones},
          {"sources", terrain.sources},
          {"notes", report.notes}};
}

/// Release points of a file, on the map, z up.
std::vector<Vec3> release_points(const TerrainArgs& args) {
  std::vector<Vec3> points;
  if (args.releases.empty()) return points;
  points = read_point_table(args.releases);
  if (resolve_up_axis(args.options.up, args.inputs.front()) == "y") {
    for (Vec3& point : points) point = y_up_to_z_up(point);
  }
  return points;
}

/// Checks the ground for its purpose; adds problems to the notes.
void check_fit(const TerrainArgs& args, const std::vector<Vec3>& releases, Terrain& terrain) {
  const auto note = [&](const std::optional<std::string>& warning) {
    if (warning) terrain.report.notes.push_back(*warning);
  };
  if (!releases.empty()) {
    check_positions_over_terrain(terrain, releases, args.releases);
    note(border_warning(terrain, releases, args.border_distance));
  }
  if (args.block_size) note(edge_length_warning(terrain, *args.block_size, *args.block_size));
}

/// Files that an export or an image of that name may replace.
OverwritePolicy rules_of(const TerrainArgs& args, const std::string& file) {
  return {.kind = file_kind_by_extension(file), .replace = args.replace};
}

OverwritePolicy terrain_rules(const TerrainArgs& args) {
  return {.kind = kTerrainFormat, .replace = args.replace};
}

void draw_picture(const TerrainArgs& args, const std::vector<Vec3>& releases,
                  const Terrain& terrain) {
  std::vector<Vec2> places;
  for (const Vec3& release : releases) places.push_back(release.head<2>());
  std::vector<std::vector<Vec2>> lines;
  if (!args.barriers.empty()) lines = read_barrier_lines(args.barriers, terrain);
  write_output(args.picture, draw_svg_map(make_site_map(terrain, places, lines)),
               rules_of(args, args.picture));
}

/// Refuses outputs that would replace files that must be kept, before the work starts.
void check_places(const TerrainArgs& args) {
  check_output_target(args.output, terrain_rules(args));
  if (!args.exported.empty()) check_mesh_output(args.exported, rules_of(args, args.exported));
  if (!args.picture.empty()) check_output_target(args.picture, rules_of(args, args.picture));
}

/// Refuses outputs of a kind that can't be written, or in the place of what is read.
void check_outputs(const TerrainArgs& args) {
  const auto check_extension = [](const std::string& option, const std::string& file,
                                  const std::vector<std::string>& known) {
    if (file.empty()) return;
    const std::string extension = lower_case_extension(file);
    if (std::find(known.begin(), known.end(), extension) != known.end()) return;
    throw InputError(option + " " + file + ": its name must end in " + comma_separated(known));
  };
  check_extension("--output", args.output, {".h5", ".hdf5"});
  check_extension("--export", args.exported,
                  {".stl", ".ply", ".obj", ".vtp", ".glb", ".tif", ".tiff"});
  check_extension("--picture", args.picture, {".svg"});
  std::vector<std::string> inputs = split_comma_separated(args.breaklines);
  for (const std::string& file : {args.releases, args.barriers}) {
    if (!file.empty()) inputs.push_back(file);
  }
  if (const std::optional<ZoneFile> zones = parse_zone_file(args.options.zones)) {
    inputs.push_back(zones->path.string());
  }
  // A terrain file may be written anew under its own name.
  for (const std::string& file : args.inputs) {
    if (file != args.output) inputs.push_back(file);
  }
  for (const std::string& output : {args.output, args.exported, args.picture}) {
    for (const std::string& input : inputs) {
      if (output.empty() || !is_same_file(output, input)) continue;
      throw InputError(output + ": is an input and would be overwritten; give another name");
    }
  }
}

void make_terrain(TerrainArgs args) {
  args.options.surface.assign(args.inputs.begin(), args.inputs.end());
  args.options.zones = split_comma_separated(args.zones);
  args.options.columns = split_comma_separated(args.columns);
  for (const std::string& file : split_comma_separated(args.breaklines)) {
    args.options.breaklines.emplace_back(file);
  }
  check_usage([&] {
    args.options.check();
    check_outputs(args);
  });
  check_places(args);
  const std::vector<Vec3> releases = release_points(args);
  Terrain terrain = read_terrain(args.options);
  check_fit(args, releases, terrain);
  if (!args.picture.empty()) draw_picture(args, releases, terrain);
  write_terrain(args.output, terrain, terrain_rules(args));
  if (!args.exported.empty()) {
    export_terrain(args.exported, terrain, args.export_up, args.export_cell,
                   rules_of(args, args.exported));
  }
  if (args.json) {
    std::cout << report_json(terrain).dump(2) << "\n";
    return;
  }
  print_report(terrain);
  std::cout << escape_nonprintable(args.output) << ": written\n";
  if (!args.exported.empty()) std::cout << escape_nonprintable(args.exported) << ": written\n";
  if (!args.picture.empty()) std::cout << escape_nonprintable(args.picture) << ": written\n";
}

void add_grid_options(CLI::App& command, TerrainArgs& args) {
  TerrainOptions& options = args.options;
  command
      .add_option("--columns", args.columns,
                  "Columns x, y and z of clouds in text, by name or number from 1, such as 2,3,4; "
                  "default: from the heading")
      ->type_name("X,Y,Z");
  command
      .add_option("--resolution", options.resolution,
                  "Cell size for clouds, and for rasters and meshes that are to be resampled, m; "
                  "default: about four points of a cloud per cell, no resampling of others")
      ->check(number_in_range(kCellSizeRange))
      ->type_name("M");
  command
      .add_option("--percentile", options.percentile,
                  "Height of a cell of a cloud: this percentile of the heights of its points, 0 "
                  "for the lowest; default: their mean")
      ->check(number_in_range(kPercentileRange))
      ->type_name("P");
  command
      .add_option("--outliers", options.outliers,
                  "Leave out points of a cloud that are farther than this above or below the "
                  "surrounding ground, m")
      ->check(number_in_range(kOutlierDistanceRange))
      ->type_name("M");
  command
      .add_option("--fill", options.fill,
                  "Fill holes up to this width, m; default: 3 cells of a cloud, 3 median edges of "
                  "a mesh, none of a raster")
      ->check(number_in_range(kHoleWidthRange))
      ->type_name("M");
  command
      .add_option("--breaklines", args.breaklines,
                  "Lines with heights (GeoJSON, GeoPackage, Shapefile; comma-separated) that "
                  "become edges of a raster's or cloud's surface")
      ->type_name("FILES");
}

void add_repair_options(CLI::App& command, TerrainOptions& options) {
  command
      .add_option("--crack", options.crack,
                  "Close cracks between tiles up to this width, m; 0: none")
      ->check(number_in_range(kCrackWidthRange))
      ->type_name("M")
      ->capture_default_str();
  command
      .add_option("--spikes", options.spike_steepness,
                  "Level single vertices that protrude by more than this many times the distance "
                  "to their neighbours; 0: none")
      ->check(number_in_range(kSpikeSteepnessRange))
      ->type_name("X")
      ->capture_default_str();
  command.add_option("--smoothing", options.smoothing, "Rounds of smoothing")
      ->check(integer_in_range(0, kMaxSmoothing))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--tolerance", options.tolerance,
                  "Simplify: remove vertices while the surface moves up or down by no more than "
                  "this, m; overhangs are kept")
      ->check(number_in_range(kSurfaceToleranceRange))
      ->type_name("M");
  command.add_flag("--cut-zones", options.cut_zones,
                   "Cut the borders of zone polygons into the triangles");
}

void add_fit_options(CLI::App& command, TerrainArgs& args) {
  CLI::Option* releases = command
                              .add_option("--release", args.releases,
                                          "Release points (lines of x y z, axes as in the inputs), "
                                          "drawn in the picture; points off the ground are refused")
                              ->type_name("FILE");
  command
      .add_option("--border-distance", args.border_distance,
                  "Warn if a release point is nearer than this to the border, m")
      ->check(number_in_range(kBorderDistanceRange))
      ->needs(releases)
      ->type_name("M")
      ->capture_default_str();
  command
      .add_option("--block-size", args.block_size,
                  "Diameter of the blocks, m: warn if the ground is much coarser or finer")
      ->check(number_in_range(kBlockLengthRange))
      ->type_name("M");
  CLI::Option* picture =
      command
          .add_option(
              "--picture", args.picture,
              "Also draw a map (svg) with shaded relief, zones, release points and barriers")
          ->type_name("FILE");
  command
      .add_option("--barriers", args.barriers,
                  "Lines to draw in the picture (GeoJSON, GeoPackage, Shapefile)")
      ->needs(picture)
      ->type_name("FILE");
}

}  // namespace

void add_terrain_command(CLI::App& app) {
  const auto args = std::make_shared<TerrainArgs>();
  CLI::App* command = &add_companion_command(app, "terrain");
  command
      ->add_option(
          "inputs", args->inputs,
          "Meshes (stl, obj, ply, ...), one raster (GeoTIFF, asc, ...), clouds (las, laz, pcd, "
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
          "of polygons with a property \"zone\", or rules: "
          "rock=slope>60,scree=height<1450,soil=else "
          "(degrees, m; the first rule that holds applies); default: one zone, ground")
      ->type_name("LIST|FILE");
  command
      ->add_option("--up", args->options.up,
                   "Axis of the inputs that points up: y, z, or auto (y for glb and gltf files, as "
                   "their standard requires, z for all others)")
      ->check(CLI::IsMember({"auto", "y", "z"}))
      ->type_name("AXIS")
      ->capture_default_str();
  add_grid_options(*command, *args);
  add_repair_options(*command, args->options);
  add_fit_options(*command, *args);
  CLI::Option* exported =
      command
          ->add_option("--export", args->exported,
                       "Also write the surface for viewing: stl, ply, obj, vtp, glb or tif")
          ->type_name("FILE");
  command
      ->add_option("--export-up", args->export_up,
                   "Up axis of the export: y, z, or auto (y in glb, z in all others)")
      ->check(CLI::IsMember({"auto", "y", "z"}))
      ->needs(exported)
      ->type_name("AXIS")
      ->capture_default_str();
  command->add_option("--export-cell", args->export_cell, "Cell size of an exported tif, m")
      ->check(number_in_range(kCellSizeRange))
      ->needs(exported)
      ->type_name("M")
      ->capture_default_str();
  command->add_flag("--replace", args->replace,
                    "Replace an existing terrain file, export or picture");
  command->add_flag("--json", args->json, "Print the report as JSON");
  command->footer(
      "Examples:\n"
      "  clast terrain blue.stl gray.stl red.stl --zones blue,gray,red --up y -o quarry.h5\n"
      "  clast terrain dem.tif --zones zones.geojson -o slope.h5 --export slope.vtp\n"
      "  clast terrain lidar.las --resolution 0.5 --zones 'rock=slope>60,soil=else' "
      "--picture slope.png");
  command->callback([args] { make_terrain(*args); });
}

}  // namespace clast
