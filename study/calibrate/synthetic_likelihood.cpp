#include "study/calibrate/synthetic_likelihood.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/types.hpp"
#include "study/campaign/named_seed.hpp"

namespace clast::study_detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kRounds = 3;  ///< until the members near the answer are found

/// The part of a symmetric matrix that can be a covariance.
MatrixXd covariance_part(const MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
         solver.eigenvectors().transpose();
}

/// Weighted mean over members, of each entry over those that have it; 0 where none has.
MatrixXd pooled(const std::vector<StatisticScatter>& members, MatrixXd StatisticScatter::*part,
                const VectorXd& weights) {
  MatrixXd sum = MatrixXd::Zero((members.front().*part).rows(), (members.front().*part).cols());
  MatrixXd weight = sum;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const MatrixXd& one = members[m].*part;
    for (Index i = 0; i < one.size(); ++i) {
      if (!std::isfinite(one.data()[i])) continue;
      sum.data()[i] += weights[static_cast<Index>(m)] * one.data()[i];
      weight.data()[i] += weights[static_cast<Index>(m)];
    }
  }
  for (Index i = 0; i < sum.size(); ++i) {
    sum.data()[i] = weight.data()[i] > 0.0 ? sum.data()[i] / weight.data()[i] : 0.0;
  }
  return sum;
}

/// Weights that go with the likelihood, to a power that leaves at least `asked` members effective.
VectorXd member_weights(const VectorXd& log_likelihood, double asked) {
  const auto raised = [&](double power) -> VectorXd {
    const VectorXd logs = power * (log_likelihood.array() - log_likelihood.maxCoeff());
    return logs.array().exp();
  };
  const auto effective = [&](double power) {
    const VectorXd weights = raised(power);
    return weights.sum() * weights.sum() / weights.squaredNorm();
  };
  if (effective(1.0) >= asked) return raised(1.0);
  double low = 0.0, high = 1.0;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (low + high);
    (effective(middle) >= asked ? low : high) = middle;
  }
  return raised(low);
}

std::size_t fewest_members(std::size_t members, std::size_t unknowns) {
  return std::min(members, std::max<std::size_t>(8, 2 * unknowns + 2));
}

std::string full_statistic_name(const CalibrationStudy& study, std::size_t statistic) {
  for (const Observation& observation : study.observations) {
    if (statistic < observation.statistics.size()) {
      return "observation " + observation.name + ", " + observation.statistics[statistic].name;
    }
    statistic -= observation.statistics.size();
  }
  return "";
}

}  // namespace

MemberStatistics compute_member_statistics(
    const CalibrationStudy& study, const std::vector<SiteDescription>& sites,
    const std::vector<std::vector<std::vector<ReleaseOutcome>>>& simulated, unsigned threads) {
  const std::size_t members = study.design.member_count;
  MemberStatistics statistics;
  statistics.groups = group_statistics_by_site(study.observations);
  statistics.cube_points.resize(static_cast<Index>(study.unknowns.size()),
                                static_cast<Index>(members));
  const std::vector<std::vector<double>> cube_points =
      study.design.sobol_points(study.unknowns.size());
  for (std::size_t m = 0; m < members; ++m) {
    for (std::size_t i = 0; i < study.unknowns.size(); ++i) {
      statistics.cube_points(static_cast<Index>(i), static_cast<Index>(m)) = cube_points[m][i];
    }
  }
  statistics.values.resize(static_cast<Index>(study.statistic_count()),
                           static_cast<Index>(members));
  statistics.scatter.assign(statistics.groups.size(), std::vector<StatisticScatter>(members));
  parallel_for(members, threads, [&](std::size_t m) {
    for (std::size_t g = 0; g < statistics.groups.size(); ++g) {
      const SiteStatisticIndices& group = statistics.groups[g];
      std::vector<const Observation*> observations;
      std::vector<std::vector<SelectedOutcome>> seen;
      for (const std::size_t o : group.observations) {
        const Observation& observation = study.observations[o];
        observations.push_back(&observation);
        seen.push_back(
            select_outcomes(observation, sites[observation.site], simulated[observation.site][m]));
        check_outcome_count(observation, seen.back());
      }
      const std::uint64_t seed =
          derive_seed(study.design.seed, "scatter " + std::to_string(g) + "/" + std::to_string(m));
      StatisticScatter& scatter = statistics.scatter[g][m];
      scatter = estimate_statistic_scatter(observations, seen, seed);
      for (std::size_t k = 0; k < group.statistics.size(); ++k) {
        statistics.values(static_cast<Index>(group.statistics[k]), static_cast<Index>(m)) =
            scatter.mean[static_cast<Index>(k)];
      }
    }
  });
  return statistics;
}

SyntheticLikelihood::SyntheticLikelihood(const CalibrationStudy& study,
                                         const MemberStatistics& statistics, unsigned threads)
    : threads_(threads),
      surrogates_(study.statistic_count()),
      fitted_(study.statistic_count(), false) {
  const std::size_t count = study.statistic_count();
  const std::size_t min_members = fewest_members(study.design.member_count, study.unknowns.size());
  observed_.resize(static_cast<Index>(count));
  std::size_t at = 0;
  for (const Observation& observation : study.observations) {
    for (const SummaryStatistic& statistic : observation.statistics) {
      fitted_[at] = observation.fitted;
      observed_[static_cast<Index>(at++)] = statistic.observed;
    }
  }
  VectorXd sampling_variance = VectorXd::Zero(static_cast<Index>(count));
  const VectorXd equal = VectorXd::Ones(static_cast<Index>(study.design.member_count));
  for (std::size_t g = 0; g < statistics.groups.size(); ++g) {
    const MatrixXd within =
        pooled(statistics.scatter[g], &StatisticScatter::release_covariance, equal);
    for (std::size_t k = 0; k < statistics.groups[g].statistics.size(); ++k) {
      const auto place = static_cast<Index>(k);
      sampling_variance[static_cast<Index>(statistics.groups[g].statistics[k])] =
          within(place, place);
    }
  }
  parallel_for(count, threads, [&](std::size_t k) {
    const auto row = static_cast<Index>(k);
    surrogates_[k] = fit_surrogate(statistics.cube_points, statistics.values.row(row),
                                   sampling_variance[row], min_members, study.design.kernel);
  });
  for (std::size_t k = 0; k < count; ++k) {
    if (surrogates_[k] || !fitted_[k]) continue;
    const auto with_value = statistics.values.row(static_cast<Index>(k)).array().isFinite().count();
    throw InputError(
        study.file.string() + ": " + full_statistic_name(study, k) + ": only " +
        format_count(static_cast<std::size_t>(with_value), "member") + " of " +
        std::to_string(study.design.member_count) + " have a value, but " +
        std::to_string(min_members) +
        " are needed; widen the ranges, simulate more releases, or set use = \"keep\"");
  }
  estimate_scatter(statistics);
}

void SyntheticLikelihood::estimate_scatter(const MemberStatistics& statistics) {
  const auto members = static_cast<double>(statistics.cube_points.cols());
  pool_scatter(statistics, VectorXd::Ones(statistics.cube_points.cols()));
  for (int round = 0; round < kRounds; ++round) {
    const double asked = std::min(members, std::max(8.0, members / 8.0));
    pool_scatter(statistics, member_weights(log_likelihood(statistics.cube_points), asked));
  }
}

void SyntheticLikelihood::pool_scatter(const MemberStatistics& statistics,
                                       const VectorXd& weights) {
  scatter_ = MatrixXd::Zero(observed_.size(), observed_.size());
  for (std::size_t g = 0; g < statistics.groups.size(); ++g) {
    const std::vector<StatisticScatter>& members = statistics.scatter[g];
    const MatrixXd field = pooled(members, &StatisticScatter::field_covariance, weights);
    const MatrixXd points = pooled(members, &StatisticScatter::point_covariance, weights);
    const MatrixXd within = pooled(members, &StatisticScatter::release_covariance, weights);
    // A bootstrap of points has the chance of the releases in it too, which surrogates smooth out.
    const MatrixXd group = covariance_part(field) + covariance_part(points - within);
    const std::vector<std::size_t>& which = statistics.groups[g].statistics;
    for (std::size_t i = 0; i < which.size(); ++i) {
      for (std::size_t k = 0; k < which.size(); ++k) {
        scatter_(static_cast<Index>(which[i]), static_cast<Index>(which[k])) =
            group(static_cast<Index>(i), static_cast<Index>(k));
      }
    }
  }
}

SyntheticLikelihood::PredictedStatistics SyntheticLikelihood::predict_statistics(
    const MatrixXd& cube_points, const std::vector<Index>& which) const {
  const auto count = static_cast<Index>(which.size());
  PredictedStatistics all{MatrixXd(count, cube_points.cols()), MatrixXd(count, cube_points.cols())};
  std::vector<GaussianProcess::Prediction> one(which.size());
  parallel_for(which.size(), threads_, [&](std::size_t i) {
    one[i] = surrogates_[static_cast<std::size_t>(which[i])]->predict(cube_points);
  });
  for (Index i = 0; i < count; ++i) {
    all.mean.row(i) = one[static_cast<std::size_t>(i)].mean;
    all.variance.row(i) = one[static_cast<std::size_t>(i)].variance;
  }
  return all;
}

VectorXd SyntheticLikelihood::observed_values(const std::vector<Index>& which) const {
  VectorXd values(static_cast<Index>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i)
    values[static_cast<Index>(i)] = observed_[which[i]];
  return values;
}

VectorXd SyntheticLikelihood::predicted_mean(std::size_t statistic,
                                             const MatrixXd& cube_points) const {
  return surrogates_[statistic]->process.predict_mean(cube_points);
}

std::vector<Index> SyntheticLikelihood::surrogate_indices(bool fitted) const {
  std::vector<Index> which;
  for (std::size_t k = 0; k < surrogates_.size(); ++k) {
    if (surrogates_[k] && fitted_[k] == fitted) which.push_back(static_cast<Index>(k));
  }
  return which;
}

MatrixXd SyntheticLikelihood::scatter_covariance(const std::vector<Index>& which) const {
  const auto count = static_cast<Index>(which.size());
  MatrixXd part(count, count);
  for (Index i = 0; i < count; ++i) {
    for (Index k = 0; k < count; ++k) {
      part(i, k) = scatter_(which[static_cast<std::size_t>(i)], which[static_cast<std::size_t>(k)]);
    }
    // A spread of nothing at all would make any misfit infinite.
    const double observed = observed_[which[static_cast<std::size_t>(i)]];
    part(i, i) += 1e-12 + 1e-12 * observed * observed;
  }
  return part;
}

namespace {

/// Squared distance and logarithm of the determinant, of each place.
struct Misfit {
  VectorXd squared;
  VectorXd log_determinant;
};

Misfit misfit_of(const SyntheticLikelihood::PredictedStatistics& expected, const VectorXd& observed,
                 const MatrixXd& scatter) {
  const Index cube_points = expected.mean.cols();
  Misfit misfit{VectorXd::Zero(cube_points), VectorXd::Zero(cube_points)};
  for (Index p = 0; p < cube_points; ++p) {
    MatrixXd covariance = scatter;
    covariance.diagonal() += expected.variance.col(p);
    const VectorXd apart = observed - expected.mean.col(p);
    const Eigen::LLT<MatrixXd> factor(covariance);
    misfit.squared[p] = apart.dot(factor.solve(apart));
    misfit.log_determinant[p] = 2.0 * MatrixXd(factor.matrixL()).diagonal().array().log().sum();
  }
  return misfit;
}

}  // namespace

VectorXd SyntheticLikelihood::log_likelihood(const MatrixXd& cube_points) const {
  const std::vector<Index> which = surrogate_indices(true);
  const Misfit misfit = misfit_of(predict_statistics(cube_points, which), observed_values(which),
                                  scatter_covariance(which));
  const double constant = static_cast<double>(which.size()) * std::log(2.0 * kPi);
  return -0.5 * (misfit.squared + misfit.log_determinant).array() - 0.5 * constant;
}

VectorXd SyntheticLikelihood::squared_distance(const MatrixXd& cube_points, bool fitted) const {
  const std::vector<Index> which = surrogate_indices(fitted);
  return misfit_of(predict_statistics(cube_points, which), observed_values(which),
                   scatter_covariance(which))
      .squared;
}

}  // namespace clast::study_detail
