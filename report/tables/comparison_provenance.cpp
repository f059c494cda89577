#include "report/tables/comparison_provenance.hpp"

#include <nlohmann/json.hpp>

#include "core/version.hpp"
#include "report/text/key_results_text.hpp"
#include "study/results/block_stiffness.hpp"

namespace clast {
namespace {

// Lowest and highest of every quantity over the runs of a block; null where results have none.
nlohmann::ordered_json stiffness_json(const CampaignResults& results) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BlockStiffnessRanges& block : collect_stiffness_by_block(results, results.runs)) {
    nlohmann::ordered_json row = {{"block", block.block}};
    for (const StiffnessRange& value : block.values) {
      row[value.name] = nullptr;
      if (!value.range.empty()) row[value.name] = {value.range.low, value.range.high};
    }
    list.push_back(row);
  }
  return list;
}

}  // namespace

std::string make_provenance_json(const ComparisonAnalyses& analyses) {
  const Comparison& comparison = analyses.comparison();
  nlohmann::ordered_json json;
  json["program_version"] = version();
  json["downslope"] = {comparison.downslope.x(), comparison.downslope.y()};
  json["downslope_from"] = comparison.downslope_given ? "campaign" : "mean release-to-stop line";
  json["answer"] = describe_key_results(comparison, analyses.key_results());
  json["warnings"] = comparison.warnings;
  json["files"] = nlohmann::ordered_json::array();
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    json["files"].push_back({{"file", file + 1},
                             {"results", results.file.filename().string()},
                             {"program_version", results.program_version},
                             {"engine", results.has_contacts() ? "clast" : results.engine},
                             {"campaign_sha256", results.campaign_sha256},
                             {"inputs", results.inputs},
                             {"runs", results.runs.size()},
                             {"planned_runs", results.planned_runs},
                             {"stiffness", stiffness_json(results)},
                             {"campaign", results.campaign_text}});
  }
  if (comparison.measured) {
    json["measured"] = {{"file", comparison.measured->file.filename().string()},
                        {"sha256", comparison.measured->sha256},
                        {"stops", comparison.measured->stops.size()}};
  }
  // Names and paths may hold bytes that are not UTF-8; they must not stop the tables.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace clast
