// `vary` of [blocks] of a campaign file.
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.hpp"
#include "core/length_unit.hpp"
#include "core/listed.hpp"
#include "library/variation_ranges.hpp"
#include "study/campaign/campaign_keys.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"

namespace clast::study_detail {
namespace {

const char* const kTitle = "[blocks] vary";

/// A number or a list of them, each in the range; empty where the key is absent.
std::vector<double> read_targets(const TomlTable& table, const std::string& key,
                                 const NumberRange& range) {
  const TomlNode* node = table.find(key);
  if (!node) return {};
  if (node->kind != TomlNode::Kind::kList) return {*table.number(key, range)};
  return table.numbers(key, *node, 1, kMostSeriesBodies, "a number or a list of numbers", range);
}

std::vector<std::size_t> read_vertices(const TomlTable& table) {
  const NumberRange range{static_cast<double>(kFewestVaried), static_cast<double>(kMostVaried)};
  std::vector<std::size_t> counts;
  for (const double value : read_targets(table, "vertices", range)) {
    if (value != std::floor(value)) {
      table.refuse("vertices", *table.find("vertices"), "must be whole numbers");
    }
    counts.push_back(static_cast<std::size_t>(value));
  }
  return counts;
}

/// Runs what a library checks; what it refuses is refused with the key's file and line.
void check_value(const TomlTable& table, const std::string& key,
                 const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    table.refuse(key, *table.find(key), in_words_of_campaign(error.what()));
  }
}

std::vector<BoxRatios> read_ratios(const TomlTable& table) {
  const TomlNode* node = table.find("to");
  if (!node) return {};
  const std::string expected = "a list of [I/L, S/L], such as [[0.8, 0.5], [0.6, 0.4]]";
  if (node->kind != TomlNode::Kind::kList || node->list.empty()) {
    table.refuse("to", *node, "must be " + expected);
  }
  std::vector<BoxRatios> all;
  for (const TomlNode& pair : node->list) {
    const std::vector<double> ratios = table.numbers("to", pair, 2, 2, expected, kVariedRatio);
    if (ratios[1] > ratios[0]) table.refuse("to", pair, "S/L must be at most I/L");
    all.push_back({ratios[0], ratios[1]});
  }
  return all;
}

std::optional<FormGrid> read_grid(const TomlTable& table) {
  const TomlNode* node = table.find("grid");
  if (!node) return std::nullopt;
  const TomlTable grid(*node, table.file(), std::string(kTitle) + " grid",
                       {"diagram", "steps", "least"});
  grid.required("diagram", "\"sneed-folk\" or \"zingg\"");
  grid.required("steps", "how many along each side, a whole number");
  FormGrid forms;
  forms.diagram = *choice(grid, "diagram", form_grid_names());
  forms.steps = static_cast<int>(*grid.count("steps", 1, kMostGridSteps));
  forms.least = grid.number("least", kLeastRatio).value_or(forms.least);
  return forms;
}

std::vector<std::string> read_forms(const TomlTable& table, const std::string& key,
                                    const std::vector<std::string>& known) {
  const std::vector<std::string> names = table.texts(key).value_or(std::vector<std::string>{});
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::find(known.begin(), known.end(), names[i]) == known.end()) {
      table.refuse(key, element(*table.find(key), i), "must be of " + listed(known));
    }
  }
  return names;
}

/// A number that only says more of what another key asks for.
void refuse_alone(const TomlTable& table, const std::string& key, bool needed,
                  const std::string& what) {
  if (const TomlNode* node = table.find(key); node && !needed) {
    table.refuse(key, *node, "is of " + what + ", which is not asked for; leave it out");
  }
}

SeriesSteps read_steps(const TomlTable& table) {
  SeriesSteps steps;
  steps.to = read_ratios(table);
  steps.grid = read_grid(table);
  steps.convexity = read_targets(table, "convexity", kVariedConvexity);
  steps.rounding = read_targets(table, "rounding", kVariedRadiusShare);
  steps.roundness = read_targets(table, "roundness", kVariedRoundness);
  steps.vertices = read_vertices(table);
  steps.detail = read_targets(table, "detail", kDetailGain);
  steps.reference = read_forms(table, "reference", reference_form_names());
  steps.inertia = read_forms(table, "inertia", inertia_form_names());
  refuse_alone(table, "roundness_edge", !steps.roundness.empty(), "roundness");
  refuse_alone(table, "degree", !steps.detail.empty(), "detail");
  refuse_alone(table, "exponent",
               std::find(steps.reference.begin(), steps.reference.end(), "superellipsoid") !=
                   steps.reference.end(),
               "the reference body superellipsoid");
  steps.roundness_edge =
      table.number("roundness_edge", kRoundnessEdge).value_or(steps.roundness_edge);
  if (const auto degree = table.count("degree", kLowestDegree, kHighestDegree)) {
    steps.degree = static_cast<int>(*degree);
  }
  steps.exponent = table.number("exponent", kSuperellipsoidExponent).value_or(steps.exponent);
  return steps;
}

void read_population(const TomlTable& vary, SeriesRequest& request) {
  const TomlNode* node = vary.find("population");
  if (!node) return;
  const TomlTable table(*node, vary.file(), std::string(kTitle) + " population",
                        {"count", "seed", "table", "units", "prefix"});
  table.required("count", "how many bodies, a whole number");
  request.draw = *table.count("count", 1, kMostSeriesBodies);
  request.seed = table.count("seed", 0, INT64_MAX).value_or(request.seed);
  if (const TomlNode* measured = table.find("table")) {
    table.text("table");
    request.table = input_file(table, "table", *measured);
  }
  if (const TomlNode* units = table.find("units"); units && request.table.empty()) {
    table.refuse("units", *units, "are those of table, which is missing; leave units out");
  }
  request.units = table.text("units").value_or("");
  request.prefix = table.text("prefix").value_or(request.prefix);
  if (!request.units.empty()) check_value(table, "units", [&] { length_unit(request.units); });
  if (table.find("prefix")) {
    check_value(table, "prefix", [&] { check_block_id(request.prefix + "0001"); });
  }
}

}  // namespace

std::optional<SeriesRequest> read_vary(const TomlTable& blocks) {
  const TomlNode* node = blocks.find("vary");
  if (!node) return std::nullopt;
  if (blocks.find("draw")) {
    blocks.refuse("vary", *node,
                  "blocks are either varied or drawn; leave draw out (population = { count = N } "
                  "of vary draws sizes and forms), or leave vary out");
  }
  const TomlTable table(*node, blocks.file(), kTitle, campaign_keys("blocks.vary"));
  SeriesRequest request;
  request.steps = read_steps(table);
  request.like = table.texts("like").value_or(std::vector<std::string>{});
  read_population(table, request);
  if (const auto keep = campaign_choice(table, "blocks.vary", "keep")) {
    request.options.variation.keep = kept_size(*keep);
  }
  if (request.asks_for_nothing()) {
    table.refuse(
        "nothing is asked for; give to, grid, like, convexity, rounding, roundness, vertices, "
        "detail, "
        "reference, inertia or population");
  }
  return request;
}

std::string in_words_of_campaign(std::string message) {
  std::erase(message, '`');
  return message;
}

}  // namespace clast::study_detail
