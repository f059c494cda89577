#include "report/json/population_json.hpp"

#include "classify/box_convention.hpp"
#include "classify/certainty.hpp"
#include "classify/surface_indices.hpp"

namespace clast {

namespace {

using Json = nlohmann::ordered_json;

Json certainty_json(const ClassCertainty& certainty) {
  return {{"class", certainty.name},        {"ratio", certainty.ratio},
          {"value", certainty.value},       {"nearest_limit", certainty.limit},
          {"distance", certainty.distance}, {"near_limit", certainty.near_limit},
          {"survives", certainty.survives}, {"others", certainty.others}};
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

Json test_json(const std::optional<TestResult>& test, const char* statistic) {
  Json json;
  json[statistic] = test ? Json(test->statistic) : Json();
  json["p_value"] = test ? Json(test->p_value) : Json();
  return json;
}

}  // namespace

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
