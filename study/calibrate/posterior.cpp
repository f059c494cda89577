#include "study/calibrate/posterior.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "core/statistics/probability.hpp"
#include "core/statistics/sample_tests.hpp"
#include "core/statistics/sobol_sequence.hpp"
#include "core/statistics/statistics.hpp"
#include "core/statistics/tempered_sampling.hpp"
#include "study/calibrate/synthetic_likelihood.hpp"
#include "study/campaign/named_seed.hpp"

namespace clast {

using namespace study_detail;
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kUniformVariance = 1.0 / 12.0;

std::vector<double> sorted_values(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<double> row_of(const MatrixXd& matrix, Index row) {
  std::vector<double> values;
  for (Index i = 0; i < matrix.cols(); ++i) values.push_back(matrix(row, i));
  return values;
}

MarginalPosterior marginal_of(const UnknownParameter& unknown, const std::vector<double>& shares) {
  const double low = quantile(shares, 0.025), high = quantile(shares, 0.975);
  const auto below = [&](double share) {
    return static_cast<double>(std::lower_bound(shares.begin(), shares.end(), share) -
                               shares.begin()) /
           static_cast<double>(shares.size());
  };
  return {unknown.prior_quantile(quantile(shares, 0.5)),
          unknown.prior_quantile(low),
          unknown.prior_quantile(high),
          (high - low) / 0.95,
          below(0.05),
          1.0 - below(0.95)};
}

MatrixXd rank_correlations(const MatrixXd& draws) {
  const Index count = draws.rows();
  MatrixXd about(count, draws.cols());
  for (Index i = 0; i < count; ++i) {
    const std::vector<double> ranked = fractional_ranks(row_of(draws, i));
    for (Index k = 0; k < draws.cols(); ++k) about(i, k) = ranked[static_cast<std::size_t>(k)];
    about.row(i).array() -= about.row(i).mean();
    about.row(i) /= std::max(about.row(i).norm(), 1e-300);
  }
  return about * about.transpose();
}

/// Draws the observable statistics: one draw of each for every draw of the unknowns.
MatrixXd predictive_draws(const SyntheticLikelihood& likelihood, const std::vector<Index>& which,
                          const MatrixXd& shares, std::uint64_t seed) {
  const SyntheticLikelihood::PredictedStatistics expected =
      likelihood.predict_statistics(shares, which);
  const MatrixXd scatter = likelihood.scatter_covariance(which);
  MatrixXd draws = expected.mean;
  Random random(seed);
  for (Index i = 0; i < draws.cols(); ++i) {
    MatrixXd covariance = scatter;
    covariance.diagonal() += expected.variance.col(i);
    VectorXd normal(draws.rows());
    for (double& value : normal) value = random.normal();
    draws.col(i) += covariance.llt().matrixL() * normal;
  }
  return draws;
}

/// Finds the observation and number of a statistic.
PredictedStatistic place_of_figure(const CalibrationStudy& study, std::size_t statistic) {
  PredictedStatistic place;
  while (statistic >= study.observations[place.observation].statistics.size()) {
    statistic -= study.observations[place.observation++].statistics.size();
  }
  place.statistic = statistic;
  return place;
}

/// The nearest value that the figure can have: the normal law of the prediction knows no bounds.
double possible(const SummaryStatistic& statistic, double value) {
  switch (statistic.kind) {
    case SummaryStatistic::Kind::kFractionBeyond:
    case SummaryStatistic::Kind::kPassedFraction:
      return std::clamp(value, 0.0, 1.0);
    case SummaryStatistic::Kind::kStopDeviation:
    case SummaryStatistic::Kind::kMeanSpeed:
    case SummaryStatistic::Kind::kMeanAngularSpeed:
    case SummaryStatistic::Kind::kMeanEnergy:
    case SummaryStatistic::Kind::kMeanScarDepth:
      return std::max(value, 0.0);
    default:
      return value;
  }
}

/// Computes the interval of a statistic from its draws, one row of `draws`.
PredictedInterval interval_of(const SummaryStatistic& statistic, const MatrixXd& draws, Index row) {
  const std::vector<double> values = sorted_values(row_of(draws, row));
  return {possible(statistic, quantile(values, 0.5)), possible(statistic, quantile(values, 0.025)),
          possible(statistic, quantile(values, 0.975))};
}

/// Returns as many points over all prior ranges as there are draws.
MatrixXd prior_places(const CalibrationStudy& study) {
  SobolSequence sequence(study.unknowns.size(), derive_seed(study.design.seed, "prior"));
  MatrixXd cube_points(static_cast<Index>(study.unknowns.size()),
                       static_cast<Index>(study.design.draw_count));
  for (Index i = 0; i < cube_points.cols(); ++i) {
    const std::vector<double> point = sequence.next_point();
    cube_points.col(i) = Eigen::Map<const VectorXd>(point.data(), cube_points.rows());
  }
  return cube_points;
}

/// Adds the predictions of fitted or kept figures, and counts how many cover what was observed.
PredictiveCheck predict_figures(const CalibrationStudy& study,
                                const SyntheticLikelihood& likelihood, bool fitted,
                                CalibrationPosterior& posterior) {
  const std::vector<Index> which = likelihood.surrogate_indices(fitted);
  PredictiveCheck check;
  check.statistics = which.size();
  if (which.empty()) return check;
  const std::string name = fitted ? "fitted" : "kept";
  const MatrixXd draws = predictive_draws(likelihood, which, posterior.probabilities,
                                          derive_seed(study.design.seed, name));
  const MatrixXd prior = predictive_draws(likelihood, which, prior_places(study),
                                          derive_seed(study.design.seed, name + " prior"));
  const VectorXd observed = likelihood.observed_values(which);
  for (std::size_t i = 0; i < which.size(); ++i) {
    PredictedStatistic statistic = place_of_figure(study, static_cast<std::size_t>(which[i]));
    const SummaryStatistic& asked =
        study.observations[statistic.observation].statistics[statistic.statistic];
    const PredictedInterval found = interval_of(asked, draws, static_cast<Index>(i));
    statistic.median = found.median;
    statistic.low = found.low;
    statistic.high = found.high;
    statistic.prior = interval_of(asked, prior, static_cast<Index>(i));
    if (statistic.covers(observed[static_cast<Index>(i)])) ++check.covered;
    posterior.predictions.push_back(statistic);
  }
  if (fitted) return check;
  // Kept figures had no part in the fit: their distance from what the draws give.
  const VectorXd mean = draws.rowwise().mean();
  const MatrixXd about = draws.colwise() - mean;
  MatrixXd covariance = about * about.transpose() / static_cast<double>(draws.cols() - 1);
  covariance.diagonal().array() += 1e-12;
  const VectorXd apart = observed - mean;
  check.squared_distance = apart.dot(covariance.llt().solve(apart));
  check.degrees_of_freedom = static_cast<double>(which.size());
  check.p_value = chi_squared_upper_tail(check.squared_distance, check.degrees_of_freedom);
  return check;
}

/// The best draw leaves a distance with as many degrees of freedom as there are figures more than
/// parameters that were determined.
void check_fit(const SyntheticLikelihood& likelihood, CalibrationPosterior& posterior) {
  Index best = 0;
  posterior.log_likelihood.maxCoeff(&best);
  double determined = 0.0;
  for (Index i = 0; i < posterior.probabilities.rows(); ++i) {
    const double variance =
        (posterior.probabilities.row(i).array() - posterior.probabilities.row(i).mean())
            .square()
            .mean();
    determined += std::max(0.0, 1.0 - variance / kUniformVariance);
  }
  PredictiveCheck& check = posterior.fitted;
  check.squared_distance = likelihood.squared_distance(posterior.probabilities.col(best), true)[0];
  check.degrees_of_freedom = static_cast<double>(check.statistics) - determined;
  if (check.degrees_of_freedom >= 0.5) {
    check.p_value = chi_squared_upper_tail(check.squared_distance, check.degrees_of_freedom);
  } else {
    check.degrees_of_freedom = std::max(0.0, check.degrees_of_freedom);
  }
}

std::vector<std::vector<SobolIndices>> sensitivities_of(const CalibrationStudy& study,
                                                        const SyntheticLikelihood& likelihood,
                                                        unsigned threads) {
  constexpr std::size_t kSamples = 2048;
  std::vector<std::vector<SobolIndices>> all(study.statistic_count());
  parallel_for(all.size(), threads, [&](std::size_t k) {
    if (!likelihood.surrogate_quality(k)) return;
    all[k] = sobol_indices(
        study.unknowns.size(),
        [&](const MatrixXd& cube_points) { return likelihood.predicted_mean(k, cube_points); },
        kSamples, derive_seed(study.design.seed, "sensitivity"));
  });
  return all;
}

/// Finds the members whose own statistics are nearest, in units of the scatter.
NearestMembers nearest_members(const CalibrationStudy& study, const MemberStatistics& statistics,
                               const SyntheticLikelihood& likelihood) {
  const std::vector<Index> which = likelihood.surrogate_indices(true);
  const VectorXd observed = likelihood.observed_values(which);
  const Eigen::LLT<MatrixXd> factor(likelihood.scatter_covariance(which));
  const auto members = static_cast<std::size_t>(statistics.cube_points.cols());
  std::vector<std::pair<double, std::size_t>> distances;
  for (std::size_t m = 0; m < members; ++m) {
    VectorXd apart(static_cast<Index>(which.size()));
    for (std::size_t i = 0; i < which.size(); ++i) {
      apart[static_cast<Index>(i)] =
          statistics.values(which[i], static_cast<Index>(m)) - observed[static_cast<Index>(i)];
    }
    const double squared = apart.dot(factor.solve(apart));
    if (std::isfinite(squared)) distances.emplace_back(squared, m);
  }
  std::sort(distances.begin(), distances.end());
  distances.resize(std::min(distances.size(), std::max<std::size_t>(5, members / 10)));
  NearestMembers nearest;
  nearest.members = distances.size();
  if (distances.empty()) return nearest;
  for (std::size_t i = 0; i < study.unknowns.size(); ++i) {
    std::vector<double> shares;
    for (const auto& [distance, m] : distances) {
      shares.push_back(statistics.cube_points(static_cast<Index>(i), static_cast<Index>(m)));
    }
    shares = sorted_values(shares);
    MarginalPosterior marginal = marginal_of(study.unknowns[i], shares);
    marginal.low = study.unknowns[i].prior_quantile(shares.front());
    marginal.high = study.unknowns[i].prior_quantile(shares.back());
    nearest.unknowns.push_back(marginal);
  }
  return nearest;
}

}  // namespace

CalibrationPosterior infer_posterior(const CalibrationStudy& study, const CalibrationRuns& runs,
                                     unsigned threads) {
  const MemberStatistics statistics =
      compute_member_statistics(study, runs.sites, runs.outcomes, threads);
  const SyntheticLikelihood likelihood(study, statistics, threads);
  TemperedSamplingOptions options;
  options.draws = study.design.draw_count;
  options.seed = derive_seed(study.design.seed, "posterior");
  TemperedSample sample = draw_tempered_sample(
      study.unknowns.size(),
      [&](const MatrixXd& cube_points) { return likelihood.log_likelihood(cube_points); }, options);
  CalibrationPosterior posterior;
  posterior.probabilities = std::move(sample.points);
  posterior.log_likelihood = std::move(sample.log_likelihood);
  posterior.log_evidence = sample.log_evidence;
  posterior.temperature_count = sample.tempering_steps;
  posterior.acceptance_rate = sample.acceptance_rate;
  posterior.member_statistics = statistics.values;
  posterior.draws = posterior.probabilities;
  for (std::size_t i = 0; i < study.unknowns.size(); ++i) {
    const auto row = static_cast<Index>(i);
    posterior.marginals.push_back(
        marginal_of(study.unknowns[i], sorted_values(row_of(posterior.probabilities, row))));
    for (double& value : posterior.draws.row(row)) value = study.unknowns[i].prior_quantile(value);
  }
  posterior.correlation = rank_correlations(posterior.probabilities);
  posterior.fitted = predict_figures(study, likelihood, true, posterior);
  posterior.held_out = predict_figures(study, likelihood, false, posterior);
  check_fit(likelihood, posterior);
  for (std::size_t k = 0; k < study.statistic_count(); ++k) {
    posterior.surrogates.push_back(likelihood.surrogate_quality(k));
  }
  posterior.sensitivities = sensitivities_of(study, likelihood, threads);
  posterior.nearest = nearest_members(study, statistics, likelihood);
  return posterior;
}

}  // namespace clast
