#include "core/statistics/gaussian_process.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/statistics/sobol_sequence.hpp"
#include "core/types.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd even_places(std::size_t dimensions, std::size_t count, std::uint64_t seed = 3) {
  SobolSequence sequence(dimensions, seed);
  MatrixXd places(dimensions, count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> point = sequence.next_point();
    for (std::size_t d = 0; d < dimensions; ++d) {
      places(static_cast<Eigen::Index>(d), static_cast<Eigen::Index>(i)) = point[d];
    }
  }
  return places;
}

double smooth(const VectorXd& x) { return std::sin(3.0 * x[0]) + x[1] * x[1]; }

VectorXd values_at(const MatrixXd& places) {
  VectorXd values(places.cols());
  for (Eigen::Index i = 0; i < places.cols(); ++i) values[i] = smooth(places.col(i));
  return values;
}

class BothKernels : public testing::TestWithParam<std::string> {
 protected:
  static Kernel kernel() {
    return GetParam() == "matern-5/2" ? Kernel::kMatern52 : Kernel::kSquaredExponential;
  }
  GaussianProcessOptions options() const {
    GaussianProcessOptions options;
    options.kernel = kernel();
    return options;
  }
};
INSTANTIATE_TEST_SUITE_P(Kernels, BothKernels,
                         testing::Values("matern-5/2", "squared exponential"));

TEST_P(BothKernels, GoThroughValuesWithoutNoise) {
  const MatrixXd places = even_places(2, 20);
  const GaussianProcess process(places, values_at(places), {VectorXd::Constant(2, 0.7), 1e-8},
                                kernel());
  const GaussianProcess::Prediction at = process.predict(places);
  EXPECT_LT((at.mean - values_at(places)).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT(at.variance.maxCoeff(), 1e-6 * process.variance());
}

// Far from all values nothing is known but the mean and the variance, and the mean has an error.
TEST_P(BothKernels, GoBackToTheMeanFarFromValues) {
  const MatrixXd places = even_places(2, 12);
  const GaussianProcess process(places, values_at(places), {VectorXd::Constant(2, 0.02), 1e-6},
                                kernel());
  const GaussianProcess::Prediction far = process.predict(MatrixXd::Constant(2, 1, 50.0));
  // So short a length makes the values independent: their mean and variance, by the textbook.
  const VectorXd values = values_at(places);
  const double mean = values.mean();
  const double variance = (values.array() - mean).square().sum() / 11.0;
  EXPECT_NEAR(far.mean[0], mean, 1e-4);
  EXPECT_NEAR(far.variance[0], variance * (1.0 + 1.0 / 12.0), 1e-3 * variance);
}

// A nugget without end leaves independent values around their mean.
TEST_P(BothKernels, AreTheMeanOfTheValuesWhereAllIsNoise) {
  const MatrixXd places = even_places(2, 15);
  const VectorXd values = values_at(places);
  const GaussianProcess process(places, values, {VectorXd::Constant(2, 0.5), 1e9}, kernel());
  EXPECT_NEAR(process.predict(places).mean[4], values.mean(), 1e-6);
  EXPECT_NEAR(process.noise_variance(), (values.array() - values.mean()).square().sum() / 14.0,
              1e-6);
}

TEST_P(BothKernels, FindASmoothFunctionAndItsError) {
  const MatrixXd places = even_places(2, 40), elsewhere = even_places(2, 200, 8);
  const GaussianProcess process(places, values_at(places), options());
  const GaussianProcess::Prediction found = process.predict(elsewhere);
  const VectorXd errors = found.mean - values_at(elsewhere);
  EXPECT_LT(errors.cwiseAbs().maxCoeff(), 0.02);
  // The error that it expects is of the size of the error that it has.
  const double expected = std::sqrt(found.variance.mean());
  const double had = std::sqrt(errors.squaredNorm() / 200.0);
  EXPECT_LT(had, 3.0 * expected);
}

TEST_P(BothKernels, FindNoiseAndACoordinateWithoutInfluence) {
  const MatrixXd places = even_places(3, 120);
  Random random(5);
  VectorXd values(120);
  for (Eigen::Index i = 0; i < 120; ++i) values[i] = smooth(places.col(i)) + 0.1 * random.normal();
  const GaussianProcess process(places, values, options());
  EXPECT_NEAR(std::sqrt(process.noise_variance()), 0.1, 0.02);
  EXPECT_GT(process.hyperparameters().length_scales[2],
            5.0 * process.hyperparameters().length_scales[0]);
}

// By definition: the process without a value, its shape the same, says what that value would be.
TEST_P(BothKernels, LeaveOneOutIsWhatARefitSays) {
  const MatrixXd places = even_places(2, 14);
  VectorXd values = values_at(places);
  values[3] += 0.2;
  const GaussianProcessHyperparameters shape{VectorXd::Constant(2, 0.6), 0.02};
  const GaussianProcess process(places, values, shape, kernel());
  const GaussianProcess::LeaveOneOut left = process.leave_one_out();
  for (Eigen::Index out = 0; out < 14; ++out) {
    MatrixXd others(2, 13);
    VectorXd those(13);
    for (Eigen::Index i = 0, at = 0; i < 14; ++i) {
      if (i == out) continue;
      others.col(at) = places.col(i);
      those[at++] = values[i];
    }
    const GaussianProcess refit(others, those, shape, kernel());
    const GaussianProcess::Prediction says = refit.predict(places.col(out));
    EXPECT_NEAR(left.error[out], values[out] - says.mean[0], 1e-9);
    const double relative = says.variance[0] / refit.variance() + shape.nugget;
    EXPECT_NEAR(left.variance[out] / process.variance(), relative, 1e-9);
  }
}

// Slopes of the likelihood, with the belief in little influence, vanish where it is greatest.
TEST_P(BothKernels, NoShapeNearbyIsLikelier) {
  const auto weighed = [](const GaussianProcess& process) {
    return process.log_likelihood() - process.hyperparameters().length_scales.cwiseInverse().sum();
  };
  const MatrixXd places = even_places(2, 40);
  Random random(11);
  VectorXd values = values_at(places);
  for (double& value : values) value += 0.05 * random.normal();
  const GaussianProcess best(places, values, options());
  for (const double factor : {0.9, 1.1}) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      GaussianProcessHyperparameters shape = best.hyperparameters();
      (i < 2 ? shape.length_scales[i] : shape.nugget) *= factor;
      EXPECT_LE(weighed(GaussianProcess(places, values, shape, kernel())), weighed(best) + 1e-3);
    }
  }
}

TEST(GaussianProcess, EqualValuesAreThatValue) {
  const GaussianProcess process(even_places(2, 5), VectorXd::Constant(5, 7.5));
  const GaussianProcess::Prediction says = process.predict(even_places(2, 3, 9));
  EXPECT_NEAR(says.mean[1], 7.5, 1e-9);
  EXPECT_NEAR(says.variance[1], 0.0, 1e-12);
}

TEST(GaussianProcess, ShiftedAndScaledValuesGiveTheSameShape) {
  const MatrixXd places = even_places(2, 30), other = even_places(2, 5, 8);
  const VectorXd values = values_at(places), scaled = 1e3 * values.array() + 5e6;
  const GaussianProcess a(places, values), b(places, scaled);
  EXPECT_NEAR(a.hyperparameters().length_scales[0], b.hyperparameters().length_scales[0], 1e-3);
  EXPECT_NEAR(1e3 * a.predict(other).mean[2] + 5e6, b.predict(other).mean[2], 1e-2);
}

TEST(GaussianProcess, TooFewPlacesAndSenselessBoundsAreRefused) {
  EXPECT_EQ(
      refusal<InputError>([] { GaussianProcess(MatrixXd(2, 2), VectorXd(2)); }),
      "a Gaussian process needs at least three points with a value each; there are 2 points and 2 "
      "values");
  GaussianProcessOptions options;
  options.max_length_scale = 0.01;
  EXPECT_EQ(refusal<InputError>([&] { options.check(); }),
            "a Gaussian process: longest 0.01 is out of range");
}

}  // namespace
}  // namespace clast
