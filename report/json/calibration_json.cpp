#include "report/json/calibration_json.hpp"

#include "report/text/calibration_text.hpp"

namespace clast {
namespace {

using Json = nlohmann::ordered_json;

Json unknown_json(const UnknownParameter& unknown) {
  return {{"parameter", unknown.parameter},
          {"unit", calibratable_range(unknown.parameter).unit},
          {"range", {unknown.low, unknown.high}}};
}

Json figure_json(const CalibrationStudy& study, const Observation& observation,
                 const SummaryStatistic& statistic) {
  return {{"observation", observation.name},
          {"site", study.sites[observation.site].name},
          {"use", observation.fitted ? "fit" : "keep"},
          {"figure", statistic.name},
          {"observed", statistic.observed}};
}

Json unknowns_json(const Calibration& calibration) {
  Json list = Json::array();
  for (std::size_t i = 0; i < calibration.study.unknowns.size(); ++i) {
    const MarginalPosterior& marginal = calibration.posterior.marginals[i];
    list.push_back(unknown_json(calibration.study.unknowns[i]));
    list.back().update({{"median", marginal.median},
                        {"interval_95", {marginal.low, marginal.high}},
                        {"width_of_prior", marginal.width},
                        {"determined", !marginal.is_undetermined()},
                        {"cut_off", marginal.is_cut_off_by_range()}});
    if (i >= calibration.posterior.nearest.unknowns.size()) continue;
    const MarginalPosterior& near = calibration.posterior.nearest.unknowns[i];
    list.back()["nearest_members"] = {{"median", near.median}, {"range", {near.low, near.high}}};
  }
  return list;
}

Json figures_json(const Calibration& calibration) {
  Json list = Json::array();
  for (std::size_t o = 0, at = 0; o < calibration.study.observations.size(); ++o) {
    const Observation& observation = calibration.study.observations[o];
    for (std::size_t i = 0; i < observation.statistics.size(); ++i, ++at) {
      const SummaryStatistic& statistic = observation.statistics[i];
      Json json = figure_json(calibration.study, observation, statistic);
      for (const PredictedStatistic& one : calibration.posterior.predictions) {
        if (one.observation != o || one.statistic != i) continue;
        json["predicted"] = one.median;
        json["interval_95"] = {one.low, one.high};
        json["prior"] = one.prior.median;
        json["prior_95"] = {one.prior.low, one.prior.high};
        json["covered"] = one.covers(statistic.observed);
      }
      if (const std::optional<SurrogateQuality>& quality = calibration.posterior.surrogates[at]) {
        json["surrogate"] = {{"members", quality->members},
                             {"error", quality->leave_one_out_error},
                             {"explained", quality->explained_variance}};
        Json first = Json::object(), total = Json::object();
        for (std::size_t k = 0; k < calibration.study.unknowns.size(); ++k) {
          const std::string& parameter = calibration.study.unknowns[k].parameter;
          first[parameter] = calibration.posterior.sensitivities[at][k].first_order;
          total[parameter] = calibration.posterior.sensitivities[at][k].total;
        }
        json["first_order"] = std::move(first);
        json["total"] = std::move(total);
      }
      list.push_back(std::move(json));
    }
  }
  return list;
}

Json check_json(const PredictiveCheck& check) {
  return {{"figures", check.statistics},
          {"covered", check.covered},
          {"squared_distance", check.squared_distance},
          {"freedom", check.degrees_of_freedom},
          {"p", check.p_value ? Json(*check.p_value) : Json()},
          {"failed", check.failed()}};
}

}  // namespace

Json calibration_json(const Calibration& calibration) {
  return {{"file", calibration.file.string()},
          {"answer", describe_calibration_result(calibration)},
          {"findings", describe_calibration_findings(calibration)},
          {"members", calibration.study.design.member_count},
          {"releases", calibration.study.design.releases_per_member},
          {"draws", calibration.posterior.draws.cols()},
          {"unknowns", unknowns_json(calibration)},
          {"figures", figures_json(calibration)},
          {"fit", check_json(calibration.posterior.fitted)},
          {"prediction", check_json(calibration.posterior.held_out)},
          {"ground", format_ground_tables(calibration)}};
}

Json study_json(const CalibrationStudy& study) {
  Json sites = Json::array(), unknowns = Json::array(), statistics = Json::array();
  for (const CalibrationSite& site : study.sites) {
    sites.push_back({{"name", site.name}, {"campaign", site.campaign.file.string()}});
  }
  for (const UnknownParameter& unknown : study.unknowns) unknowns.push_back(unknown_json(unknown));
  for (const Observation& observation : study.observations) {
    for (const SummaryStatistic& statistic : observation.statistics) {
      statistics.push_back(figure_json(study, observation, statistic));
    }
  }
  return {{"members", study.design.member_count},
          {"releases", study.design.releases_per_member},
          {"runs", study.run_count()},
          {"sites", std::move(sites)},
          {"unknowns", std::move(unknowns)},
          {"figures", std::move(statistics)}};
}

}  // namespace clast
