#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/optimal_bounding_box.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/random.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

double cgal_box_volume(const std::vector<Vec3>& points) {
  std::vector<Kernel::Point_3> input;
  for (const Vec3& p : points) input.emplace_back(p.x(), p.y(), p.z());
  std::array<Kernel::Point_3, 8> corners;
  CGAL::oriented_bounding_box(input, corners);
  const auto side = [&](int corner) {
    return std::sqrt(CGAL::squared_distance(corners[0], corners[corner]));
  };
  return side(1) * side(3) * side(5);
}

// Two searches that share no method; CGAL's evolutionary one may only be worse.
TEST(SmallestBox, IsNeverLargerThanCgalsOnRandomHulls) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const std::uint64_t count = 8 + random.uniform_index(100);
    const Vec3 axes(1.0, random.uniform(0.3, 1.0), random.uniform(0.2, 1.0));
    std::vector<Vec3> points;
    for (std::uint64_t i = 0; i < count; ++i) {
      points.push_back(random.unit_vector().cwiseProduct(axes) * random.uniform(0.7, 1.0));
    }
    EXPECT_LE(smallest_box(points).volume(), cgal_box_volume(points) * (1.0 + 1e-9))
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace clast
