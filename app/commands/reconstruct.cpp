#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "app/block_report.hpp"
#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "app/progress.hpp"
#include "app/scan_list.hpp"
#include "app/scan_to_block.hpp"
#include "app/shape_to_block.hpp"
#include "app/text_table.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "library/block_library.hpp"

namespace clast {

namespace {

struct ReconstructArgs {
  std::vector<std::string> scans;
  std::string library = "blocks.h5";
  std::string units = "m";
  std::string ground = "auto";
  bool replace = false;
  bool json = false;
  ScanToBlockOptions options;
};

std::vector<Block> blocks_from(const ScanFile& scan, const ScanToBlockOptions& options,
                               const std::function<void(const std::string&)>& stage) {
  if (!scan.is_shp()) return blocks_from_scan(scan.path, scan.id, options, stage);
  const ShpShape shape = scan.shape ? *scan.shape : read_shp(scan.path).front();
  return {block_from_shape(shape, scan.path, scan.id, options, stage)};
}

void reconstruct(ReconstructArgs args) {
  ScanToBlockOptions& options = args.options;
  options.unit_name = args.units;
  options.scan.unit = length_unit(args.units);
  check_usage([&] { options.check(); });
  const std::vector<ScanFile> scans = list_scans(args.scans);
  if (options.block.mass && options.split) {
    throw CLI::ValidationError("--mass", "is the mass of one block, but --split may make several");
  }
  if (options.block.mass && scans.size() > 1) {
    throw CLI::ValidationError("--mass", "is the mass of one block, but " +
                                             std::to_string(scans.size()) + " scans are given");
  }
  BlockLibrary library;
  if (std::filesystem::exists(args.library)) library = BlockLibrary::read(args.library);
  // A place that can't be written is refused before the work and not after it.
  { const OutputFile trial(args.library); }

  constexpr std::size_t kStages = 3;
  Progress progress("steps", kStages * scans.size());
  std::size_t steps = 0;
  nlohmann::ordered_json made = nlohmann::ordered_json::array();
  nlohmann::ordered_json failed = nlohmann::ordered_json::array();
  std::string last_failure;
  // A batch that is killed loses little; a write for every block would copy the library every time.
  constexpr std::chrono::seconds kBetweenWrites(60);
  auto written = std::chrono::steady_clock::now();
  const auto reconstruct_one = [&](const ScanFile& scan) {
    check_block_id(scan.id);
    const bool several = options.split && !scan.is_shp();
    const std::string first = several ? scan.id + "_1" : scan.id;
    if (library.has(first) && !args.replace) {
      throw InputError("block " + first + " is in " + args.library +
                       " already; use --replace to put the new one in its place");
    }
    const std::vector<Block> blocks = blocks_from(
        scan, options, [&](const std::string& what) { progress.update(steps++, what); });
    progress.clear();
    for (const Block& block : blocks) {
      library.add(block, args.replace);
      made.push_back(block_json(block));
      if (args.json) continue;
      std::cout << block_line(block) << "\n";
      for (const std::string& warning : block.warnings) std::cout << "  note: " << warning << "\n";
    }
    if (std::chrono::steady_clock::now() - written > kBetweenWrites) {
      library.write(args.library);
      written = std::chrono::steady_clock::now();
    }
    std::cout.flush();
  };
  for (std::size_t i = 0; i < scans.size(); ++i) {
    try {
      reconstruct_one(scans[i]);
    } catch (const Error& error) {  // one bad scan never costs the batch
      progress.clear();
      const std::string path = scans[i].path.string();
      const std::string reason = error.what();
      failed.push_back({{"scan", path}, {"reason", reason}});
      last_failure = reason.find(path) == std::string::npos ? path + ": " + reason : reason;
      if (scans.size() > 1) std::cerr << "clast: " << last_failure << "\n";
    }
    steps = kStages * (i + 1);
  }

  if (!made.empty()) library.write(args.library);
  if (args.json) {
    std::cout << nlohmann::ordered_json{{"blocks", made}, {"failed", failed}}.dump(2) << "\n";
  } else if (!made.empty()) {
    std::cout << args.library << ": " << counted(made.size(), "block") << " written, "
              << library.blocks().size() << " in all\n";
  }
  if (failed.empty()) return;
  if (scans.size() == 1) throw InputError(last_failure);
  throw InputError(std::to_string(failed.size()) + " of " + std::to_string(scans.size()) +
                   " scans gave no block; the reasons are above");
}

}  // namespace

void add_reconstruct(CLI::App& app) {
  const auto args = std::make_shared<ReconstructArgs>();
  ScanToBlockOptions& options = args->options;
  CLI::App* command = app.add_subcommand(
      "reconstruct", "Turn scans (meshes and point clouds) into blocks of a library");
  command
      ->add_option("scans", args->scans,
                   "Mesh files (obj, ply, stl, off, glb, gltf, 3ds, tab), point clouds (ply, pcd, "
                   "las, xyz, txt, csv), Rockable or ExaDEM shapes (shp: cores with their "
                   "radius), or folders of them")
      ->required()
      ->type_name("SCAN");
  command
      ->add_option("-o,--output", args->library,
                   "Block library; blocks are added to one that is there")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_flag("--replace", args->replace,
                    "Replace blocks whose id is in the library already");
  command
      ->add_option("--units", args->units,
                   "Length unit of the scans: m, cm, mm, km, in, ft, or metres per unit")
      ->type_name("UNIT")
      ->capture_default_str();
  CLI::Option* up =
      command
          ->add_option("--up", options.scan.up,
                       "Axis of the scans that points up: y or z; without it z, or away from the "
                       "ground where a scan holds ground")
          ->check(up_axis())
          ->type_name("AXIS");
  command
      ->add_option(
          "--ground", args->ground,
          "auto: take away the ground around a block; none: the scan is of the block alone")
      ->check(CLI::IsMember({"auto", "none"}))
      ->type_name("WHICH")
      ->capture_default_str();
  command->add_flag("--split", options.split,
                    "Make a block of everything that stands on the ground of a scan, as ID_1, ID_2 "
                    "... in order of x, and not only of what stands near its middle");
  command
      ->add_option("--vertices", options.vertices,
                   "Vertices a block has at most, 4 or more; default: the fewest up to 2000 with "
                   "which it is within the tolerance")
      ->check(number_between(4, 1e6))
      ->type_name("N");
  CLI::Option* radius =
      command->add_option("--radius", options.block.radius, "Minkowski radius of the rounding, m")
          ->check(number_between(0.0, 1e3))
          ->type_name("M");
  CLI::Option* share =
      command
          ->add_option(
              "--radius-share", options.block.radius_share,
              "The same as a share of S, the shortest side, 0 to 0.25; without it and without "
              "--vertices, 0.02 is halved down to 0.0025 where the tolerance needs it")
          ->check(number_between(0.0, 0.25))
          ->excludes(radius)
          ->type_name("SHARE")
          ->capture_default_str();
  command
      ->add_flag("--core", options.block.core,
                 "The mesh is the core that the sphere is swept over, not the rock's surface")
      ->needs(radius);
  command
      ->add_flag("--convex", options.block.convex,
                 "Take the convex hull of each scan, for example to compare with simpler models")
      ->excludes("--core");
  CLI::Option* density = command->add_option("--density", options.block.density, "Density, kg/m3")
                             ->check(positive_number())
                             ->type_name("KG/M3")
                             ->capture_default_str();
  command
      ->add_option("--mass", options.block.mass,
                   "Weighed mass of the block, kg: sets the density, or checks the volume when "
                   "--density is given too")
      ->check(positive_number())
      ->type_name("KG");
  command
      ->add_option("--accuracy", options.block.accuracy,
                   "Relative accuracy of volume and inertia, 1e-6 to 1e-2")
      ->check(number_between(1e-6, 1e-2))
      ->type_name("REL")
      ->capture_default_str();
  command
      ->add_option(
          "--tolerance", options.block.tolerance,
          "How far a block may lie off its scan (Hausdorff distance), as a share of L, the "
          "longest side; a block beyond it is made with a warning")
      ->check(number_between(1e-6, 1.0))
      ->type_name("SHARE")
      ->capture_default_str();
  command->add_flag("--keep-inner-shells", options.scan.keep_inner_shells,
                    "Keep closed shells inside a scan (bubbles) as cavities; without it rock fills "
                    "them. Their number and volume are told either way");
  command->add_flag("--any-size", options.any_size, "Take blocks over 50 m or under 1 mm too");
  command->add_flag("--json", args->json, "Print the blocks as JSON");
  command->footer(
      "Examples:\n"
      "  clast reconstruct scans/ -o blocks.h5 --units mm --density 2650\n"
      "  clast reconstruct SP1A.stl -o blocks.h5 --core --radius 0.027 --mass 342\n"
      "  clast reconstruct slope.las -o blocks.h5 --split\n"
      "  clast reconstruct shapes.shp -o blocks.h5 --density 2700");
  command->callback([args, density, radius, share, up] {
    args->options.up_given = up->count() > 0;
    args->options.find_ground = args->ground == "auto";
    args->options.radius_given = radius->count() + share->count() > 0;
    args->options.block.density_given = density->count() > 0;
    reconstruct(*args);
  });
}

}  // namespace clast
