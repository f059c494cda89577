#include "report/text/block_text.hpp"

#include "classify/schemes.hpp"
#include "core/comma_separated.hpp"
#include "core/number_text.hpp"
#include "library/block_bracket.hpp"
#include "library/block_measures.hpp"
#include "library/unscaled.hpp"

namespace clast {

namespace {

/// Length unit of the block; "u" is the unit of an unscaled block's model.
std::string length_unit_of(const Block& block) { return is_unscaled(block) ? "u" : "m"; }

std::string vector_text(const Vec3& v) {
  return format_rounded(v[0], 6) + "  " + format_rounded(v[1], 6) + "  " + format_rounded(v[2], 6);
}

/// Lists the bounds of the unobserved side, as names with values.
NamedValues unseen_lines(const Block& block) {
  const VolumeBracket& unseen = *block.volume_bracket;
  const BlockBracket range = derive_block_bracket(block);
  const auto between = [](double low, const std::optional<double>& high, int digits) {
    return high ? format_rounded(low, digits) + " to " + format_rounded(*high, digits)
                : "at least " + format_rounded(low, digits);
  };
  const std::string unit = length_unit_of(block);
  NamedValues lines = {
      {"surface filled in %", format_rounded(100.0 * unseen.filled_fraction, 2)},
      {"volume " + unit + "3", between(unseen.lower_volume, unseen.upper_volume, 4) + ", best " +
                                   format_rounded(unseen.estimated_volume)}};
  if (!is_unscaled(block)) {
    lines.push_back({"mass kg", between(range.lower_mass, range.upper_mass, 4)});
    lines.push_back({"density kg/m3", range.lower_density
                                          ? between(*range.lower_density, range.upper_density, 4)
                                          : "at most " + format_rounded(range.upper_density)});
  }
  if (!range.axes) {
    lines.push_back({"L, I, S, classes", "not known: too much of the block was not scanned"});
  } else {
    const auto& [low, high] = *range.axes;
    lines.push_back({"L " + unit, between(low.L, high.L, 4)});
    lines.push_back({"I " + unit, between(low.I, high.I, 4)});
    lines.push_back({"S " + unit, between(low.S, high.S, 4)});
    lines.push_back({"s_c", between(*range.lower_s_c, range.upper_s_c, 3)});
    lines.push_back({"possible classes", comma_separated(range.classes.at("sneed-folk")) + "; " +
                                             comma_separated(range.classes.at("zingg")) + "; " +
                                             comma_separated(range.classes.at("garcia"))});
  }
  if (!unseen.assumption.empty()) lines.push_back({"bounds are valid if", unseen.assumption});
  return lines;
}

}  // namespace

std::string format_block_line(const Block& block) {
  const Axes axes = block.axes();
  const std::size_t count = block.body.vertices.size();
  const bool metric = !is_unscaled(block);
  const std::string unit = metric ? " m" : " model units";
  std::string line =
      block.id + ": " + std::to_string(count) + (count == 1 ? " vertex, " : " vertices, ") +
      format_rounded(axes.L, 3) + " x " + format_rounded(axes.I, 3) + " x " +
      format_rounded(axes.S, 3) + unit + ", " + format_rounded(block.mass.volume) +
      (metric ? " m3, " : " cubic units, ") +
      (metric ? format_rounded(block.mass.mass) + " kg, " : "UNSCALED: no mass, ") +
      sneed_folk_class(axes) + ", " + zingg_class(axes) + ", " + garcia_class(axes) + ", ";
  if (block.from_core)
    return line + "core with radius " + format_rounded(block.body.radius, 3) + unit;
  return line + "within " + format_rounded(block.deviation.hausdorff, 2) + unit + " of the scan (" +
         format_rounded(100.0 * block.deviation.hausdorff / axes.L, 2) + " % of L)";
}

TextTable make_block_table(std::span<const Block* const> blocks) {
  TextTable table{{"id", "vertices", "L m", "I m", "S m", "s_c", "volume m3", "density kg/m3",
                   "mass kg", "sneed_folk", "zingg", "shape", "radius m", "hausdorff m"},
                  {}};
  for (const Block* block : blocks) {
    const Axes axes = block->axes();
    const auto length = [&](double value, int digits = 4, const char* power = "") {
      return format_rounded(value, digits) + (is_unscaled(*block) ? std::string(" u") + power : "");
    };
    table.rows.push_back({block->id, std::to_string(block->body.vertices.size()), length(axes.L),
                          length(axes.I), length(axes.S), format_rounded(elongation_index(axes), 3),
                          length(block->mass.volume, 4, "3"), format_rounded(block->density),
                          is_unscaled(*block) ? "-" : format_rounded(block->mass.mass),
                          sneed_folk_class(axes), zingg_class(axes), garcia_class(axes),
                          length(block->body.radius, 3), length(block->deviation.hausdorff, 2)});
  }
  return table;
}

std::string describe_unscaled_blocks(std::span<const Block* const> blocks) {
  std::string names;
  for (const Block* block : blocks) {
    if (is_unscaled(*block)) names += (names.empty() ? "" : ", ") + block->id;
  }
  if (names.empty()) return names;
  return "Unscaled (u is the unit of the model; its length is not known): " + names + "; " +
         explain_unscaled_block() + ".";
}

NamedValues describe_block(const Block& block) {
  NamedValues lines;
  const auto line = [&](const std::string& name, const std::string& value) {
    lines.push_back({name, value});
  };
  line("source", block.source.file);
  line("source sha256", block.source.sha256);
  line("options", block.source.options);
  line("made by", "clast " + block.source.program_version);
  const std::string unit = length_unit_of(block);
  if (is_unscaled(block)) line("unscaled", explain_unscaled_block());
  line("area " + unit + "2", format_rounded(block.area, 6));
  line("centre " + unit, vector_text(block.mass.centre));
  for (int row = 0; row < 3 && !is_unscaled(block); ++row) {
    if (row == 0) line("principal moments kg m2", vector_text(block.principal.moments));
    line(row == 0 ? "inertia kg m2" : "", vector_text(block.mass.inertia.row(row).transpose()));
  }
  for (const auto& [name, value] : block_indices(block, block.axes())) {
    line(name, format_rounded(value));
  }
  if (const std::optional<StaticEquilibriumCounts> sides = block_equilibria(block)) {
    line("equilibria", std::to_string(sides->stable) + " stable, " +
                           std::to_string(sides->unstable) + " unstable, " +
                           std::to_string(sides->saddle) + " saddles");
  }
  line("mean deviation " + unit, format_rounded(block.deviation.mean, 3));
  line("scan to body at most " + unit, format_rounded(block.deviation.scan_to_body, 3));
  line("body to scan at most " + unit, format_rounded(block.deviation.body_to_scan, 3));
  line("volume difference to scan", format_rounded(block.deviation.volume_relative, 2));
  line("area difference to scan", format_rounded(block.deviation.area_relative, 2));
  line("moments difference to scan", format_rounded(block.deviation.moments_relative, 2));
  if (block.volume_bracket) {
    for (const std::array<std::string, 2>& one : unseen_lines(block)) lines.push_back(one);
  }
  const FieldNotes& field = block.field;
  if (!field.site.empty()) line("site", field.site);
  if (field.taped_axes) {
    line("taped L I S m",
         vector_text({field.taped_axes->L, field.taped_axes->I, field.taped_axes->S}));
  }
  if (field.weighed_mass) line("weighed kg", format_rounded(*field.weighed_mass));
  if (!field.note.empty()) line("note", field.note);
  for (const std::string& warning : block.warnings) line("warning", warning);
  return lines;
}

}  // namespace clast
