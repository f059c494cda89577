// Statistics of axes, against directions written by hand and by how often tests reject.
#include "core/statistics/axial_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "core/types.hpp"

namespace clast {
namespace {

constexpr double kDegree = kPi / 180.0;

std::vector<double> in_rad(std::vector<double> degrees) {
  for (double& angle : degrees) angle *= kDegree;
  return degrees;
}

TEST(AxialAngle, IsTheSameFromEitherEnd) {
  for (const double degrees : {-400.0, -90.0, -45.0, 0.0, 30.0, 89.0, 90.0, 91.0, 180.0, 270.0}) {
    const double angle = wrap_axial_angle(degrees * kDegree);
    EXPECT_GT(angle, -0.5 * kPi - 1e-12);
    EXPECT_LE(angle, 0.5 * kPi + 1e-12);
    EXPECT_NEAR(std::sin(angle - degrees * kDegree), 0.0, 1e-12) << degrees;
  }
}

TEST(AxialMean, OfOppositeEndsIsTheirLine) {
  // As vectors the first two cancel.
  const AxialMean mean = axial_mean(in_rad({20.0, 200.0, -160.0}));
  EXPECT_NEAR(mean.direction, 20.0 * kDegree, 1e-12);
  EXPECT_NEAR(mean.resultant_length, 1.0, 1e-12);
}

TEST(AxialMean, IsTheBisectorAndTheCosineOfTheSpread) {
  // Doubled angles of +-15 degrees about 80: R = cos 30.
  const AxialMean mean = axial_mean(in_rad({65.0, 95.0}));
  EXPECT_NEAR(mean.direction, 80.0 * kDegree, 1e-12);
  EXPECT_NEAR(mean.resultant_length, std::sqrt(3.0) / 2.0, 1e-12);
}

TEST(AxialMean, OfEvenDirectionsHasNone) {
  const AxialMean mean = axial_mean(in_rad({0.0, 60.0, 120.0}));
  EXPECT_NEAR(mean.resultant_length, 0.0, 1e-12);
  EXPECT_TRUE(std::isnan(mean.direction));
  EXPECT_EQ(axial_mean({}).count, 0u);
}

TEST(Rayleigh, OfManyAxesIsTheExponential) {
  EXPECT_NEAR(rayleigh_p_value({1'000'000, 0.0, 0.002}), std::exp(-4.0), 1e-6);
  EXPECT_EQ(rayleigh_p_value({}), 1.0);
}

TEST(Rayleigh, RejectsEvenDirectionsAsOftenAsItSays) {
  Random random(5);
  for (const std::size_t count : {8u, 60u}) {
    int rejected = 0;
    constexpr int kStudies = 8000;
    for (int study = 0; study < kStudies; ++study) {
      std::vector<double> angles(count);
      for (double& angle : angles) angle = random.uniform(-0.5 * kPi, 0.5 * kPi);
      rejected += rayleigh_p_value(axial_mean(angles)) < 0.05;
    }
    // Three standard deviations of the count are 0.7 %.
    EXPECT_NEAR(static_cast<double>(rejected) / kStudies, 0.05, 0.008) << count;
  }
}

/// Axes that are parallel within a cluster, each cluster in a direction of its own.
TEST(Rayleigh, OfClustersIsNotDeceivedByAxesThatAlignEachOther) {
  Random random(6);
  int rejected = 0, rejected_alone = 0;
  constexpr int kStudies = 1000;
  for (int study = 0; study < kStudies; ++study) {
    ClusteredValues angles;
    for (std::uint32_t cluster = 0; cluster < 6; ++cluster) {
      const double direction = random.uniform(0.0, kPi);
      for (int i = 0; i < 10; ++i) {
        angles.values.push_back(direction + 0.3 * random.normal());
        angles.clusters.push_back(cluster);
      }
    }
    rejected += *clustered_rayleigh_p_value(angles, 6, 9, 199) <= 0.05;
    rejected_alone += rayleigh_p_value(axial_mean(angles.values)) < 0.05;
  }
  EXPECT_NEAR(static_cast<double>(rejected) / kStudies, 0.05, 0.021);
  EXPECT_GT(rejected_alone, kStudies / 2);
}

TEST(Rayleigh, OfClustersFindsOneDirectionOfAll) {
  ClusteredValues angles;
  for (std::uint32_t i = 0; i < 40; ++i) {
    angles.values.push_back(0.2 + 0.01 * (i % 7));
    angles.clusters.push_back(i % 8);
  }
  EXPECT_LT(*clustered_rayleigh_p_value(angles, 8, 1), 0.001);
  angles.clusters.assign(40, 3);
  EXPECT_FALSE(clustered_rayleigh_p_value(angles, 8, 1));
}

}  // namespace
}  // namespace clast
