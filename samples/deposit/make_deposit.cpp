/// Program `make_deposit FOLDER`: makes a virtual deposit, a scan of it, and the truth.
#include <CLI/CLI.hpp>
#include <iostream>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "samples/deposit/deposit.hpp"

namespace {

constexpr std::size_t kNaturalRocks = 14;

struct Options {
  std::string folder;
  std::string kind = "heap", stations = "drone", scans;
  clast::DepositRecipe recipe = {};
  unsigned threads = 0;
  bool bodies = false;
};

void make(Options options, bool count_is_given) {
  using namespace clast;
  DepositRecipe& recipe = options.recipe;
  recipe.kind = parse_deposit_kind(options.kind);
  recipe.stations = parse_scan_stations(options.stations);
  if (!count_is_given && recipe.kind == DepositKind::kNatural) recipe.blocks = kNaturalRocks;
  std::vector<StoneScan> scans;
  if (!options.scans.empty()) scans = read_stone_scans(options.scans);
  const VirtualDeposit deposit = make_deposit(recipe, scans, options.threads);
  write_deposit(deposit, options.folder, options.bodies);
  std::size_t eligible = 0, visible = 0;
  for (const TrueBlock& block : deposit.blocks) {
    if (block.is_eligible()) ++eligible;
    if (block.points > 0) ++visible;
  }
  std::cout << options.folder << ": " << format_count(deposit.scan.points.size(), "point") << ", "
            << format_count(deposit.blocks.size(), "block") << " of " << recipe.blocks
            << " at rest, " << visible << " seen, " << eligible << " eligible; spacing "
            << format_significant(recipe.spacing(), 4) << " m, largest overlap "
            << format_significant(deposit.largest_overlap / recipe.spacing(), 2) << " spacings\n";
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Makes a virtual deposit of rock blocks, a scan of it, and the truth"};
  app.add_option("folder", options.folder, "Folder for scan.ply, truth.ply, blocks.csv, ...")
      ->required();
  app.add_option("--kind", options.kind, "heap, scattered, slope or natural")
      ->capture_default_str();
  CLI::Option* blocks = app.add_option("--blocks", options.recipe.blocks,
                                       "Number of blocks; 200, of natural ground 14");
  app.add_option("--seed", options.recipe.seed, "Seed of all random numbers")
      ->capture_default_str();
  app.add_option("--spacing", options.recipe.spacings_per_block,
                 "Spacings of points per I of the smallest block, 0.25 m")
      ->capture_default_str();
  app.add_option("--noise", options.recipe.noise,
                 "Standard deviation along the line of sight, spacings")
      ->capture_default_str();
  app.add_option("--fines", options.recipe.fines,
                 "Depth of fines over the local height of the deposit")
      ->capture_default_str();
  app.add_option("--size-ratio", options.recipe.size_ratio, "I of the largest block over smallest")
      ->capture_default_str();
  app.add_option("--stations", options.stations, "drone or tripod")->capture_default_str();
  app.add_option("--scans", options.scans,
                 "Folder of closed meshes of stones; every second block is made from one");
  app.add_option("--threads", options.threads, "Number of threads; 0: one per core");
  app.add_flag("--bodies", options.bodies, "Also write the true bodies as meshes");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    make(options, blocks->count() > 0);
  } catch (const std::exception& error) {
    std::cerr << "make_deposit: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
