#include "app/population_print.hpp"

#include "app/text_table.hpp"
#include "classify/box_convention.hpp"
#include "classify/certainty.hpp"
#include "classify/surface_indices.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"

namespace clast {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double share) { return with_decimals(100.0 * share, 1); }

std::string shares_text(const SchemeShares& scheme, bool weighed) {
  TextTable table{{scheme.scheme, "blocks", "share %", "95 % from", "to"}, {}};
  if (weighed) {
    for (const char* name : {"mass kg", "by mass %", "95 % from", "to"}) {
      table.headings.push_back(name);
    }
  }
  for (const ClassShare& share : scheme.shares) {
    table.rows.push_back({share.name, std::to_string(share.count), percent(share.share),
                          percent(share.low), percent(share.high)});
    if (!weighed) continue;
    for (const std::string& cell : {rounded(share.mass), percent(share.mass_share),
                                    percent(share.mass_low), percent(share.mass_high)}) {
      table.rows.back().push_back(cell);
    }
  }
  return table.text();
}

void add_laws(TextTable& table, const std::string& weighting, const SizeCurve& curve) {
  for (const SizeLaw& law : curve.laws) {
    const bool normal = law.kind == SizeLawKind::kLogNormal;
    table.rows.push_back({name_of(law.kind) + " " + weighting,
                          std::string(normal ? "median " : "d63 ") + rounded(law.location, 3) +
                              " +- " + rounded(law.location_error, 2) + " m",
                          std::string(normal ? "sigma of ln " : "exponent ") +
                              rounded(law.spread, 3) + " +- " + rounded(law.spread_error, 2),
                          rounded(law.distance, 3), law.p_value ? p_words(*law.p_value) : "-"});
  }
}

std::string size_text(const SizeDistribution& size) {
  if (size.by_number.blocks == 0) return "no sizes: every block is unscaled\n";
  TextTable percentiles{{"size " + name_of(size.measure), "blocks", "d10 m", "d50 m", "d90 m"}, {}};
  const auto add = [&](const std::string& name, const SizeCurve& curve) {
    percentiles.rows.push_back({name, std::to_string(curve.blocks), rounded(curve.d10, 3),
                                rounded(curve.d50, 3), rounded(curve.d90, 3)});
  };
  add("by number", size.by_number);
  if (size.by_mass) add("by mass", *size.by_mass);
  TextTable laws{{"fit", "size", "spread", "KS distance", "p"}, {}};
  add_laws(laws, "by number", size.by_number);
  if (size.by_mass) add_laws(laws, "by mass", *size.by_mass);
  return percentiles.text() + (laws.rows.empty() ? std::string() : "\n" + laws.text());
}

Json curve_json(const SizeCurve& curve) {
  if (curve.blocks == 0) return nullptr;  // every block is unscaled
  Json laws = Json::array();
  for (const SizeLaw& law : curve.laws) {
    const bool normal = law.kind == SizeLawKind::kLogNormal;
    Json json = {{"law", name_of(law.kind)},
                 {normal ? "median_m" : "d63_m", law.location},
                 {normal ? "median_error_m" : "d63_error_m", law.location_error},
                 {normal ? "sigma" : "exponent", law.spread},
                 {normal ? "sigma_error" : "exponent_error", law.spread_error},
                 {"ks_distance", law.distance}};
    json["ks_p_value"] = law.p_value ? Json(*law.p_value) : Json();
    laws.push_back(json);
  }
  return {{"blocks", curve.blocks},
          {"d10_m", curve.d10},
          {"d50_m", curve.d50},
          {"d90_m", curve.d90},
          {"fits", laws}};
}

Json certainty_json(const ClassCertainty& certainty) {
  return {{"class", certainty.name},        {"ratio", certainty.ratio},
          {"value", certainty.value},       {"nearest_limit", certainty.limit},
          {"distance", certainty.distance}, {"near_limit", certainty.near_limit},
          {"survives", certainty.survives}, {"others", certainty.others}};
}

Json test_json(const std::optional<TestResult>& test, const char* statistic) {
  Json json;
  json[statistic] = test ? Json(test->statistic) : Json();
  json["p_value"] = test ? Json(test->p_value) : Json();
  return json;
}

}  // namespace

std::string blocks_text(const Population& population, const PopulationOptions& options) {
  TextTable table{{"block", "L m", "I m", "S m", "s_c"}, {}};
  table.headings.insert(table.headings.end(), options.schemes.begin(), options.schemes.end());
  const std::string& first = options.schemes.front();
  table.headings.push_back("how sure (" + first + ")");
  for (const MeasuredBlock& block : population.blocks) {
    const char* const unit = block.unscaled ? " u" : "";
    table.rows.push_back({block.name, rounded(block.axes.L) + unit, rounded(block.axes.I) + unit,
                          rounded(block.axes.S) + unit,
                          rounded(elongation_s_c(block.as_written), 3)});
    for (const std::string& scheme : options.schemes) {
      table.rows.back().push_back(shape_class(scheme, block.as_written, options.limits));
    }
    const ClassCertainty certainty =
        class_certainty(first, block.axes, block.axis_error, options.limits);
    table.rows.back().push_back(certainty.near_limit ? certainty_words(certainty)
                                                     : "clear of limits");
  }
  return table.text();
}

Json measured_block_json(const MeasuredBlock& block, const SchemeOptions& limits) {
  const std::string unit = block.unscaled ? "_units" : "_m";
  Json json = {{"id", block.name},
               {"box" + unit, {block.axes.L, block.axes.I, block.axes.S}},
               {"axis_error" + unit, block.axis_error},
               {"s_c", elongation_s_c(block.as_written)},
               {"sneed_folk", sneed_folk_class(block.as_written, limits)},
               {"zingg", zingg_class(block.as_written)},
               {"shape", garcia_class(block.as_written)}};
  if (block.mass) json["mass_kg"] = *block.mass;
  for (std::size_t i = 0; i < block.by_box.size(); ++i) {
    const Axes& axes = block.by_box[i];
    json["boxes" + unit][name_of(kBoxConventions[i])] = {axes.L, axes.I, axes.S};
  }
  for (const std::string& scheme : scheme_names()) {
    json["classes"][scheme] =
        certainty_json(class_certainty(scheme, block.axes, block.axis_error, limits));
  }
  json["indices"] = form_indices(block.as_written);
  return json;
}

Json formulas_json() {
  Json json;
  for (const FormIndex& index : form_index_list()) {
    json[index.name] = {{"formula", index.formula}, {"source", index.source}};
  }
  for (const SurfaceIndex& index : surface_index_list()) {
    json[index.name] = {{"formula", index.formula}, {"source", index.source}};
  }
  return json;
}

std::string summary_text(const PopulationSummary& summary) {
  std::string text;
  for (const SchemeShares& scheme : summary.schemes) {
    text += "\n" + shares_text(scheme, summary.weighed > 0);
  }
  text += "\n" + size_text(summary.size) + "\n";
  for (const SizeShape& relation : summary.size_and_shape) {
    text += size_shape_words(relation, summary.size.measure) + "\n";
  }
  return text + "C40 (S/L at most 0.4): " + percent(summary.c40) + " %\n";
}

std::string comparison_text(const PopulationComparison& comparison) {
  std::string text = "\n" + printable(comparison.name_a + " against " + comparison.name_b) + ":\n";
  for (const ClassDifference& one : comparison.schemes) text += one.words + "\n";
  for (const MeasureDifference& one : comparison.measures) text += one.words + "\n";
  return text;
}

Json shares_json(const PopulationSummary& summary) {
  Json population = Json::object();
  for (const SchemeShares& scheme : summary.schemes) {
    population[scheme.scheme] = Json::array();
    for (const ClassShare& share : scheme.shares) {
      Json row = {{"class", share.name},
                  {"blocks", share.count},
                  {"share", share.share},
                  {"low", share.low},
                  {"high", share.high}};
      if (summary.weighed > 0) {
        row["mass_kg"] = share.mass;
        row["mass_share"] = share.mass_share;
        row["mass_low"] = share.mass_low;
        row["mass_high"] = share.mass_high;
      }
      population[scheme.scheme].push_back(row);
    }
  }
  return population;
}

Json size_json(const PopulationSummary& summary) {
  const SizeDistribution& size = summary.size;
  Json json = {{"size", name_of(size.measure)},
               {"reading_step_m", size.step},
               {"by_number", curve_json(size.by_number)}};
  if (size.by_mass) {
    json["by_mass"] = curve_json(*size.by_mass);
    json["total_mass_kg"] = size.total_mass;
  }
  return json;
}

Json size_and_shape_json(const PopulationSummary& summary) {
  Json all = Json::array();
  for (const SizeShape& relation : summary.size_and_shape) {
    Json json = {{"shape", relation.measure->name}, {"blocks", relation.blocks}};
    json.update(test_json(relation.test, "spearman_rho"));
    json["words"] = size_shape_words(relation, summary.size.measure);
    all.push_back(json);
  }
  return all;
}

Json comparison_json(const PopulationComparison& comparison) {
  Json measures = Json::array(), schemes = Json::array();
  for (const MeasureDifference& one : comparison.measures) {
    Json json = {{"measure", one.measure->name}};
    json.update(test_json(one.test, "ks_distance"));
    json["words"] = one.words;
    measures.push_back(json);
  }
  for (const ClassDifference& one : comparison.schemes) {
    Json json = {{"scheme", one.scheme}};
    json["chi_squared"] = one.test ? Json(one.test->chi_squared) : Json();
    json["degrees_of_freedom"] = one.test ? Json(one.test->freedom) : Json();
    json["smallest_expected"] = one.test ? Json(one.test->smallest_expected) : Json();
    json["random_tables"] = one.test ? Json(one.test->draws) : Json();
    json["p_value"] = one.test ? Json(one.test->p_value) : Json();
    json["words"] = one.words;
    schemes.push_back(json);
  }
  return {{"a", comparison.name_a},
          {"b", comparison.name_b},
          {"measures", measures},
          {"schemes", schemes}};
}

}  // namespace clast
