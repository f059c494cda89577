#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <memory>

#include "app/block_line.hpp"
#include "app/commands/commands.hpp"
#include "app/option_flags.hpp"
#include "app/text_table.hpp"
#include "classify/equilibria.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "library/block_library.hpp"
#include "library/unscaled.hpp"
#include "library/unseen_range.hpp"
#include "report/json/block_json.hpp"

namespace clast {

namespace {

struct ShowArgs {
  std::string library;
  std::vector<std::string> ids;
  bool json = false;
};

std::string overview(const std::vector<const Block*>& blocks) {
  TextTable table{{"id", "vertices", "L m", "I m", "S m", "s_c", "volume m3", "density kg/m3",
                   "mass kg", "sneed_folk", "zingg", "shape", "radius m", "hausdorff m"},
                  {}};
  std::string unscaled;
  for (const Block* block : blocks) {
    const Axes axes = block->axes();
    const auto length = [&](double value, int digits = 4, const char* power = "") {
      return rounded(value, digits) + (is_unscaled(*block) ? std::string(" u") + power : "");
    };
    table.rows.push_back(
        {block->id, std::to_string(block->body.vertices.size()), length(axes.L), length(axes.I),
         length(axes.S), rounded(elongation_s_c(axes), 3), length(block->mass.volume, 4, "3"),
         rounded(block->density), mass_text(*block), sneed_folk_class(axes), zingg_class(axes),
         garcia_class(axes), length(block->body.radius, 3), length(block->deviation.hausdorff, 2)});
    if (is_unscaled(*block)) unscaled += (unscaled.empty() ? "" : ", ") + printable(block->id);
  }
  if (unscaled.empty()) return table.text();
  return table.text() + "\nUnscaled (u: unit of the model, of no known length): " + unscaled +
         "; " + unscaled_reason() + ".\n";
}

std::string vector_text(const Vec3& v) {
  return rounded(v[0], 6) + "  " + rounded(v[1], 6) + "  " + rounded(v[2], 6);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// What the unseen side leaves open, as names with values.
std::vector<std::array<std::string, 2>> unseen_lines(const Block& block) {
  const UnseenPart& unseen = *block.unseen;
  const UnseenRange range = unseen_range(block);
  const auto between = [](double low, const std::optional<double>& high, int digits) {
    return high ? rounded(low, digits) + " to " + rounded(*high, digits)
                : "at least " + rounded(low, digits);
  };
  const std::string unit = length_unit_of(block);
  std::vector<std::array<std::string, 2>> lines = {
      {"surface filled in %", rounded(100.0 * unseen.invented_share, 2)},
      {"volume " + unit + "3", between(unseen.lower_volume, unseen.upper_volume, 4) + ", best " +
                                   rounded(unseen.best_volume)}};
  if (!is_unscaled(block)) {
    lines.push_back({"mass kg", between(range.lower_mass, range.upper_mass, 4)});
    lines.push_back({"density kg/m3", range.lower_density
                                          ? between(*range.lower_density, range.upper_density, 4)
                                          : "at most " + rounded(range.upper_density)});
  }
  if (!range.axes) {
    lines.push_back({"L, I, S, classes", "not known: too much of the block was not seen"});
  } else {
    const auto& [low, high] = *range.axes;
    lines.push_back({"L " + unit, between(low.L, high.L, 4)});
    lines.push_back({"I " + unit, between(low.I, high.I, 4)});
    lines.push_back({"S " + unit, between(low.S, high.S, 4)});
    lines.push_back({"s_c", between(*range.lower_s_c, range.upper_s_c, 3)});
    lines.push_back({"possible classes", listed(range.classes.at("sneed-folk")) + "; " +
                                             listed(range.classes.at("zingg")) + "; " +
                                             listed(range.classes.at("garcia"))});
  }
  if (!unseen.assumption.empty()) lines.push_back({"bounds hold if", unseen.assumption});
  return lines;
}

/// What the overview leaves out.
std::string details(const Block& block) {
  std::string text = "\n" + printable(block.id) + "\n";
  const auto line = [&](const std::string& name, const std::string& value) {
    text += "  " + name + std::string(name.size() < 26 ? 26 - name.size() : 1, ' ') + shown(value) +
            "\n";
  };
  line("source", block.source.file);
  line("source sha256", block.source.sha256);
  line("options", block.source.options);
  line("made by", "clast " + block.source.program_version);
  const std::string unit = length_unit_of(block);
  if (is_unscaled(block)) line("unscaled", unscaled_reason());
  line("area " + unit + "2", rounded(block.area, 6));
  line("centre " + unit, vector_text(block.mass.centre));
  for (int row = 0; row < 3 && !is_unscaled(block); ++row) {
    if (row == 0) line("principal moments kg m2", vector_text(block.principal.moments));
    line(row == 0 ? "inertia kg m2" : "", vector_text(block.mass.inertia.row(row).transpose()));
  }
  for (const auto& [name, value] : block_indices(block, block.axes())) {
    line(name, rounded(value));
  }
  if (!block.body.faces.empty()) {  // a ball or a capsule rests on every side
    const Equilibria sides = static_equilibria(block.body, block.mass.centre);
    line("equilibria", std::to_string(sides.stable) + " stable, " + std::to_string(sides.unstable) +
                           " unstable, " + std::to_string(sides.saddle) + " saddles");
  }
  line("mean deviation " + unit, rounded(block.deviation.mean, 3));
  line("scan to body at most " + unit, rounded(block.deviation.scan_to_body, 3));
  line("body to scan at most " + unit, rounded(block.deviation.body_to_scan, 3));
  line("volume against scan", rounded(block.deviation.volume_relative, 2));
  line("area against scan", rounded(block.deviation.area_relative, 2));
  line("moments against scan", rounded(block.deviation.moments_relative, 2));
  if (block.unseen) {
    for (const auto& [name, value] : unseen_lines(block)) line(name, value);
  }
  const FieldNotes& field = block.field;
  if (!field.site.empty()) line("site", field.site);
  if (field.taped) {
    line("taped L I S m", vector_text({field.taped->L, field.taped->I, field.taped->S}));
  }
  if (field.weighed_mass) line("weighed kg", rounded(*field.weighed_mass));
  if (!field.note.empty()) line("note", field.note);
  for (const std::string& warning : block.warnings) line("warning", warning);
  return text;
}

void show(const ShowArgs& args) {
  const BlockLibrary library = BlockLibrary::read(args.library);
  std::vector<const Block*> blocks;
  for (const std::string& id : args.ids) blocks.push_back(&library.block(id));
  if (args.ids.empty()) {
    for (const Block& block : library.blocks()) blocks.push_back(&block);
  }
  if (args.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Block* block : blocks) all.push_back(block_json(*block));
    std::cout << all.dump(2) << "\n";
    return;
  }
  std::cout << overview(blocks);
  if (args.ids.empty()) return;
  for (const Block* block : blocks) std::cout << details(*block);
}

}  // namespace

void add_show(CLI::App& app) {
  const auto args = std::make_shared<ShowArgs>();
  CLI::App* command = app.add_subcommand("show", "Show what a library holds");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->ids, "Blocks to show in full; default: one line per block")
      ->type_name("ID");
  command->add_flag("--json", args->json, "Print all data of the blocks as JSON");
  command->footer(
      "Lengths in m, volumes in m3, masses in kg, moments of inertia in kg m2 about the "
      "centre of mass.\nL, I, S are the sides of the smallest box, s_c = L/I - 1.\n"
      "Examples:\n  clast show blocks.h5\n  clast show blocks.h5 SP1A --json");
  command->callback([args] { show(*args); });
}

}  // namespace clast
