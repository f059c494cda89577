#include <algorithm>
#include <cmath>
#include <map>

#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/capital.hpp"
#include "study/campaign/ground_fields.hpp"
#include "study/compare/ensemble_effects.hpp"

namespace clast::report_detail {
namespace {

constexpr double kSignificanceLevel = 0.05;

bool is_share(const ParameterEffect& effect) { return effect.outcome != "mean runout"; }

std::string effect_number(const ParameterEffect& effect, double value) {
  return is_share(effect) ? format_fixed(100.0 * value, 1) : format_significant_digits(value);
}

std::string runs_of(const Comparison& comparison, const ParameterEffect& effect) {
  std::string text;
  if (has_several_files(comparison)) text = "file " + std::to_string(effect.file + 1) + ": ";
  if (!effect.group.empty()) text += "group " + effect.group + ": ";
  return text;
}

std::string describe_parameter(const std::string& parameter) {
  for (const GroundParameterField& field : ground_parameter_fields()) {
    if (parameter == field.name) return field.words;
  }
  return parameter;
}

/// A sentence for one outcome of the runs of one group: its band, and what moves it most.
std::string effect_sentence(const Comparison& comparison,
                            const std::vector<ParameterEffect>& effects) {
  const ParameterEffect& any = effects.front();
  const std::string unit = is_share(any) ? " %" : " m";
  std::string text = runs_of(comparison, any) + "over " + std::to_string(any.members) +
                     " draws of the ground parameters, the " +
                     (is_share(any) ? "fraction of runs " + any.outcome : any.outcome) + " is " +
                     effect_number(any, any.outcome_median) + unit + " (" +
                     effect_number(any, any.outcome_p5) + " to " +
                     effect_number(any, any.outcome_p95) + unit + " in nine draws in ten)";
  const auto size = [](const ParameterEffect& effect) {
    return effect.correlation ? std::abs(effect.correlation->statistic) : 0.0;
  };
  const auto maximum = std::max_element(
      effects.begin(), effects.end(),
      [&](const ParameterEffect& a, const ParameterEffect& b) { return size(a) < size(b); });
  // Bonferroni correction for several parameters.
  const double limit = kSignificanceLevel / static_cast<double>(effects.size());
  if (!maximum->correlation || maximum->correlation->p_value > limit) {
    text += "; no single parameter has a significant effect on it";
  } else {
    text += std::string("; it ") + (maximum->correlation->statistic > 0.0 ? "grows" : "falls") +
            " most strongly with the " + describe_parameter(maximum->parameter) + " of " +
            maximum->zone + " (rank correlation " +
            format_fixed(maximum->correlation->statistic, 2) + ")";
  }
  return capitalized(text) + ".";
}

}  // namespace

std::string format_ensemble_section(const ComparisonAnalyses& analyses) {
  const Comparison& comparison = analyses.comparison();
  const std::vector<ParameterEffect>& effects = analyses.ensemble_effects();
  if (effects.empty()) return "";
  HtmlTable table({"outcome", "zone", "parameter", "drawn from", "to", "rank correlation", "p",
                   "fraction of variance"},
                  3);
  std::string sentences;
  for (std::size_t i = 0; i < effects.size();) {
    std::vector<ParameterEffect> same;
    for (; i < effects.size(); ++i) {
      const ParameterEffect& effect = effects[i];
      if (!same.empty() && (effect.file != same[0].file || effect.group != same[0].group ||
                            effect.outcome != same[0].outcome)) {
        break;
      }
      same.push_back(effect);
      const std::optional<TestResult>& correlation = effect.correlation;
      table.row({runs_of(comparison, effect) + effect.outcome, effect.zone,
                 describe_parameter(effect.parameter), format_significant_digits(effect.low),
                 format_significant_digits(effect.high),
                 correlation ? format_fixed(correlation->statistic, 2) : "-",
                 correlation ? format_significant_digits(correlation->p_value, 2) : "-",
                 effect.first_order ? format_percent(*effect.first_order) : "-"});
    }
    sentences += format_paragraph(effect_sentence(comparison, same));
  }
  return format_section(
      "Uncertain ground",
      sentences +
          format_folded_section(
              "Every parameter",
              table.html() +
                  format_paragraph(
                      "Every run was simulated with each draw of the ground parameters. The "
                      "fraction of variance is given for 40 or more draws.")));
}

}  // namespace clast::report_detail
