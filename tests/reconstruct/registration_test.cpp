// Scans of one block in different poses: found, or refused with the reason.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "mesh/geodesic_sphere.hpp"
#include "reconstruct/registration/registration.hpp"
#include "tests/support/partial_scans.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

PartialScanRecipe bare_recipe() {
  PartialScanRecipe recipe;
  recipe.points = 3000;
  recipe.ground_points = 0.0;
  return recipe;
}

/// Two scans of a rock without ground, and the pose that takes the second to the first.
struct RockScans {
  std::vector<ScanToRegister> scans;
  Pose first_from_second;
};

RockScans scan_rock(std::uint64_t seed, const TriangleMesh& body) {
  Random random(seed);
  const PartialScanner scanner(body);
  const ScanPair pair = make_scan_pair(scanner, bare_recipe(), bare_recipe(), 0.4, 0.8, random);
  return {{{"top", pair.first.points}, {"bottom", pair.second.points}},
          pair.first.scan_from_block * pair.second.scan_from_block.inverse()};
}

TriangleMesh joined_rock() { return rock_mesh(12, {0.5, 0.4, 0.3}, 3); }

double largest_error(const Similarity& found, const Pose& truth, const std::vector<Vec3>& points) {
  double most = 0.0;
  for (const Vec3& p : points) most = std::max(most, (found * p - truth * p).norm());
  return most;
}

TEST(Registration, FindsThePoseOfATurnedBlockOnAnyNumberOfThreads) {
  const RockScans rocks = scan_rock(11, joined_rock());
  const Registration one = register_scans(rocks.scans, {.threads = 1});
  EXPECT_LT(largest_error(one.first_from_scan[1], rocks.first_from_second, rocks.scans[1].points),
            0.004);
  EXPECT_GT(one.overlap, 0.25);
  EXPECT_LT(one.deviation, 0.003);
  const Registration two = register_scans(rocks.scans, {.threads = 2});
  EXPECT_EQ(one.first_from_scan[1].pose.translation, two.first_from_scan[1].pose.translation);
  EXPECT_EQ(one.first_from_scan[1].pose.rotation.coeffs(),
            two.first_from_scan[1].pose.rotation.coeffs());
}

TEST(Registration, PickedPlacesGiveThePose) {
  RockScans rocks = scan_rock(12, joined_rock());
  RegistrationOptions options;
  const Pose back = rocks.first_from_second.inverse();
  for (const Vec3& place : {Vec3(0.3, 0.0, 0.1), Vec3(-0.2, 0.2, 0.2), Vec3(0.0, -0.3, 0.3)}) {
    options.pairs.push_back({0, 1, place, back * place + Vec3(0.005, -0.005, 0.0)});
  }
  const Registration found = register_scans(rocks.scans, options);
  EXPECT_LT(largest_error(found.first_from_scan[1], rocks.first_from_second, rocks.scans[1].points),
            0.004);
  options.pairs[1].point_b = options.pairs[0].point_b;
  options.pairs[1].point_a = options.pairs[0].point_a;
  EXPECT_TRUE(contains(refusal([&] { register_scans(rocks.scans, options); }), "on a line"));
}

TEST(Registration, AMirroredScanIsRefused) {
  RockScans rocks = scan_rock(13, joined_rock());
  for (Vec3& p : rocks.scans[1].points) p.x() = -p.x();
  EXPECT_THROW(register_scans(rocks.scans), GeometryError);
}

TEST(Registration, AnotherBlockIsRefused) {
  RockScans rocks = scan_rock(14, joined_rock());
  rocks.scans[1] = scan_rock(15, rock_mesh(12, {0.5, 0.4, 0.3}, 9)).scans[1];
  EXPECT_THROW(register_scans(rocks.scans), GeometryError);
}

TEST(Registration, AnotherScaleIsRefusedWithItsFactor) {
  RockScans rocks = scan_rock(16, joined_rock());
  for (Vec3& p : rocks.scans[1].points) p *= 1.02;
  try {
    register_scans(rocks.scans);
    FAIL() << "not refused";
  } catch (const GeometryError& error) {
    const std::string text = error.what(), before = "multiplied by ";
    ASSERT_NE(text.find(before), std::string::npos) << text;
    EXPECT_NEAR(std::stod(text.substr(text.find(before) + before.size())), 1.0 / 1.02, 0.005);
  }
}

/// The third scan agrees best with the second, and only the second has a hint.
TEST(Registration, HintsOfThreeScansHoldWhicheverAreJoinedFirst) {
  RockScans rocks = scan_rock(19, joined_rock());
  Random random(20);
  const Quat first_from_second = rocks.first_from_second.rotation;
  rocks.scans.push_back({"bottom again", {}});
  const Quat turn(Eigen::AngleAxisd(2.0, Vec3(0.6, 0.0, 0.8)));
  for (const Vec3& p : rocks.scans[1].points) {
    const Vec3 noise(random.normal(), random.normal(), random.normal());
    rocks.scans[2].points.push_back(turn * (p + 0.001 * noise));
  }
  RegistrationOptions options;
  options.threads = 0;
  const Quat rough(Eigen::AngleAxisd(0.3, Vec3(0.0, 0.6, 0.8)));
  options.hints.push_back({1, rough * first_from_second});
  const Registration found = register_scans(rocks.scans, options);
  EXPECT_LT(largest_error(found.first_from_scan[1], rocks.first_from_second, rocks.scans[1].points),
            0.006);
}

// Two caps of a ball fit wherever they are, and cover more or less of it.
TEST(Registration, CapsOfABallAreRefused) {
  const RockScans balls = scan_rock(17, scaled(geodesic_sphere(12), 0.5));
  EXPECT_THROW(register_scans(balls.scans), GeometryError);
}

// Each of two scans shows a whole ball, which is the same body at every pose.
TEST(Registration, WholeBallsAreJoined) {
  const TriangleMesh ball = scaled(geodesic_sphere(30), 0.5);
  std::vector<Vec3> second;
  for (const Vec3& v : ball.vertices) second.push_back(Vec3(v.y(), v.z() + 0.2, v.x()));
  const Registration found = register_scans({{"top", ball.vertices}, {"bottom", second}});
  EXPECT_LT((found.first_from_scan[1] * Vec3(0.0, 0.2, 0.0)).norm(), 0.002);
}

TEST(Registration, InputThatDoesNotFitTogetherIsRefused) {
  const RockScans rocks = scan_rock(18, joined_rock());
  EXPECT_TRUE(contains(refusal([&] { register_scans({rocks.scans[0]}); }), "two to eight"));
  RegistrationOptions first_turned;
  first_turned.hints.push_back({0, Quat::Identity()});
  EXPECT_TRUE(contains(refusal([&] { register_scans(rocks.scans, first_turned); }), "first scan"));
  RegistrationOptions wrong_scan;
  wrong_scan.pairs.push_back({0, 5, Vec3::Zero(), Vec3::Zero()});
  EXPECT_TRUE(contains(refusal([&] { register_scans(rocks.scans, wrong_scan); }), "not among"));
}

}  // namespace
}  // namespace clast
