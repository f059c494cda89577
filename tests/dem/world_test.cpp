// Bodies that hit each other, against closed forms.
#include "dem/simulation/world.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

/// Steps until the two bodies have touched and parted.
void collide(World& world, double latest) {
  bool touched = false;
  while (world.time() < latest) {
    world.step();
    const bool touching = world.statistics().touching_pairs > 0;
    if (touched && !touching) return;
    touched = touched || touching;
  }
  FAIL() << "no collision was over by " << latest << " s";
}

struct TwoSpheres {
  double second_mass;
  double restitution;  ///< e_n^2
};
void PrintTo(const TwoSpheres& spheres, std::ostream* out) {
  *out << spheres.second_mass << " kg, restitution " << spheres.restitution;
}

class Spheres : public testing::TestWithParam<TwoSpheres> {};

// v1' = v1 - (1 + e) m2/(m1 + m2) (v1 - v2), and the other way round.
TEST_P(Spheres, HeadOn) {
  const auto [second_mass, restitution] = GetParam();
  const double e = std::sqrt(restitution);
  const std::vector<RigidBody> shapes = {ball(1.0, 0.1), ball(second_mass, 0.15)};
  WorldSettings settings = stiff_world(shapes[0], 1e7, 100.0);
  settings.between_bodies = {restitution, 0.5, 0.0};
  World world(shapes, settings);
  const Vec3 line = Vec3(1.0, 2.0, -0.5).normalized();
  world.add_body(0, at(Vec3(0.1, 0.2, 0.3), 2.0 * line));
  world.add_body(1, at(Vec3(0.1, 0.2, 0.3) + 0.26 * line, -1.0 * line));
  collide(world, 0.5);
  const double closing = 3.0, total = 1.0 + second_mass;
  const double first = 2.0 - (1.0 + e) * second_mass / total * closing;
  const double second = -1.0 + (1.0 + e) / total * closing;
  const double scale = 0.005 * e * closing;
  EXPECT_NEAR(world.state(0).velocity.dot(line), first, scale);
  EXPECT_NEAR(world.state(1).velocity.dot(line), second, scale);
  EXPECT_LT(world.state(0).velocity.cross(line).norm(), 1e-9);
  EXPECT_LT(world.state(0).angular_velocity.norm(), 1e-9);
  const double reduced = second_mass / total;
  const EnergyBalance energy = world.energy_balance();
  EXPECT_NEAR(energy.normal, 0.5 * reduced * closing * closing * (1.0 - restitution),
              0.005 * reduced * closing * closing);
}

// Without friction the speed along the surfaces stays; with it, while they slide, it changes by the
// impulse mu J, which also turns them.
TEST_P(Spheres, Oblique) {
  const auto [second_mass, restitution] = GetParam();
  const double e = std::sqrt(restitution), mu = 0.05;
  for (const double friction : {0.0, mu}) {
    const std::vector<RigidBody> shapes = {ball(1.0, 0.1), ball(second_mass, 0.15)};
    WorldSettings settings = stiff_world(shapes[0], 1e8, 100.0);
    settings.between_bodies = {restitution, friction, 0.0};
    // Aimed so that the line of centres is x when they collide.
    World aimed(shapes, settings);
    const double until = 1e-4 / 2.0;
    aimed.add_body(0, at({0, -3.0 * until, 0}, {2.0, 3.0, 0.0}));
    aimed.add_body(1, at({0.2501, 0, 0}));
    collide(aimed, 0.5);
    const double reduced = second_mass / (1.0 + second_mass);
    const double impulse = (1.0 + e) * reduced * 2.0;
    const RigidState& first = aimed.state(0);
    const RigidState& second = aimed.state(1);
    EXPECT_NEAR(first.velocity.x(), 2.0 - impulse, 0.01 * impulse);
    EXPECT_NEAR(first.velocity.y(), 3.0 - friction * impulse, 0.01 * impulse);
    EXPECT_NEAR(second.velocity.x(), impulse / second_mass, 0.01 * impulse / second_mass);
    EXPECT_NEAR(second.velocity.y(), friction * impulse / second_mass,
                0.01 * impulse / second_mass);
    // What ends a contact acts where it was when the step began: a lever of a step's movement on
    // a small part of the impulse.
    const double angular_slack = 0.01 * friction * impulse + 1e-9 * impulse;
    EXPECT_NEAR(0.4 * 0.1 * first.angular_velocity.z(), -friction * impulse, angular_slack);
    EXPECT_NEAR(0.4 * 0.15 * second_mass * second.angular_velocity.z(), -friction * impulse,
                angular_slack);
  }
}
INSTANTIATE_TEST_SUITE_P(Pairs, Spheres,
                         testing::Values(TwoSpheres{1.0, 1.0}, TwoSpheres{1.0, 0.25},
                                         TwoSpheres{5.0, 0.64}, TwoSpheres{5.0, 0.04},
                                         TwoSpheres{0.2, 0.25}));

TEST(FixedBody, ReturnsASphereAndKeepsItsPlace) {
  const std::vector<RigidBody> shapes = {ball(1.0, 0.1), ball(1.0, 0.3)};
  WorldSettings settings = stiff_world(shapes[0], 1e7, 100.0);
  settings.between_bodies = {0.25, 0.5, 0.0};
  World world(shapes, settings);
  world.add_body(0, at({0, 0, 0.41}, {0, 0, -3.0}));
  world.add_body(1, at({0, 0, 0}, {1, 2, 3}), true);
  collide(world, 0.1);
  EXPECT_NEAR(world.state(0).velocity.z(), 1.5, 0.005 * 1.5);
  EXPECT_EQ(world.state(1).position, Vec3(Vec3::Zero()));
  EXPECT_EQ(world.state(1).velocity, Vec3(Vec3::Zero()));
}

/// One block on a fixed one, its centre `offset` away, started `drop` above the depth of rest.
struct Stand {
  bool small_above;
  Vec2 offset;
};
std::ostream& operator<<(std::ostream& out, const Stand& stand) {
  return out << (stand.small_above ? "small" : "large") << " above, " << stand.offset.transpose();
}
constexpr double kStandTouching = 0.25 + 0.2 + 0.03, kStandMass = 300.0;
constexpr double kStandDepth = kStandMass * 9.81 / (1e7 * 0.04);

World stand_at_rest(const Stand& stand, double drop) {
  RigidBody small = box(kStandMass, {0.5, 0.5, 0.4}, 0.01, 2);
  RigidBody large = box(kStandMass, {0.8, 0.8, 0.5}, 0.02, 3);
  if (!stand.small_above) std::swap(small, large);
  WorldSettings settings = stiff_world(small, 1e7, 20.0);
  settings.gravity = 9.81;
  settings.between_bodies = {0.04, 0.6, 0.1};
  settings.start_overlap = 1.0;
  World world({small, large}, settings);
  world.add_body(0, at({stand.offset.x(), stand.offset.y(), kStandTouching - kStandDepth + drop}));
  world.add_body(1, at({0, 0, 0}), true);
  EXPECT_EQ(world.run_until_rest(20.0), StopReason::kRest);
  return world;
}

class OnAFixedBlock : public testing::TestWithParam<Stand> {};

TEST_P(OnAFixedBlock, RestsAtTheDepthOfTheLaw) {
  const World world = stand_at_rest(GetParam(), 0.1 * kStandDepth);
  EXPECT_NEAR(kStandTouching - world.state(0).position.z(), kStandDepth, 0.01 * kStandDepth);
  EXPECT_NEAR(world.overlap(0, 1), kStandDepth, 0.01 * kStandDepth);
  EXPECT_LT(world.state(0).orientation.angularDistance(Quat::Identity()), 1e-6);
  EXPECT_LT(world.energy_balance().error, 0.005);
}
// The smaller's face within the larger's, seen from above and from below.
INSTANTIATE_TEST_SUITE_P(Stands, OnAFixedBlock,
                         testing::Values(Stand{true, {0, 0}}, Stand{true, {0.08, 0.11}},
                                         Stand{true, {-0.13, 0.02}}, Stand{false, {0, 0}}));

class OverTheEdge : public testing::TestWithParam<Stand> {};

// Part of either face has nothing beneath it, the centre of mass has: the block stays, carried by
// just its weight, not deeper than twice the depth of one law, and not pushed away by walls that
// are deep behind each other beside the overlap.
TEST_P(OverTheEdge, Stays) {
  World world = stand_at_rest(GetParam(), 0.01);
  // What it tilts while it settles shifts its centre by about its depth.
  EXPECT_LT((world.state(0).position.head<2>() - GetParam().offset).norm(), kStandDepth);
  EXPECT_LT(world.energy_balance().error, 0.005);
  for (const double until = world.time() + 3.0; world.time() < until;) world.step();
  const Vec3 position = world.state(0).position;
  EXPECT_LT((world.contact_force(0) - Vec3(0, 0, kStandMass * 9.81)).norm(),
            0.01 * kStandMass * 9.81);
  EXPECT_LT(world.overlap(0, 1), 2.0 * kStandDepth);
  for (const double until = world.time() + 3.0; world.time() < until;) world.step();
  EXPECT_LT((world.state(0).position - position).head<2>().norm(), 2e-4);
}
INSTANTIATE_TEST_SUITE_P(Stands, OverTheEdge,
                         testing::Values(Stand{true, {0.2, 0.14}}, Stand{true, {0.3, 0.0}},
                                         Stand{true, {0.3, 0.3}}, Stand{false, {0.2, 0.14}},
                                         Stand{false, {0.15, 0.2}}, Stand{false, {0.0, 0.11}}));

// e_n^2 = 1 and no friction: whatever is stored comes back, over a hundred bounces in a closed
// room.
TEST(Elastic, SpheresKeepTheirEnergy) {
  std::vector<RigidBody> shapes = room_slabs(0.5);
  shapes.push_back(ball(1.0, 0.15));
  shapes.push_back(ball(2.0, 0.2));
  WorldSettings settings = stiff_world(shapes[3], 1e7, 40.0);
  settings.between_bodies = {1.0, 0.0, 0.0};
  World world(shapes, settings);
  world.add_body(3, at({-0.3, 0.1, 0.05}, {3.0, 0.4, 1.0}));
  world.add_body(4, at({0.2, 0, 0}, {-1.0, -2.0, 0.5}));
  add_room(world, 0, 0.5);
  int bounces = 0;
  std::size_t before = 0;
  while (bounces < 100 && world.time() < 60.0) {
    world.step();
    const std::size_t touching = world.statistics().touching_pairs;
    if (touching > before) ++bounces;
    before = touching;
  }
  EXPECT_EQ(bounces, 100);
  const EnergyBalance energy = world.energy_balance();
  EXPECT_NEAR(energy.final, energy.initial, 1e-3 * energy.initial);
  EXPECT_NEAR(energy.initial - energy.final, energy.dissipated(), 1e-5 * energy.initial);
}

class ElasticBlocks : public testing::TestWithParam<ContactWeighting> {};

TEST_P(ElasticBlocks, KeepTheirEnergyOrSayWhereItWent) {
  std::vector<RigidBody> shapes = room_slabs(0.6);
  shapes.push_back(ellipsoid(1.0, {0.2, 0.15, 0.12}, 0.02, 2));
  shapes.push_back(box(2.0, {0.3, 0.2, 0.25}, 0.02));
  WorldSettings settings = stiff_world(shapes[3], 1e7, 40.0);
  settings.weighting = GetParam();
  settings.between_bodies = {1.0, 0.0, 0.0};
  World world(shapes, settings);
  world.add_body(3, at({-0.3, 0.1, 0.05}, {3.0, 0.4, 1.0}));
  world.add_body(4, at({0.2, 0, 0}, {-1.0, -2.0, 0.5}));
  add_room(world, 0, 0.6);
  // Without weights energy must stay; with them what changes must be booked.
  const int wanted = GetParam() == ContactWeighting::kNone ? 100 : 40;
  int bounces = 0;
  std::size_t before = 0;
  while (bounces < wanted && world.time() < 60.0) {
    world.step();
    const std::size_t touching = world.statistics().touching_pairs;
    if (touching > before) ++bounces;
    before = touching;
  }
  EXPECT_EQ(bounces, wanted);
  const EnergyBalance energy = world.energy_balance();
  RecordProperty("drift", std::to_string(energy.final / energy.initial - 1.0));
  if (GetParam() == ContactWeighting::kNone) {
    EXPECT_NEAR(energy.final, energy.initial, 1e-3 * energy.initial);
  }
  EXPECT_NEAR(energy.initial - energy.final, energy.dissipated(), 1e-5 * energy.initial);
}
INSTANTIATE_TEST_SUITE_P(Weights, ElasticBlocks,
                         testing::Values(ContactWeighting::kPatch, ContactWeighting::kOverlap,
                                         ContactWeighting::kCount, ContactWeighting::kNone),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace clast
