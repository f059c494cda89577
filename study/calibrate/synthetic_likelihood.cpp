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

std::string full_statistic_name(const CalibrationStudy& study, std::size_t figure) {
  for (const Observation& observation : study.observations) {
    if (figure < observation.figures.size()) {
      return "observation " + observation.name + ", " + observation.figures[figure].name;
    }
    figure -= observation.figures.size();
  }
  return "";
}

}  // namespace

MemberStatistics compute_member_statistics(
    const CalibrationStudy& study, const std::vector<SiteDescription>& sites,
    const std::vector<std::vector<std::vector<ReleaseOutcome>>>& simulated, unsigned threads) {
  const std::size_t members = study.design.members;
  MemberStatistics figures;
  figures.groups = group_by_site(study.observations);
  figures.places.resize(static_cast<Index>(study.unknowns.size()), static_cast<Index>(members));
  const std::vector<std::vector<double>> places = study.design.places(study.unknowns.size());
  for (std::size_t m = 0; m < members; ++m) {
    for (std::size_t i = 0; i < study.unknowns.size(); ++i) {
      figures.places(static_cast<Index>(i), static_cast<Index>(m)) = places[m][i];
    }
  }
  figures.values.resize(static_cast<Index>(study.statistic_count()), static_cast<Index>(members));
  figures.scatter.assign(figures.groups.size(), std::vector<StatisticScatter>(members));
  parallel_for(members, threads, [&](std::size_t m) {
    for (std::size_t g = 0; g < figures.groups.size(); ++g) {
      const SiteStatistics& group = figures.groups[g];
      std::vector<const Observation*> observations;
      std::vector<std::vector<SelectedOutcome>> seen;
      for (const std::size_t o : group.observations) {
        const Observation& observation = study.observations[o];
        observations.push_back(&observation);
        seen.push_back(
            select_outcomes(observation, sites[observation.site], simulated[observation.site][m]));
        check_enough(observation, seen.back());
      }
      const std::uint64_t seed =
          derive_seed(study.design.seed, "scatter " + std::to_string(g) + "/" + std::to_string(m));
      StatisticScatter& scatter = figures.scatter[g][m];
      scatter = estimate_statistic_scatter(observations, seen, seed);
      for (std::size_t k = 0; k < group.figures.size(); ++k) {
        figures.values(static_cast<Index>(group.figures[k]), static_cast<Index>(m)) =
            scatter.mean[static_cast<Index>(k)];
      }
    }
  });
  return figures;
}

SyntheticLikelihood::SyntheticLikelihood(const CalibrationStudy& study,
                                         const MemberStatistics& figures, unsigned threads)
    : threads_(threads),
      surrogates_(study.statistic_count()),
      fitted_(study.statistic_count(), false) {
  const std::size_t count = study.statistic_count();
  const std::size_t fewest = fewest_members(study.design.members, study.unknowns.size());
  observed_.resize(static_cast<Index>(count));
  std::size_t at = 0;
  for (const Observation& observation : study.observations) {
    for (const SummaryStatistic& figure : observation.figures) {
      fitted_[at] = observation.fitted;
      observed_[static_cast<Index>(at++)] = figure.observed;
    }
  }
  VectorXd chance = VectorXd::Zero(static_cast<Index>(count));
  const VectorXd equal = VectorXd::Ones(static_cast<Index>(study.design.members));
  for (std::size_t g = 0; g < figures.groups.size(); ++g) {
    const MatrixXd within = pooled(figures.scatter[g], &StatisticScatter::within, equal);
    for (std::size_t k = 0; k < figures.groups[g].figures.size(); ++k) {
      const auto place = static_cast<Index>(k);
      chance[static_cast<Index>(figures.groups[g].figures[k])] = within(place, place);
    }
  }
  parallel_for(count, threads, [&](std::size_t k) {
    const auto row = static_cast<Index>(k);
    surrogates_[k] = fit_surrogate(figures.places, figures.values.row(row), chance[row], fewest,
                                   study.design.kernel);
  });
  for (std::size_t k = 0; k < count; ++k) {
    if (surrogates_[k] || !fitted_[k]) continue;
    const auto with_value = figures.values.row(static_cast<Index>(k)).array().isFinite().count();
    throw InputError(
        study.file.string() + ": " + full_statistic_name(study, k) + ": only " +
        format_count(static_cast<std::size_t>(with_value), "member") + " of " +
        std::to_string(study.design.members) + " have a value, but " + std::to_string(fewest) +
        " are needed; widen the ranges, simulate more releases, or set use = \"keep\"");
  }
  estimate_scatter(figures);
}

void SyntheticLikelihood::estimate_scatter(const MemberStatistics& figures) {
  const auto members = static_cast<double>(figures.places.cols());
  pool_scatter(figures, VectorXd::Ones(figures.places.cols()));
  for (int round = 0; round < kRounds; ++round) {
    const double asked = std::min(members, std::max(8.0, members / 8.0));
    pool_scatter(figures, member_weights(log_likelihood(figures.places), asked));
  }
}

void SyntheticLikelihood::pool_scatter(const MemberStatistics& figures, const VectorXd& weights) {
  scatter_ = MatrixXd::Zero(observed_.size(), observed_.size());
  for (std::size_t g = 0; g < figures.groups.size(); ++g) {
    const std::vector<StatisticScatter>& members = figures.scatter[g];
    const MatrixXd field = pooled(members, &StatisticScatter::field, weights);
    const MatrixXd points = pooled(members, &StatisticScatter::points, weights);
    const MatrixXd within = pooled(members, &StatisticScatter::within, weights);
    // A bootstrap of points has the chance of the releases in it too, which surrogates smooth out.
    const MatrixXd group = covariance_part(field) + covariance_part(points - within);
    const std::vector<std::size_t>& which = figures.groups[g].figures;
    for (std::size_t i = 0; i < which.size(); ++i) {
      for (std::size_t k = 0; k < which.size(); ++k) {
        scatter_(static_cast<Index>(which[i]), static_cast<Index>(which[k])) =
            group(static_cast<Index>(i), static_cast<Index>(k));
      }
    }
  }
}

SyntheticLikelihood::Expected SyntheticLikelihood::predict_statistics(
    const MatrixXd& places, const std::vector<Index>& which) const {
  const auto count = static_cast<Index>(which.size());
  Expected all{MatrixXd(count, places.cols()), MatrixXd(count, places.cols())};
  std::vector<GaussianProcess::Prediction> one(which.size());
  parallel_for(which.size(), threads_, [&](std::size_t i) {
    one[i] = surrogates_[static_cast<std::size_t>(which[i])]->predict(places);
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

VectorXd SyntheticLikelihood::mean(std::size_t figure, const MatrixXd& places) const {
  return surrogates_[figure]->process.predict_mean(places);
}

std::vector<Index> SyntheticLikelihood::known(bool fitted) const {
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

Misfit misfit_of(const SyntheticLikelihood::Expected& expected, const VectorXd& observed,
                 const MatrixXd& scatter) {
  const Index places = expected.mean.cols();
  Misfit misfit{VectorXd::Zero(places), VectorXd::Zero(places)};
  for (Index p = 0; p < places; ++p) {
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

VectorXd SyntheticLikelihood::log_likelihood(const MatrixXd& places) const {
  const std::vector<Index> which = known(true);
  const Misfit misfit = misfit_of(predict_statistics(places, which), observed_values(which),
                                  scatter_covariance(which));
  const double constant = static_cast<double>(which.size()) * std::log(2.0 * kPi);
  return -0.5 * (misfit.squared + misfit.log_determinant).array() - 0.5 * constant;
}

VectorXd SyntheticLikelihood::squared_distance(const MatrixXd& places, bool fitted) const {
  const std::vector<Index> which = known(fitted);
  return misfit_of(predict_statistics(places, which), observed_values(which),
                   scatter_covariance(which))
      .squared;
}

}  // namespace clast::study_detail
