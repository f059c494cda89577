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
#include "report/json/series_json.hpp"
#include "report/text/series_text.hpp"

namespace clast {

namespace {

struct VaryArgs {
  SeriesRequest request;
  std::string library;
  std::string output = "series.h5";
  std::vector<std::string> forms;  ///< --to
  std::string grid;
  double least = 0.2;
  std::vector<double> convexities, roundings, gains;
  std::vector<std::size_t> vertices;
  int degree = 6;
  std::vector<std::string> references, inertia;
  double exponent = 4.0;
  std::string table;
  std::string keep = "mass";
  bool json = false;
};

constexpr NumberRange kGridSteps{1.0, 100.0};
constexpr std::size_t kMostDrawn = 100'000;
constexpr std::size_t kMostListed = 40;  ///< rows of the table on the terminal
constexpr std::size_t kMostNamed = 5;    ///< failed bodies that are named

/// "0.8,0.5".
StretchTo read_ratios(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto i_l = number_in(text.substr(0, comma));
  const auto s_l = comma == text.npos ? std::nullopt : number_in(text.substr(comma + 1));
  return stretch_to(i_l.value_or(NAN), s_l.value_or(NAN), text);
}

/// "sneed-folk:10" or "zingg:5".
std::vector<Variation> read_grid(const std::string& text, double least) {
  const std::size_t colon = text.find(':');
  const double steps = colon == text.npos ? 0.0 : number_in(text.substr(colon + 1)).value_or(0.0);
  if (!kGridSteps.holds(steps) || steps != std::floor(steps)) {
    throw InputError("--grid " + text +
                     ": give sneed-folk:STEPS or zingg:STEPS, a whole number of steps " +
                     kGridSteps.words());
  }
  return stretches_over(text.substr(0, colon), static_cast<int>(steps), least);
}

/// What every block is varied by, but for --like, which needs the library.
std::vector<Variation> variations_wanted(const VaryArgs& args) {
  std::vector<Variation> variations;
  for (const std::string& form : args.forms) variations.emplace_back(read_ratios(form));
  if (!args.grid.empty()) {
    for (Variation& form : read_grid(args.grid, args.least)) variations.push_back(std::move(form));
  }
  for (const double convexity : args.convexities) variations.emplace_back(ConvexityOf{convexity});
  for (const double share : args.roundings) variations.emplace_back(RoundingOf{share});
  for (const std::size_t count : args.vertices) variations.emplace_back(VertexCount{count});
  for (const double gain : args.gains) variations.emplace_back(DetailTimes{gain, args.degree});
  for (const std::string& name : args.references) {
    variations.emplace_back(ReferenceTo{reference_form(name), args.exponent});
  }
  for (const std::string& name : args.inertia) {
    variations.emplace_back(InertiaTwin{reference_form(name)});
  }
  return variations;
}

RequestedSeries make_bodies(SeriesRequest request) {
  const InterruptionWatch watch;
  std::unique_ptr<ProgressBar> progress;
  request.options.progress = [&](const ProgressStep& step) {
    if (watch.interrupted()) throw Cancelled();
    if (!progress) progress = std::make_unique<ProgressBar>("bodies", step.total);
    progress->update(step.done);
  };
  try {
    return make_series(request);
  } catch (const Cancelled&) {
    throw InputError("interrupted; " + request.output.string() + " is as it was");
  }
}

void print_series(const VaryArgs& args, const RequestedSeries& made) {
  const BlockSeries& series = made.series;
  if (args.json) {
    std::cout << series_json(series, made.fit).dump(2) << "\n";
    return;
  }
  const std::size_t listed = std::min(kMostListed, series.blocks.size());
  std::cout << series_table({series.blocks.data(), listed}).text();
  if (listed < series.blocks.size()) {
    std::cout << "... and " << series.blocks.size() - listed << " more, which clast show lists\n";
  }
  if (made.fit) std::cout << "\n" << described_fit(*made.fit);
  std::cout << "\n"
            << printable(args.output) << ": " << counted(series.blocks.size(), "body", "bodies")
            << " written, " << counted(made.in_all, "block") << " in all\n";
}

void vary(const VaryArgs& args) {
  SeriesRequest request = args.request;
  check_usage([&] {
    request.variations = variations_wanted(args);
    request.library = args.library;
    request.output = args.output;
    request.table = args.table;
    request.options.variation.keep = kept_size(args.keep);
    request.check();
  });
  const RequestedSeries made = make_bodies(request);
  for (const std::string& note : made.notes) std::cerr << "clast: note: " << shown(note) << "\n";
  print_series(args, made);
  const std::vector<std::string>& failed = made.series.failed;
  for (std::size_t i = 0; i < std::min(kMostNamed, failed.size()); ++i) {
    std::cerr << "clast: warning: " << shown(failed[i]) << "\n";
  }
  if (!failed.empty()) {
    throw GeometryError(std::to_string(failed.size()) + " of " + std::to_string(made.wanted) +
                        " bodies could not be made; the others are in " + args.output);
  }
}

void add_form_options(CLI::App& command, VaryArgs& args) {
  command.add_option("--to", args.forms, "Stretch to these ratios, I/L,S/L such as 0.8,0.5")
      ->type_name("I/L,S/L");
  command
      .add_option("--grid", args.grid,
                  "Stretch to forms all over a diagram: sneed-folk:STEPS, (STEPS + 1)(STEPS + 2)/2 "
                  "forms, or zingg:STEPS, (STEPS + 1)^2")
      ->type_name("DIAGRAM:STEPS");
  command.add_option("--least", args.least, "Smallest S/L, in zingg I/L and S/I, of the grid")
      ->check(within({0.01, 0.99}))
      ->type_name("RATIO")
      ->capture_default_str();
  command
      .add_option("--like", args.request.like,
                  "Stretch to the ratios of these blocks of the library")
      ->type_name("ID");
}

void add_surface_options(CLI::App& command, VaryArgs& args) {
  command
      .add_option("--convexity", args.convexities,
                  "Fill hollows until the volume is this share of the hull's")
      ->check(within({0.01, 1.0}))
      ->type_name("SHARE");
  command
      .add_option("--rounding", args.roundings,
                  "Radius of edges and corners as a share of S, 0 to 0.4")
      ->check(within({1e-3, 0.4, "of S", "sharp edges"}))
      ->type_name("SHARE");
  command.add_option("--vertices", args.vertices, "Simplify the core to so many vertices")
      ->check(whole_number(8, 2000))
      ->type_name("N");
  command
      .add_option("--detail", args.gains,
                  "Multiply what lies off the coarse form: 0 smooths, 1 keeps, 2 roughens")
      ->check(within({0.01, 10.0, "", "smooth"}))
      ->type_name("FACTOR");
  command
      .add_option("--degree", args.degree,
                  "Spherical harmonics up to this degree are the coarse form")
      ->check(whole_number(2, 20))
      ->type_name("N")
      ->capture_default_str();
}

void add_body_options(CLI::App& command, VaryArgs& args) {
  command.add_option("--reference", args.references, "Bodies with the block's I/L and S/L")
      ->check(CLI::IsMember(reference_form_names()))
      ->type_name("FORM");
  command.add_option("--exponent", args.exponent, "Of the superellipsoid, 1 to 20")
      ->check(within({1.0, 20.0}))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--inertia", args.inertia,
                  "Bodies with the block's mass and principal moments of inertia")
      ->check(CLI::IsMember({"ellipsoid", "box"}))
      ->type_name("FORM");
  CLI::Option* draw =
      command
          .add_option("--draw", args.request.draw,
                      "So many bodies with sizes and forms as the blocks have, or as --from says")
          ->check(whole_number(1, kMostDrawn))
          ->type_name("N");
  command
      .add_option("--from", args.table,
                  "Table with columns L, I and S of measured blocks, to draw sizes and forms from")
      ->needs(draw)
      ->type_name("TABLE");
  command
      .add_option(
          "--units", args.request.units,
          "Length unit of the table: m, cm, mm, km, in, ft, or metres per unit; default: as "
          "its header says, else m")
      ->type_name("UNIT")
      ->needs(draw);
  command.add_option("--seed", args.request.seed, "Of the bodies drawn")
      ->check(whole_number())
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--prefix", args.request.prefix, "Ids of bodies drawn are this and a number")
      ->type_name("TEXT")
      ->capture_default_str();
}

}  // namespace

void add_vary(CLI::App& app) {
  const auto args = std::make_shared<VaryArgs>();
  CLI::App* command =
      app.add_subcommand("vary", "Make twins and series of blocks that differ in one thing");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->request.ids, "Blocks to vary; default: all")->type_name("ID");
  command->add_option("-o,--output", args->output, "Block library; blocks in it are kept")
      ->type_name("LIB")
      ->capture_default_str();
  command->add_flag("--replace", args->request.replace, "Replace blocks of the same id");
  add_form_options(*command, *args);
  add_surface_options(*command, *args);
  add_body_options(*command, *args);
  command->add_option("--keep", args->keep, "What the bodies have in common with their block")
      ->check(CLI::IsMember({"mass", "volume", "L"}))
      ->type_name("WHAT")
      ->capture_default_str();
  command
      ->add_option("--threads", args->request.options.threads,
                   "Threads to use; 0: one for each core")
      ->check(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--json", args->json, "Print the bodies as JSON");
  command->footer(
      "Bodies are named after their block and what was done: B01_il0.8_sl0.5. All but references "
      "keep the block's\nI/L and S/L unless these are what is varied; targets are reached within "
      "0.5 %.\n"
      "Examples:\n"
      "  clast vary blocks.h5 B01 --grid sneed-folk:10 -o forms.h5\n"
      "  clast vary blocks.h5 B01 --convexity 0.9 0.95 1 --reference ellipsoid box\n"
      "  clast vary blocks.h5 --draw 2000 --from taped.csv -o deposit.h5\n"
      "  clast show forms.h5 --report forms");
  command->callback([args] { vary(*args); });
}

}  // namespace clast
