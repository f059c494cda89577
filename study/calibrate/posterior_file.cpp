#include "study/calibrate/posterior_file.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/hdf5_file.hpp"
#include "study/calibrate/detail/site_outcomes.hpp"

namespace clast {

using namespace study_detail;

namespace {

using Eigen::Index;

constexpr double kNotStored = std::numeric_limits<double>::quiet_NaN();

/// Writes a matrix row by row.
void write_matrix(Hdf5Group& group, const std::string& name, const Eigen::MatrixXd& matrix) {
  std::vector<double> values;
  for (Index i = 0; i < matrix.rows(); ++i) {
    for (Index k = 0; k < matrix.cols(); ++k) values.push_back(matrix(i, k));
  }
  group.write<double>(
      name, values,
      {static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())});
}

void write_unknowns(Hdf5Group group, const CalibrationStudy& study) {
  std::vector<std::string> parameters, units;
  std::vector<double> low, high;
  std::vector<std::uint8_t> logarithmic;
  for (const UnknownParameter& unknown : study.unknowns) {
    parameters.push_back(unknown.parameter);
    units.push_back(calibratable_range(unknown.parameter).unit);
    low.push_back(unknown.low);
    high.push_back(unknown.high);
    logarithmic.push_back(unknown.logarithmic ? 1 : 0);
  }
  group.write<std::string>("parameter", parameters);
  group.write<std::string>("unit", units);
  group.write<double>("low", low);
  group.write<double>("high", high);
  group.write<std::uint8_t>("logarithmic", logarithmic);
}

/// Writes the observed statistics, and those of surrogates and prediction.
void write_figures(Hdf5Group group, const CalibrationStudy& study,
                   const CalibrationPosterior& posterior) {
  std::vector<std::string> observation, site, use, name;
  std::vector<double> observed, error;
  for (const Observation& one : study.observations) {
    for (const SummaryStatistic& statistic : one.statistics) {
      observation.push_back(one.name);
      site.push_back(study.sites[one.site].name);
      use.emplace_back(one.fitted ? "fit" : "keep");
      name.push_back(statistic.name);
      observed.push_back(statistic.observed);
      error.push_back(statistic.error.value_or(
          statistic.measurement_error > 0.0 ? statistic.measurement_error : kNotStored));
    }
  }
  group.write<std::string>("observation", observation);
  group.write<std::string>("site", site);
  group.write<std::string>("use", use);
  group.write<std::string>("figure", name);
  group.write<double>("observed", observed);
  group.write<double>("stated_error", error);
  write_matrix(group, "members", posterior.member_statistics);
  std::vector<double> cross, explained, inflation, roughness;
  for (const std::optional<SurrogateQuality>& quality : posterior.surrogates) {
    cross.push_back(quality ? quality->leave_one_out_error : kNotStored);
    explained.push_back(quality ? quality->explained_variance : kNotStored);
    inflation.push_back(quality ? quality->inflation : kNotStored);
    roughness.push_back(quality ? quality->roughness : kNotStored);
  }
  group.write<double>("surrogate_error", cross);
  group.write<double>("surrogate_explained", explained);
  group.write<double>("surrogate_inflation", inflation);
  group.write<double>("surrogate_roughness", roughness);
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (const Observation& one : study.observations) {
    first.push_back(count);
    count += one.statistics.size();
  }
  std::vector<double> median(count, kNotStored), low(count, kNotStored), high(count, kNotStored);
  std::vector<double> prior_median = median, prior_low = median, prior_high = median;
  for (const PredictedStatistic& statistic : posterior.predictions) {
    const std::size_t at = first[statistic.observation] + statistic.statistic;
    median[at] = statistic.median;
    low[at] = statistic.low;
    high[at] = statistic.high;
    prior_median[at] = statistic.prior.median;
    prior_low[at] = statistic.prior.low;
    prior_high[at] = statistic.prior.high;
  }
  group.write<double>("predicted_median", median);
  group.write<double>("predicted_low", low);
  group.write<double>("predicted_high", high);
  group.write<double>("prior_median", prior_median);
  group.write<double>("prior_low", prior_low);
  group.write<double>("prior_high", prior_high);
  std::vector<double> first_order, total;
  for (const std::vector<SobolIndices>& shares : posterior.sensitivities) {
    for (std::size_t i = 0; i < study.unknowns.size(); ++i) {
      first_order.push_back(shares.empty() ? kNotStored : shares[i].first_order);
      total.push_back(shares.empty() ? kNotStored : shares[i].total);
    }
  }
  group.write<double>("first_order", first_order, {count, study.unknowns.size()});
  group.write<double>("total", total, {count, study.unknowns.size()});
}

void write_check(Hdf5Group& group, const std::string& name, const PredictiveCheck& check) {
  group.set_attribute<std::int64_t>(name + "_figures", static_cast<std::int64_t>(check.statistics));
  group.set_attribute<std::int64_t>(name + "_covered", static_cast<std::int64_t>(check.covered));
  group.set_attribute<double>(name + "_squared_distance", check.squared_distance);
  group.set_attribute<double>(name + "_freedom", check.degrees_of_freedom);
  group.set_attribute<double>(name + "_p", check.p_value.value_or(kNotStored));
}

void write_found(Hdf5Group group, const CalibrationPosterior& posterior) {
  write_matrix(group, "draws", posterior.draws.transpose());
  group.write<double>("log_likelihood",
                      std::span(posterior.log_likelihood.data(),
                                static_cast<std::size_t>(posterior.log_likelihood.size())));
  write_matrix(group, "rank_correlation", posterior.correlation);
  std::vector<double> median, low, high, width, near_median, near_low, near_high;
  for (const MarginalPosterior& marginal : posterior.marginals) {
    median.push_back(marginal.median);
    low.push_back(marginal.low);
    high.push_back(marginal.high);
    width.push_back(marginal.width);
  }
  for (const MarginalPosterior& marginal : posterior.nearest.unknowns) {
    near_median.push_back(marginal.median);
    near_low.push_back(marginal.low);
    near_high.push_back(marginal.high);
  }
  group.write<double>("median", median);
  group.write<double>("low_95", low);
  group.write<double>("high_95", high);
  group.write<double>("width_of_prior", width);
  group.write<double>("nearest_median", near_median);
  group.write<double>("nearest_low", near_low);
  group.write<double>("nearest_high", near_high);
  group.set_attribute<std::int64_t>("nearest_members",
                                    static_cast<std::int64_t>(posterior.nearest.members));
  group.set_attribute<double>("log_evidence", posterior.log_evidence);
  group.set_attribute<std::int64_t>("temperatures",
                                    static_cast<std::int64_t>(posterior.temperature_count));
  group.set_attribute<double>("accepted", posterior.acceptance_rate);
  write_check(group, "fitted", posterior.fitted);
  write_check(group, "kept", posterior.held_out);
}

}  // namespace

void write_posterior(const std::filesystem::path& target, const CalibrationStudy& study,
                     const StoredCalibration& stored, const CalibrationPosterior* posterior,
                     const OverwritePolicy& rules) {
  OutputFile output(target, rules);
  {
    Hdf5File file = Hdf5File::create(output.temporary_path(), kPosteriorFormat, kPosteriorSchema);
    Hdf5Group root = file.root();
    root.set_attribute<std::string>("study_sha256", study.sha256);
    root.set_attribute<std::string>("design_sha256", stored.design_sha256);
    if (!stored.physics_digest.empty()) {
      root.set_attribute<std::string>("physics_digest", stored.physics_digest);
    }
    root.set_attribute<std::int64_t>("members", study.design.member_count);
    root.set_attribute<std::int64_t>("releases", study.design.releases_per_member);
    root.set_attribute<std::int64_t>("seed", static_cast<std::int64_t>(study.design.seed));
    root.set_attribute<std::string>(
        "kernel", study.design.kernel == Kernel::kMatern52 ? "matern-5/2" : "squared-exponential");
    root.write<std::string>("study", std::vector<std::string>{study.text});
    root.write<std::string>("inputs", stored.inputs);
    write_unknowns(root.create_group("unknowns"), study);
    std::vector<double> values;
    for (const std::vector<double>& place : study.design.sobol_points(study.unknowns.size())) {
      const std::vector<double> member = study.values(place);
      values.insert(values.end(), member.begin(), member.end());
    }
    root.write<double>("member_values", values, {study.design.member_count, study.unknowns.size()});
    Hdf5Group sites = root.create_group("sites");
    for (std::size_t i = 0; i < stored.runs.sites.size(); ++i) {
      write_site_outcomes(sites.create_group(std::to_string(i)), stored.runs.sites[i],
                          stored.runs.outcomes[i], stored.done[i]);
    }
    if (posterior) {
      write_figures(root.create_group("figures"), study, *posterior);
      write_found(root.create_group("posterior"), *posterior);
    }
    file.flush();
  }
  output.commit();
}

StoredCalibration read_calibration_runs(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path, kPosteriorFormat, kPosteriorSchema);
  const Hdf5Group root = file.root();
  StoredCalibration stored;
  stored.design_sha256 = root.read_attribute<std::string>("design_sha256");
  if (root.has_attribute("physics_digest")) {
    stored.physics_digest = root.read_attribute<std::string>("physics_digest");
  }
  stored.inputs = root.read<std::string>("inputs");
  const auto members = root.read_attribute<std::int64_t>("members");
  const CheckedGroup top{path.string(), "", root};
  if (members < 1 || members > 1'000'000)
    top.throw_damaged("members", "is not a number of members");
  const Hdf5Group sites = root.open_group("sites");
  for (std::size_t i = 0; sites.contains(std::to_string(i)); ++i) {
    const std::string name = "/sites/" + std::to_string(i);
    const CheckedGroup site{path.string(), name, sites.open_group(std::to_string(i))};
    stored.runs.sites.push_back(read_site_description(site));
    const auto done = site.column<std::uint8_t>("done", static_cast<std::size_t>(members));
    stored.done.emplace_back(done.begin(), done.end());
    const CheckedGroup runs{path.string(), name + "/runs", site.group.open_group("runs")};
    stored.runs.outcomes.push_back(
        read_release_outcomes(runs, stored.runs.sites.back(), static_cast<std::size_t>(members)));
  }
  return stored;
}

}  // namespace clast
