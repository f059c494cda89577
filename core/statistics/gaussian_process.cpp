#include "core/statistics/gaussian_process.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Squared distances of all pairs of two sets, each coordinate in units of its length.
MatrixXd squared_distances(const MatrixXd& a, const MatrixXd& b, const VectorXd& length_scales) {
  MatrixXd squares = MatrixXd::Zero(a.cols(), b.cols());
  for (Index j = 0; j < b.cols(); ++j) {
    for (Index i = 0; i < a.cols(); ++i) {
      double sum = 0.0;
      for (Index d = 0; d < a.rows(); ++d) {
        const double apart = (a(d, i) - b(d, j)) / length_scales[d];
        sum += apart * apart;
      }
      squares(i, j) = sum;
    }
  }
  return squares;
}

double kernel_correlation(Kernel kernel, double square) {
  if (kernel == Kernel::kSquaredExponential) return std::exp(-0.5 * square);
  const double r = std::sqrt(5.0 * square);
  return (1.0 + r + r * r / 3.0) * std::exp(-r);
}

/// Change of the correlation with the logarithm of a length, over the square of that coordinate's
/// distance in units of its length.
double slope(Kernel kernel, double square) {
  if (kernel == Kernel::kSquaredExponential) return std::exp(-0.5 * square);
  const double r = std::sqrt(5.0 * square);
  return 5.0 / 3.0 * (1.0 + r) * std::exp(-r);
}

MatrixXd correlations(const MatrixXd& a, const MatrixXd& b,
                      const GaussianProcessHyperparameters& hyperparameters, Kernel kernel) {
  MatrixXd matrix = squared_distances(a, b, hyperparameters.length_scales);
  for (Index i = 0; i < matrix.size(); ++i) {
    matrix.data()[i] = kernel_correlation(kernel, matrix.data()[i]);
  }
  return matrix;
}

/// The restricted log-likelihood with variance and mean at their best, and its gradient.
struct Likelihood {
  double value = 0.0;
  VectorXd gradient;  ///< by the logarithms of the lengths, then of the nugget
};

Likelihood likelihood_of(const MatrixXd& points, const VectorXd& values,
                         const GaussianProcessHyperparameters& hyperparameters, Kernel kernel) {
  const Index count = points.cols(), dimensions = points.rows();
  const MatrixXd squares = squared_distances(points, points, hyperparameters.length_scales);
  MatrixXd matrix(count, count);
  for (Index i = 0; i < matrix.size(); ++i) {
    matrix.data()[i] = kernel_correlation(kernel, squares.data()[i]);
  }
  matrix.diagonal().array() += hyperparameters.nugget;
  const Eigen::LLT<MatrixXd> factor(matrix);
  MatrixXd projected = factor.solve(MatrixXd::Identity(count, count));
  const VectorXd ones = projected.rowwise().sum();
  const double total = ones.sum();
  projected -= ones * ones.transpose() / total;
  const VectorXd weights = projected * values;
  const double squared = values.dot(weights);
  const auto degrees_of_freedom = static_cast<double>(count - 1);
  Likelihood result;
  result.value =
      -0.5 * (degrees_of_freedom * std::log(squared / degrees_of_freedom) + std::log(total)) -
      MatrixXd(factor.matrixL()).diagonal().array().log().sum();
  // Half of freedom a a'/squared - Q, against which every derivative is summed.
  const MatrixXd pull =
      0.5 * (degrees_of_freedom / squared * weights * weights.transpose() - projected);
  result.gradient = VectorXd::Zero(dimensions + 1);
  for (Index j = 0; j < count; ++j) {
    for (Index i = 0; i < count; ++i) {
      const double part = pull(i, j) * slope(kernel, squares(i, j));
      for (Index d = 0; d < dimensions; ++d) {
        const double apart = (points(d, i) - points(d, j)) / hyperparameters.length_scales[d];
        result.gradient[d] += part * apart * apart;
      }
    }
  }
  result.gradient[dimensions] = hyperparameters.nugget * pull.trace();
  return result;
}

GaussianProcessHyperparameters shape_of(const VectorXd& logarithms) {
  const Index dimensions = logarithms.size() - 1;
  return {logarithms.head(dimensions).array().exp(), std::exp(logarithms[dimensions])};
}

/// The best shape that steps from `start` come upon, and its likelihood.
std::pair<VectorXd, double> climb(const MatrixXd& points, const VectorXd& values,
                                  const GaussianProcessOptions& options, VectorXd at) {
  constexpr double kFirst = 0.3, kMost = 1.0, kLeast = 1e-3, kGrow = 1.2, kShrink = 0.5;
  const Index count = at.size();
  VectorXd low = VectorXd::Constant(count, std::log(options.min_length_scale));
  VectorXd high = VectorXd::Constant(count, std::log(options.max_length_scale));
  low[count - 1] = std::log(options.min_nugget);
  high[count - 1] = std::log(options.max_nugget);
  VectorXd steps = VectorXd::Constant(count, kFirst), before = VectorXd::Zero(count);
  VectorXd best = at;
  double most = -1e300;
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const GaussianProcessHyperparameters hyperparameters = shape_of(at);
    Likelihood here = likelihood_of(points, values, hyperparameters, options.kernel);
    const VectorXd belief = options.shrinkage * hyperparameters.length_scales.cwiseInverse();
    here.value -= belief.sum();
    here.gradient.head(belief.size()) += belief;
    if (here.value > most) {
      most = here.value;
      best = at;
    }
    for (Index i = 0; i < count; ++i) {
      const double turned = here.gradient[i] * before[i];
      if (turned > 0.0) steps[i] = std::min(kMost, kGrow * steps[i]);
      if (turned < 0.0) {
        steps[i] *= kShrink;
        here.gradient[i] = 0.0;  // the next step is taken from there as if it were the first
      }
      const double sign = here.gradient[i] > 0.0 ? 1.0 : here.gradient[i] < 0.0 ? -1.0 : 0.0;
      at[i] = std::clamp(at[i] + sign * steps[i], low[i], high[i]);
    }
    before = here.gradient;
    if (steps.maxCoeff() < kLeast) break;
  }
  return {best, most};
}

GaussianProcessHyperparameters best_shape(const MatrixXd& points, const VectorXd& values,
                                          const GaussianProcessOptions& options) {
  // A wavy function with little noise, and a smooth one with more.
  constexpr double kStarts[2][2] = {{0.5, 0.01}, {2.0, 0.1}};
  std::pair<VectorXd, double> best{VectorXd(), -2e300};
  for (const auto& [length, nugget] : kStarts) {
    VectorXd start = VectorXd::Constant(points.rows() + 1, std::log(length));
    start[points.rows()] = std::log(nugget);
    const std::pair<VectorXd, double> found = climb(points, values, options, start);
    if (found.second > best.second) best = found;
  }
  return shape_of(best.first);
}

}  // namespace

void GaussianProcessOptions::check() const {
  const auto refuse = [](const std::string& field, double value) {
    throw InputError("a Gaussian process: " + field + " " + format_significant(value, 6) +
                     " is out of range");
  };
  if (!(min_length_scale > 0.0)) refuse("shortest", min_length_scale);
  if (!(max_length_scale > min_length_scale)) refuse("longest", max_length_scale);
  if (!(min_nugget > 0.0)) refuse("smallest_nugget", min_nugget);
  if (!(max_nugget > min_nugget)) refuse("largest_nugget", max_nugget);
  if (!(shrinkage >= 0.0)) refuse("shrinkage", shrinkage);
  if (iterations < 1) refuse("iterations", iterations);
}

GaussianProcess::GaussianProcess(const MatrixXd& points, const VectorXd& values,
                                 const GaussianProcessOptions& options)
    : kernel_(options.kernel), points_(points), values_(values) {
  options.check();
  if (points.cols() < 3 || points.cols() != values.size()) {
    throw InputError(
        "a Gaussian process needs at least three points with a value each; there are " +
        std::to_string(points.cols()) + " points and " + std::to_string(values.size()) + " values");
  }
  const double spread = values.maxCoeff() - values.minCoeff();
  hyperparameters_ = {VectorXd::Constant(points.rows(), options.max_length_scale),
                      options.min_nugget};
  if (spread > 0.0) {
    const VectorXd scaled = (values.array() - values.minCoeff()) / spread;
    hyperparameters_ = best_shape(points, scaled, options);
  }
  solve();
}

GaussianProcess::GaussianProcess(const MatrixXd& points, const VectorXd& values,
                                 const GaussianProcessHyperparameters& hyperparameters,
                                 Kernel kernel)
    : kernel_(kernel), points_(points), values_(values), hyperparameters_(hyperparameters) {
  solve();
}

void GaussianProcess::solve() {
  const Index count = points_.cols();
  MatrixXd matrix = correlations(points_, points_, hyperparameters_, kernel_);
  matrix.diagonal().array() += hyperparameters_.nugget;
  const Eigen::LLT<MatrixXd> factor(matrix);
  factor_ = factor.matrixL();
  ones_ = factor.solve(VectorXd::Ones(count));
  const double total = ones_.sum();
  mean_ = ones_.dot(values_) / total;
  const VectorXd about = values_.array() - mean_;
  weights_ = factor.solve(about);
  const auto degrees_of_freedom = static_cast<double>(count - 1);
  variance_ = std::max(0.0, about.dot(weights_) / degrees_of_freedom);
  log_likelihood_ = -0.5 * (degrees_of_freedom * std::log(variance_) + std::log(total)) -
                    factor_.diagonal().array().log().sum();
}

VectorXd GaussianProcess::predict_mean(const MatrixXd& points) const {
  const MatrixXd across = correlations(points_, points, hyperparameters_, kernel_);
  return (across.transpose() * weights_).array() + mean_;
}

GaussianProcess::Prediction GaussianProcess::predict(const MatrixXd& points) const {
  const MatrixXd across = correlations(points_, points, hyperparameters_, kernel_);
  Prediction prediction;
  prediction.mean = (across.transpose() * weights_).array() + mean_;
  const VectorXd missing = 1.0 - (across.transpose() * ones_).array();
  const MatrixXd known = factor_.triangularView<Eigen::Lower>().solve(across);
  prediction.variance = variance_ * (1.0 - known.colwise().squaredNorm().transpose().array() +
                                     missing.array().square() / ones_.sum())
                                        .max(0.0);
  return prediction;
}

GaussianProcess::LeaveOneOut GaussianProcess::leave_one_out() const {
  const Index count = points_.cols();
  // Inverse correlations, projected off the mean, which is found without the value too.
  MatrixXd projected =
      factor_.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(count, count));
  projected = (projected.transpose() * projected).eval();
  projected -= ones_ * ones_.transpose() / ones_.sum();
  const VectorXd diagonal = projected.diagonal();
  return {(projected * values_).array() / diagonal.array(), variance_ / diagonal.array()};
}

}  // namespace clast
