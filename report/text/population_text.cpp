#include "report/text/population_text.hpp"

#include "classify/box_convention.hpp"
#include "classify/certainty.hpp"
#include "classify/surface_indices.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/text_table.hpp"

namespace clast {
namespace {

std::string percentage(double share) { return format_decimals(100.0 * share, 1); }

std::string shares_text(const SchemeFractions& scheme, bool weighed) {
  TextTable table{{scheme.scheme, "blocks", "share %", "95 % from", "to"}, {}};
  if (weighed) {
    for (const char* name : {"mass kg", "by mass %", "95 % from", "to"}) {
      table.headings.push_back(name);
    }
  }
  for (const ClassFraction& share : scheme.fractions) {
    table.rows.push_back({share.name, std::to_string(share.count), percentage(share.fraction),
                          percentage(share.low), percentage(share.high)});
    if (!weighed) continue;
    for (const std::string& cell : {format_rounded(share.mass), percentage(share.mass_fraction),
                                    percentage(share.mass_low), percentage(share.mass_high)}) {
      table.rows.back().push_back(cell);
    }
  }
  return table.text();
}

void add_laws(TextTable& table, const std::string& weighting, const SizeCurve& curve) {
  for (const FittedSizeLaw& law : curve.laws) {
    const bool normal = law.kind == SizeLawKind::kLogNormal;
    table.rows.push_back(
        {name_of(law.kind) + " " + weighting,
         std::string(normal ? "median " : "d63 ") + format_rounded(law.location, 3) + " +- " +
             format_rounded(law.location_error, 2) + " m",
         std::string(normal ? "sigma of ln " : "exponent ") + format_rounded(law.spread, 3) +
             " +- " + format_rounded(law.spread_error, 2),
         format_rounded(law.distance, 3), law.p_value ? format_p_value(*law.p_value) : "-"});
  }
}

std::string size_text(const SizeDistribution& size) {
  if (size.by_number.blocks == 0) return "no sizes, because all blocks are unscaled\n";
  TextTable percentiles{{"size " + name_of(size.measure), "blocks", "d10 m", "d50 m", "d90 m"}, {}};
  const auto add = [&](const std::string& name, const SizeCurve& curve) {
    percentiles.rows.push_back({name, std::to_string(curve.blocks), format_rounded(curve.d10, 3),
                                format_rounded(curve.d50, 3), format_rounded(curve.d90, 3)});
  };
  add("by number", size.by_number);
  if (size.by_mass) add("by mass", *size.by_mass);
  TextTable laws{{"fit", "size", "spread", "KS distance", "p"}, {}};
  add_laws(laws, "by number", size.by_number);
  if (size.by_mass) add_laws(laws, "by mass", *size.by_mass);
  return percentiles.text() + (laws.rows.empty() ? std::string() : "\n" + laws.text());
}

}  // namespace

std::string format_blocks_table(const Population& population, const PopulationOptions& options) {
  const std::vector<std::string>& schemes = options.selected_schemes();
  TextTable table{{"block", "L m", "I m", "S m", "s_c"}, {}};
  table.headings.insert(table.headings.end(), schemes.begin(), schemes.end());
  const std::string& first = schemes.front();
  table.headings.push_back("certainty (" + first + ")");
  for (const MeasuredBlock& block : population.blocks) {
    const char* const unit = block.unscaled ? " u" : "";
    table.rows.push_back({block.name, format_rounded(block.axes.L) + unit,
                          format_rounded(block.axes.I) + unit, format_rounded(block.axes.S) + unit,
                          format_rounded(elongation_index(block.axes_in_table_unit), 3)});
    for (const std::string& scheme : schemes) {
      table.rows.back().push_back(shape_class(scheme, block.axes_in_table_unit, options.limits));
    }
    const ClassCertainty certainty =
        assess_class_certainty(first, block.axes, block.axis_error, options.limits);
    table.rows.back().push_back(certainty.near_limit ? describe_certainty(certainty)
                                                     : "far from class limits");
  }
  return table.text();
}

std::string format_population_summary(const PopulationSummary& summary) {
  std::string text;
  for (const SchemeFractions& scheme : summary.schemes) {
    text += "\n" + shares_text(scheme, summary.blocks_with_mass > 0);
  }
  text += "\n" + size_text(summary.size) + "\n";
  for (const SizeShapeCorrelation& relation : summary.size_shape_correlations) {
    text += describe_size_shape(relation, summary.size.measure) + "\n";
  }
  return text + "C40 (S/L at most 0.4): " + percentage(summary.c40) + " %\n";
}

std::string format_population_comparison(const PopulationComparison& comparison) {
  std::string text =
      "\n" + escape_nonprintable(comparison.name_a + " against " + comparison.name_b) + ":\n";
  for (const ClassFractionDifference& one : comparison.schemes) text += one.description + "\n";
  for (const ShapeMeasureDifference& one : comparison.measures) text += one.description + "\n";
  return text;
}

}  // namespace clast
