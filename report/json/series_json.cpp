#include "report/json/series_json.hpp"

#include "classify/schemes.hpp"
#include "classify/surface_indices.hpp"
#include "library/unscaled.hpp"

namespace clast {
namespace {

nlohmann::ordered_json body_json(const Block& block) {
  const VariationRecord record = parse_variation(block).value_or(VariationRecord{});
  const bool metric = !is_unscaled(block);
  nlohmann::ordered_json json = {
      {"id", block.id}, {"parent", record.parent}, {"kind", record.kind}};
  json["reference"] = nullptr;
  if (!record.reference.empty()) json["reference"] = record.reference;
  json["target_I_over_L"] = nullptr;
  json["target_S_over_L"] = nullptr;
  json["target"] = nullptr;
  if (record.target_ratios) {
    json["target_I_over_L"] = record.target_ratios->i_l;
    json["target_S_over_L"] = record.target_ratios->s_l;
  } else if (record.reference.empty()) {
    json["target"] = record.target_value;
  }
  const BoxRatios ratios = box_ratios(block.box);
  json["I_over_L"] = ratios.i_l;
  json["S_over_L"] = ratios.s_l;
  json["convexity"] = convexity(block.body, block.mass.volume);
  json["radius_share_of_S"] = block.body.radius / block.box.lengths[2];
  json["vertices"] = block.body.vertices.size();
  json[metric ? "L_m" : "L_units"] = block.box.lengths[0];
  json[metric ? "volume_m3" : "volume_units3"] = block.mass.volume;
  json["mass_kg"] = metric ? nlohmann::ordered_json(block.mass.mass) : nlohmann::ordered_json();
  json["sneed_folk"] = sneed_folk_class(block.axes());
  return json;
}

}  // namespace

nlohmann::ordered_json series_json(const VariedBlockSeries& series,
                                   const std::optional<CopulaFit>& fit) {
  nlohmann::ordered_json json;
  json["bodies"] = nlohmann::ordered_json::array();
  for (const Block& block : series.blocks) json["bodies"].push_back(body_json(block));
  json["failed"] = series.failures;
  json["fit"] = nullptr;
  if (!fit) return json;
  nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
  for (const RankCorrelation& pair : fit->correlations) {
    pairs.push_back({{"first", pair.first},
                     {"second", pair.second},
                     {"population", pair.population},
                     {"drawn", pair.sampled}});
  }
  json["fit"] = {{"largest_difference", fit->max_cdf_difference},
                 {"weakened", fit->removed_correlation},
                 {"rank_correlations", pairs}};
  return json;
}

}  // namespace clast
