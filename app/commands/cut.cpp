#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/interruption.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/progress_bar.hpp"
#include "core/error.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/statistics.hpp"
#include "library/block_ranges.hpp"
#include "library/library_update.hpp"
#include "library/mass_file.hpp"

namespace clast {

namespace {

struct CutArgs {
  std::string mass;
  std::string output = "blocks.h5";
  std::vector<std::string> joints;
  std::string units = "m";
  std::string up = "auto";
  MassBlockOptions options;
  bool replace = false;
};

/// Blocks that hold less of the mass are warned of.
constexpr double kUsualShare = 0.9;
/// Failed blocks that are named.
constexpr std::size_t kMostNamed = 5;

MassBlocks cut_blocks(const CutArgs& args) {
  MassBlockOptions options = args.options;
  const InterruptionWatch watch;
  std::unique_ptr<ProgressBar> progress;
  options.progress = [&](const ProgressStep& step) {
    if (watch.interrupted()) throw Cancelled();
    if (!progress) progress = std::make_unique<ProgressBar>("blocks", step.total);
    progress->update(step.done);
  };
  try {
    return blocks_of_mass_file({args.mass, args.units, args.up}, options);
  } catch (const Cancelled&) {
    throw InputError("interrupted; " + args.output + " is as it was");
  }
}

void cut(const CutArgs& args) {
  CutArgs checked = args;
  check_usage([&] {
    for (const std::string& joint : args.joints) {
      checked.options.joints.push_back(read_joint_set(joint));
    }
    length_unit(args.units);
    check_block_id(args.options.prefix + "0001");
    args.options.block.check();
  });
  check_library_place(args.output);
  const MassBlocks made = cut_blocks(checked);
  if (made.blocks.empty()) {
    throw GeometryError(args.mass + ": no piece became a block; the first: " + made.failed.front());
  }
  const BlockLibrary library =
      update_library(args.output, {.make = true}, [&](BlockLibrary& changed) {
        for (const Block& block : made.blocks) changed.add(block, args.replace);
      });
  for (std::size_t i = 0; i < std::min(kMostNamed, made.failed.size()); ++i) {
    std::cerr << "clast: warning: " << shown(made.failed[i]) << "\n";
  }
  if (made.failed.size() > kMostNamed) {
    std::cerr << "clast: warning: " << made.failed.size() - kMostNamed
              << " more pieces could not be made into blocks\n";
  }
  const double share = made.block_volume / made.volume;
  if (share < kUsualShare) {
    std::cerr << "clast: warning: " << percent(1.0 - share)
              << " of the mass is in no block: the surface is hollow there within a block, or "
                 "pieces are smaller than --least-volume; closer joints or a smaller volume lose "
                 "less\n";
  }
  std::vector<double> volumes;
  for (const Block& block : made.blocks) volumes.push_back(block.mass.volume);
  std::sort(volumes.begin(), volumes.end());
  std::cout << counted(made.blocks.size(), "block") << " of " << with_digits(volumes.front(), 3)
            << " to " << with_digits(volumes.back(), 3) << " m3, median "
            << with_digits(quantile(volumes, 0.5), 3) << " m3; together "
            << with_digits(made.block_volume, 4) << " m3, " << percent(share) << " of the mass of "
            << with_digits(made.volume, 4) << " m3\n"
            << printable(args.output) << ": " << counted(made.blocks.size(), "block")
            << " written, " << library.blocks().size() << " in all\n";
}

/// How the mass is cut and its blocks are made.
void add_block_making_options(CLI::App& command, MassBlockOptions& options) {
  command.add_option("--seed", options.cutting.seed, "Of the places of the joints")
      ->check(whole_number())
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--least-volume", options.cutting.least_volume,
                  "Pieces smaller than this are left out, m3")
      ->check(within(kBlockVolume))
      ->type_name("M3")
      ->capture_default_str();
  command
      .add_option("--most-blocks", options.cutting.most_blocks, "Joints that cut more are refused")
      ->check(whole_number(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--density", options.block.density, "Density, kg/m3")
      ->check(within(kBlockDensity))
      ->type_name("KG/M3")
      ->capture_default_str();
  command
      .add_option("--radius-share", options.block.radius_share,
                  "Minkowski radius of the rounding as a share of S, 0 to 0.25")
      ->check(within(kRadiusShare))
      ->type_name("SHARE")
      ->capture_default_str();
}

}  // namespace

void add_cut(CLI::App& app) {
  const auto args = std::make_shared<CutArgs>();
  MassBlockOptions& options = args->options;
  CLI::App* command = app.add_subcommand("cut", "Cut a rock mass into its blocks by joint sets");
  command->add_option("mass", args->mass, "Closed mesh of the mass, such as a scar")
      ->required()
      ->type_name("MESH");
  command
      ->add_option("-j,--joints", args->joints,
                   "A joint set, DIP/DIP_DIRECTION/SPACING or DIP/DIP_DIRECTION/SPACING/SCATTER: "
                   "degrees, the direction clockwise from north (y), and metres along the normal; "
                   "give one for each set")
      ->required()
      ->allow_extra_args(false)
      ->type_name("SET");
  command->add_option("-o,--output", args->output, "Block library; blocks in it are kept")
      ->type_name("LIB")
      ->capture_default_str();
  command->add_flag("--replace", args->replace, "Replace blocks of the same id");
  command->add_option("--prefix", options.prefix, "Ids are this and a number")
      ->type_name("TEXT")
      ->capture_default_str();
  add_block_making_options(*command, options);
  command
      ->add_option("--units", args->units,
                   "Length unit of the mesh: m, cm, mm, km, in, ft, or metres per unit")
      ->type_name("UNIT")
      ->capture_default_str();
  command
      ->add_option("--up", args->up,
                   "Axis of the mesh that points up: z, y, or auto: y of glb and gltf, z of all "
                   "others")
      ->check(CLI::IsMember({"auto", "y", "z"}))
      ->type_name("AXIS")
      ->capture_default_str();
  command->add_option("--threads", options.threads, "Threads to use; 0: one for each core")
      ->check(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->footer(
      "The joints cut through the whole mass. Blocks are convex and keep their place on the map: a "
      "campaign\nwith [[mass]] in_place = true releases them from there.\n"
      "Examples:\n"
      "  clast cut scar.ply -j 65/095/1.2/0.3 -j 80/190/1.5 -j 20/310/0.8/0.2 -o insitu.h5\n"
      "  clast classify insitu.h5 --against talus.csv");
  command->callback([args] { cut(*args); });
}

}  // namespace clast
