#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
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
#include "core/number_range.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "library/series_request.hpp"
#include "library/variation_ranges.hpp"
#include "report/json/series_json.hpp"
#include "report/text/series_text.hpp"

namespace clast {

namespace {

struct VaryArgs {
  VariationSeriesRequest request;
  std::string library;
  std::string output = "series.h5";
  std::vector<std::string> forms;  ///< --to
  std::string grid;
  double least = 0.2;
  VariationTargets steps;
  std::string table;
  std::string keep = "mass";
  bool json = false;
};

constexpr NumberRange kGridSteps{1.0, kMaxGridSteps};
constexpr std::size_t kMaxListed = 40;      ///< rows of the table on the terminal
constexpr std::size_t kMaxNamedBodies = 5;  ///< failed bodies that are named

/// "0.8,0.5".
BoxRatios read_ratios(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto i_l = parse_number(text.substr(0, comma));
  const auto s_l = comma == text.npos ? std::nullopt : parse_number(text.substr(comma + 1));
  return check_stretch_ratios(i_l.value_or(NAN), s_l.value_or(NAN), text);
}

/// "sneed-folk:10" or "zingg:5".
FormGrid read_grid(const std::string& text, double least) {
  const std::size_t colon = text.find(':');
  const double steps =
      colon == text.npos ? 0.0 : parse_number(text.substr(colon + 1)).value_or(0.0);
  if (!kGridSteps.contains(steps) || steps != std::floor(steps)) {
    throw InputError("--grid " + text +
                     ": give sneed-folk:STEPS or zingg:STEPS, a whole number of steps " +
                     kGridSteps.describe());
  }
  return {text.substr(0, colon), static_cast<int>(steps), least};
}

/// Targets of all options except --like, which needs the library.
VariationTargets steps_wanted(const VaryArgs& args) {
  VariationTargets steps = args.steps;
  for (const std::string& form : args.forms) steps.ratios.push_back(read_ratios(form));
  if (!args.grid.empty()) steps.grid = read_grid(args.grid, args.least);
  return steps;
}

VariationSeriesResult make_bodies(VariationSeriesRequest request) {
  const InterruptionWatch watch;
  std::unique_ptr<ProgressBar> progress;
  request.options.progress = [&](const ProgressUpdate& step) {
    if (watch.interrupted()) throw Cancelled();
    if (!progress) progress = std::make_unique<ProgressBar>("bodies", step.total);
    progress->update(step.done);
  };
  try {
    return make_variation_series(request);
  } catch (const Cancelled&) {
    throw InputError("interrupted; " + request.output.string() + " is unchanged");
  }
}

void print_series(const VaryArgs& args, const VariationSeriesResult& made) {
  const VariedBlockSeries& series = made.series;
  if (args.json) {
    std::cout << series_json(series, made.fit).dump(2) << "\n";
    return;
  }
  const std::size_t listed = std::min(kMaxListed, series.blocks.size());
  std::cout << make_series_table({series.blocks.data(), listed}).text();
  if (listed < series.blocks.size()) {
    std::cout << "... and " << series.blocks.size() - listed << " more, which clast show lists\n";
  }
  if (made.fit) std::cout << "\n" << describe_copula_fit(*made.fit);
  std::cout << "\n"
            << escape_nonprintable(args.output) << ": "
            << format_count(series.blocks.size(), "body", "bodies") << " written, "
            << format_count(made.output_blocks, "block") << " in all\n";
}

void vary(const VaryArgs& args) {
  VariationSeriesRequest request = args.request;
  check_usage([&] {
    request.targets = steps_wanted(args);
    request.library = args.library;
    request.output = args.output;
    request.table = args.table;
    request.options.variation.preserved_size = parse_preserved_size(args.keep);
    request.check();
  });
  const VariationSeriesResult made = make_bodies(request);
  for (const std::string& note : made.notes)
    std::cerr << "clast: note: " << format_for_terminal(note) << "\n";
  print_series(args, made);
  const std::vector<std::string>& failed = made.series.failures;
  for (std::size_t i = 0; i < std::min(kMaxNamedBodies, failed.size()); ++i) {
    std::cerr << "clast: warning: " << format_for_terminal(failed[i]) << "\n";
  }
  if (!failed.empty()) {
    throw GeometryError(std::to_string(failed.size()) + " of " +
                        std::to_string(made.requested_count) +
                        " bodies could not be made; the others are in " + args.output);
  }
}

void add_form_options(CLI::App& command, VaryArgs& args) {
  command.add_option("--to", args.forms, "Stretch to these ratios I/L,S/L, for example 0.8,0.5")
      ->type_name("I/L,S/L");
  command
      .add_option("--grid", args.grid,
                  "Stretch to a grid of forms over a diagram: sneed-folk:STEPS gives "
                  "(STEPS + 1)(STEPS + 2)/2 forms, zingg:STEPS gives (STEPS + 1)^2")
      ->type_name("DIAGRAM:STEPS");
  command
      .add_option("--least", args.least,
                  "Smallest ratio in the grid: S/L of sneed-folk, I/L and S/I of zingg")
      ->check(number_in_range(kMinRatioRange))
      ->type_name("RATIO")
      ->capture_default_str();
  command
      .add_option("--like", args.request.target_ratio_ids,
                  "Stretch each block to the axis ratios of these blocks of the library")
      ->type_name("ID");
}

void add_surface_options(CLI::App& command, VaryArgs& args) {
  command
      .add_option("--convexity", args.steps.convexity,
                  "Fill hollows until the volume is this fraction of that of the convex hull")
      ->check(number_in_range(kVariedConvexityRange))
      ->type_name("SHARE");
  command
      .add_option("--rounding", args.steps.rounding,
                  "Radius of edges and corners as a fraction of S, 0 to 0.4")
      ->check(number_in_range(kVariedRadiusFractionRange))
      ->type_name("SHARE");
  command
      .add_option("--roundness", args.steps.roundness,
                  "Choose the radius that gives this Wadell roundness")
      ->check(number_in_range(kVariedRoundnessRange))
      ->type_name("VALUE");
  command
      .add_option("--roundness-edge", args.steps.roundness_edge,
                  "Edge length of the mesh on which roundness is measured, as a fraction of the "
                  "diameter of a sphere of equal volume")
      ->check(number_in_range(kRoundnessEdgeRange))
      ->type_name("SHARE")
      ->capture_default_str();
  command.add_option("--vertices", args.steps.vertices, "Simplify to this many vertices")
      ->check(integer_in_range(kMinVariedVertices, kMaxVariedVertices))
      ->type_name("N");
  command
      .add_option("--detail", args.steps.detail,
                  "Multiply the surface detail: 0 removes it, 1 keeps it, 2 doubles it")
      ->check(number_in_range(kDetailGainRange))
      ->type_name("FACTOR");
  command
      .add_option("--degree", args.steps.degree,
                  "Degree of the spherical harmonics of the coarse form; detail is the remainder")
      ->check(integer_in_range(kMinDegree, kMaxDegree))
      ->type_name("N")
      ->capture_default_str();
}

void add_body_options(CLI::App& command, VaryArgs& args) {
  command
      .add_option(
          "--reference", args.steps.reference,
          "Simple bodies with the block's I/L and S/L; sphere and EOTA bodies have fixed ratios")
      ->check(CLI::IsMember(reference_shape_names()))
      ->type_name("FORM");
  command.add_option("--exponent", args.steps.exponent, "Exponent of the superellipsoid, 1 to 20")
      ->check(number_in_range(kSuperellipsoidExponentRange))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--inertia", args.steps.inertia,
                  "Bodies with the block's mass and principal moments of inertia")
      ->check(CLI::IsMember(inertia_body_names()))
      ->type_name("FORM");
  CLI::Option* draw =
      command
          .add_option("--draw", args.request.sampled_count,
                      "Draw this many bodies, with sizes and forms distributed like those of the "
                      "blocks, or of the table of --from")
          ->check(integer_in_range(1, kMaxSeriesBodies))
          ->type_name("N");
  command
      .add_option("--from", args.table,
                  "Table of measured blocks with columns L, I and S, or a library, for --draw")
      ->needs(draw)
      ->type_name("TABLE");
  command
      .add_option("--units", args.request.units,
                  "Length unit of the table: m, cm, mm, km, in, ft, or metres per unit; default: "
                  "from its header, else m")
      ->type_name("UNIT")
      ->needs(draw);
  command.add_option("--seed", args.request.seed, "Random seed of --draw")
      ->check(integer_in_range())
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--prefix", args.request.prefix,
                  "Prefix of the ids of drawn bodies, which are numbered")
      ->type_name("TEXT")
      ->capture_default_str();
}

}  // namespace

void add_vary_command(CLI::App& app) {
  const auto args = std::make_shared<VaryArgs>();
  CLI::App* command =
      app.add_subcommand("vary", "Make variants and series of blocks that differ in one property");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->request.ids, "Blocks to vary; default: all")->type_name("ID");
  command
      ->add_option("-o,--output", args->output, "Block library to write; existing blocks are kept")
      ->type_name("LIB")
      ->capture_default_str();
  command->add_flag("--replace", args->request.replace, "Replace blocks of the same id");
  add_form_options(*command, *args);
  add_surface_options(*command, *args);
  add_body_options(*command, *args);
  command->add_option("--keep", args->keep, "Quantity that is equal for a body and its block")
      ->check(CLI::IsMember({"mass", "volume", "L"}))
      ->type_name("WHAT")
      ->capture_default_str();
  command
      ->add_option("--threads", args->request.options.threads,
                   "Threads to use; 0: one for each core")
      ->check(integer_in_range(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--json", args->json, "Print the bodies as JSON");
  command->footer(
      "Bodies are named after their block and the variation, such as B01_il0.8_sl0.5.\nI/L and S/L "
      "are those of the original block unless they are varied.\nTargets are reached within 0.5 %, "
      "roundness within 1 %.\nIf a target can't be reached, the nearest possible value is "
      "reported.\n"
      "Examples:\n"
      "  clast vary blocks.h5 B01 --grid sneed-folk:10 -o forms.h5\n"
      "  clast vary blocks.h5 B01 --convexity 0.9 0.95 1 --reference ellipsoid box\n"
      "  clast vary blocks.h5 --draw 2000 --from taped.csv -o deposit.h5\n"
      "  clast show forms.h5 --report forms");
  command->callback([args] { vary(*args); });
}

}  // namespace clast
