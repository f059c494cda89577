#include "report/text/calibration_text.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/files/toml_text.hpp"
#include "core/number_text.hpp"
#include "core/text_table.hpp"
#include "report/text/capital.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast {

using namespace report_detail;
namespace {

constexpr double kRidge = 0.6;  ///< rank correlation from which two parameters are a ridge

std::string calibrated_value(double value) { return format_rounded(value, 3); }

std::string unit_of(const std::string& parameter) {
  const std::string unit = calibratable_range(parameter).unit;
  return unit.empty() ? "" : " " + unit;
}

std::string join_with_and(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return text;
}

std::string check_sentence(const PredictiveCheck& check, bool fitted) {
  const std::string covered =
      std::to_string(check.covered) + " of " +
      format_count(check.statistics, fitted ? "fitted statistic" : "kept statistic");
  std::string text = covered + (check.covered == 1 ? " lies" : " lie") +
                     " within the 95 % interval of the prediction";
  if (!check.p_value) {
    return text + "; there are as many parameters as statistics, so the fit cannot be tested";
  }
  const std::string p = *check.p_value < 0.001
                            ? std::string(" (p below 0.001)")
                            : " (p = " + format_significant(*check.p_value, 2) + ")";
  if (!check.failed()) return text + ", and together they agree with the model" + p;
  return text + ", but together they contradict the model" + p + ": " +
         (fitted ? "no parameters within the ranges explain the observations; the contact law, the "
                   "ranges or the release points are wrong"
                 : "the calibrated parameters do not predict them");
}

/// Unknowns whose posterior median no near member comes close to.
std::vector<std::string> contradicted(const Calibration& calibration) {
  std::vector<std::string> names;
  const CalibrationPosterior& posterior = calibration.posterior;
  for (std::size_t i = 0; i < posterior.nearest.unknowns.size(); ++i) {
    const MarginalPosterior& near = posterior.nearest.unknowns[i];
    const MarginalPosterior& found = posterior.marginals[i];
    if (found.high < near.low || found.low > near.high) {
      names.push_back(describe_unknown(calibration.study.unknowns[i].parameter));
    }
  }
  return names;
}

void add_ridges(const Calibration& calibration, std::vector<std::string>& findings) {
  const std::vector<UnknownParameter>& unknowns = calibration.study.unknowns;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    for (std::size_t k = i + 1; k < unknowns.size(); ++k) {
      const double together = calibration.posterior.correlation(static_cast<Eigen::Index>(i),
                                                                static_cast<Eigen::Index>(k));
      if (std::abs(together) < kRidge) continue;
      findings.push_back(
          describe_unknown(unknowns[i].parameter) + " and " +
          describe_unknown(unknowns[k].parameter) +
          (together < 0.0
               ? " compensate each other"
               : " are correlated: a higher value of one compensates a higher value of the other") +
          " (rank correlation " + format_decimals(together, 2) + ")");
    }
  }
}

void add_surrogate_warnings(const Calibration& calibration, std::vector<std::string>& findings) {
  constexpr double kPoor = 0.5;
  std::vector<std::string> poor, none;
  std::size_t at = 0;
  for (const Observation& observation : calibration.study.observations) {
    for (const SummaryStatistic& statistic : observation.statistics) {
      const std::optional<SurrogateQuality>& quality = calibration.posterior.surrogates[at++];
      const std::string name = statistic.name + " of " + observation.name;
      if (!quality) none.push_back(name);
      if (quality && quality->explained_variance < kPoor && observation.fitted)
        poor.push_back(name);
    }
  }
  if (!poor.empty()) {
    findings.push_back(
        "the unknowns explain little of the variation of " + join_with_and(poor) +
        ": these statistics constrain the unknowns little; simulate more members or releases");
  }
  if (!none.empty()) {
    findings.push_back("too few members have a value of " + join_with_and(none) +
                       ", so it cannot be predicted");
  }
}

}  // namespace

std::string describe_unknown(const std::string& parameter) {
  const std::size_t point = parameter.rfind('.');
  const std::string field = parameter.substr(point + 1);
  for (const GroundParameterField& one : ground_parameter_fields()) {
    if (field != one.name || !is_ground_parameter(parameter)) continue;
    const std::size_t begin = std::string("ground.").size();
    return std::string(one.words) + " of " + parameter.substr(begin, point - begin);
  }
  if (const std::string name = class_of_fraction_parameter(parameter); !name.empty()) {
    return "fraction of " + name + " blocks";
  }
  std::string words = field.substr(0, field.find("_n_m"));
  for (const char* unit : {"_m_s", "_rad_s", "_m", "_kg"}) {
    if (words.ends_with(unit)) {
      words.resize(words.size() - std::string(unit).size());
      break;
    }
  }
  std::replace(words.begin(), words.end(), '_', ' ');
  return words + (is_release_parameter(parameter) ? " of release"
                  : is_block_parameter(parameter) ? " of blocks"
                                                  : " of contacts");
}

std::string describe_calibration_result(const Calibration& calibration) {
  std::vector<std::string> determined, undetermined;
  const std::vector<UnknownParameter>& unknowns = calibration.study.unknowns;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const MarginalPosterior& marginal = calibration.posterior.marginals[i];
    const std::string name = describe_unknown(unknowns[i].parameter);
    if (marginal.is_undetermined()) {
      undetermined.push_back(name);
      continue;
    }
    determined.push_back(name + " " + calibrated_value(marginal.median) +
                         unit_of(unknowns[i].parameter) + " (" + calibrated_value(marginal.low) +
                         " to " + calibrated_value(marginal.high) + ")");
  }
  std::string text;
  if (determined.empty()) {
    text = "the observations determine none of the unknowns";
  } else {
    text =
        "values with 95 % intervals, within the ranges of the study: " + join_with_and(determined);
    if (calibration.posterior.fitted.failed()) {
      text =
          "the contact law does not explain the observations; the parameters that fit best are " +
          join_with_and(determined);
    }
  }
  if (!undetermined.empty() && !determined.empty()) {
    text += "; the observations do not determine " + join_with_and(undetermined);
  }
  return capitalized(text) + ".";
}

std::vector<std::string> describe_calibration_findings(const Calibration& calibration) {
  const CalibrationPosterior& posterior = calibration.posterior;
  std::vector<std::string> findings = {check_sentence(posterior.fitted, true)};
  if (posterior.held_out.statistics > 0)
    findings.push_back(check_sentence(posterior.held_out, false));
  for (std::size_t i = 0; i < posterior.marginals.size(); ++i) {
    if (!posterior.marginals[i].is_cut_off_by_range()) continue;
    const bool low =
        posterior.marginals[i].fraction_at_low > posterior.marginals[i].fraction_at_high;
    findings.push_back(
        "the posterior of " + describe_unknown(calibration.study.unknowns[i].parameter) +
        " is cut off at the " + (low ? "low" : "high") + " end of its range: widen the range");
  }
  add_ridges(calibration, findings);
  add_surrogate_warnings(calibration, findings);
  const std::vector<std::string> names = contradicted(calibration);
  if (!names.empty()) {
    findings.push_back("the members closest to the observations have different values of " +
                       join_with_and(names) +
                       ": the surrogates are unreliable until more members are simulated");
  }
  for (std::string& finding : findings) finding = capitalized(finding) + ".";
  return findings;
}

std::string format_study_summary(const CalibrationStudy& study) {
  TextTable unknowns{{"parameter", "from", "to"}, {}};
  for (const UnknownParameter& unknown : study.unknowns) {
    unknowns.rows.push_back(
        {unknown.parameter, calibrated_value(unknown.low), calibrated_value(unknown.high)});
  }
  TextTable statistics{{"observation", "use", "figure", "observed"}, {}};
  for (const Observation& observation : study.observations) {
    for (const SummaryStatistic& statistic : observation.statistics) {
      statistics.rows.push_back({observation.name, observation.fitted ? "fit" : "keep",
                                 statistic.name, calibrated_value(statistic.observed)});
    }
  }
  return std::to_string(study.run_count()) +
         " runs: " + format_count(study.design.member_count, "member") + " of " +
         format_count(study.design.releases_per_member, "release") + " at " +
         format_count(study.sites.size(), "site") + "\n\n" + unknowns.text() + "\n" +
         statistics.text() + "\n";
}

std::string format_unknowns_table(const Calibration& calibration) {
  TextTable table{{"parameter", "from", "to", "median", "95 % from", "95 % to", "width left"}, {}};
  for (std::size_t i = 0; i < calibration.study.unknowns.size(); ++i) {
    const UnknownParameter& unknown = calibration.study.unknowns[i];
    const MarginalPosterior& marginal = calibration.posterior.marginals[i];
    table.rows.push_back({unknown.parameter, calibrated_value(unknown.low),
                          calibrated_value(unknown.high), calibrated_value(marginal.median),
                          calibrated_value(marginal.low), calibrated_value(marginal.high),
                          format_percent(std::min(1.0, marginal.width), 0)});
  }
  return table.text();
}

std::string format_statistics_table(const Calibration& calibration) {
  TextTable table{{"observation", "use", "figure", "observed", "predicted", "95 % from", "95 % to",
                   "prior from", "prior to", "surrogate"},
                  {}};
  const std::vector<Observation>& observations = calibration.study.observations;
  for (std::size_t o = 0, at = 0; o < observations.size(); ++o) {
    for (std::size_t i = 0; i < observations[o].statistics.size(); ++i, ++at) {
      const SummaryStatistic& statistic = observations[o].statistics[i];
      std::vector<std::string> row = {observations[o].name, observations[o].fitted ? "fit" : "keep",
                                      statistic.name, calibrated_value(statistic.observed)};
      const std::vector<PredictedStatistic>& predicted = calibration.posterior.predictions;
      const auto found =
          std::find_if(predicted.begin(), predicted.end(), [&](const PredictedStatistic& one) {
            return one.observation == o && one.statistic == i;
          });
      if (found == predicted.end()) {
        row.insert(row.end(), 6, "-");
      } else {
        for (const double value :
             {found->median, found->low, found->high, found->prior.low, found->prior.high}) {
          row.push_back(calibrated_value(value));
        }
        row.push_back(format_percent(
            std::max(0.0, calibration.posterior.surrogates[at]->explained_variance), 0));
      }
      table.rows.push_back(row);
    }
  }
  return table.text();
}

std::string format_ground_tables(const Calibration& calibration) {
  const CalibrationStudy& study = calibration.study;
  std::string text = "# Medians of the posterior of clast calibrate from " +
                     study.file.filename().string() + ".\n";
  std::set<std::string> written;
  for (CalibrationSite site : study.sites) {
    for (std::size_t i = 0; i < study.unknowns.size(); ++i) {
      if (has_parameter(site.campaign, study.unknowns[i].parameter)) {
        set_parameter(site.campaign, study.unknowns[i].parameter,
                      calibration.posterior.marginals[i].median);
      }
    }
    for (const auto& [zone, ground] : site.campaign.ground) {
      if (!written.insert(zone).second) continue;
      text += "[ground." + format_toml_key(zone) + "]\n";
      for (const GroundParameterField& field : ground_parameter_fields()) {
        const std::optional<Distribution>& asked = ground.*field.distribution;
        if (asked)
          text += std::string(field.name) + " = " + format_significant(asked->first, 4) + "\n";
      }
    }
  }
  for (std::size_t i = 0; i < study.unknowns.size(); ++i) {
    const std::string& parameter = study.unknowns[i].parameter;
    if (is_ground_parameter(parameter)) continue;
    text += "# " + parameter + " = " +
            format_significant(calibration.posterior.marginals[i].median, 4) + "\n";
  }
  const bool all_ground = std::all_of(
      study.unknowns.begin(), study.unknowns.end(),
      [](const UnknownParameter& unknown) { return is_ground_parameter(unknown.parameter); });
  if (all_ground) {
    text +=
        "# To include the uncertainty, each member uses one draw of the "
        "posterior.\n[ensemble]\nmembers = " +
        std::to_string(std::min<Eigen::Index>(50, calibration.posterior.draws.cols())) +
        "\nposterior = \"" + calibration.file.filename().string() + "\"\n";
  }
  return text;
}

}  // namespace clast
