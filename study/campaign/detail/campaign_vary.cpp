// `vary` of [blocks] of a campaign file.
#include <algorithm>

#include "core/error.hpp"
#include "core/length_unit.hpp"
#include "library/variation_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"

namespace clast::study_detail {
namespace {

std::vector<BoxRatios> read_ratios(const DeclaredTable& table) {
  const TomlNode& node = *table.find("to");
  const std::string expected = "a list of [I/L, S/L], such as [[0.8, 0.5], [0.6, 0.4]]";
  if (node.kind != TomlNode::Kind::kList || node.list.empty()) {
    table.refuse("to", node, "must be " + expected);
  }
  std::vector<BoxRatios> all;
  for (const TomlNode& pair : node.list) {
    const std::vector<double> ratios =
        table.read_numbers("to", pair, 2, 2, expected, kVariedRatioRange);
    if (ratios[1] > ratios[0]) table.refuse("to", pair, "S/L must be at most I/L");
    all.push_back({ratios[0], ratios[1]});
  }
  return all;
}

const MemberTable<FormGrid>& grid_keys() {
  static const MemberTable<FormGrid> keys(
      {"blocks.vary.grid", "A grid of forms over a diagram"},
      {{"diagram", "", "form diagram",
        required_format("\"sneed-folk\" or \"zingg\"", word_format(form_grid_diagram_names())),
        &FormGrid::diagram},
       {"steps", "", "number of steps along each side",
        required_format("a whole number of steps along each side", count_format(1, kMaxGridSteps)),
        &FormGrid::steps},
       {"least", "", "smallest S/L of sneed-folk, smallest I/L and S/I of zingg",
        number_format(kMinRatioRange), &FormGrid::min_ratio}});
  return keys;
}

FormGrid read_grid(const DeclaredTable& vary) {
  FormGrid grid;
  grid_keys().read(vary.inner_table("grid"), grid);
  return grid;
}

const MemberTable<VariationSeriesRequest>& population_keys() {
  static const MemberTable<VariationSeriesRequest> keys(
      {"blocks.vary.population", "Bodies with drawn sizes and forms"},
      {{"count", "", "number of bodies",
        required_format("a whole number of bodies", count_format(1, kMaxSeriesBodies)),
        &VariationSeriesRequest::sampled_count},
       {"seed", "", "seed of the draw", seed_format(), &VariationSeriesRequest::seed},
       {"table", "", "table of measured blocks, with columns L, I and S", text_format(),
        &VariationSeriesRequest::table},
       {"units", "", "length unit of the table", text_format(), &VariationSeriesRequest::units},
       {"prefix", "", "prefix of the ids, which are numbered", text_format(),
        &VariationSeriesRequest::prefix}});
  return keys;
}

void read_population(const DeclaredTable& vary, VariationSeriesRequest& request) {
  const DeclaredTable table = vary.inner_table("population");
  population_keys().read(table, request);
  if (table.find("units")) {
    if (request.table.empty()) {
      table.refuse("units", "are the units of table, but there is no table; leave units out");
    }
    table.run_check("units", [&] { parse_length_unit(request.units); });
  }
  if (table.find("prefix")) {
    table.run_check("prefix", [&] { check_block_id(request.prefix + "0001"); });
  }
}

/// A number that only says more of what another key asks for.
void refuse_alone(const TomlTable& table, const std::string& key, bool needed,
                  const std::string& what) {
  if (const TomlNode* node = table.find(key); node && !needed) {
    table.refuse(key, *node, "is of " + what + ", which is not requested; leave it out");
  }
}

void check_steps(const DeclaredTable& table, const VariationTargets& steps) {
  refuse_alone(table, "roundness_edge", !steps.roundness.empty(), "roundness");
  refuse_alone(table, "degree", !steps.detail.empty(), "detail");
  refuse_alone(table, "exponent",
               std::find(steps.reference.begin(), steps.reference.end(), "superellipsoid") !=
                   steps.reference.end(),
               "the reference body superellipsoid");
}

}  // namespace

const MemberTable<VariationSeriesRequest>& vary_keys() {
  using Steps = VariationTargets;
  constexpr auto kSteps = &VariationSeriesRequest::targets;
  const auto numbers = [](const NumberRange& range) {
    return one_or_more_format(number_format(range), kMaxSeriesBodies);
  };
  static const MemberTable<VariationSeriesRequest> keys(
      {"blocks.vary", "Bodies made from the blocks, which replace them"},
      {{"to", "", "stretch to these ratios, [I/L, S/L] each",
        list_format(list_format(number_format(kVariedRatioRange), 2, 2), 1), &read_ratios, kSteps,
        &Steps::ratios},
       {"grid", "", "stretch to a grid of forms over a diagram", table_format(grid_keys().keys),
        &read_grid, kSteps, &Steps::grid},
       {"like", "", "stretch to the ratios of these blocks of the library", texts_format(),
        &VariationSeriesRequest::target_ratio_ids},
       {"convexity", "", "fill hollows until the volume is this fraction of that of the hull",
        numbers(kVariedConvexityRange), kSteps, &Steps::convexity},
       {"rounding", "", "radius of edges and corners as a fraction of S",
        numbers(kVariedRadiusFractionRange), kSteps, &Steps::rounding},
       {"roundness", "", "round edges and corners to this Wadell roundness",
        numbers(kVariedRoundnessRange), kSteps, &Steps::roundness},
       {"roundness_edge", "",
        "edge length of the mesh on which roundness is measured, as a fraction of the diameter of "
        "a sphere of equal volume",
        number_format(kRoundnessEdgeRange), kSteps, &Steps::roundness_edge},
       {"vertices", "", "simplify the core to this number of vertices",
        one_or_more_format(count_format(kMinVariedVertices, kMaxVariedVertices), kMaxSeriesBodies),
        kSteps, &Steps::vertices},
       {"detail", "",
        "factor for the deviation of the surface from the coarse form: 0 smooths, 2 roughens",
        numbers(kDetailGainRange), kSteps, &Steps::detail},
       {"degree", "", "degree of the spherical harmonics of the coarse form",
        count_format(kMinDegree, kMaxDegree), kSteps, &Steps::degree},
       {"reference", "", "simple bodies with the block's I/L and S/L",
        one_or_more_format(word_format(reference_shape_names())), kSteps, &Steps::reference},
       {"exponent", "", "exponent of the superellipsoid",
        number_format(kSuperellipsoidExponentRange), kSteps, &Steps::exponent},
       {"inertia", "", "bodies with the block's mass and principal moments",
        one_or_more_format(word_format(inertia_body_names())), kSteps, &Steps::inertia},
       {"population", "",
        "bodies with sizes and forms drawn from the distribution of the blocks, or of a table",
        table_format(population_keys().keys), &read_population},
       {"keep", "", "quantity that is equal for a body and its block",
        word_format({"mass", "volume", "L"}), &parse_preserved_size,
        &VariationSeriesRequest::options, &VariationSeriesOptions::variation,
        &VariationOptions::preserved_size}});
  return keys;
}

VariationSeriesRequest read_variation_request(const DeclaredTable& blocks) {
  if (blocks.find("draw")) {
    blocks.refuse("vary",
                  "blocks are either varied or drawn; leave draw out (population = { count = N } "
                  "of vary draws sizes and forms), or leave vary out");
  }
  const DeclaredTable table = blocks.inner_table("vary");
  VariationSeriesRequest request;
  vary_keys().read(table, request);
  check_steps(table, request.targets);
  if (request.is_empty()) {
    table.refuse(
        "no variation is requested; give to, grid, like, convexity, rounding, roundness, vertices, "
        "detail, reference, inertia or population");
  }
  return request;
}

}  // namespace clast::study_detail
