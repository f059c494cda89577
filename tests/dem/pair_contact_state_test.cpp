// Which bodies are near, and the contacts of two bodies that both move.
#include "dem/contact/pair_contact_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dem/search/broad_phase.hpp"
#include "dem/search/detail/resolved_contacts.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {

using namespace dem_detail;

namespace {

class BroadPhaseWalk : public testing::TestWithParam<unsigned> {};

TEST_P(BroadPhaseWalk, MissesNoOverlap) {
  Random random(GetParam());
  std::vector<BoundingSphere> spheres;
  for (int i = 0; i < 60; ++i) {
    spheres.push_back({3.0 * random.uniform() * random.unit_vector(),
                       i == 0 ? 2.0 : random.uniform(0.05, 0.4), i % 10 == 0});
  }
  BroadPhase near;
  std::size_t lists = 0, overlaps = 0;
  for (int step = 0; step < 400; ++step) {
    for (BoundingSphere& sphere : spheres) {
      if (!sphere.fixed) sphere.centre += random.uniform(0.0, 0.02) * random.unit_vector();
    }
    if (near.update_pairs(spheres, 0.1)) ++lists;
    ASSERT_TRUE(std::is_sorted(near.pairs().begin(), near.pairs().end()));
    for (std::uint32_t i = 0; i < spheres.size(); ++i) {
      for (std::uint32_t j = i + 1; j < spheres.size(); ++j) {
        const bool listed =
            std::binary_search(near.pairs().begin(), near.pairs().end(), BroadPhase::Pair{i, j});
        if (spheres[i].fixed && spheres[j].fixed) {
          EXPECT_FALSE(listed);
        } else if ((spheres[i].centre - spheres[j].centre).norm() <
                   spheres[i].radius + spheres[j].radius) {
          ++overlaps;
          ASSERT_TRUE(listed) << i << " and " << j << " at step " << step;
        }
      }
    }
  }
  EXPECT_GT(overlaps, 10000u);
  EXPECT_LT(lists, 200u);
  EXPECT_GT(lists, 5u);
}
INSTANTIATE_TEST_SUITE_P(Seeds, BroadPhaseWalk, testing::Range(1u, 5u));

TEST(BroadPhase, AreMadeAnewWhenABodyComes) {
  BroadPhase near;
  std::vector<BoundingSphere> spheres = {{{0, 0, 0}, 1.0, false}};
  EXPECT_TRUE(near.update_pairs(spheres, 0.1));
  spheres.push_back({{0.5, 0, 0}, 1.0, false});
  EXPECT_TRUE(near.update_pairs(spheres, 0.1));
  EXPECT_EQ(near.pairs().size(), 1u);
  EXPECT_FALSE(near.update_pairs(spheres, 0.1));
}

std::vector<ContactPoint> search_pair_from_scratch(const IndexedSurface& ground,
                                                   const BlockSurface& block, double size,
                                                   const Pose& ground_from_block) {
  TerrainNarrowPhase search(ground, block, size);
  search.find_contacts(ground_from_block, 0.0);
  return search.find_contacts(ground_from_block, 100.0);  // every list expired, depths known
}

class Walk : public testing::TestWithParam<unsigned> {};

// Two bodies that wander about each other: a pair that slept and forgot what was far finds what a
// search without a past finds.
TEST_P(Walk, NothingTouchesUnseen) {
  Random random(GetParam());
  const double radius = GetParam() % 2 == 0 ? 0.0 : 0.02;
  const std::array<RigidBody, 4> others = {box(100.0, {0.4, 0.3, 0.35}, radius, 2),
                                           rock(2, {0.3, 0.2, 0.25}, radius, 2000.0, GetParam()),
                                           capsule(10.0, 0.4, 0.08), ball(10.0, 0.2)};
  const RigidBody ground_body = rock(3, {0.42, 0.36, 0.30}, radius, 2700.0, GetParam());
  const RigidBody& block_body = others[GetParam() % 4];
  const BlockSurface ground(ground_body.shape);
  const BlockSurface block(block_body.shape);
  const double size = std::min(ground_body.size(), block_body.size());
  const GroundParameters law{0.2, 0.5, 0.1};
  const ContactModel model{
      std::span(&law, 1), {}, {1e6, 1e6, 1e5, 1e-4}, ContactWeighting::kNone, {}};
  PairContactState pair(ground, block, size, model);
  BodyMotion a, b;
  b.world_from_body.translation = {0.9, 0, 0};
  const auto wander = [&](BodyMotion& motion) {
    const double turn = random.uniform(0.0, 0.01);
    Pose& pose = motion.world_from_body;
    pose.rotation =
        (Quat(Eigen::AngleAxisd(turn, random.unit_vector())) * pose.rotation).normalized();
    pose.translation += random.uniform(0.0, 0.01) * random.unit_vector();
  };
  std::size_t touched = 0, far = 0, compared = 0;
  bool been_deep = false;
  for (int step = 0; step < 3000; ++step) {
    wander(a);
    wander(b);
    // Kept between a shallow overlap and out of reach, coming and going.
    const Vec3 apart = b.world_from_body.translation - a.world_from_body.translation;
    const double wanted = 0.65 + 0.25 * std::sin(0.01 * step);
    b.world_from_body.translation += 0.05 * (wanted - apart.norm()) * apart.normalized();
    if (pair.max_overlap() > 0.08 * size) {
      b.world_from_body.translation += 0.5 * pair.max_overlap() * apart.normalized();
    }
    pair.update_loads(a, b, 1e-4);
    touched += pair.is_touching();
    far += !pair.has_narrow_phase();
    // A search without a past knows of no deep overlap, nor which edges have passed each other in
    // it, so that only shallow ones compare, of two that have not been deeper since they met.
    been_deep = pair.has_narrow_phase() && (been_deep || pair.max_overlap() > 0.25 * size);
    if (step % 5 != 0 || been_deep || pair.max_overlap() > 0.08 * size) continue;
    ++compared;
    const Pose pose = a.world_from_body.inverse() * b.world_from_body;
    const std::vector<ContactPoint> expected = search_pair_from_scratch(ground, block, size, pose);
    ASSERT_EQ(pair.contact_count(), expected.size()) << "step " << step;
    double deepest = 0.0;
    for (const ContactPoint& contact : expected) deepest = std::max(deepest, contact.overlap);
    ASSERT_NEAR(pair.max_overlap(), deepest, 1e-12) << "step " << step;
  }
  EXPECT_GT(touched, 300u);
  EXPECT_GT(far, 100u);
  EXPECT_GT(compared, 250u);
}
INSTANTIATE_TEST_SUITE_P(Seeds, Walk, testing::Range(1u, 9u));

class Roles : public testing::TestWithParam<unsigned> {};

// Whichever of two convex bodies is the ground: the same deepest contact between skins.
TEST_P(Roles, FindTheSameContacts) {
  Random random(GetParam());
  const RigidBody first = ellipsoid(100.0, {0.42, 0.36, 0.30}, 0.03, 3);
  const RigidBody second = box(100.0, {0.4, 0.3, 0.35}, 0.02, 2);
  const BlockSurface a(first.shape), b(second.shape);
  int compared = 0;
  for (int trial = 0; trial < 3000 && compared < 150; ++trial) {
    const Pose a_from_b{0.6 * random.unit_vector(), random.rotation()};
    const std::vector<ContactPoint> as_block = search_pair_from_scratch(a, b, 0.35, a_from_b);
    const std::vector<ContactPoint> as_ground =
        search_pair_from_scratch(b, a, 0.35, a_from_b.inverse());
    const auto deepest = [](const std::vector<ContactPoint>& contacts) {
      return std::max_element(
          contacts.begin(), contacts.end(),
          [](const ContactPoint& p, const ContactPoint& q) { return p.overlap < q.overlap; });
    };
    ASSERT_EQ(as_block.empty(), as_ground.empty()) << trial;
    if (as_block.empty() ||
        std::max(deepest(as_block)->overlap, deepest(as_ground)->overlap) > 0.05) {
      continue;
    }
    ++compared;
    const ContactPoint p = *deepest(as_block), q = *deepest(as_ground);
    EXPECT_NEAR(p.overlap, q.overlap, 1e-9) << trial;
    EXPECT_LT((p.normal + a_from_b.rotation * q.normal).norm(), 1e-6) << trial;
    EXPECT_LT((p.position() - a_from_b * q.position()).norm(), 1e-6) << trial;
  }
  EXPECT_GE(compared, 100);
}
INSTANTIATE_TEST_SUITE_P(Seeds, Roles, testing::Range(1u, 5u));

// A corner deep in the other body is pushed out the shortest way whichever body it belongs to.
TEST(Roles, ACornerDeepInsideIsFoundFromBothSides) {
  const RigidBody plate = box(100.0, {2.0, 2.0, 0.6}), cube = box(50.0, Vec3::Constant(0.5));
  const BlockSurface a(plate.shape), b(cube.shape);
  // Standing on its corner, 6 cm under the middle of the plate's top.
  Pose a_from_b;
  a_from_b.rotation = Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3(0, 0, -1));
  TerrainNarrowPhase as_block(a, b, 0.5), as_ground(b, a, 0.5);
  std::vector<ContactPoint> one, other;
  for (double sunk = -0.02; sunk < 0.121; sunk += 0.01) {
    a_from_b.translation = {0.1, 0.2, 0.3 + std::sqrt(0.1875) - sunk};
    one = as_block.find_contacts(a_from_b, sunk + 0.02);
    other = as_ground.find_contacts(a_from_b.inverse(), sunk + 0.02);
  }
  for (const std::vector<ContactPoint>& contacts : {one, other}) {
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].overlap, 0.12, 1e-12);
  }
}

TEST(Contacts, OfWallsBehindEachOtherAreNone) {
  // A cube that overhangs another by all but 8 cm and sank 2 cm into its top.
  const BlockSurface cube(box(1.0, Vec3::Ones()).shape);
  for (const double tilt : {0.0, 0.01, -0.01}) {
    const Pose pose{{0.92, 0.46, 0.98}, Quat(Eigen::AngleAxisd(tilt, Vec3(0.3, 1, 0.1)))};
    const std::vector<ContactPoint> contacts = search_pair_from_scratch(cube, cube, 1.0, pose);
    EXPECT_FALSE(contacts.empty());
    for (const ContactPoint& contact : contacts) {
      EXPECT_GT(contact.normal.z(), 0.99);
      EXPECT_LT(contact.overlap, 0.04);
    }
  }
}

TEST(Contacts, OfFlushCubesPushThemApartUpwards) {
  const BlockSurface cube(box(1.0, Vec3::Ones()).shape);
  for (const double shift : {0.0, 1e-4, -2e-3}) {
    for (const double tilt : {0.0, 5e-4}) {
      const Pose pose{{shift, 0.5 * shift, 0.99}, Quat(Eigen::AngleAxisd(tilt, Vec3::UnitX()))};
      const std::vector<ContactPoint> contacts = search_pair_from_scratch(cube, cube, 1.0, pose);
      EXPECT_GE(contacts.size(), 3u);
      for (const ContactPoint& contact : contacts) EXPECT_GT(contact.normal.z(), 0.99);
    }
  }
}

TEST(RodNarrowPhase, OfRodsAndBalls) {
  const BlockSurface rod(capsule(1.0, 1.0, 0.1).shape);
  const BlockSurface sphere(ball(1.0, 0.2).shape);
  const auto expect_one = [](const std::vector<ContactPoint>& contacts, const Vec3& foot,
                             double overlap) {
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].overlap, overlap, 1e-12);
    EXPECT_LT((contacts[0].surface_point - foot).norm(), 1e-12);
  };
  const Quat quarter(Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()));
  RodNarrowPhase crossed(rod, rod), ball_on_rod(rod, sphere), rod_on_ball(sphere, rod);
  expect_one(crossed.find_contacts({{0.2, 0.1, 0.19}, quarter}), {0.2, 0, 0.1}, 0.01);
  // Beside its middle, beside its end, and past it.
  expect_one(ball_on_rod.find_contacts({{0.3, 0, 0.28}, Quat::Identity()}), {0.3, 0, 0.1}, 0.02);
  expect_one(ball_on_rod.find_contacts({{0.78, 0, 0}, Quat::Identity()}), {0.6, 0, 0}, 0.02);
  expect_one(rod_on_ball.find_contacts({{0.3, 0, 0.28}, Quat::Identity()}), {0, 0, 0.2}, 0.02);
  EXPECT_TRUE(ball_on_rod.find_contacts({{0.3, 0, 0.4}, Quat::Identity()}).empty());
  EXPECT_NEAR(ball_on_rod.clearance(), 0.1, 1e-12);
  // Side by side they touch at the ends of the stretch they share.
  const std::vector<ContactPoint> parallel =
      crossed.find_contacts({{0.4, 0, 0.19}, Quat::Identity()});
  ASSERT_EQ(parallel.size(), 2u);
  for (const ContactPoint& contact : parallel) {
    EXPECT_NEAR(contact.overlap, 0.01, 1e-12);
    EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), 1e-12);
  }
}

TEST(GroundsPlace, IsTakenByFacesThenSizeThenOrder) {
  const BlockSurface small_ball(ball(1.0, 0.2).shape), large_ball(ball(1.0, 2.0).shape);
  const BlockSurface cube(box(1.0, Vec3::Ones()).shape),
      small_cube(box(1.0, {0.8, 0.8, 0.8}).shape);
  EXPECT_TRUE(is_reference_body(cube, large_ball));
  EXPECT_FALSE(is_reference_body(large_ball, cube));
  EXPECT_TRUE(is_reference_body(cube, small_ball));
  EXPECT_TRUE(is_reference_body(cube, small_cube));
  EXPECT_FALSE(is_reference_body(small_cube, cube));
  EXPECT_TRUE(is_reference_body(cube, cube));
}

}  // namespace
}  // namespace clast
