#include "core/statistics/sobol_indices.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/types.hpp"

namespace clast {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Ishigami and Homma's function, whose shares are known in closed form.
TEST(SobolIndices, OfIshigamisFunctionAreKnown) {
  constexpr double a = 7.0, b = 0.1;
  const auto ishigami = [](const MatrixXd& places) {
    VectorXd values(places.cols());
    for (Index i = 0; i < places.cols(); ++i) {
      const VectorXd x = kPi * (2.0 * places.col(i).array() - 1.0);
      values[i] =
          std::sin(x[0]) + a * std::pow(std::sin(x[1]), 2) + b * std::pow(x[2], 4) * std::sin(x[0]);
    }
    return values;
  };
  const double p4 = std::pow(kPi, 4), p8 = p4 * p4;
  const double first = 0.5 * std::pow(1.0 + b * p4 / 5.0, 2), second = a * a / 8.0;
  const double both = 8.0 * b * b * p8 / 225.0, all = first + second + both;
  const std::vector<SobolIndices> shares = sobol_indices(4, ishigami, 40'000, 3);
  EXPECT_NEAR(shares[0].first_order, first / all, 0.02);
  EXPECT_NEAR(shares[0].total, (first + both) / all, 0.02);
  EXPECT_NEAR(shares[1].first_order, second / all, 0.02);
  EXPECT_NEAR(shares[1].total, second / all, 0.02);
  EXPECT_NEAR(shares[2].first_order, 0.0, 0.02);
  EXPECT_NEAR(shares[2].total, both / all, 0.02);
  EXPECT_EQ(shares[3].first_order, 0.0);
  EXPECT_EQ(shares[3].total, 0.0);
}

TEST(SobolIndices, OfAConstantAreNone) {
  const auto constant = [](const MatrixXd& places) -> VectorXd {
    return VectorXd::Constant(places.cols(), 5e6);
  };
  for (const SobolIndices& share : sobol_indices(2, constant, 100, 1)) {
    EXPECT_EQ(share.first_order, 0.0);
    EXPECT_EQ(share.total, 0.0);
  }
}

// A large constant costs no digits: shares of x0 + 2 x1 are 1/5 and 4/5.
TEST(SobolIndices, OfASumAreThoseOfItsTerms) {
  const auto sum = [](const MatrixXd& places) -> VectorXd {
    return 5e6 + places.row(0).array() + 2.0 * places.row(1).array();
  };
  const std::vector<SobolIndices> shares = sobol_indices(2, sum, 20'000, 1);
  EXPECT_NEAR(shares[0].first_order, 0.2, 0.02);
  EXPECT_NEAR(shares[1].total, 0.8, 0.02);
}

}  // namespace
}  // namespace clast
