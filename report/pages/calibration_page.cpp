#include "report/pages/calibration_page.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/version.hpp"
#include "report/charts/palette.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/html/assets.hpp"
#include "report/html/contents_list.hpp"
#include "report/html/html_page.hpp"
#include "report/html/page_script.hpp"
#include "report/html/report_page.hpp"
#include "report/text/calibration_text.hpp"

namespace clast {

using namespace report_detail;
namespace {

using Eigen::Index;
using Json = nlohmann::ordered_json;

std::string label_of(const UnknownParameter& unknown) {
  const std::string unit = calibratable_range(unknown.parameter).unit;
  return describe_unknown(unknown.parameter) + (unit.empty() ? "" : ", " + unit);
}

std::string calibration_head(const Calibration& calibration) {
  const CalibrationDesign& design = calibration.study.design;
  std::string html =
      "<header id=\"answer\">\n<h1>Ground parameters estimated from observations</h1>\n";
  html += "<p class=\"lead\">" +
          escape_html(calibration.study.file.filename().string() + ": " +
                      format_count(design.member_count, "member") + " of " +
                      format_count(design.releases_per_member, "release") + " at " +
                      format_count(calibration.study.sites.size(), "site")) +
          "</p>\n<p class=\"answer\">" + escape_html(describe_calibration_result(calibration)) +
          "</p>\n";
  for (const std::string& finding : describe_calibration_findings(calibration))
    html += format_paragraph(finding);
  return html + "</header>\n";
}

/// Draws of an unknown in equal bins of its range, against the level line of the prior.
std::string marginal_chart(const Calibration& calibration, std::size_t unknown) {
  constexpr std::size_t kBins = 24;
  std::vector<double> shares(kBins, 0.0);
  const auto row = calibration.posterior.probabilities.row(static_cast<Index>(unknown));
  for (const double share : row) {
    shares[std::min(kBins - 1, static_cast<std::size_t>(share * kBins))] +=
        1.0 / static_cast<double>(row.size());
  }
  const UnknownParameter& own = calibration.study.unknowns[unknown];
  ChartTrace posterior{"after", kDataColours[0], "", ChartTrace::Kind::kSteps, {}, {}};
  ChartTrace prior{"before", kDataColours[3], "6 3", ChartTrace::Kind::kLine, {}, {}};
  for (std::size_t bin = 0; bin <= kBins; ++bin) {
    const double value = own.prior_quantile(static_cast<double>(bin) / kBins);
    const double at = own.logarithmic ? std::log10(value) : value;
    posterior.x.push_back(at);
    posterior.y.push_back(shares[std::min(bin, kBins - 1)]);
    if (bin > 0 && bin < kBins) continue;
    prior.x.push_back(at);
    prior.y.push_back(1.0 / kBins);
  }
  const std::string axis = (own.logarithmic ? "log10 of " : "") + label_of(own);
  return draw_plotly_chart({describe_unknown(own.parameter), axis, "fraction of the draws", true},
                           {posterior, prior});
}

std::string unknowns_section(const Calibration& calibration) {
  HtmlTable table({"parameter", "range from", "to", "median", "95 % from", "95 % to", "width left",
                   "nearest members from", "to"},
                  1);
  std::string charts;
  const CalibrationPosterior& posterior = calibration.posterior;
  for (std::size_t i = 0; i < calibration.study.unknowns.size(); ++i) {
    const UnknownParameter& unknown = calibration.study.unknowns[i];
    const MarginalPosterior& marginal = posterior.marginals[i];
    std::vector<std::string> row = {label_of(unknown),
                                    format_significant_digits(unknown.low),
                                    format_significant_digits(unknown.high),
                                    format_significant_digits(marginal.median),
                                    format_significant_digits(marginal.low),
                                    format_significant_digits(marginal.high),
                                    format_percent(std::min(1.0, marginal.width), 0)};
    if (i < posterior.nearest.unknowns.size()) {
      row.push_back(format_significant_digits(posterior.nearest.unknowns[i].low));
      row.push_back(format_significant_digits(posterior.nearest.unknowns[i].high));
    } else {
      row.insert(row.end(), 2, "-");
    }
    table.row(row);
    charts += marginal_chart(calibration, i);
  }
  return format_section(
      "Parameters",
      table.html() +
          format_paragraph(
              "The prior is uniform within each range. Width left is the width of the 95 % "
              "interval divided by the width of the range; above 80 %, the observations do not "
              "determine the parameter. The nearest members are the simulated parameter sets whose "
              "statistics are closest to the observed ones.") +
          "<div class=\"charts\">\n" + charts + "</div>\n");
}

/// Some of the draws over two unknowns.
std::string pair_chart(const Calibration& calibration, Index a, Index b) {
  constexpr Index kMaxPoints = 400;
  const Eigen::MatrixXd& draws = calibration.posterior.draws;
  const Index stride = std::max<Index>(1, draws.cols() / kMaxPoints);
  Json x = Json::array(), y = Json::array();
  for (Index i = 0; i < draws.cols(); i += stride) {
    x.push_back(draws(a, i));
    y.push_back(draws(b, i));
  }
  const UnknownParameter& first = calibration.study.unknowns[static_cast<std::size_t>(a)];
  const UnknownParameter& second = calibration.study.unknowns[static_cast<std::size_t>(b)];
  const auto axis = [](const UnknownParameter& unknown) {
    Json json = {{"title", {{"text", escape_html(label_of(unknown))}}},
                 {"gridcolor", "#e2e6ea"},
                 {"zeroline", false}};
    if (unknown.logarithmic) json["type"] = "log";
    return json;
  };
  const Json statistic = {
      {"data",
       {{{"type", "scatter"},
         {"mode", "markers"},
         {"x", x},
         {"y", y},
         {"hoverinfo", "skip"},
         {"marker", {{"size", 4}, {"opacity", 0.5}, {"color", kDataColours[0]}}}}}},
      {"layout",
       {{"height", 380},
        {"margin", {{"l", 62}, {"r", 14}, {"t", 10}, {"b", 46}}},
        {"showlegend", false},
        {"xaxis", axis(first)},
        {"yaxis", axis(second)}}}};
  const std::string title = describe_unknown(first.parameter) + " and " +
                            describe_unknown(second.parameter) + " (rank correlation " +
                            format_fixed(calibration.posterior.correlation(a, b), 2) + ")";
  return format_plotly_figure(title, "pairs", statistic.dump(), title);
}

/// The pairs of unknowns that go together most.
std::string ridges_section(const Calibration& calibration) {
  constexpr std::size_t kMostPairs = 6;
  const Eigen::MatrixXd& together = calibration.posterior.correlation;
  std::vector<std::pair<double, std::pair<Index, Index>>> pairs;
  for (Index a = 0; a < together.rows(); ++a) {
    for (Index b = a + 1; b < together.rows(); ++b) {
      pairs.push_back({-std::abs(together(a, b)), {a, b}});
    }
  }
  if (pairs.empty()) return "";
  std::sort(pairs.begin(), pairs.end());
  std::string charts;
  for (std::size_t i = 0; i < std::min(kMostPairs, pairs.size()); ++i) {
    charts += pair_chart(calibration, pairs[i].second.first, pairs[i].second.second);
  }
  return format_section(
      "Pairs of parameters",
      format_paragraph("Draws from the posterior for the most strongly correlated pairs of "
                       "parameters. A narrow band means that the observations determine a "
                       "combination of the two better than either one alone.") +
          "<div class=\"charts\">\n" + charts + "</div>\n");
}

std::string prediction_section(const Calibration& calibration) {
  HtmlTable table({"observation", "use", "figure", "observed", "predicted", "95 % from", "95 % to",
                   "prior from", "prior to"},
                  3);
  std::vector<IntervalRow> marks;
  for (const PredictedStatistic& one : calibration.posterior.predictions) {
    const Observation& observation = calibration.study.observations[one.observation];
    const SummaryStatistic& statistic = observation.statistics[one.statistic];
    table.row({observation.name, observation.fitted ? "fit" : "keep", statistic.name,
               format_significant_digits(statistic.observed, 4),
               format_significant_digits(one.median, 4), format_significant_digits(one.low, 4),
               format_significant_digits(one.high, 4), format_significant_digits(one.prior.low, 4),
               format_significant_digits(one.prior.high, 4)});
    const double half = std::max(0.5 * (one.high - one.low), 1e-300);
    constexpr double kFarthest = 5.0;  // of what would push the others together
    const auto scaled = [&](double value) {
      return std::clamp((value - statistic.observed) / half, -kFarthest, kFarthest);
    };
    const std::string name = observation.name + ": " + statistic.name;
    marks.push_back({name, scaled(one.median), scaled(one.low), scaled(one.high),
                     !one.covers(statistic.observed),
                     name + (observation.fitted ? " (fitted)" : " (kept)") + ": observed " +
                         format_significant_digits(statistic.observed, 4) + ", predicted " +
                         format_significant_digits(one.low, 4) + " to " +
                         format_significant_digits(one.high, 4)});
  }
  return format_section(
      "Observed against predicted",
      draw_interval_chart("Predicted minus observed",
                          "predicted minus observed, in half widths of the 95 % interval", marks) +
          table.html() +
          format_paragraph(
              "The intervals are predictions of an observation: they include the uncertainty of "
              "the parameters, the random variation for the number of releases in the field, and "
              "the error of the surrogate. The prior intervals are for parameters anywhere in "
              "their ranges; if the posterior interval is hardly narrower, the fitted observations "
              "constrain the statistic little. Kept statistics were not fitted."));
}

std::string sensitivity_table(const Calibration& calibration, double SobolIndices::*share) {
  std::vector<std::string> heads = {"figure"};
  for (const UnknownParameter& unknown : calibration.study.unknowns) {
    heads.push_back(describe_unknown(unknown.parameter));
  }
  HtmlTable table(heads, 1);
  std::size_t at = 0;
  for (const Observation& observation : calibration.study.observations) {
    for (const SummaryStatistic& statistic : observation.statistics) {
      const std::vector<SobolIndices>& shares = calibration.posterior.sensitivities[at++];
      if (shares.empty()) continue;
      std::vector<std::string> row = {observation.name + ": " + statistic.name};
      for (const SobolIndices& one : shares) row.push_back(format_percent(one.*share, 0));
      table.row(row);
    }
  }
  return table.html();
}

std::string surrogate_table(const Calibration& calibration) {
  HtmlTable table({"figure", "members", "error", "explained", "inflation", "roughness"}, 1);
  std::size_t at = 0;
  for (const Observation& observation : calibration.study.observations) {
    for (const SummaryStatistic& statistic : observation.statistics) {
      const std::optional<SurrogateQuality>& quality = calibration.posterior.surrogates[at++];
      const std::string name = observation.name + ": " + statistic.name;
      if (!quality) {
        table.row({name, "too few", "-", "-", "-", "-"});
        continue;
      }
      table.row({name, std::to_string(quality->members),
                 format_significant_digits(quality->leave_one_out_error),
                 format_percent(std::max(0.0, quality->explained_variance), 0),
                 format_fixed(quality->inflation, 2),
                 format_significant_digits(quality->roughness)});
    }
  }
  return table.html();
}

std::string influence_section(const Calibration& calibration) {
  return format_section(
      "Sensitivity of the statistics to the parameters",
      sensitivity_table(calibration, &SobolIndices::total) +
          format_paragraph("Fraction of the variance of each statistic, over the ranges of the "
                           "parameters, that is explained by a parameter alone or in interaction "
                           "with others (Sobol's total index).") +
          format_folded_section("Fraction explained by a parameter alone",
                                sensitivity_table(calibration, &SobolIndices::first_order)) +
          format_folded_section(
              "Accuracy of the surrogates for members not used to fit them",
              surrogate_table(calibration) +
                  format_paragraph(
                      "Error is the root mean square of the leave-one-out errors, in the unit of "
                      "the statistic; explained is the fraction of the variance that the surrogate "
                      "predicts. The variances of the surrogates are multiplied by the inflation, "
                      "and the roughness is added: variation that is neither smooth nor random.")));
}

std::string format_provenance_section(const Calibration& calibration) {
  std::string facts =
      format_fact("Report by", std::string("clast ") + version()) +
      format_fact("Posterior", calibration.file.string()) +
      format_fact("Study", calibration.study.file.string() + " " + calibration.study.sha256) +
      format_fact("Seed", std::to_string(calibration.study.design.seed)) +
      format_fact("Draws", std::to_string(calibration.posterior.draws.cols()) + " after " +
                               std::to_string(calibration.posterior.temperature_count) +
                               " temperatures, " +
                               format_percent(calibration.posterior.acceptance_rate, 0) +
                               " of the last Metropolis moves accepted");
  std::string inputs;
  for (const std::string& input : calibration.stored.inputs) inputs += format_paragraph(input);
  return format_section("For campaigns",
                        "<pre>" + escape_html(format_ground_tables(calibration)) + "</pre>\n") +
         format_section(
             "Provenance",
             "<dl class=\"facts\">\n" + facts + "</dl>\n" +
                 format_folded_section("Input files and their SHA-256", inputs) +
                 format_folded_section("Study file",
                                       "<pre>" + escape_html(calibration.study.text) + "</pre>\n"));
}

}  // namespace

std::string make_calibration_page(const Calibration& calibration) {
  const std::string sections = calibration_head(calibration) + unknowns_section(calibration) +
                               prediction_section(calibration) + ridges_section(calibration) +
                               influence_section(calibration) +
                               format_provenance_section(calibration);
  return make_report_page("Calibration: " + calibration.study.file.stem().string(),
                          format_script_element(assets::unpack_js) + make_contents_list(sections) +
                              sections + charts_script());
}

}  // namespace clast
