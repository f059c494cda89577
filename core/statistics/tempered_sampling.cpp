#include "core/statistics/tempered_sampling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Weights of draws whose likelihood is raised by a further power, before they are scaled to sum
/// one: in units of the greatest.
VectorXd weights_of(const VectorXd& log_likelihood, double power) {
  const VectorXd logarithms = power * log_likelihood;
  return (logarithms.array() - logarithms.maxCoeff()).exp();
}

double effective(const VectorXd& weights) {
  const double sum = weights.sum();
  return sum * sum / weights.squaredNorm();
}

/// The further power that leaves the asked number of draws effective, at most `most`.
double next_power(const VectorXd& log_likelihood, double asked, double most) {
  if (effective(weights_of(log_likelihood, most)) >= asked) return most;
  double low = 0.0, high = most;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (effective(weights_of(log_likelihood, middle)) >= asked ? low : high) = middle;
  }
  return low > 0.0 ? low : high;
}

/// Systematic resampling: draws as often as their weights say, up to rounding.
void resample(const VectorXd& weights, Random& random, TemperedSample& sample) {
  const Index count = weights.size();
  const double each = weights.sum() / static_cast<double>(count);
  double at = random.uniform() * each, reached = weights[0];
  MatrixXd points = sample.points;
  VectorXd logs = sample.log_likelihood;
  for (Index i = 0, from = 0; i < count; ++i, at += each) {
    while (reached < at && from + 1 < count) reached += weights[++from];
    points.col(i) = sample.points.col(from);
    logs[i] = sample.log_likelihood[from];
  }
  sample.points = std::move(points);
  sample.log_likelihood = std::move(logs);
}

/// Reflected at 0 and 1 until it lies between.
double folded_in(double x) {
  x = std::abs(std::fmod(x, 2.0));
  return x > 1.0 ? 2.0 - x : x;
}

/// The triangle that turns independent normal numbers into ones with the draws' covariance.
MatrixXd spread_of(const MatrixXd& points) {
  constexpr double kLeast = 1e-10;  // variance, for draws that all coincide
  const VectorXd mean = points.rowwise().mean();
  const MatrixXd about = points.colwise() - mean;
  MatrixXd covariance = about * about.transpose() / static_cast<double>(points.cols());
  covariance.diagonal().array() += kLeast;
  return covariance.llt().matrixL();
}

/// Metropolis moves of all draws at a temperature.
void move(const LogLikelihood& log_likelihood, double power, int moves, double& scale,
          Random& random, TemperedSample& sample) {
  constexpr double kAimed = 0.3;
  const Index count = sample.points.cols(), dimensions = sample.points.rows();
  const MatrixXd spread = spread_of(sample.points);
  for (int step = 0; step < moves; ++step) {
    MatrixXd proposed(dimensions, count);
    for (Index i = 0; i < proposed.size(); ++i) proposed.data()[i] = random.normal();
    proposed = (sample.points + scale * (spread * proposed)).unaryExpr(&folded_in).eval();
    const VectorXd logs = log_likelihood(proposed);
    Index accepted = 0;
    for (Index i = 0; i < count; ++i) {
      // Drawn in any case, so that the draws after it do not depend on this one.
      const double level = std::log(1.0 - random.uniform());
      if (!(level < power * (logs[i] - sample.log_likelihood[i]))) continue;
      sample.points.col(i) = proposed.col(i);
      sample.log_likelihood[i] = logs[i];
      ++accepted;
    }
    sample.acceptance_rate = static_cast<double>(accepted) / static_cast<double>(count);
    scale = std::clamp(scale * std::exp(sample.acceptance_rate - kAimed), 1e-3, 10.0);
  }
}

}  // namespace

void TemperedSamplingOptions::check() const {
  const auto refuse = [](const std::string& field, double value) {
    throw InputError("tempered sampling: " + field + " " + format_significant(value, 6) +
                     " is out of range");
  };
  if (draws < 10 || draws > 1'000'000) refuse("draws", static_cast<double>(draws));
  if (!(effective_fraction > 0.0 && effective_fraction < 1.0)) refuse("kept", effective_fraction);
  if (moves < 1 || moves > 10'000) refuse("moves", moves);
}

TemperedSample draw_tempered_sample(std::size_t dimensions, const LogLikelihood& log_likelihood,
                                    const TemperedSamplingOptions& options) {
  options.check();
  const auto count = static_cast<Index>(options.draws);
  Random random(options.seed);
  TemperedSample sample;
  sample.points.resize(static_cast<Index>(dimensions), count);
  for (Index i = 0; i < sample.points.size(); ++i) sample.points.data()[i] = random.uniform();
  sample.log_likelihood = log_likelihood(sample.points);
  if (!(sample.log_likelihood.array() > -1e300).any()) {
    throw InputError("the likelihood is zero or not a number for all " +
                     std::to_string(options.draws) + " initial draws");
  }
  double scale = 2.38 / std::sqrt(static_cast<double>(dimensions));
  for (double power = 0.0; power < 1.0; ++sample.tempering_steps) {
    const double further =
        next_power(sample.log_likelihood, options.effective_fraction * static_cast<double>(count),
                   1.0 - power);
    const VectorXd weights = weights_of(sample.log_likelihood, further);
    sample.log_evidence += further * sample.log_likelihood.maxCoeff() + std::log(weights.mean());
    power = further >= 1.0 - power ? 1.0 : power + further;
    resample(weights, random, sample);
    move(log_likelihood, power, options.moves, scale, random, sample);
  }
  return sample;
}

}  // namespace clast
