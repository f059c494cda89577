#include "report/json/population_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "classify/axis_orientation.hpp"
#include "classify/box_convention.hpp"
#include "classify/certainty.hpp"
#include "classify/surface_indices.hpp"
#include "core/angle.hpp"
#include "report/json/block_json.hpp"
#include "report/text/scanned_deposit_text.hpp"

namespace clast {

namespace {

using Json = nlohmann::ordered_json;

Json certainty_json(const ClassCertainty& certainty) {
  return {{"class", certainty.name},          {"ratio", certainty.nearest_ratio},
          {"value", certainty.ratio_value},   {"nearest_limit", certainty.nearest_limit},
          {"distance", certainty.distance},   {"near_limit", certainty.near_limit},
          {"survives", certainty.is_certain}, {"others", certainty.other_possible_classes}};
}

Json curve_json(const SizeCurve& curve) {
  if (curve.blocks == 0) return nullptr;  // every block is unscaled
  Json laws = Json::array();
  for (const FittedSizeLaw& law : curve.laws) {
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

Json surface_json(const SurfaceMeasures& measures) {
  Json json = {{"equilibria", equilibria_json(measures.sides)}};
  if (!measures.roundness) return json;
  json["roundness"] = {{"wadell_roundness", measures.roundness->value},
                       {"edge_length_m", measures.roundness->edge_length},
                       {"inscribed_radius_m", measures.roundness->inscribed_radius},
                       {"corner_share", measures.roundness->corner_fraction}};
  return json;
}

/// A block of "blocks": its axes, every class with its certainty, every index of form.
Json measured_block_json(const MeasuredBlock& block, const SchemeOptions& limits) {
  const std::string unit = block.unscaled ? "_units" : "_m";
  Json json = {{"id", block.name},
               {"box" + unit, {block.axes.L, block.axes.I, block.axes.S}},
               {"axis_error" + unit, block.axis_error},
               {"s_c", elongation_index(block.axes_in_table_unit)},
               {"sneed_folk", sneed_folk_class(block.axes_in_table_unit, limits)},
               {"zingg", zingg_class(block.axes_in_table_unit)},
               {"shape", garcia_class(block.axes_in_table_unit)}};
  if (block.mass) json["mass_kg"] = *block.mass;
  for (std::size_t i = 0; i < block.axes_by_box.size(); ++i) {
    const Axes& axes = block.axes_by_box[i];
    json["boxes" + unit][name_of(kBoxConventions[i])] = {axes.L, axes.I, axes.S};
  }
  for (const std::string& scheme : scheme_names()) {
    json["classes"][scheme] =
        certainty_json(assess_class_certainty(scheme, block.axes, block.axis_error, limits));
  }
  json["indices"] = form_indices(block.axes_in_table_unit);
  return json;
}

/// Formula and source of every index of form.
Json formulas_json() {
  Json json;
  for (const FormIndex& index : form_index_definitions()) {
    json[index.name] = {{"formula", index.formula}, {"source", index.source}};
  }
  for (const SurfaceIndex& index : surface_index_definitions()) {
    json[index.name] = {{"formula", index.formula}, {"source", index.source}};
  }
  return json;
}

/// Rows of "population": {scheme: [...]}.
Json shares_json(const PopulationSummary& summary) {
  Json population = Json::object();
  for (const SchemeFractions& scheme : summary.schemes) {
    population[scheme.scheme] = Json::array();
    for (const ClassFraction& share : scheme.fractions) {
      Json row = {{"class", share.name},
                  {"blocks", share.count},
                  {"share", share.fraction},
                  {"low", share.low},
                  {"high", share.high}};
      if (summary.blocks_with_mass > 0) {
        row["mass_kg"] = share.mass;
        row["mass_share"] = share.mass_fraction;
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
  for (const SizeShapeCorrelation& relation : summary.size_shape_correlations) {
    Json json = {{"shape", relation.measure->name}, {"blocks", relation.blocks}};
    json.update(test_json(relation.test, "spearman_rho"));
    json["words"] = describe_size_shape(relation, summary.size.measure);
    all.push_back(json);
  }
  return all;
}

Json estimate_json(const EstimatedValue& estimate) {
  return {
      {"value", estimate.value}, {"low", estimate.interval.low}, {"high", estimate.interval.high}};
}

Json correction_json(const VisibilityCorrection& correction) {
  return {{"found_at_most", VisibilityCorrection::kMostFound},
          {"middle_size_m", correction.middle_size},
          {"visible_area_mean", correction.model.mean},
          {"visible_area_slope", correction.model.slope},
          {"visible_area_deviation", correction.model.deviation},
          {"least_points", VisibilityCorrection::kLeastPoints},
          {"least_visible_fraction", VisibilityCorrection::kLeastVisibleFraction},
          {"words", describe_visibility_correction(correction)}};
}

Json long_axes_json(const LongAxisTrends& axes) {
  Json json = {{"blocks", axes.trends.size()},
               {"least_elongation", kLeastElongation},
               {"resultant_length", axes.mean.resultant_length},
               {"rayleigh_p_value", axes.p_value},
               {"words", describe_long_axes(axes)}};
  json["mean_trend_deg"] =
      std::isfinite(axes.mean.direction) ? Json(axes.mean.direction * kDegreesPerRadian) : Json();
  return json;
}

/// Statistics of a scanned deposit: sizes {weighting: {quantity: {percentile: ...}}} and classes.
Json scanned_deposit_json(const ScannedDepositSummary& summary) {
  Json json = {{"blocks", summary.blocks},
               {"expected_blocks", summary.expected_blocks},
               {"corrected_blocks", estimate_json(summary.corrected_blocks)},
               {"correction", correction_json(summary.correction)}};
  for (const WeightedSizes& sizes : summary.sizes) {
    Json& weighted = json["sizes"][name_of(sizes.weighting)];
    for (std::size_t q = 0; q < kWeightedQuantities.size(); ++q) {
      const std::string quantity = kWeightedQuantities[q];
      for (std::size_t p = 0; p < kWeightedPercentiles.size(); ++p) {
        weighted[quantity + (quantity == "volume" ? "_m3" : "_m")][kWeightedPercentileNames[p]] =
            estimate_json(sizes.percentiles[q][p]);
      }
    }
  }
  for (const CorrectedSchemeFractions& scheme : summary.schemes) {
    for (const CorrectedFraction& one : scheme.fractions) {
      json["classes"][scheme.scheme].push_back({{"class", one.name},
                                                {"found", estimate_json(one.found)},
                                                {"corrected", estimate_json(one.corrected)}});
    }
  }
  json["long_axes"] = long_axes_json(summary.long_axes);
  return json;
}

/// Observation of a block of a scanned deposit.
Json observation_json(const DepositObservation& seen, const VisibilityCorrection& correction,
                      double intermediate) {
  const AxisOrientation axis = axis_orientation(seen.long_axis);
  return {{"points", seen.points},
          {"visible_fraction", seen.visible_fraction},
          {"confidence", seen.confidence},
          {"plan_area_m2", seen.plan_area},
          {"exposed_area_m2", seen.exposed_area},
          {"trend_deg", axis.trend * kDegreesPerRadian},
          {"plunge_deg", axis.plunge * kDegreesPerRadian},
          {"found_probability", correction.inclusion_probability(intermediate)}};
}

Json comparison_json(const PopulationComparison& comparison) {
  Json measures = Json::array(), schemes = Json::array();
  for (const ShapeMeasureDifference& one : comparison.measures) {
    Json json = {{"measure", one.measure->name}};
    json.update(test_json(one.test, "ks_distance"));
    json["words"] = one.description;
    measures.push_back(json);
  }
  for (const ClassFractionDifference& one : comparison.schemes) {
    Json json = {{"scheme", one.scheme}};
    json["chi_squared"] = one.test ? Json(one.test->chi_squared) : Json();
    json["degrees_of_freedom"] = one.test ? Json(one.test->degrees_of_freedom) : Json();
    json["smallest_expected"] = one.test ? Json(one.test->smallest_expected) : Json();
    json["random_tables"] = one.test ? Json(one.test->draws) : Json();
    json["p_value"] = one.test ? Json(one.test->p_value) : Json();
    json["words"] = one.description;
    schemes.push_back(json);
  }
  return {{"a", comparison.name_a},
          {"b", comparison.name_b},
          {"measures", measures},
          {"schemes", schemes}};
}

std::string one_line(const Json& json) { return json.dump(); }

/// The members of one population, without the braces around them.
void write_population(std::ostream& out, const ReportedPopulation& reported,
                      const PopulationOptions& options) {
  const PopulationSummary& summary = reported.summary;
  out << "\"name\": " << one_line(reported.population.name)
      << ",\n\"box\": " << one_line(reported.reading.box.value_or("as measured"))
      << ",\n\"blocks\": [";
  for (std::size_t i = 0; i < reported.population.blocks.size(); ++i) {
    Json json = measured_block_json(reported.population.blocks[i], options.limits);
    if (i < reported.surfaces.size() && reported.surfaces[i]) {
      json["indices"].update(Json(reported.surfaces[i]->indices));
      json.update(surface_json(*reported.surfaces[i]));
    }
    const MeasuredBlock& block = reported.population.blocks[i];
    if (reported.deposit && block.deposit && !block.unscaled) {
      json["deposit"] =
          observation_json(*block.deposit, reported.deposit->correction, block.axes.I);
    }
    out << (i > 0 ? ",\n" : "\n") << one_line(json);
  }
  out << "\n],";
  if (reported.deposit)
    out << "\n\"deposit\": " << one_line(scanned_deposit_json(*reported.deposit)) << ",";
  out << "\n\"population\": " << one_line(shares_json(summary))
      << ",\n\"size\": " << one_line(size_json(summary))
      << ",\n\"size_and_shape\": " << one_line(size_and_shape_json(summary))
      << ",\n\"c40\": " << one_line(summary.c40) << ",\n\"skipped\": " << reported.skipped
      << ",\n\"notes\": " << one_line(reported.notes);
}

}  // namespace

void write_population_json(std::ostream& out, const PopulationReport& report) {
  out << "{\n";
  write_population(out, report.populations.front(), report.options);
  out << ",\n\"formulas\": " << one_line(formulas_json());
  if (report.comparison) {
    out << ",\n\"against\": {\n";
    write_population(out, report.populations.back(), report.options);
    out << "\n},\n\"comparison\": " << one_line(comparison_json(*report.comparison));
  }
  out << "\n}\n";
}

}  // namespace clast
