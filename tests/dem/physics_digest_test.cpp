#include "dem/simulation/physics_digest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sstream>

#include "dem/contact/contact_law.hpp"

namespace clast {
namespace {

TEST(PhysicsDigest, IsTheSameAtAnyTimeAndOtherUnderOtherPhysics) {
  EXPECT_EQ(physics_digest().size(), 64u);
  EXPECT_EQ(simulate_reference_motions(), simulate_reference_motions());
  EXPECT_NE(simulate_reference_motions(9.81), simulate_reference_motions(9.8101));
}

/// Lines of the standard motions after the name of a law, or of the world at the end.
std::vector<std::string> lines() {
  std::vector<std::string> all;
  std::istringstream text(simulate_reference_motions());
  for (std::string line; std::getline(text, line);) all.push_back(line);
  return all;
}

std::vector<double> numbers(const std::string& line) {
  std::istringstream text(line);
  std::vector<double> all;
  for (double value; text >> value;) all.push_back(value);
  return all;
}

// A digest of blocks that fly past each other or lie still would show nothing.
TEST(PhysicsDigest, BlocksTouchUnderEveryLawAndEachOther) {
  const std::vector<std::string> all = lines();
  const std::vector<std::string> laws = contact_law_names();
  ASSERT_EQ(all.size(), 4 * laws.size() + 3);
  std::vector<std::vector<double>> ends;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    EXPECT_EQ(all[4 * i], laws[i]);
    const std::vector<double> end = numbers(all[4 * i + 2]);
    EXPECT_GT(std::hypot(end[3], end[4], end[5]), 0.2) << "it moves still";
    EXPECT_GT(numbers(all[4 * i + 3])[0], 1e-4) << "it was in the ground";
    for (const std::vector<double>& other : ends) EXPECT_NE(end, other);
    ends.push_back(end);
  }
  const std::vector<double> first = numbers(all[all.size() - 2]), second = numbers(all.back());
  EXPECT_LT(first[3], 2.9) << "started with 3 m/s";
  EXPECT_GT(second[3], 0.0) << "started with -1 m/s, over the flat: hit by the first";
}

TEST(PhysicsDigest, TakesNextToNoTime) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer makes it many times slower";
#endif
  double least = 1e300;  // s; other work on the machine only adds to it
  for (int i = 0; i < 5; ++i) {
    const std::clock_t begin = std::clock();
    simulate_reference_motions();
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  EXPECT_LT(least, 0.15);  // about 0.02 on a processor of 2.6 GHz; slow and busy ones may check too
}

TEST(PhysicsDigest, NamesBothWhereTheyDiffer) {
  const std::string a(64, 'a'), b(64, 'b');
  EXPECT_EQ(describe_physics_difference(a, a), "");
  EXPECT_EQ(describe_physics_difference("", a), "");
  EXPECT_EQ(describe_physics_difference(a, b),
            "this version of clast computes different motions (physics digest aaaaaaaaaa, here "
            "bbbbbbbbbb)");
}

}  // namespace
}  // namespace clast
