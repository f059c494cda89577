// The neighbour list of two blocks against all their features, one by one.
#include "dem/search/block_narrow_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "dem/search/detail/resolved_contacts.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {

using namespace dem_detail;

namespace {

using Key = std::tuple<int, std::uint32_t, std::uint32_t>;
Key key_of(const ContactPoint& contact) {
  return {static_cast<int>(contact.kind), contact.block_feature, contact.ground_feature};
}

/// Every contact of every feature of the block with every one of the ground, however deep.
std::vector<ContactPoint> all_against_all(const BlockSurface& ground, const BlockSurface& block,
                                          double size, const Pose& pose) {
  FeatureTests tests(ground, block, size);
  tests.set_pose(pose.rotation.toRotationMatrix(), pose.translation);
  std::vector<ContactPoint> contacts;
  for (const std::uint32_t vertex : block.parts.vertices) {
    const Vec3 centre = tests.in_ground_frame(block.features.vertices[vertex]);
    const NearestPoint nearest =
        find_nearest_face(ground.local_faces, ground.features, centre, 1e300, 0.0, 0).nearest;
    if (nearest.distance >= tests.reach()) continue;
    if (nearest.distance >= 0.0) {
      tests.add_outside_contacts(vertex, centre, ground.local_faces, contacts);
    } else {
      const bool inverted = tests.is_inverted_push(vertex, centre, nearest);
      contacts.push_back(tests.make_inside_contact(
          vertex, centre,
          inverted ? tests.nearest_valid_push_point(vertex, centre, nearest, ground.local_faces)
                   : nearest));
    }
  }
  for (const BlockSide& side : block.parts.sides) {
    std::optional<ContactPoint> contact;
    const auto keep = [&] {
      if (contact) add_unique_contact(contacts, *contact);
      contact.reset();
    };
    for (const BlockSide& other : ground.parts.sides) {
      if (side.is_face || other.is_face) continue;
      tests.test_edge_edge(side.feature, other.feature, contact);
      keep();
    }
    for (const std::uint32_t corner : ground.parts.vertices) {
      if (side.is_face) {
        tests.test_face_vertex(side.feature, corner, contact);
      } else if (tests.reach() > 0.0) {
        tests.test_edge_vertex(side.feature, corner, contact);
      }
      keep();
    }
  }
  return contacts;
}

struct Pairing {
  const char* name;
  RigidBody ground, block;
  int steps = 2000;
  double pace = 1.0;  ///< slowly, what was found before counts for many steps
};
void PrintTo(const Pairing& pairing, std::ostream* out) { *out << pairing.name; }

std::vector<Pairing> pairings() {
  return {
      {"rock on rock", rock(2, {0.42, 0.36, 0.30}, 0.02, 2700.0, 1),
       rock(2, {0.35, 0.28, 0.25}, 0.01, 2700.0, 2)},
      {"rough on rough", rock(4, {0.42, 0.36, 0.30}, 0.01, 2700.0, 3),
       rock(4, {0.42, 0.30, 0.25}, 0.01, 2700.0, 4), 300},
      {"sharp edges", rock(3, {0.42, 0.36, 0.30}, 0.0, 2700.0, 5), box(100.0, {0.4, 0.3, 0.35})},
      {"boxes", box(100.0, {0.5, 0.4, 0.45}, 0.02), box(100.0, {0.4, 0.3, 0.35}, 0.02)},
      {"rod", rock(3, {0.42, 0.36, 0.30}, 0.02, 2700.0, 6), capsule(10.0, 0.5, 0.06)},
      {"ball", rock(3, {0.42, 0.36, 0.30}, 0.02, 2700.0, 7), ball(10.0, 0.2)},
      {"rock on rock, slowly", rock(2, {0.42, 0.36, 0.30}, 0.02, 2700.0, 1),
       rock(2, {0.35, 0.28, 0.25}, 0.01, 2700.0, 2), 4000, 0.1},
      {"sharp edges, slowly", rock(3, {0.42, 0.36, 0.30}, 0.0, 2700.0, 5),
       box(100.0, {0.4, 0.3, 0.35}), 4000, 0.1},
      {"boxes, slowly", box(100.0, {0.5, 0.4, 0.45}, 0.02), box(100.0, {0.4, 0.3, 0.35}, 0.02),
       8000, 0.05}};
}

class BlockContactsOf : public testing::TestWithParam<Pairing> {};

/// Two that move about each other while they touch a little: pushed apart by what they overlap.
TEST_P(BlockContactsOf, AreThoseOfAllFeatures) {
  const RigidBody &ground_body = GetParam().ground, &block_body = GetParam().block;
  const BlockSurface ground(ground_body.shape), block(block_body.shape);
  const double size = std::min(ground_body.size(), block_body.size());
  const double radius = block_body.bounding_radius();
  const double reach = ground.radius + block.radius;
  BlockNarrowPhase search(ground, block, size);
  Random random(17);
  Pose pose{{0.95, 0.1, 0.0}, Quat::Identity()};
  double displacement = 0.0, deepest = 0.0;
  std::size_t touched = 0, apart = 0, slept = 0;
  for (int step = 0; step < GetParam().steps; ++step) {
    const double pace = GetParam().pace;
    const double turn = pace * random.uniform(0.0, 0.01);
    Vec3 shift = pace * random.uniform(0.0, 0.004) * random.unit_vector();
    const double closing = 0.003 + 0.006 * std::sin(0.05 * pace * step) - 0.4 * deepest;
    shift -= pace * closing * pose.translation.normalized();
    pose.rotation =
        (Quat(Eigen::AngleAxisd(turn, random.unit_vector())) * pose.rotation).normalized();
    pose.translation += shift;
    displacement += shift.norm() + 2.0 * std::sin(0.5 * turn) * radius;
    const std::vector<ContactPoint> all = all_against_all(ground, block, size, pose);
    const double safe = search.contact_free_displacement();
    const std::vector<ContactPoint> found = search.find_contacts(pose, displacement);
    deepest = 0.0;
    for (const ContactPoint& contact : found) deepest = std::max(deepest, contact.overlap);
    // What goes in deeper than twice the deepest is edges that have only passed each other.
    std::vector<Key> expected, keys;
    for (const ContactPoint& contact : all) {
      if (contact.overlap <= std::max(2.0 * deepest, 2.0 * reach)) {
        expected.push_back(key_of(contact));
      }
    }
    for (const ContactPoint& contact : found) keys.push_back(key_of(contact));
    std::sort(expected.begin(), expected.end());
    std::sort(keys.begin(), keys.end());
    for (const Key& key : keys) {
      ASSERT_TRUE(std::any_of(all.begin(), all.end(),
                              [&](const ContactPoint& c) { return key_of(c) == key; }))
          << "step " << step;
    }
    if (deepest < reach + 0.05 * size) {  // deeper ones may be resolved by others
      ASSERT_TRUE(std::includes(keys.begin(), keys.end(), expected.begin(), expected.end()))
          << "step " << step;
    }
    if (displacement < safe) {
      ++slept;
      ASSERT_TRUE(found.empty()) << "step " << step << ": " << safe - displacement << " m early";
    }
    (found.empty() ? apart : touched) += 1;
  }
  EXPECT_GT(touched, 100u);
  EXPECT_GT(apart, 50u);
  EXPECT_GT(slept, 20u);
}
INSTANTIATE_TEST_SUITE_P(Pairings, BlockContactsOf, testing::ValuesIn(pairings()));

// Skins far apart: known at once, and for how long.
TEST(BlockNarrowPhase, LetBlocksFarApartMoveAsFarAsTheirGap) {
  const BlockSurface a(box(1.0, {1.0, 1.0, 1.0}, 0.05, 1).shape), b(ball(1.0, 0.2).shape);
  BlockNarrowPhase search(a, b, 0.4);
  EXPECT_TRUE(search.find_contacts({{3.0, 0.0, 0.0}, Quat::Identity()}, 0.0).empty());
  EXPECT_NEAR(search.contact_free_displacement(), 3.0 - 0.5 - 0.05 - 0.2, 1e-9);
}

// The first call knows of no past, in which the two may have gone deep into each other.
TEST(BlockNarrowPhase, LetBlocksSideBySideMoveAsFarAsTheirGapFromTheSecondCallOn) {
  const BlockSurface surface(box(1.0, {1.0, 1.0, 1.0}, 0.02, 1).shape);
  BlockNarrowPhase search(surface, surface, 1.0);
  const Quat turned(Eigen::AngleAxisd(0.3, Vec3::UnitX()));
  for (const double displacement : {0.0, 1e-6}) {
    EXPECT_TRUE(search.find_contacts({{1.06, 0.1, 0.0}, turned}, displacement).empty());
  }
  EXPECT_NEAR(search.contact_free_displacement(), 0.02 + 1e-6, 1e-9);
}

/// Two rough rocks are pushed into each other until some corners of one are inside the other. One
/// that points aside may be nearest to a face that would push it out through its own rock; the way
/// out that is taken instead is not that to the far side.
TEST(CornersThatPointAside, AreNotPushedToTheFarSide) {
  Random random(3);
  std::size_t deep = 0;
  for (int pair = 0; pair < 60; ++pair) {
    const auto seed = static_cast<std::uint64_t>(1 + pair % 4);
    const RigidBody first = rock(5, {0.30, 0.25, 0.20}, 0.01, 2650.0, seed);
    const RigidBody second = rock(5, {0.30, 0.25, 0.20}, 0.01, 2650.0, 5 - seed);
    const BlockSurface ground(first.shape), block(second.shape);
    const double size = std::min(first.size(), second.size());
    const Vec3 direction = random.unit_vector();
    const Quat turn = random.rotation();
    for (double distance = 0.5; distance > 0.2; distance -= 0.01) {
      BlockNarrowPhase search(ground, block, size);
      const std::vector<ContactPoint>& contacts =
          search.find_contacts({distance * direction, turn}, 0.0);
      if (contacts.size() < 30) continue;
      std::vector<double> overlaps;
      for (const ContactPoint& contact : contacts) overlaps.push_back(contact.overlap);
      std::sort(overlaps.begin(), overlaps.end());
      EXPECT_LE(overlaps.back(), std::max(0.25 * size, 2.0 * overlaps[overlaps.size() - 2]))
          << pair;
      if (overlaps.back() > 0.1 * size) ++deep;
      break;
    }
  }
  EXPECT_GT(deep, 30u);
}

}  // namespace
}  // namespace clast
