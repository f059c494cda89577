#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/interruption.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/progress_bar.hpp"
#include "classify/dimension_table.hpp"
#include "classify/form_grid.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/length_unit.hpp"
#include "core/number_range.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/utf8.hpp"
#include "library/block_ranges.hpp"
#include "library/block_series.hpp"
#include "library/library_update.hpp"
#include "report/json/series_json.hpp"
#include "report/text/series_text.hpp"

namespace clast {

namespace {

struct VaryArgs {
  std::string library;
  std::vector<std::string> ids;
  std::string output = "series.h5";
  std::vector<std::string> forms;  ///< --to
  std::string grid;
  double least = 0.2;
  std::vector<std::string> like;
  std::vector<double> convexities, roundings, gains;
  std::vector<std::size_t> vertices;
  int degree = 6;
  std::vector<std::string> references, inertia;
  double exponent = 4.0;
  std::size_t draw = 0;
  std::string table;
  std::string units;  ///< of the table; empty: as its header says
  std::string prefix = "V";
  std::uint64_t seed = 1;
  std::string keep = "mass";
  unsigned threads = 0;
  bool replace = false;
  bool json = false;
};

constexpr NumberRange kRatio{0.01, 1.0}, kGridSteps{1.0, 100.0};
constexpr std::size_t kMostBodies = 100'000;
constexpr std::size_t kMostListed = 40;  ///< rows of the table on the terminal
constexpr std::size_t kMostNamed = 5;    ///< failed bodies that are named

/// "0.8,0.5".
BoxRatios read_ratios(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto i_l = number_in(text.substr(0, comma));
  const auto s_l = comma == text.npos ? std::nullopt : number_in(text.substr(comma + 1));
  if (!i_l || !s_l || !kRatio.holds(*i_l) || !kRatio.holds(*s_l) || *s_l > *i_l) {
    throw InputError("--to " + text + ": give I/L,S/L, such as 0.8,0.5, both " + kRatio.words() +
                     " and S/L at most I/L");
  }
  return {*i_l, *s_l};
}

/// "sneed-folk:10" or "zingg:5".
std::vector<Axes> read_grid(const std::string& text, double least) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const double steps = colon == text.npos ? 0.0 : number_in(text.substr(colon + 1)).value_or(0.0);
  const bool whole = kGridSteps.holds(steps) && steps == std::floor(steps);
  if (whole && name == "sneed-folk") return sneed_folk_grid(static_cast<int>(steps), least);
  if (whole && name == "zingg") return zingg_grid(static_cast<int>(steps), least);
  throw InputError("--grid " + text +
                   ": give sneed-folk:STEPS or zingg:STEPS, a whole number of steps " +
                   kGridSteps.words());
}

void add_forms(const VaryArgs& args, std::vector<Variation>& variations) {
  for (const std::string& form : args.forms) {
    variations.emplace_back(StretchTo{read_ratios(form)});
  }
  if (!args.grid.empty()) {
    for (const Axes& axes : read_grid(args.grid, args.least)) {
      variations.emplace_back(StretchTo{{axes.I / axes.L, axes.S / axes.L}});
    }
  }
}

/// What every block is varied by, but for --like, which needs the library.
std::vector<Variation> variations_wanted(const VaryArgs& args) {
  std::vector<Variation> variations;
  add_forms(args, variations);
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

std::vector<DrawnBlock> population_of(const VaryArgs& args, std::span<const Block* const> parents) {
  if (args.table.empty()) return drawn_from(parents);
  DimensionColumns columns;
  if (!args.units.empty()) columns.units = length_unit(args.units);
  const DimensionTable table = read_dimension_table(args.table, columns);
  for (const std::string& note : table.notes) {
    std::cerr << "clast: note: " << shown(args.table + ": " + note) << "\n";
  }
  std::vector<DrawnBlock> population;
  for (const MeasuredBlock& block : table.blocks) {
    if (!kBlockLength.holds(block.axes.L) || !kBlockLength.holds(block.axes.S)) {
      throw InputError(args.table + ": block " + block.name + " is " +
                       with_digits(block.axes.L, 4) + " x " + with_digits(block.axes.S, 4) +
                       " m; L and S must be " + kBlockLength.words() + "; give `units`");
    }
    population.push_back({block.axes, std::nullopt});
  }
  return population;
}

/// Two requests for one name would be one body.
void refuse_repeated(const std::vector<VariationRequest>& requests) {
  std::set<std::string> ids;
  for (const VariationRequest& request : requests) {
    if (!ids.insert(request.id).second) {
      throw InputError("\"" + request.id + "\" is asked for twice; ask for each body once");
    }
  }
}

struct Wanted {
  std::vector<VariationRequest> requests;
  std::optional<CopulaFit> fit;
};

Wanted bodies_wanted(const VaryArgs& args, const BlockLibrary& library,
                     std::vector<Variation> variations) {
  const std::vector<const Block*> parents = library.chosen(args.ids);
  for (const std::string& id : args.like) {
    variations.emplace_back(StretchTo{box_ratios(library.block(id).box)});
  }
  Wanted wanted;
  wanted.requests = variations_of(parents, variations);
  if (args.draw > 0) {
    DrawnSeries drawn =
        draw_series(parents, population_of(args, parents), args.draw, args.seed, args.prefix);
    wanted.fit = std::move(drawn.fit);
    for (VariationRequest& request : drawn.requests) {
      wanted.requests.push_back(std::move(request));
    }
  }
  if (wanted.requests.size() > kMostBodies) {
    throw InputError(std::to_string(wanted.requests.size()) +
                     " bodies are asked for; the most is " + std::to_string(kMostBodies));
  }
  refuse_repeated(wanted.requests);
  return wanted;
}

BlockSeries make_bodies(const VaryArgs& args, const Wanted& wanted) {
  BlockSource source{as_utf8(args.library), sha256_of_file(args.library), "", ""};
  if (args.draw > 0) source.options = "seed=" + std::to_string(args.seed);
  if (!args.table.empty()) {
    source.options += " population_sha256=" + sha256_of_file(args.table);
  }
  const InterruptionWatch watch;
  std::unique_ptr<ProgressBar> progress;
  SeriesOptions options;
  options.variation.keep = kept_size(args.keep);
  options.threads = args.threads;
  options.progress = [&](const ProgressStep& step) {
    if (watch.interrupted()) throw Cancelled();
    if (!progress) progress = std::make_unique<ProgressBar>("bodies", step.total);
    progress->update(step.done);
  };
  try {
    return make_series(wanted.requests, source, options);
  } catch (const Cancelled&) {
    throw InputError("interrupted; " + args.output + " is as it was");
  }
}

void print_series(const VaryArgs& args, const BlockSeries& series, const Wanted& wanted,
                  std::size_t in_all) {
  if (args.json) {
    std::cout << series_json(series, wanted.fit).dump(2) << "\n";
    return;
  }
  const std::size_t listed = std::min(kMostListed, series.blocks.size());
  std::cout << series_table({series.blocks.data(), listed}).text();
  if (listed < series.blocks.size()) {
    std::cout << "... and " << series.blocks.size() - listed << " more, which clast show lists\n";
  }
  if (wanted.fit) std::cout << "\n" << described_fit(*wanted.fit);
  std::cout << "\n"
            << printable(args.output) << ": " << counted(series.blocks.size(), "body", "bodies")
            << " written, " << counted(in_all, "block") << " in all\n";
}

void vary(const VaryArgs& args) {
  std::vector<Variation> variations;
  check_usage([&] {
    variations = variations_wanted(args);
    check_block_id(args.prefix + "0001");
    if (!args.units.empty()) length_unit(args.units);
    if (variations.empty() && args.like.empty() && args.draw == 0) {
      throw InputError(
          "nothing is asked for; give --to, --grid, --like, --convexity, --rounding, "
          "--vertices, --detail, --reference, --inertia or --draw");
    }
  });
  check_library_place(args.output);
  const BlockLibrary library = BlockLibrary::read(args.library);
  const Wanted wanted = bodies_wanted(args, library, std::move(variations));
  const BlockSeries series = make_bodies(args, wanted);
  if (series.blocks.empty()) {
    throw GeometryError("no body could be made; the first: " + series.failed.front());
  }
  const BlockLibrary written =
      update_library(args.output, {.make = true}, [&](BlockLibrary& changed) {
        for (const Block& block : series.blocks) changed.add(block, args.replace);
      });
  print_series(args, series, wanted, written.blocks().size());
  for (std::size_t i = 0; i < std::min(kMostNamed, series.failed.size()); ++i) {
    std::cerr << "clast: warning: " << shown(series.failed[i]) << "\n";
  }
  if (!series.failed.empty()) {
    throw GeometryError(std::to_string(series.failed.size()) + " of " +
                        std::to_string(wanted.requests.size()) +
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
  command.add_option("--like", args.like, "Stretch to the ratios of these blocks of the library")
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
          .add_option("--draw", args.draw,
                      "So many bodies with sizes and forms as the blocks have, or as --from says")
          ->check(whole_number(1, kMostBodies))
          ->type_name("N");
  command
      .add_option("--from", args.table,
                  "Table with columns L, I and S of measured blocks, to draw sizes and forms from")
      ->needs(draw)
      ->type_name("TABLE");
  command
      .add_option(
          "--units", args.units,
          "Length unit of the table: m, cm, mm, km, in, ft, or metres per unit; default: as "
          "its header says, else m")
      ->type_name("UNIT")
      ->needs(draw);
  command.add_option("--seed", args.seed, "Of the bodies drawn")
      ->check(whole_number())
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--prefix", args.prefix, "Ids of bodies drawn are this and a number")
      ->type_name("TEXT")
      ->capture_default_str();
}

}  // namespace

void add_vary(CLI::App& app) {
  const auto args = std::make_shared<VaryArgs>();
  CLI::App* command =
      app.add_subcommand("vary", "Make twins and series of blocks that differ in one thing");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->ids, "Blocks to vary; default: all")->type_name("ID");
  command->add_option("-o,--output", args->output, "Block library; blocks in it are kept")
      ->type_name("LIB")
      ->capture_default_str();
  command->add_flag("--replace", args->replace, "Replace blocks of the same id");
  add_form_options(*command, *args);
  add_surface_options(*command, *args);
  add_body_options(*command, *args);
  command->add_option("--keep", args->keep, "What the bodies have in common with their block")
      ->check(CLI::IsMember({"mass", "volume", "L"}))
      ->type_name("WHAT")
      ->capture_default_str();
  command->add_option("--threads", args->threads, "Threads to use; 0: one for each core")
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
