#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/interruption.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/progress_bar.hpp"
#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/statistics/statistics.hpp"
#include "core/text_table.hpp"
#include "library/block_ranges.hpp"
#include "library/library_update.hpp"
#include "library/rock_mass_file.hpp"
#include "mesh/mesh_io.hpp"
#include "study/campaign/released_blocks.hpp"
#include "terrain/terrain_ranges.hpp"

namespace clast {

namespace {

struct CutArgs {
  std::string mass;           ///< closed mesh; else before and after
  std::string before, after;  ///< comma-separated
  std::string polygon;
  std::string scar;
  ReleasedMassOptions difference;
  std::string output = "blocks.h5";
  std::vector<std::string> joints;
  std::string units = "m";
  std::string up = "auto";
  RockMassOptions options;
  bool replace = false;
};

/// Blocks that hold less of the mass are warned of.
constexpr double kUsualFraction = 0.9;
/// Failed blocks that are named.
constexpr std::size_t kMaxNamedBlocks = 5;

/// Bodies that are listed.
constexpr std::size_t kMaxBodies = 10;

BeforeAfterTerrains terrains_of(const CutArgs& args) {
  BeforeAfterTerrains terrains;
  terrains.up = args.up;
  for (const std::string& file : split_comma_separated(args.before))
    terrains.before.emplace_back(file);
  for (const std::string& file : split_comma_separated(args.after))
    terrains.after.emplace_back(file);
  return terrains;
}

/// Calls `make` with the options and a bar; Ctrl-C ends it.
RockMassBlocks cut_blocks(const CutArgs& args,
                          const std::function<RockMassBlocks(const RockMassOptions&)>& make) {
  RockMassOptions options = args.options;
  const InterruptionWatch watch;
  std::unique_ptr<ProgressBar> progress;
  options.progress = [&](const ProgressUpdate& step) {
    if (watch.interrupted()) throw Cancelled();
    if (!progress) progress = std::make_unique<ProgressBar>("blocks", step.total);
    progress->update(step.done);
  };
  try {
    return make(options);
  } catch (const Cancelled&) {
    throw InputError("interrupted; " + args.output + " is unchanged");
  }
}

void print_mass(const ReleasedMass& mass) {
  for (const std::string& note : mass.notes) {
    std::cerr << "clast: warning: " << format_for_terminal(note) << "\n";
  }
  TextTable table{{"body", "m3", "m2 in plan", "m thick", "x", "y", "z", ""}, {}};
  std::vector<std::pair<const ReleasedBody*, const char*>> bodies;
  for (const ReleasedBody& body : mass.bodies) bodies.emplace_back(&body, "taken");
  for (const ReleasedBody& body : mass.excluded) bodies.emplace_back(&body, "left out");
  std::sort(bodies.begin(), bodies.end(),
            [](const auto& a, const auto& b) { return a.first->rank < b.first->rank; });
  for (const auto& [body, what] : bodies) {
    if (table.rows.size() == kMaxBodies) break;
    table.rows.push_back(
        {std::to_string(body->rank), format_rounded(body->volume), format_rounded(body->plan_area),
         format_rounded(body->max_thickness, 3), format_decimals(body->centre.x(), 1),
         format_decimals(body->centre.y(), 1), format_decimals(body->centre.z(), 1), what});
  }
  std::cout << table.text() << "mass of " << format_significant(mass.volume(), 4) << " m3 in "
            << format_count(mass.bodies.size(), "body", "bodies") << "; left out: ";
  if (mass.excluded.empty()) {
    std::cout << "none\n";
  } else {
    std::cout << format_count(mass.excluded.size(), "body", "bodies") << " of "
              << format_significant(mass.excluded_volume(), 3) << " m3 together\n";
  }
  std::cout << "edges of the surfaces, median: " << format_significant(mass.median_edge_before, 3)
            << " m before, " << format_significant(mass.median_edge_after, 3) << " m after\n";
}

/// Files that the mesh of the mass may replace.
OverwritePolicy scar_rules(const CutArgs& args) {
  return {.kind = file_kind_by_extension(args.scar), .replace = args.replace};
}

RockMassBlocks blocks_between(const CutArgs& args) {
  const BeforeAfterTerrains terrains = terrains_of(args);
  ReleasedMassOptions difference = args.difference;
  difference.min_volume = args.options.cutting.min_volume;
  const ReleasedMass mass = read_released_mass(terrains, difference);
  print_mass(mass);
  if (!args.scar.empty()) {
    write_mesh(args.scar, make_released_mass_mesh(mass), {.rules = scar_rules(args)});
    std::cout << escape_nonprintable(args.scar) << ": written\n";
  }
  if (args.joints.empty()) return {};
  return cut_blocks(args, [&](const RockMassOptions& options) {
    return cut_released_mass(mass, terrains, difference, options);
  });
}

void check_sources(const CutArgs& args) {
  if (args.mass.empty() == args.before.empty()) {
    throw InputError("give a closed mesh of the mass, or --before and --after");
  }
  if (args.joints.empty() && args.scar.empty()) {
    throw InputError(
        "--joints is required; to write the mass without cutting it, give --before, --after and "
        "--scar");
  }
  for (const std::string& input : split_comma_separated(args.before + "," + args.after)) {
    if (input.empty() || args.scar.empty()) continue;
    if (is_same_file(args.scar, input)) {
      throw InputError("--scar " + args.scar +
                       ": is an input and would be overwritten; give another name");
    }
  }
  static const std::vector<std::string> known = {".glb", ".obj", ".ply", ".stl", ".vtp"};
  if (!args.scar.empty() &&
      std::find(known.begin(), known.end(), lower_case_extension(args.scar)) == known.end()) {
    throw InputError("--scar " + args.scar + ": its name must end in " + comma_separated(known));
  }
}

void print_cut_blocks(const CutArgs& args, const RockMassBlocks& made,
                      const BlockLibrary& library) {
  for (std::size_t i = 0; i < std::min(kMaxNamedBlocks, made.failures.size()); ++i) {
    std::cerr << "clast: warning: " << format_for_terminal(made.failures[i]) << "\n";
  }
  if (made.failures.size() > kMaxNamedBlocks) {
    std::cerr << "clast: warning: " << made.failures.size() - kMaxNamedBlocks
              << " more pieces could not be made into blocks\n";
  }
  const double share = made.block_volume / made.volume;
  if (share < kUsualFraction) {
    std::cerr
        << "clast: warning: " << format_percent(1.0 - share)
        << " of the mass is in no block: the surface is concave within a block, or pieces are "
           "smaller than --least-volume; use a closer joint spacing or a smaller --least-volume\n";
  }
  std::vector<double> volumes;
  for (const Block& block : made.blocks) volumes.push_back(block.mass.volume);
  std::sort(volumes.begin(), volumes.end());
  std::cout << format_count(made.blocks.size(), "block") << " of "
            << format_significant(volumes.front(), 3) << " to "
            << format_significant(volumes.back(), 3) << " m3, median "
            << format_significant(quantile(volumes, 0.5), 3) << " m3; together "
            << format_significant(made.block_volume, 4) << " m3, " << format_percent(share)
            << " of the mass of " << format_significant(made.volume, 4) << " m3\n"
            << escape_nonprintable(args.output) << ": " << format_count(made.blocks.size(), "block")
            << " written, " << library.blocks().size() << " in all\n";
}

void cut(CutArgs args) {
  check_usage([&] {
    check_sources(args);
    for (const std::string& joint : args.joints) {
      args.options.joints.push_back(parse_joint_set(joint));
    }
    parse_length_unit(args.units);
    check_block_id(args.options.prefix + "0001");
    args.options.block.check();
    if (!args.polygon.empty()) args.difference.polygon = args.polygon;
    args.difference.check();
  });
  if (!args.scar.empty()) check_mesh_output(args.scar, scar_rules(args));
  if (!args.joints.empty()) check_library_writable(args.output);
  const RockMassBlocks made =
      args.mass.empty() ? blocks_between(args)
                        : cut_blocks(args, [&](const RockMassOptions& options) {
                            return cut_rock_mass_file({args.mass, args.units, args.up}, options);
                          });
  if (args.joints.empty()) return;
  if (made.blocks.empty()) {
    throw GeometryError((args.mass.empty() ? args.before : args.mass) +
                        ": no piece became a block; first reason: " + made.failures.front());
  }
  const BlockLibrary library =
      update_library(args.output, {.create_if_missing = true}, [&](BlockLibrary& changed) {
        for (const Block& block : made.blocks) changed.add(block, args.replace);
      });
  print_cut_blocks(args, made, library);
}

/// The mass as the difference of two terrains.
void add_difference_options(CLI::App& command, CLI::Option* mass, CutArgs& args) {
  CLI::Option* before =
      command
          .add_option("--before", args.before,
                      "Instead of a mesh: the terrain before the failure, in any format that "
                      "`clast terrain` reads; several files comma-separated")
          ->excludes(mass)
          ->type_name("FILES");
  CLI::Option* after = command
                           .add_option("--after", args.after,
                                       "The terrain after the failure, in the same map system; the "
                                       "mass is the volume between the two terrains")
                           ->needs(before)
                           ->type_name("FILES");
  before->needs(after);
  command
      .add_option(
          "--min-thickness", args.difference.min_thickness,
          "Smallest vertical difference between the two terrains that counts as rock mass, m; 0: "
          "any")
      ->check(number_in_range(kMassThicknessRange))
      ->needs(before)
      ->type_name("M")
      ->capture_default_str();
  command
      .add_option("--polygon", args.polygon,
                  "Take only the mass within these polygons (GeoJSON, GeoPackage, Shapefile)")
      ->needs(before)
      ->type_name("FILE");
  command
      .add_option(
          "--bodies", args.difference.bodies,
          "Which bodies to take if the mass consists of several: largest, all, or their numbers "
          "in order of volume, such as 1,3")
      ->needs(before)
      ->type_name("WHICH")
      ->capture_default_str();
  command
      .add_option(
          "--resolution", args.difference.resolution,
          "First convert both terrains to grids with this cell size, using the highest point of "
          "each cell, m; default: both as they are")
      ->check(number_in_range(kCellSizeRange))
      ->needs(before)
      ->type_name("M");
  command
      .add_option("--scar", args.scar,
                  "Also write the mass as a closed mesh (ply, obj, vtp, stl, glb); without "
                  "--joints, nothing else is written")
      ->needs(before)
      ->type_name("FILE");
}

void add_block_making_options(CLI::App& command, RockMassOptions& options) {
  command.add_option("--seed", options.cutting.seed, "Random seed of the joint positions")
      ->check(integer_in_range())
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--least-volume", options.cutting.min_volume,
                  "Pieces smaller than this are left out, m3")
      ->check(number_in_range(kBlockVolumeRange))
      ->type_name("M3")
      ->capture_default_str();
  command
      .add_option("--most-blocks", options.cutting.max_blocks,
                  "Largest number of blocks; joints that would cut more are refused")
      ->check(integer_in_range(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--density", options.block.density, "Density, kg/m3")
      ->check(number_in_range(kBlockDensityRange))
      ->type_name("KG/M3")
      ->capture_default_str();
  command
      .add_option("--radius-share", options.block.radius_fraction,
                  "Minkowski radius of the rounding as a fraction of S, 0 to 0.25")
      ->check(number_in_range(kRadiusFractionRange))
      ->type_name("SHARE")
      ->capture_default_str();
}

}  // namespace

void add_cut_command(CLI::App& app) {
  const auto args = std::make_shared<CutArgs>();
  RockMassOptions& options = args->options;
  CLI::App* command = &add_companion_command(app, "cut");
  CLI::Option* mass =
      command->add_option("mass", args->mass, "Closed mesh of the mass, such as a scar")
          ->type_name("MESH");
  add_difference_options(*command, mass, *args);
  command
      ->add_option("-j,--joints", args->joints,
                   "A joint set, DIP/DIP_DIRECTION/SPACING or DIP/DIP_DIRECTION/SPACING/SCATTER: "
                   "degrees, the direction clockwise from north (y), and metres along the normal; "
                   "give one for each set")
      ->allow_extra_args(false)
      ->type_name("SET");
  command
      ->add_option("-o,--output", args->output, "Block library to write; existing blocks are kept")
      ->type_name("LIB")
      ->capture_default_str();
  command->add_flag("--replace", args->replace, "Replace blocks of the same id");
  command->add_option("--prefix", options.prefix, "Prefix of the ids, which are numbered")
      ->type_name("TEXT")
      ->capture_default_str();
  add_block_making_options(*command, options);
  command
      ->add_option("--units", args->units,
                   "Length unit of the mesh: m, cm, mm, km, in, ft, or metres per unit")
      ->needs(mass)
      ->type_name("UNIT")
      ->capture_default_str();
  command
      ->add_option("--up", args->up,
                   "Axis of the meshes that points up: z, y, or auto: y of glb and gltf, z of all "
                   "others")
      ->check(CLI::IsMember({"auto", "y", "z"}))
      ->type_name("AXIS")
      ->capture_default_str();
  command->add_option("--threads", options.threads, "Threads to use; 0: one for each core")
      ->check(integer_in_range(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->footer(
      "The joints cut through the whole mass. Blocks are convex and keep their position on the "
      "map.\nA campaign with [[mass]] in_place = true releases the blocks from this position.\n"
      "Examples:\n"
      "  clast cut scar.ply -j 65/095/1.2/0.3 -j 80/190/1.5 -j 20/310/0.8/0.2 -o insitu.h5\n"
      "  clast cut --before 2019.tif --after 2024.tif --polygon scar.geojson --scar scar.ply\n"
      "  clast classify insitu.h5 --against talus.csv");
  command->callback([args] { cut(*args); });
}

}  // namespace clast
