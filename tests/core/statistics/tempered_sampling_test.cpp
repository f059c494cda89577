#include "core/statistics/tempered_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/types.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Two normal coordinates that go together by 0.9, about (0.4, 0.6), and a third without influence.
constexpr double kSpread = 0.05, kTogether = 0.9;
VectorXd ridge(const MatrixXd& places) {
  VectorXd logs(places.cols());
  for (Index i = 0; i < places.cols(); ++i) {
    const double x = (places(0, i) - 0.4) / kSpread, y = (places(1, i) - 0.6) / kSpread;
    logs[i] = -0.5 * (x * x - 2.0 * kTogether * x * y + y * y) / (1.0 - kTogether * kTogether);
  }
  return logs;
}

TEST(TemperedSampling, FindsARidgeAndLeavesTheRestUniform) {
  const TemperedSample sample = draw_tempered_sample(3, ridge, {.draws = 4000, .seed = 2});
  const VectorXd mean = sample.points.rowwise().mean();
  const MatrixXd about = sample.points.colwise() - mean;
  const MatrixXd covariance = about * about.transpose() / 4000.0;
  // Standard errors: spread/sqrt(4000) = 0.0008 of independent draws; these go together somewhat.
  EXPECT_NEAR(mean[0], 0.4, 0.004);
  EXPECT_NEAR(mean[1], 0.6, 0.004);
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), kSpread, 0.003);
  EXPECT_NEAR(covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1)), kTogether, 0.02);
  EXPECT_NEAR(mean[2], 0.5, 0.02);
  EXPECT_NEAR(covariance(2, 2), 1.0 / 12.0, 0.006);
}

// The integral of the likelihood over the cube: 2 pi s^2 sqrt(1 - r^2).
TEST(TemperedSampling, KnowsTheMeanLikelihood) {
  const double expected =
      std::log(2.0 * kPi * kSpread * kSpread * std::sqrt(1.0 - kTogether * kTogether));
  EXPECT_NEAR(draw_tempered_sample(3, ridge, {.draws = 4000, .seed = 5}).log_evidence, expected,
              0.1);
}

// exp(-20 x) on [0, 1]: the mean is 1/20 but for e^-20, and draws at the side are not lost.
TEST(TemperedSampling, KeepsToTheCubeAtItsSides) {
  const auto likelihood = [](const MatrixXd& places) -> VectorXd { return -20.0 * places.row(0); };
  const TemperedSample sample = draw_tempered_sample(1, likelihood, {.draws = 4000});
  EXPECT_GE(sample.points.minCoeff(), 0.0);
  EXPECT_LE(sample.points.maxCoeff(), 1.0);
  EXPECT_NEAR(sample.points.mean(), 0.05, 0.003);
}

TEST(TemperedSampling, ALevelLikelihoodLeavesTheCubeUniform) {
  const auto level = [](const MatrixXd& places) -> VectorXd {
    return VectorXd::Zero(places.cols());
  };
  const TemperedSample sample = draw_tempered_sample(2, level, {.draws = 3000});
  EXPECT_NEAR(sample.points.row(1).mean(), 0.5, 0.02);
  EXPECT_EQ(sample.tempering_steps, 1u);
  EXPECT_NEAR(sample.log_evidence, 0.0, 1e-12);
}

TEST(TemperedSampling, SeedsDecideEveryBit) {
  const TemperedSample a = draw_tempered_sample(3, ridge, {.draws = 200, .seed = 4});
  EXPECT_EQ(a.points, draw_tempered_sample(3, ridge, {.draws = 200, .seed = 4}).points);
  EXPECT_NE(a.points, draw_tempered_sample(3, ridge, {.draws = 200, .seed = 5}).points);
}

TEST(TemperedSampling, RefusesSenselessOptionsAndALikelihoodThatIsNowhere) {
  EXPECT_EQ(refusal<InputError>([] { draw_tempered_sample(1, ridge, {.draws = 2}); }),
            "tempered sampling: draws 2 is out of range");
  EXPECT_EQ(
      refusal<InputError>([] { draw_tempered_sample(1, ridge, {.effective_fraction = 1.0}); }),
      "tempered sampling: kept 1 is out of range");
  const auto nowhere = [](const MatrixXd& places) -> VectorXd {
    return VectorXd::Constant(places.cols(), -std::numeric_limits<double>::infinity());
  };
  EXPECT_EQ(refusal<InputError>([&] { draw_tempered_sample(1, nowhere, {.draws = 20}); }),
            "the likelihood is zero or not a number for all 20 initial draws");
}

}  // namespace
}  // namespace clast
