#include "core/statistics/sobol_sequence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/error.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

std::vector<std::vector<double>> points_of(SobolSequence sequence, std::size_t count) {
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(sequence.next_point());
  return points;
}

// The first ten points that Joe and Kuo publish with their direction numbers.
TEST(SobolSequence, BeginsAsPublished) {
  const std::vector<std::vector<double>> published = {{0, 0, 0},
                                                      {0.5, 0.5, 0.5},
                                                      {0.75, 0.25, 0.25},
                                                      {0.25, 0.75, 0.75},
                                                      {0.375, 0.375, 0.625},
                                                      {0.875, 0.875, 0.125},
                                                      {0.625, 0.125, 0.875},
                                                      {0.125, 0.625, 0.375},
                                                      {0.1875, 0.3125, 0.9375},
                                                      {0.6875, 0.8125, 0.4375}};
  EXPECT_EQ(points_of(SobolSequence(3), published.size()), published);
}

// Sobol's property A, which a wrong direction number of any dimension breaks.
TEST(SobolSequence, EveryHalvedCubeHasOnePoint) {
  for (const std::size_t dimensions : {std::size_t{3}, std::size_t{12}, kMaxSobolDimensions}) {
    SobolSequence sequence(dimensions);
    const std::size_t count = std::size_t{1} << dimensions;
    std::vector<bool> seen(count, false);
    std::size_t cubes = 0;
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t cube = 0;
      for (const double x : sequence.next_point()) cube = 2 * cube + (x >= 0.5 ? 1 : 0);
      if (!seen[cube]) ++cubes;
      seen[cube] = true;
    }
    EXPECT_EQ(cubes, count) << dimensions;
  }
}

TEST(SobolSequence, ScrambledCoordinatesAreAsEven) {
  constexpr std::size_t kCount = 256;
  for (const std::uint64_t seed : {1u, 2u, 77u}) {
    const auto points = points_of(SobolSequence(kMaxSobolDimensions, seed), kCount);
    for (std::size_t d = 0; d < kMaxSobolDimensions; ++d) {
      std::set<int> parts;
      for (const auto& point : points) parts.insert(static_cast<int>(point[d] * kCount));
      EXPECT_EQ(parts.size(), kCount) << "dimension " << d;
    }
    // The first two dimensions are a (0, 8, 2)-net in base 2: every 16 x 16 cell has one point.
    std::set<std::pair<int, int>> cells;
    for (const auto& point : points) {
      cells.emplace(static_cast<int>(point[0] * 16), static_cast<int>(point[1] * 16));
    }
    EXPECT_EQ(cells.size(), kCount);
  }
}

// The integral of prod (1 + (x_i - 1/2)) is 1; by random points it has the standard error
// sqrt(((1 + 1/12)^6 - 1)/1024) = 0.025.
TEST(SobolSequence, IntegratesFarBetterThanChance) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    double sum = 0.0;
    for (const auto& point : points_of(SobolSequence(6, seed), 1024)) {
      double product = 1.0;
      for (const double x : point) product *= 0.5 + x;
      sum += product;
    }
    EXPECT_NEAR(sum / 1024.0, 1.0, 0.0025) << seed;
  }
}

TEST(SobolSequence, SeedsAndDimensionsDoNotDisturbEachOther) {
  const auto few = points_of(SobolSequence(2, 9), 20), many = points_of(SobolSequence(5, 9), 20);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i][0], many[i][0]);
    EXPECT_EQ(few[i][1], many[i][1]);
  }
  EXPECT_NE(few, points_of(SobolSequence(2, 10), 20));
}

TEST(SobolSequence, DimensionsOutsideOfTheTableAreRefused) {
  EXPECT_EQ(refusal<InputError>([] { SobolSequence(0, 1); }),
            "a Sobol sequence of 0 dimensions: must be from 1 to 21");
  EXPECT_EQ(refusal<InputError>([] { SobolSequence(22); }),
            "a Sobol sequence of 22 dimensions: must be from 1 to 21");
}

}  // namespace
}  // namespace clast
