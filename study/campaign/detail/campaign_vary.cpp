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
    const std::vector<double> ratios = table.numbers("to", pair, 2, 2, expected, kVariedRatio);
    if (ratios[1] > ratios[0]) table.refuse("to", pair, "S/L must be at most I/L");
    all.push_back({ratios[0], ratios[1]});
  }
  return all;
}

const MemberTable<FormGrid>& grid_keys() {
  static const MemberTable<FormGrid> keys(
      {"blocks.vary.grid", "Forms all over a diagram"},
      {{"diagram", "", "of form", required("\"sneed-folk\" or \"zingg\"", words(form_grid_names())),
        &FormGrid::diagram},
       {"steps", "", "along each side",
        required("how many along each side, a whole number", count(1, kMaxGridSteps)),
        &FormGrid::steps},
       {"least", "", "smallest S/L, in zingg I/L and S/I", number(kMinRatio), &FormGrid::least}});
  return keys;
}

FormGrid read_grid(const DeclaredTable& vary) {
  FormGrid grid;
  grid_keys().read(vary.inner_table("grid"), grid);
  return grid;
}

const MemberTable<SeriesRequest>& population_keys() {
  static const MemberTable<SeriesRequest> keys(
      {"blocks.vary.population", "Bodies with drawn sizes and forms"},
      {{"count", "", "how many",
        required("how many bodies, a whole number", count(1, kMaxSeriesBodies)),
        &SeriesRequest::draw},
       {"seed", "", "of the draw", seed(), &SeriesRequest::seed},
       {"table", "", "of measured blocks, with columns L, I and S", text(), &SeriesRequest::table},
       {"units", "", "length unit of the table", text(), &SeriesRequest::units},
       {"prefix", "", "ids are this and a number", text(), &SeriesRequest::prefix}});
  return keys;
}

void read_population(const DeclaredTable& vary, SeriesRequest& request) {
  const DeclaredTable table = vary.inner_table("population");
  population_keys().read(table, request);
  if (table.find("units")) {
    if (request.table.empty()) {
      table.refuse("units", "are those of table, which is missing; leave units out");
    }
    table.checked("units", [&] { parse_length_unit(request.units); });
  }
  if (table.find("prefix")) {
    table.checked("prefix", [&] { check_block_id(request.prefix + "0001"); });
  }
}

/// A number that only says more of what another key asks for.
void refuse_alone(const TomlTable& table, const std::string& key, bool needed,
                  const std::string& what) {
  if (const TomlNode* node = table.find(key); node && !needed) {
    table.refuse(key, *node, "is of " + what + ", which is not asked for; leave it out");
  }
}

void check_steps(const DeclaredTable& table, const SeriesTargets& steps) {
  refuse_alone(table, "roundness_edge", !steps.roundness.empty(), "roundness");
  refuse_alone(table, "degree", !steps.detail.empty(), "detail");
  refuse_alone(table, "exponent",
               std::find(steps.reference.begin(), steps.reference.end(), "superellipsoid") !=
                   steps.reference.end(),
               "the reference body superellipsoid");
}

}  // namespace

const MemberTable<SeriesRequest>& vary_keys() {
  using Steps = SeriesTargets;
  constexpr auto kSteps = &SeriesRequest::steps;
  const auto numbers = [](const NumberRange& range) {
    return one_or_more(number(range), kMaxSeriesBodies);
  };
  static const MemberTable<SeriesRequest> keys(
      {"blocks.vary", "Bodies made of the blocks, that run in their place"},
      {{"to", "", "stretch to these ratios, [I/L, S/L] each",
        list(list(number(kVariedRatio), 2, 2), 1), &read_ratios, kSteps, &Steps::ratios},
       {"grid", "", "stretch to forms all over a diagram", table(grid_keys().keys), &read_grid,
        kSteps, &Steps::grid},
       {"like", "", "stretch to the ratios of these blocks of the library", texts(),
        &SeriesRequest::like_ids},
       {"convexity", "", "fill hollows until the volume is this share of the hull's",
        numbers(kVariedConvexity), kSteps, &Steps::convexity},
       {"rounding", "", "radius of edges and corners as a share of S",
        numbers(kVariedRadiusFraction), kSteps, &Steps::rounding},
       {"roundness", "", "round edges and corners until Wadell's roundness is this",
        numbers(kVariedRoundness), kSteps, &Steps::roundness},
       {"roundness_edge", "",
        "edges that it is measured on, over the diameter of the ball of equal volume",
        number(kRoundnessEdge), kSteps, &Steps::roundness_edge},
       {"vertices", "", "simplify the core to so many",
        one_or_more(count(kMinVariedVertices, kMaxVariedVertices), kMaxSeriesBodies), kSteps,
        &Steps::vertices},
       {"detail", "", "factor on what lies off the coarse form: 0 smooths, 2 roughens",
        numbers(kDetailGain), kSteps, &Steps::detail},
       {"degree", "", "spherical harmonics up to this degree are the coarse form",
        count(kMinDegree, kMaxDegree), kSteps, &Steps::degree},
       {"reference", "", "simple bodies with the block's I/L and S/L",
        one_or_more(words(reference_shape_names())), kSteps, &Steps::reference},
       {"exponent", "", "of the superellipsoid", number(kSuperellipsoidExponent), kSteps,
        &Steps::exponent},
       {"inertia", "", "bodies with the block's mass and principal moments",
        one_or_more(words(inertia_form_names())), kSteps, &Steps::inertia},
       {"population", "", "bodies with sizes and forms drawn as the blocks, or a table, have them",
        table(population_keys().keys), &read_population},
       {"keep", "", "what bodies have in common with their block", words({"mass", "volume", "L"}),
        &parse_preserved_size, &SeriesRequest::options, &SeriesOptions::variation,
        &VariationOptions::keep}});
  return keys;
}

SeriesRequest read_vary(const DeclaredTable& blocks) {
  if (blocks.find("draw")) {
    blocks.refuse("vary",
                  "blocks are either varied or drawn; leave draw out (population = { count = N } "
                  "of vary draws sizes and forms), or leave vary out");
  }
  const DeclaredTable table = blocks.inner_table("vary");
  SeriesRequest request;
  vary_keys().read(table, request);
  check_steps(table, request.steps);
  if (request.is_empty()) {
    table.refuse(
        "nothing is asked for; give to, grid, like, convexity, rounding, roundness, vertices, "
        "detail, reference, inertia or population");
  }
  return request;
}

}  // namespace clast::study_detail
