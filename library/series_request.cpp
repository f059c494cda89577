#include "library/series_request.hpp"

#include <set>
#include <utility>

#include "classify/dimension_table.hpp"
#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "library/block_ranges.hpp"
#include "library/deposit_observations.hpp"
#include "library/library_update.hpp"
#include "library/variation_ranges.hpp"

namespace clast {

namespace {

/// Number of forms that represent a corrected deposit.
constexpr std::size_t kDepositForms = 2000;

/// Forms of library blocks. Those of a scanned deposit are drawn from their intervals, in the
/// numbers for which the blocks stand.
std::vector<BlockForm> forms_of_blocks(std::span<const Block* const> blocks, std::uint64_t seed,
                                       std::vector<std::string>& notes) {
  const std::optional<WeightedDeposit> deposit = weigh_deposit(blocks);
  std::vector<BlockForm> forms = block_forms(blocks);
  if (!deposit) return forms;
  notes.push_back(describe_weighted_deposit(*deposit));
  Random random(seed);
  std::vector<BlockForm> drawn;
  for (std::size_t k = 0; k < kDepositForms; ++k) {
    const std::size_t i = choose_by_weight(deposit->weights, random);
    drawn.push_back({draw_block_sizes(deposit->blocks[i], random).axes, forms[i].convexity});
  }
  return drawn;
}

std::vector<BlockForm> population_of(const VariationSeriesRequest& request,
                                     std::span<const Block* const> parents,
                                     std::vector<std::string>& notes) {
  if (request.table.empty()) return forms_of_blocks(parents, request.seed, notes);
  if (request.table.extension() == ".h5" || request.table.extension() == ".hdf5") {
    const BlockLibrary population = BlockLibrary::read(request.table);
    return forms_of_blocks(population.select_blocks({}), request.seed, notes);
  }
  DimensionColumns columns;
  if (!request.units.empty()) columns.units = parse_length_unit(request.units);
  const DimensionTable table = read_dimension_table(request.table, columns);
  for (const std::string& note : table.notes) {
    notes.push_back(request.table.string() + ": " + note);
  }
  std::vector<BlockForm> population;
  for (const MeasuredBlock& block : table.blocks) {
    if (!kBlockLengthRange.contains(block.axes.L) || !kBlockLengthRange.contains(block.axes.S)) {
      throw InputError(request.table.string() + ": block " + block.name + " is " +
                       format_significant(block.axes.L, 4) + " x " +
                       format_significant(block.axes.S, 4) + " m; L and S must be " +
                       kBlockLengthRange.describe() + "; give `units`");
    }
    population.push_back({block.axes, std::nullopt});
  }
  return population;
}

/// Two requests for one name would be one body.
void refuse_repeated(const std::vector<VariationRequest>& bodies) {
  std::set<std::string> ids;
  for (const VariationRequest& body : bodies) {
    if (!ids.insert(body.id).second) {
      throw InputError("\"" + body.id + "\" is requested twice; request each body once");
    }
  }
}

std::vector<VariationRequest> bodies_wanted(const VariationSeriesRequest& request,
                                            const BlockLibrary& library,
                                            VariationSeriesResult& made) {
  const std::vector<const Block*> parents = library.select_blocks(request.ids);
  std::vector<Variation> variations = request.targets.variations();
  for (const std::string& id : request.target_ratio_ids) {
    variations.emplace_back(StretchVariation{box_ratios(library.find_block(id).box)});
  }
  std::vector<VariationRequest> bodies = combine_variations(parents, variations);
  if (bodies.size() + request.sampled_count > kMaxSeriesBodies) {
    throw InputError(std::to_string(bodies.size() + request.sampled_count) +
                     " bodies are requested; the limit is " + std::to_string(kMaxSeriesBodies));
  }
  if (request.sampled_count > 0) {
    SampledVariationRequests drawn =
        sample_variation_requests(parents, population_of(request, parents, made.notes),
                                  request.sampled_count, request.seed, request.prefix);
    made.fit = std::move(drawn.fit);
    for (VariationRequest& body : drawn.requests) bodies.push_back(std::move(body));
  }
  refuse_repeated(bodies);
  return bodies;
}

BlockSource source_of(const VariationSeriesRequest& request) {
  BlockSource source{to_utf8(request.library.string()), sha256_of_file(request.library), "", ""};
  if (request.sampled_count > 0) source.options = "seed=" + std::to_string(request.seed);
  if (!request.table.empty()) {
    source.options += " population_sha256=" + sha256_of_file(request.table);
  }
  return source;
}

}  // namespace

bool VariationSeriesRequest::is_empty() const {
  return targets.variations().empty() && target_ratio_ids.empty() && sampled_count == 0;
}

void VariationSeriesRequest::check() const {
  check_block_id(prefix + "0001");
  if (!units.empty()) parse_length_unit(units);
  if (is_empty()) {
    throw InputError(
        "no variation is requested; give `to`, `grid`, `like`, `convexity`, `rounding`, "
        "`roundness`, "
        "`vertices`, "
        "`detail`, `reference`, `inertia` or `draw`");
  }
}

VariationSeriesResult make_variation_series(const VariationSeriesRequest& request,
                                            const BlockLibrary& library) {
  request.check();
  VariationSeriesResult made;
  const std::vector<VariationRequest> bodies = bodies_wanted(request, library, made);
  made.requested_count = bodies.size();
  made.series = make_variation_series(bodies, source_of(request), request.options);
  if (made.series.blocks.empty()) {
    throw GeometryError("no body could be made; first reason: " + made.series.failures.front());
  }
  return made;
}

VariationSeriesResult make_variation_series(const VariationSeriesRequest& request) {
  request.check();
  if (!request.output.empty()) check_library_writable(request.output);
  VariationSeriesResult made = make_variation_series(request, BlockLibrary::read(request.library));
  if (request.output.empty()) return made;
  const BlockLibrary written =
      update_library(request.output, {.create_if_missing = true}, [&](BlockLibrary& changed) {
        for (const Block& block : made.series.blocks) changed.add(block, request.replace);
      });
  made.output_blocks = written.blocks().size();
  return made;
}

}  // namespace clast
