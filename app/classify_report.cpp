#include "app/classify_report.hpp"

#include <algorithm>

#include "app/text_table.hpp"
#include "classify/certainty.hpp"
#include "classify/sizes.hpp"

namespace clast {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double share) { return with_decimals(100.0 * share, 1); }

std::string block_table(const Classification& all) {
  TextTable table{{"block", "L m", "I m", "S m", "s_c"}, {}};
  table.headings.insert(table.headings.end(), all.schemes.begin(), all.schemes.end());
  const std::string& first = all.schemes.front();
  table.headings.push_back("how sure (" + first + ")");
  for (const ClassifiedBlock& block : all.blocks) {
    table.rows.push_back({block.name, rounded(block.axes.L), rounded(block.axes.I),
                          rounded(block.axes.S), rounded(elongation_s_c(block.axes), 3)});
    for (const std::string& scheme : all.schemes) {
      table.rows.back().push_back(shape_class(scheme, block.axes, all.options));
    }
    const ClassCertainty certainty =
        class_certainty(first, block.axes, block.axis_error, all.options);
    table.rows.back().push_back(certainty.near_limit ? described(certainty) : "clear of limits");
  }
  return table.text();
}

std::string share_table(const Classification& all, const std::string& scheme) {
  const std::vector<double> masses = all.masses();
  TextTable table{{scheme, "blocks", "share %", "95 % from", "to"}, {}};
  if (!masses.empty()) table.headings.push_back("mass %");
  for (const ClassShare& share : class_shares(all.axes(), scheme, all.options, masses)) {
    // Of 25 classes most are empty.
    if (share.count == 0 && class_names(scheme).size() > 10) continue;
    table.rows.push_back({share.name, std::to_string(share.count), percent(share.share),
                          percent(share.low), percent(share.high)});
    if (share.mass_share) table.rows.back().push_back(percent(*share.mass_share));
  }
  return table.text();
}

std::string size_lines(const Classification& all) {
  const std::vector<Axes> axes = all.axes();
  const SizeDistribution sizes = size_distribution(axes, all.masses());
  const auto three = [](double a, double b, double c) {
    return rounded(a, 3) + ", " + rounded(b, 3) + ", " + rounded(c, 3) + " m\n";
  };
  std::string text =
      "size (L I S)^(1/3), d10, d50, d90 by number: " + three(sizes.d10, sizes.d50, sizes.d90);
  if (sizes.mass_d50) {
    text += "the same by mass: " + three(*sizes.mass_d10, *sizes.mass_d50, *sizes.mass_d90);
  }
  if (sizes.log_normal && sizes.rosin_rammler) {
    const SizeFit& normal = *sizes.log_normal;
    const SizeFit& rosin = *sizes.rosin_rammler;
    text += "log-normal: median " + rounded(normal.scale, 3) + " m, spread of ln d " +
            rounded(normal.spread, 3) + ", off by at most " + percent(normal.distance) + " %\n";
    text += "Rosin-Rammler: d' " + rounded(rosin.scale, 3) + " m, n " + rounded(rosin.spread, 3) +
            ", off by at most " + percent(rosin.distance) + " %\n";
  }
  if (const auto both = size_and_shape(axes)) {
    text += "rank correlation of size with s_c " + with_decimals(both->s_c, 2) + ", S/L " +
            with_decimals(both->s_l, 2) + ", (L-I)/(L-S) " +
            with_decimals(both->disc_rod_index, 2) + "\n";
  }
  return text + "C40 (S/L at most 0.4): " + percent(c40(axes)) + " %\n";
}

Json certainty_json(const ClassCertainty& certainty) {
  return {{"class", certainty.name},        {"ratio", certainty.ratio},
          {"value", certainty.value},       {"nearest_limit", certainty.limit},
          {"distance", certainty.distance}, {"near_limit", certainty.near_limit},
          {"survives", certainty.survives}, {"others", certainty.others}};
}

Json block_json_of(const ClassifiedBlock& block, const SchemeOptions& options) {
  Json json = {{"id", block.name},
               {"box_m", {block.axes.L, block.axes.I, block.axes.S}},
               {"axis_error_m", block.axis_error},
               {"s_c", elongation_s_c(block.axes)},
               {"sneed_folk", sneed_folk_class(block.axes, options)},
               {"zingg", zingg_class(block.axes)},
               {"shape", garcia_class(block.axes)}};
  if (block.mass) json["mass_kg"] = *block.mass;
  for (const std::string& scheme : scheme_names()) {
    json["classes"][scheme] =
        certainty_json(class_certainty(scheme, block.axes, block.axis_error, options));
  }
  json["indices"] = form_indices(block.axes);
  for (const auto& [key, value] : block.more.items()) {
    key == "indices" ? json[key].update(value) : void(json[key] = value);
  }
  return json;
}

Json size_json(const Classification& all) {
  const std::vector<Axes> axes = all.axes();
  const SizeDistribution sizes = size_distribution(axes, all.masses());
  Json json = {{"d10_m", sizes.d10}, {"d50_m", sizes.d50}, {"d90_m", sizes.d90}};
  if (sizes.mass_d50) {
    json["by_mass"] = {
        {"d10_m", *sizes.mass_d10}, {"d50_m", *sizes.mass_d50}, {"d90_m", *sizes.mass_d90}};
  }
  const auto fit = [&](const char* name, const std::optional<SizeFit>& fitted, const char* scale,
                       const char* spread) {
    if (!fitted) return;
    json[name] = {
        {scale, fitted->scale}, {spread, fitted->spread}, {"ks_distance", fitted->distance}};
  };
  fit("log_normal", sizes.log_normal, "median_m", "sigma_ln");
  fit("rosin_rammler", sizes.rosin_rammler, "d63_m", "n");
  if (const auto both = size_and_shape(axes)) {
    json["rank_correlation"] = {
        {"s_c", both->s_c}, {"S/L", both->s_l}, {"disc_rod_index", both->disc_rod_index}};
  }
  return json;
}

Json test_json(const TestResult& result) {
  Json json = {{"statistic", result.statistic}, {"p_value", result.p_value}};
  if (result.degrees > 0) {
    json["degrees_of_freedom"] = result.degrees;
    json["small_counts"] = result.small_counts;
  }
  return json;
}

}  // namespace

std::vector<Axes> Classification::axes() const {
  std::vector<Axes> all;
  for (const ClassifiedBlock& block : blocks) all.push_back(block.axes);
  return all;
}

std::vector<double> Classification::masses() const {
  std::vector<double> all;
  for (const ClassifiedBlock& block : blocks) {
    if (!block.mass) return {};
    all.push_back(*block.mass);
  }
  return all;
}

std::string classification_text(const Classification& all) {
  std::string text =
      "L, I, S: " +
      (all.box == "as measured" ? all.box
                                : "sides of the " + all.box + " box of the rounded body") +
      "\n\n" + block_table(all);
  for (const std::string& scheme : all.schemes) text += "\n" + share_table(all, scheme);
  if (!all.blocks.empty()) text += "\n" + size_lines(all);
  if (all.skipped > 0) text += counted(all.skipped, "row") + " skipped\n";
  return text;
}

Json classification_json(const Classification& all) {
  Json json = {{"box", all.box}, {"blocks", Json::array()}, {"population", Json::object()}};
  for (const ClassifiedBlock& block : all.blocks) {
    json["blocks"].push_back(block_json_of(block, all.options));
  }
  const std::vector<Axes> axes = all.axes();
  const std::vector<double> masses = all.masses();
  for (const std::string& scheme : all.schemes) {
    Json& rows = json["population"][scheme] = Json::array();
    for (const ClassShare& share : class_shares(axes, scheme, all.options, masses)) {
      rows.push_back({{"class", share.name},
                      {"blocks", share.count},
                      {"share", share.share},
                      {"low", share.low},
                      {"high", share.high}});
      if (share.mass_share) rows.back()["mass_share"] = *share.mass_share;
    }
  }
  if (!axes.empty()) {
    json["sizes"] = size_json(all);
    json["c40"] = c40(axes);
  }
  for (const FormIndex& index : form_index_list()) {
    json["formulas"][index.name] = {{"formula", index.formula}, {"source", index.source}};
  }
  json["skipped"] = all.skipped;
  json["notes"] = all.notes;
  return json;
}

std::vector<std::string> comparison_lines(const Classification& a, const Classification& b) {
  const std::string& scheme = a.schemes.front();
  const PopulationComparison found = compared(a.axes(), b.axes(), scheme, a.options);
  return {in_words("values of s_c", found.s_c), in_words("values of S/L", found.s_l),
          in_words("values of (L-I)/(L-S)", found.disc_rod_index),
          in_words(scheme + " classes", found.classes)};
}

Json comparison_json(const Classification& a, const Classification& b) {
  const PopulationComparison found = compared(a.axes(), b.axes(), a.schemes.front(), a.options);
  return {{"s_c", test_json(found.s_c)},
          {"S/L", test_json(found.s_l)},
          {"disc_rod_index", test_json(found.disc_rod_index)},
          {"scheme", a.schemes.front()},
          {"classes", test_json(found.classes)},
          {"in_words", comparison_lines(a, b)}};
}

}  // namespace clast
