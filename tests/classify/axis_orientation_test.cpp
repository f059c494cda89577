#include "classify/axis_orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.hpp"

namespace clast {
namespace {

constexpr double kDegree = kRadiansPerDegree;

TEST(AxisOrientation, IsThatOfTheLowerEnd) {
  for (const double trend : {10.0, 100.0, 190.0, 280.0, 359.0}) {
    for (const double plunge : {1.0, 30.0, 89.0}) {
      const double t = trend * kDegree, p = plunge * kDegree;
      const Vec3 lower(std::sin(t) * std::cos(p), std::cos(t) * std::cos(p), -std::sin(p));
      for (const double sign : {2.5, -0.1}) {
        const AxisOrientation found = axis_orientation(sign * lower);
        EXPECT_NEAR(found.trend / kDegree, trend, 1e-9);
        EXPECT_NEAR(found.plunge / kDegree, plunge, 1e-9);
      }
    }
  }
}

TEST(AxisOrientation, OfAHorizontalAxisIsBelowHalfATurn) {
  EXPECT_DOUBLE_EQ(axis_orientation({0.0, -2.0, 0.0}).trend, 0.0);
  EXPECT_DOUBLE_EQ(axis_orientation({-1.0, 0.0, 0.0}).trend, 90.0 * kDegree);
  EXPECT_DOUBLE_EQ(axis_orientation({-1.0, 1.0, 0.0}).trend, 135.0 * kDegree);
  EXPECT_DOUBLE_EQ(axis_orientation({-1.0, 1.0, 0.0}).plunge, 0.0);
}

TEST(AxisOrientation, OfAVerticalAxisIsAllPlunge) {
  EXPECT_DOUBLE_EQ(axis_orientation({0.0, 0.0, 1.0}).plunge, 90.0 * kDegree);
  EXPECT_DOUBLE_EQ(axis_orientation({0.0, 0.0, 1.0}).trend, 0.0);
}

}  // namespace
}  // namespace clast
