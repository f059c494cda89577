/// Program `score_deposit FOLDER LABELLED.ply`: scores a segmentation of a virtual deposit.
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "samples/deposit/body_score.hpp"
#include "samples/deposit/segmentation_score.hpp"

namespace {

using namespace clast;
using Json = nlohmann::ordered_json;

constexpr double kTolerance = 1e-4;  // m, of the coordinates of a point

/// A number; null where it is not finite, which JSON cannot hold.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const RangeScore& score) {
  return {{"count", score.count},
          {"coverage", score.coverage},
          {"median_width", finite(score.median_width)},
          {"mean_score", finite(score.mean_score)}};
}

Json to_json(const EstimateScore& score) {
  Json json = {{"count", score.count},
               {"median_absolute_error", score.median_absolute_error},
               {"bias", score.bias}};
  if (score.bounds.count > 0) json["bounds"] = to_json(score.bounds);
  if (score.intervals.count > 0) json["intervals"] = to_json(score.intervals);
  if (score.constant_factor) {
    json["constant_factor"] = to_json(score.constant_factor->score);
    json["constant_factor"]["factors"] = {score.constant_factor->low_factor,
                                          score.constant_factor->high_factor};
  }
  return json;
}

Json to_json(const BodyScore& score) {
  Json json = {{"visible_fraction", {score.least_visible, score.most_visible}}};
  for (std::size_t q = 0; q < kBodyQuantities.size(); ++q) {
    json[kBodyQuantities[q]] = to_json(score.quantities[q]);
  }
  return json;
}

Json to_json(const SegmentationScore& score) {
  Json json = {{"precision", score.precision()},
               {"recall", score.recall()},
               {"close_fraction", score.close_fraction()},
               {"eligible", score.eligible},
               {"matched", score.matched},
               {"close", score.close},
               {"proposals", score.proposals},
               {"false_proposals", score.false_proposals},
               {"ignored_proposals", score.ignored_proposals},
               {"on_ground", score.on_ground},
               {"over_segmented", score.over_segmented},
               {"under_segmented", score.under_segmented}};
  for (const BlockScore& block : score.blocks) {
    json["blocks"].push_back({{"block", block.block},
                              {"eligible", block.eligible},
                              {"visible_fraction", block.visible_fraction},
                              {"proposal", block.proposal},
                              {"iou", block.iou},
                              {"parts", block.parts}});
  }
  return json;
}

Json score(const std::filesystem::path& folder, const std::string& labelled,
           const std::string& bodies) {
  const LabelledCloud truth = read_labelled_cloud(folder / "truth.ply");
  const std::vector<TrueBlock> blocks = read_true_blocks(folder);
  const std::vector<std::uint32_t> labels =
      align_labels(truth, read_labelled_cloud(labelled), kTolerance);
  const SegmentationScore segmentation = score_segmentation(truth.blocks, labels, blocks);
  Json json = to_json(segmentation);
  if (bodies.empty()) return json;
  const std::vector<BodyScore> scores =
      score_bodies(segmentation, blocks, read_stated_bodies(bodies));
  json["bodies"] = to_json(scores.front());
  for (std::size_t i = 1; i < scores.size(); ++i) {
    json["bodies_by_visible_fraction"].push_back(to_json(scores[i]));
  }
  return json;
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder, labelled, bodies;
  CLI::App app{"Scores a segmentation of a virtual deposit and prints the score as JSON"};
  app.add_option("folder", folder, "Folder that make_deposit wrote")->required();
  app.add_option("labelled", labelled, "PLY file: points of scan.ply with the property block")
      ->required();
  app.add_option("--bodies", bodies,
                 "CSV table of the sizes of the proposed blocks: block, L_m, I_m, S_m, volume_m3; "
                 "bounds L_m_low, L_m_high, ...; intervals L_m_low90, L_m_high90, ...");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    std::cout << score(folder, labelled, bodies).dump(2) << "\n";
  } catch (const std::exception& error) {
    std::cerr << "score_deposit: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
