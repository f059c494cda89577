// Structures of blocks that stand or fall as statics says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "shapes/convex_hull.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

constexpr double kDensity = 2600.0;     // kg/m^3
constexpr double kEdgeRadius = 0.01;    // of all edges, m
constexpr double kRestStiffness = 1e9;  // N/m
constexpr double kStepsPerRadian = 5.0;

/// A block where it stands.
struct Placed {
  RigidBody body;
  RigidState state;
  bool fixed = false;
};

/// The hull of some corners, rounded outwards.
Placed block_of(std::span<const Vec3> corners, bool fixed = false) {
  const SpheroPolyhedron shape = make_sphero_polyhedron(convex_hull(corners), kEdgeRadius);
  const MassProperties mass = sphero_mass_properties(shape, kDensity, 1e-3);
  const PrincipalFrame frame = principal_frame(mass);
  Placed placed;
  placed.body.shape = transformed(shape, Pose{mass.centre, frame.rotation}.inverse());
  placed.body.mass = mass.mass;
  placed.body.moments = frame.moments;
  placed.body.smallest_side = std::cbrt(mass.volume);
  placed.state.position = mass.centre;
  placed.state.orientation = frame.rotation;
  placed.fixed = fixed;
  return placed;
}

/// A box with its rounding, between two corners.
Placed box_between(const Vec3& low, const Vec3& high, bool fixed = false) {
  std::vector<Vec3> corners;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 side((corner & 1) ? 1.0 : 0.0, (corner & 2) ? 1.0 : 0.0, (corner & 4) ? 1.0 : 0.0);
    const Vec3 inner = high - low - Vec3::Constant(2.0 * kEdgeRadius);
    corners.push_back(low + Vec3::Constant(kEdgeRadius) + side.cwiseProduct(inner));
  }
  return block_of(corners, fixed);
}

/// Fixed, its top at height 0.
Placed floor_slab(double half) {
  return box_between({-half, -half, -1.0}, {half, half, 0.0}, true);
}

/// @param tilt  the whole structure is turned about the x axis by this angle, rad
World world_of(const std::vector<Placed>& blocks, double friction, double tilt = 0.0) {
  std::vector<RigidBody> shapes;
  for (const Placed& block : blocks) shapes.push_back(block.body);
  const auto lighter = [](const Placed& a, const Placed& b) {
    return std::pair(a.fixed, a.body.mass) < std::pair(b.fixed, b.body.mass);
  };
  const Placed& lightest = *std::min_element(blocks.begin(), blocks.end(), lighter);
  WorldSettings settings = stiff_world(lightest.body, kRestStiffness, kStepsPerRadian);
  settings.gravity = kTestGravity;
  settings.between_bodies = {0.1, friction, 0.0};
  World world(shapes, settings);
  const Quat turn(Eigen::AngleAxisd(tilt, Vec3::UnitX()));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    RigidState state = blocks[i].state;
    state.position = turn * state.position;
    state.orientation = turn * state.orientation;
    world.add_body(i, state, blocks[i].fixed);
  }
  return world;
}

/// Farthest that any block is from where it was, m.
double farthest_moved(const World& world, const std::vector<RigidState>& from) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    farthest = std::max(farthest, (world.state(i).position - from[i].position).norm());
  }
  return farthest;
}

std::vector<RigidState> states_of(const World& world) {
  std::vector<RigidState> states;
  for (std::size_t i = 0; i < world.body_count(); ++i) states.push_back(world.state(i));
  return states;
}

/// Does all of it fall asleep where it stood before? What falls is not waited for.
bool is_representative(World& world) {
  constexpr double kFallen = 0.1, kLongest = 20.0;  // m, s
  const std::vector<RigidState> start = states_of(world);
  while (world.time() < kLongest && farthest_moved(world, start) < kFallen) {
    const std::size_t moving = world.body_count() - 1;  // but for the floor
    if (world.statistics().sleeping_bodies == moving) return true;
    world.step();
  }
  return false;
}

// Blocks at rest go on swaying on their tangential springs until they fall asleep; the stack's top
// must be where it was by then, and stay.
TEST(Stack, OfTenCubesStandsForAMinute) {
  constexpr double kSide = 0.5;  // m
  std::vector<Placed> blocks = {floor_slab(1.0)};
  for (int i = 0; i < 10; ++i) {
    blocks.push_back(box_between({-0.5 * kSide, -0.5 * kSide, kSide * i},
                                 {0.5 * kSide, 0.5 * kSide, kSide * (i + 1)}));
  }
  World world = world_of(blocks, 0.6);
  while (world.time() < 5.0) world.step();
  const std::vector<RigidState> settled = states_of(world);
  EXPECT_LT(settled[10].position.head<2>().norm(), 2e-3 * kSide);
  EXPECT_GT(settled[10].position.z(), 9.5 * kSide - 10 * 1e-3 * kSide);
  while (world.time() < 60.0) world.step();
  EXPECT_LT(farthest_moved(world, settled), 1e-4 * kSide);
  EXPECT_LT(world.energy_balance().error, 1e-3);
}

/// A share of the farthest that four bricks can overhang, each as far as those above it allow: the
/// i-th from the top by half its flat length over i.
class Overhang : public testing::TestWithParam<double> {};

TEST_P(Overhang, OfBricksStandsWhileTheCentreOfAllAboveIsSupported) {
  constexpr int kBricks = 4;
  constexpr double kLength = 0.8, kHeight = 0.2;
  std::vector<Placed> blocks = {floor_slab(1.0)};
  double edge = 1.0;  // of what is below, m
  for (int i = kBricks; i >= 1; --i) {
    const double shift = GetParam() * (0.5 * kLength - kEdgeRadius) / i;
    const double bottom = kHeight * (kBricks - i), end = edge + shift;
    blocks.push_back(box_between({end - kLength, -0.2, bottom}, {end, 0.2, bottom + kHeight}));
    edge = end;
  }
  World world = world_of(blocks, 0.6);
  EXPECT_EQ(is_representative(world), GetParam() < 1.0);
}
INSTANTIATE_TEST_SUITE_P(Shares, Overhang, testing::Values(0.95, 0.98, 1.02, 1.05));

/// Tilted so far, as a share of the angle at which the weight of a wall passes the edge of its
/// lowest joint.
class Wall : public testing::TestWithParam<double> {};

TEST_P(Wall, OfBricksStandsUntilItsWeightPassesItsFoot) {
  constexpr int kCourses = 6, kBricks = 3;
  constexpr double kLength = 0.5, kHeight = 0.2, kDepth = 0.2, kJoint = 1e-3;
  std::vector<Placed> blocks = {floor_slab(2.0)};
  for (int course = 0; course < kCourses; ++course) {
    // Running bond: every other course begins and ends with half a brick.
    std::vector<double> ends = {0.0};
    if (course % 2 == 1) ends.push_back(0.5 * kLength);
    while (ends.back() + kLength <= kBricks * kLength) ends.push_back(ends.back() + kLength);
    if (course % 2 == 1) ends.push_back(kBricks * kLength);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      blocks.push_back(
          box_between({ends[i] - 0.75, -0.5 * kDepth, kHeight * course},
                      {ends[i + 1] - 0.75 - kJoint, 0.5 * kDepth, kHeight * (course + 1)}));
    }
  }
  const double topples = std::atan((kDepth - 2.0 * kEdgeRadius) / (kCourses * kHeight));
  World world = world_of(blocks, 0.6, GetParam() * topples);
  EXPECT_EQ(is_representative(world), GetParam() < 1.0);
}
INSTANTIATE_TEST_SUITE_P(Shares, Wall, testing::Values(0.0, 0.95, 1.05));

/// The arch of seven voussoirs between semicircles about the origin, on fixed abutments.
struct Arch {
  static constexpr int kBlocks = 7;
  static constexpr double kMeanRadius = 2.0;  // m
  explicit Arch(double of_thickness) : thickness(of_thickness) {
    for (int i = 0; i < kBlocks; ++i) {
      std::vector<Vec3> corners;
      for (const int side : {0, 1}) {
        const double angle = std::numbers::pi * ((i + side) / double(kBlocks) - 0.5);
        const Vec3 along(std::sin(angle), 0.0, std::cos(angle));
        const Vec3 inward = (side == 0 ? 1.0 : -1.0) * Vec3(along.z(), 0.0, -along.x());
        for (const double radius : {inner(), outer()}) {
          for (const double y : {-0.3, 0.3}) {
            corners.push_back(radius * along + kEdgeRadius * inward + Vec3(0.0, y, 0.0));
          }
        }
      }
      blocks.push_back(block_of(corners));
    }
    blocks.push_back(floor_slab(2.0 * kMeanRadius));
  }
  double inner() const { return kMeanRadius - 0.5 * thickness; }
  double outer() const { return kMeanRadius + 0.5 * thickness; }

  double thickness;  ///< of the flat parts of the joints, which is where forces can pass, m
  std::vector<Placed> blocks;
};

/// Is there a line of thrust that stays within all joints? The part above the joint at the angle a
/// from the crown, of weight W and with its weight's arm X (that of half the crown's block left
/// out, which is the same for all joints), is in equilibrium if the thrust passes the joint at the
/// radius r = (W X + u)/(W sin a + H cos a) with the horizontal thrust H and one u for all joints:
/// linear inequalities in H and u (Heyman's safe theorem).
bool line_of_thrust_fits(const Arch& arch) {
  struct Line {  // a H + b u <= c
    double a, b, c;
  };
  std::vector<Line> limits = {{-1.0, 0.0, 0.0}};
  double weight = 0.0, moment = 0.0;
  for (int i = Arch::kBlocks / 2; i < Arch::kBlocks; ++i) {
    const Placed& block = arch.blocks[static_cast<std::size_t>(i)];
    const bool crown = i == Arch::kBlocks / 2;
    const double part = (crown ? 0.5 : 1.0) * block.body.mass * kTestGravity;
    weight += part;
    if (!crown) moment += part * block.state.position.x();
    const double angle = std::numbers::pi * ((i + 1) / double(Arch::kBlocks) - 0.5);
    const double s = std::sin(angle), c = std::cos(angle);
    limits.push_back({arch.inner() * c, -1.0, moment - arch.inner() * weight * s});
    limits.push_back({-arch.outer() * c, 1.0, arch.outer() * weight * s - moment});
  }
  for (const Line& one : limits) {
    for (const Line& two : limits) {
      const double determinant = one.a * two.b - two.a * one.b;
      if (std::abs(determinant) < 1e-12) continue;
      const double thrust = (one.c * two.b - two.c * one.b) / determinant;
      const double u = (one.a * two.c - two.a * one.c) / determinant;
      const bool inside = std::all_of(limits.begin(), limits.end(), [&](const Line& line) {
        return line.a * thrust + line.b * u <= line.c + 1e-9 * weight;
      });
      if (inside) return true;
    }
  }
  return false;
}

double least_thickness() {
  double falls = 0.02, stays = 1.0;
  while (stays - falls > 1e-4) {
    const double middle = 0.5 * (falls + stays);
    (line_of_thrust_fits(Arch(middle)) ? stays : falls) = middle;
  }
  return stays;
}

/// As thick as this share of the least thickness that stands.
class Arches : public testing::TestWithParam<double> {};

TEST_P(Arches, OfSevenVoussoirsStandAsLongAsALineOfThrustFitsIn) {
  const Arch arch(GetParam() * least_thickness());
  World world = world_of(arch.blocks, 0.9);
  EXPECT_EQ(is_representative(world), GetParam() > 1.0);
}
INSTANTIATE_TEST_SUITE_P(Shares, Arches, testing::Values(0.95, 0.98, 1.05));

// Five equal balls in a row, a little apart so that they hit one after the other.
TEST(Cradle, HandsTheVelocityToTheLastBall) {
  const RigidBody one = ball(1.0, 0.1);
  WorldSettings settings = stiff_world(one, 1e7, 40.0);
  settings.between_bodies = {1.0, 0.3, 0.0};
  World world({one}, settings);
  for (int i = 0; i < 5; ++i) {
    world.add_body(0, at({0.21 * i, 0.0, 0.0}, {i == 0 ? 1.0 : 0.0, 0.0, 0.0}));
  }
  while (world.time() < 0.2) world.step();
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(world.state(i).velocity.x(), i == 4 ? 1.0 : 0.0, 1e-6) << i;
  }
}

}  // namespace
}  // namespace clast
