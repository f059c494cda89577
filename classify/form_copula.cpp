#include "classify/form_copula.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/statistics/probability.hpp"
#include "core/statistics/sample_tests.hpp"
#include "core/statistics/statistics.hpp"

namespace clast {
namespace {

constexpr std::size_t kFewest = 10;
constexpr const char* kNames[] = {"L", "I/L", "S/I", "convexity"};
/// Steps in which rank correlations that are no matrix together are weakened.
constexpr double kWeaker = 0.05;
/// Smallest pivot of a matrix that is one.
constexpr double kMinPivot = 1e-9;

double rank_correlation(std::span<const double> a, std::span<const double> b) {
  // None: one of the two is the same of all blocks.
  const std::optional<TestResult> result = spearman_test(a, b);
  return result ? result->statistic : 0.0;
}

}  // namespace

FormCopula::Values FormCopula::measure_values(std::span<const BlockForm> blocks, bool convexity) {
  Values values(convexity ? 4 : 3);
  for (const BlockForm& block : blocks) {
    const Axes axes = Axes::sorted(block.axes.L, block.axes.I, block.axes.S);
    values[0].push_back(std::log(axes.L));
    values[1].push_back(axes.I / axes.L);
    values[2].push_back(axes.S / axes.I);
    if (convexity) values[3].push_back(block.convexity.value_or(1.0));
  }
  return values;
}

FormCopula::FormCopula(std::span<const BlockForm> population) {
  if (population.size() < kFewest) {
    throw InputError("a distribution of forms needs at least ten blocks, but there are " +
                     std::to_string(population.size()));
  }
  has_convexity_ = std::all_of(population.begin(), population.end(),
                               [](const BlockForm& block) { return block.convexity.has_value(); });
  values_ = measure_values(population, has_convexity_);
  sorted_ = values_;
  for (std::vector<double>& values : sorted_) std::sort(values.begin(), values.end());

  const auto count = static_cast<Eigen::Index>(values_.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      const double rank = rank_correlation(values_[static_cast<std::size_t>(i)],
                                           values_[static_cast<std::size_t>(k)]);
      normal(i, k) = normal(k, i) = 2.0 * std::sin(kPi * rank / 6.0);
    }
  }
  // Correlations found one by one need not be possible together.
  for (;; removed_correlation_ = std::min(1.0, removed_correlation_ + kWeaker)) {
    const Eigen::MatrixXd tried = (1.0 - removed_correlation_) * normal +
                                  removed_correlation_ * Eigen::MatrixXd::Identity(count, count);
    const Eigen::LLT<Eigen::MatrixXd> factor(tried);
    const Eigen::MatrixXd lower = factor.matrixL();
    if (factor.info() != Eigen::Success || lower.diagonal().minCoeff() < kMinPivot) continue;
    for (Eigen::Index i = 0; i < count; ++i) {
      mixing_.emplace_back();
      for (Eigen::Index k = 0; k <= i; ++k) mixing_.back().push_back(lower(i, k));
    }
    break;
  }
}

BlockForm FormCopula::sample(Random& random) const {
  std::vector<double> free, drawn;
  for (std::size_t i = 0; i < sorted_.size(); ++i) free.push_back(random.normal());
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    double normal = 0.0;
    for (std::size_t k = 0; k <= i; ++k) normal += mixing_[i][k] * free[k];
    drawn.push_back(quantile(sorted_[i], std::clamp(normal_cdf(normal), 0.0, 1.0)));
  }
  const double L = std::exp(drawn[0]), I = drawn[1] * L;
  BlockForm block;
  block.axes = {L, I, drawn[2] * I};
  if (has_convexity_) block.convexity = drawn[3];
  return block;
}

CopulaFit FormCopula::assess_fit(std::span<const BlockForm> drawn) const {
  CopulaFit fit;
  fit.removed_correlation = removed_correlation_;
  const Values values = measure_values(drawn, has_convexity_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::optional<TestResult> ks = two_sample_ks_test(values_[i], values[i]);
    if (ks) fit.max_cdf_difference = std::max(fit.max_cdf_difference, ks->statistic);
    for (std::size_t k = 0; k < i; ++k) {
      fit.correlations.push_back({kNames[k], kNames[i], rank_correlation(values_[k], values_[i]),
                                  rank_correlation(values[k], values[i])});
    }
  }
  return fit;
}

}  // namespace clast
