// The sleeping candidates against a search that has forgotten everything.
#include "dem/search/terrain_narrow_phase.hpp"

#include <gtest/gtest.h>

#include "dem/search/detail/ballistic_sphere.hpp"
#include "dem/simulation/release.hpp"
#include "dem/surface/ghost_edges.hpp"
#include "dem/surface/segment_distance.hpp"
#include "dem/surface/terrain_impl.hpp"
#include "tests/support/ground_gap.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {

using namespace dem_detail;

namespace {

std::vector<ContactPoint> from_scratch(const TerrainSurface& terrain, const RigidBody& body,
                                       const Pose& pose) {
  const BlockSurface block(body.shape);
  TerrainNarrowPhase search(terrain.impl().surface, block, body.size());
  search.find_contacts(pose, 0.0);
  return search.find_contacts(pose, body.bounding_radius());  // every list expired, depths known
}

class LongWalk : public testing::TestWithParam<unsigned> {};

TEST_P(LongWalk, NothingTouchesUnseen) {
  Random random(GetParam());
  const double radius = GetParam() % 3 == 0 ? 0.0 : 0.02;
  const RigidBody body = rock(3, {0.42, 0.36, 0.30}, radius, 2700.0, GetParam());
  const BlockSurface block(body.shape);
  const TerrainSurface terrain = ground(rough_slope(30, 0.35, 0.5, 0.10, GetParam()));
  TerrainNarrowPhase search(terrain.impl().surface, block, body.size());
  Pose pose;
  double displacement = 0.0;
  std::size_t seen = 0;
  for (int i = 0; i < 3000; ++i) {
    const double turn = random.uniform(0.0, 0.01);
    const Vec3 shift = random.uniform(0.0, 0.01) * random.unit_vector();
    pose.rotation =
        (Quat(Eigen::AngleAxisd(turn, random.unit_vector())) * pose.rotation).normalized();
    pose.translation += shift;
    displacement += shift.norm() + turn * body.bounding_radius();
    // Kept near the ground: between clear of it and a tenth of the block inside.
    const double height = *terrain.height_at(pose.translation.x(), pose.translation.y(), 0.0);
    const double wanted = std::clamp(pose.translation.z() - height, 0.24, 0.42);
    displacement += std::abs(height + wanted - pose.translation.z());
    pose.translation.z() = height + wanted;

    const std::vector<ContactPoint>& found = search.find_contacts(pose, displacement);
    seen += found.size();
    if (i % 5 != 0) continue;
    const std::vector<ContactPoint> expected = from_scratch(terrain, body, pose);
    ASSERT_EQ(found.size(), expected.size()) << "step " << i;
    for (std::size_t c = 0; c < found.size(); ++c) {
      EXPECT_EQ(found[c].kind, expected[c].kind);
      EXPECT_EQ(found[c].block_feature, expected[c].block_feature);
      EXPECT_NEAR(found[c].overlap, expected[c].overlap, 1e-12);
      EXPECT_LT((found[c].normal - expected[c].normal).norm(), 1e-9);
    }
  }
  EXPECT_GT(seen, 1000u);
}
// 19, 24 and 35 are walks on which a turn brings deep edges into contact.
INSTANTIATE_TEST_SUITE_P(Seeds, LongWalk, testing::Values(1u, 2u, 3u, 4u, 5u, 6u, 19u, 24u, 35u));

TEST(SafeTravel, NoContactBeforeIt) {
  Random random(2);
  const RigidBody body = rock(3, {0.42, 0.36, 0.30}, 0.01, 2700.0, 5);
  const BlockSurface block(body.shape);
  const TerrainSurface terrain = ground(rough_slope(30, 0.5, 0.4, 0.10));
  for (int i = 0; i < 200; ++i) {
    Pose pose{{random.uniform(-3, 3), random.uniform(-3, 3), 0.0}, random.rotation()};
    pose.translation.z() = *terrain.height_at(pose.translation.x(), pose.translation.y(), 0.0) +
                           random.uniform(0.5, 3.0);
    TerrainNarrowPhase search(terrain.impl().surface, block, body.size());
    if (!search.find_contacts(pose, 0.0).empty()) continue;
    const double safe = search.contact_free_displacement();
    for (int trial = 0; trial < 5; ++trial) {
      Pose moved = pose;
      moved.translation += 0.999 * safe * random.unit_vector();
      EXPECT_TRUE(from_scratch(terrain, body, moved).empty());
    }
  }
}

TEST(SafeTime, NoContactBeforeIt) {
  Random random(4);
  const RigidBody body = rock(3, {0.42, 0.36, 0.30}, 0.01, 2700.0, 5);
  const BlockSurface block(body.shape);
  const TerrainSurface terrain = ground(rough_slope(30, 0.5, 0.4, 0.10));
  const double g = 9.81, uneven = body.moments.maxCoeff() / body.moments.minCoeff();
  const double radius = body.bounding_radius();
  double flown = 0.0, by_top_speed = 0.0;
  for (int i = 0; i < 200; ++i) {
    RigidState start;
    start.position = {random.uniform(-3, 3), random.uniform(-3, 3), 0.0};
    start.orientation = random.rotation();
    start.position.z() = *terrain.height_at(start.position.x(), start.position.y(), 0.0) + 2.0;
    const std::optional<double> gap = ground_gap(terrain, body, start, 3.0);
    ASSERT_TRUE(gap);
    start.position.z() -= *gap - random.uniform(0.001, 0.1);  // close to the ground or in it
    // About as if it rolled.
    start.angular_velocity = random.uniform(0.0, 20.0) * random.unit_vector();
    start.velocity = start.angular_velocity.cross(Vec3(0.0, 0.0, 0.36)) +
                     random.uniform(0.0, 1.0) * random.unit_vector();
    TerrainNarrowPhase search(terrain.impl().surface, block, body.size());
    if (!search.find_contacts(start.world_from_body(), 0.0).empty()) continue;
    const double spin = std::sqrt(2.0 * rotational_energy(body, start) / body.moments.minCoeff());
    const double max_point_speed = start.velocity.norm() + spin * radius;
    const double time =
        search.find_contact_free_flight_time({.velocity = start.velocity,
                                              .spin = start.angular_velocity,
                                              .rotational_acceleration = uneven * spin * spin,
                                              .acceleration = g + uneven * spin * spin * radius,
                                              .max_point_speed = max_point_speed,
                                              .gravity = g},
                                             1e-5);
    EXPECT_GT(time, 0.0);
    flown += time;
    by_top_speed += search.contact_free_displacement() / max_point_speed;
    for (const double share : {0.25, 0.5, 0.75, 0.999}) {
      const RigidState later = free_flight(body, start, share * time, g);
      EXPECT_TRUE(from_scratch(terrain, body, later.world_from_body()).empty())
          << "release " << i << " at " << share << " of " << time << " s";
    }
  }
  // What the velocity of every vertex gives over the top speed of any.
  EXPECT_GT(flown, 1.2 * by_top_speed);
}

// From cells alone, so never too long, and on flat ground too short by one stretch of the path.
TEST(BallisticSphere, TouchesNothingBeforeItsClearTime) {
  Random random(3);
  double flown = 0.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const TerrainSurface terrain =
        ground(rough_slope(24, 0.5, random.uniform(0.0, 0.8), 0.1, seed));
    const IndexedSurface& surface = terrain.impl().surface;
    BallisticSphere ball{.centre = {random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0), 0.0},
                         .velocity = random.uniform(0.0, 15.0) * random.unit_vector(),
                         .gravity = seed % 5 == 0 ? 0.0 : 9.81,
                         .radius = random.uniform(0.1, 1.0)};
    ball.centre.z() = *terrain.height_at(ball.centre.x(), ball.centre.y(), 0.0) + ball.radius +
                      random.uniform(0.0, 3.0);
    const double time = ballistic_contact_free_time(surface.grid, ball, 3.0);
    flown += time;
    for (int i = 1; i <= 40; ++i) {
      const double t = time * i / 40.0;
      const Vec3 centre =
          ball.centre + t * ball.velocity - Vec3(0.0, 0.0, 0.5 * ball.gravity * t * t);
      const std::optional<NearestPoint> nearest = surface.nearest_point(centre, 2.0 * ball.radius);
      const double distance = nearest ? nearest->distance : 2.0 * ball.radius;
      EXPECT_TRUE(time == 0.0 || distance >= ball.radius) << seed;
    }
  }
  EXPECT_GT(flown, 20.0);  // s
  const TerrainSurface flat = ground(plane_mesh(20.0, 80));
  const BallisticSphere falling{
      .centre = {0.3, 0.2, 3.0}, .velocity = Vec3::Zero(), .gravity = 9.81, .radius = 0.5};
  const double root = std::sqrt(2.0 * 2.5 / 9.81);
  const double time = ballistic_contact_free_time(flat.impl().surface.grid, falling, 3.0);
  EXPECT_LE(time, root);
  EXPECT_GT(9.81 * time * time / 2.0, 2.5 - 0.5);
  const BallisticSphere leaving{
      .centre = {0.0, 0.0, 3.0}, .velocity = {30.0, 0.0, 0.0}, .gravity = 0.0, .radius = 0.5};
  EXPECT_NEAR(ballistic_contact_free_time(flat.impl().surface.grid, leaving, 9.0), 20.0 / 30.0,
              1.0 / 30.0);
}

/// A ridge 1 m high and 4 cm wide at its foot, on level ground.
TriangleMesh thin_ridge() {
  TriangleMesh mesh;
  const std::array<double, 5> across = {-20.0, -0.02, 0.0, 0.02, 20.0};
  const std::array<double, 5> height = {0.0, 0.0, 1.0, 0.0, 0.0};
  for (std::uint32_t row = 0; row < 5; ++row) {
    for (std::uint32_t i = 0; i < 5; ++i) {
      mesh.vertices.emplace_back(across[i], 10.0 * row - 20.0, height[i]);
      if (row == 4 || i == 4) continue;
      const std::uint32_t a = 5 * row + i;
      mesh.triangles.push_back({a, a + 1, a + 6});
      mesh.triangles.push_back({a, a + 6, a + 5});
    }
  }
  return mesh;
}

TEST(TerrainNarrowPhase, TakesNothingFromAnotherOfItsThread) {
  const TerrainSurface terrain = ground(thin_ridge());
  const RigidBody small = box(100.0, {0.4, 0.4, 0.4}), large = box(1e5, {3.0, 3.0, 3.0});
  const BlockSurface small_surface(small.shape), large_surface(large.shape);
  int passed = 0;
  for (const double height : {0.85, 0.9, 0.95}) {
    for (const double tilt : {0.1, 0.2, 0.4}) {
      TerrainNarrowPhase pierced(terrain.impl().surface, small_surface, small.size());
      TerrainNarrowPhase flying(terrain.impl().surface, large_surface, large.size());
      const Pose on_ridge{{0.1, 0.3, height}, Quat(Eigen::AngleAxisd(-tilt, Vec3::UnitY()))};
      // Where its edges have only passed through the ridge they do not touch, but are measured.
      if (pierced.find_contacts(on_ridge, 0.0).empty() &&
          pierced.contact_free_displacement() == 0.0)
        ++passed;
      EXPECT_TRUE(flying.find_contacts({{5.0, 0.0, 50.0}, Quat::Identity()}, 0.0).empty());
    }
  }
  EXPECT_GE(passed, 5);
}

TEST(LocalGround, AgreesWithTheWholeGround) {
  Random random(6);
  const TerrainSurface terrain = ground(rough_slope(30, 0.35, 0.5, 0.10));
  const IndexedSurface& whole = terrain.impl().surface;
  for (int i = 0; i < 50; ++i) {
    Vec3 centre(random.uniform(-4, 4), random.uniform(-4, 4), 0.0);
    centre.z() = *terrain.height_at(centre.x(), centre.y(), 0.0);
    LocalGround around;
    LocalFaces local;
    around.collect_near(whole, centre, 2.0);
    local.collect_near(whole.features, around, centre, 1.2);
    for (int k = 0; k < 20; ++k) {
      const Vec3 query = centre + random.uniform(0.0, 0.6) * random.unit_vector();
      const std::optional<NearestPoint> expected = whole.nearest_point(query, 5.0);
      ASSERT_TRUE(expected);
      const auto guess = static_cast<std::uint32_t>(random.uniform_index(local.faces.size()));
      const LocalFaces::NearestFace found = local.nearest(whole.features, query, 0.6, 0.3, guess);
      EXPECT_EQ(found.nearest.distance, expected->distance);
      EXPECT_EQ(found.nearest.face, expected->face);
      double second = 1e300;
      for (std::uint32_t f = 0; f < whole.features.faces.size(); ++f) {
        if (f == expected->face) continue;
        second =
            std::min(second, std::abs(nearest_point_on_face(whole.features, f, query).distance));
      }
      EXPECT_LE(found.second, second);
      EXPECT_GE(found.second, std::min(second, std::abs(expected->distance) + 0.3) - 1e-12);
      EXPECT_LE(local.plane.clearance(query), expected->distance);
    }
  }
}

TEST(ClosestSegmentPoints, NoOtherPairOfPointsIsCloser) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = random.unit_vector(), b = 0.5 * random.unit_vector(), u = random.unit_vector();
    const Vec3 v = i % 10 == 0 ? u : random.unit_vector();  // parallel ones too
    const double length_a = random.uniform(0.1, 2.0), length_b = random.uniform(0.1, 2.0);
    const ClosestSegmentPoints closest = closest_segment_points({a, u, length_a}, {b, v, length_b});
    EXPECT_LT((closest.separation - (a + closest.first * u - b - closest.second * v)).norm(),
              1e-12);
    double sampled = 1e300;
    for (int s = 0; s <= 100; ++s) {
      for (int t = 0; t <= 100; ++t) {
        const Vec3 between = a + 0.01 * s * length_a * u - b - 0.01 * t * length_b * v;
        sampled = std::min(sampled, between.norm());
      }
    }
    EXPECT_LE(closest.separation.norm(), sampled + 1e-12);
    EXPECT_GE(closest.separation.norm(), sampled - 0.01 * (length_a + length_b));
  }
}

// Segments that do not cross are moved about at random, as far as `displacement_to_crossing`
// allows.
TEST(WayToCrossing, NothingCrossesBefore) {
  Random random(11);
  int bounded = 0, crossed_soon_after = 0;
  for (int i = 0; i < 20000; ++i) {
    const Segment block{0.6 * random.unit_vector(), random.unit_vector(), random.uniform(0.1, 0.6)};
    const Segment ground{block.point_at(random.uniform(-0.3, 0.9)) + 0.1 * random.unit_vector(),
                         random.unit_vector(), random.uniform(0.1, 0.6)};
    const double radius = 1.2;  // of all that the block holds, about the origin
    const ClosestSegmentPoints closest = closest_segment_points(block, ground);
    if (closest.crossing) continue;
    const double displacement =
        displacement_to_crossing(closest, block, ground, Vec3::Zero(), radius);
    EXPECT_GE(displacement, 0.0);
    if (displacement > 0.0) ++bounded;
    const auto crosses_after = [&](double moved) {
      const double turning = random.uniform(0.0, 1.0);
      const double angle = 2.0 * std::asin(std::min(1.0, 0.5 * turning * moved / radius));
      const Eigen::AngleAxisd turn(angle, random.unit_vector());
      const Vec3 shift = (1.0 - turning) * moved * random.unit_vector();
      return closest_segment_points(
                 {turn * block.start + shift, turn * block.direction, block.length}, ground)
          .crossing;
    };
    for (int k = 0; k < 40; ++k) ASSERT_FALSE(crosses_after(0.999 * displacement)) << i;
    for (int k = 0; k < 40; ++k) crossed_soon_after += crosses_after(2.0 * displacement);
  }
  EXPECT_GT(bounded, 10000);
  EXPECT_GT(crossed_soon_after, 10000);  // so the bound is not far from the best there is
}

TEST(Contacts, FourKindsAreFound) {
  // A roof of two faces with a ridge along y at z = 0.
  TriangleMesh roof;
  roof.vertices = {{-2, -2, -1}, {0, -2, 0}, {2, -2, -1}, {-2, 2, -1}, {0, 2, 0}, {2, 2, -1}};
  roof.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  const TerrainSurface ridge = ground(roof);
  const RigidBody cube = box(1.0, Vec3::Ones(), 0.05);
  Pose pose{{0.0, 0.0, 0.54}, Quat::Identity()};
  std::vector<ContactPoint> contacts = from_scratch(ridge, cube, pose);
  ASSERT_EQ(contacts.size(), 2u);  // the ridge passes under two edges of the bottom face
  for (const ContactPoint& contact : contacts) {
    EXPECT_EQ(contact.kind, ContactKind::kEdgeEdge);
    EXPECT_NEAR(contact.overlap, 0.01, 1e-12);
    EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), 1e-12);
  }
  // A peak under the middle of the bottom face.
  TriangleMesh pyramid;
  pyramid.vertices = {{-2, -2, -1}, {2, -2, -1}, {2, 2, -1}, {-2, 2, -1}, {0.1, 0.2, 0}};
  pyramid.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const TerrainSurface peak = ground(pyramid);
  contacts = from_scratch(peak, cube, pose);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].kind, ContactKind::kFaceVertex);
  EXPECT_NEAR(contacts[0].overlap, 0.01, 1e-12);
  // An edge over the peak, and a corner beside it on a face.
  pose.rotation = Quat(Eigen::AngleAxisd(kPi / 4, Vec3::UnitX()));
  pose.translation = {0.1, 0.2, std::sqrt(0.5) + 0.04};
  contacts = from_scratch(peak, cube, pose);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].kind, ContactKind::kEdgeVertex);
  EXPECT_NEAR(contacts[0].overlap, 0.01, 1e-12);
  const TerrainSurface flat = ground(plane_mesh(3.0, 3));
  pose.rotation = Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3(0, 0, -1));
  pose.translation = {0.1, 0.2, std::sqrt(0.75) + 0.04};
  contacts = from_scratch(flat, cube, pose);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].kind, ContactKind::kVertexGround);
  EXPECT_NEAR(contacts[0].overlap, 0.01, 1e-12);
}

// Where the survey ends the ground goes on as the plane of its last faces: what hangs over the
// border is carried as it was before, and not drawn down to a border that lies lower.
TEST(Contacts, BeyondTheBorderAreThoseOfThePlane) {
  const double slope = 0.6, half = 2.0;
  const TerrainSurface falling = ground(plane_mesh(half, 4, slope));
  const Vec3 normal(std::sin(slope), 0.0, std::cos(slope));
  const RigidBody body = ball(1.0, 0.25);
  for (const double uphill : {-1.0, 1.0}) {
    for (const double beyond : {-0.01, 0.001, 0.05, 0.3}) {
      for (const double across : {0.3, half + 0.2}) {  // over a side, and over a corner
        const double x = uphill * (half + beyond), depth = 0.1;
        const Vec3 on_plane(x, across, -std::tan(slope) * x);
        const Pose pose{on_plane - depth * normal, Quat::Identity()};
        const std::vector<ContactPoint> contacts = from_scratch(falling, body, pose);
        ASSERT_EQ(contacts.size(), 1u) << x;
        EXPECT_LT((contacts[0].normal - normal).norm(), 1e-9);
        EXPECT_NEAR(contacts[0].overlap, depth + 0.25, 1e-9);
        EXPECT_LT((contacts[0].surface_point - on_plane).norm(), 1e-9);
      }
    }
  }
}

// All edges rise from the bottom of a pit, so the vertex there owns no direction, neither up into
// the air nor down into the solid.
TEST(NormalCone, OfAPitIsEmpty) {
  TriangleMesh pit;
  pit.vertices = {{-1, -1, 1}, {0, -1, 1.5}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {0, 0, 0}};
  pit.triangles = {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}};
  const SurfaceFeatures surface = extract_surface_features(pit);
  Random random(1);
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(is_in_normal_cone(surface, 5, random.unit_vector()));
  EXPECT_FALSE(is_in_normal_cone(surface, 5, -Vec3::UnitZ()));
  EXPECT_FALSE(is_near_normal_cone(surface, 5, -Vec3::UnitZ()));
  for (Vec3& vertex : pit.vertices) vertex.z() = -vertex.z();
  EXPECT_TRUE(is_in_normal_cone(extract_surface_features(pit), 5, Vec3::UnitZ()));
}

TEST(GroundGap, CubeOverAPlaneAndARidge) {
  const RigidBody cube = box(1.0, Vec3::Ones(), 0.05);
  RigidState state;
  state.position = {0.2, 0.1, 1.0};
  const TerrainSurface flat = ground(plane_mesh(5.0, 7));
  EXPECT_NEAR(*ground_gap(flat, cube, state, 2.0), 0.45, 1e-12);
  EXPECT_FALSE(ground_gap(flat, cube, state, 0.4));
  state.position.z() = 0.5;
  EXPECT_NEAR(*ground_gap(flat, cube, state, 2.0), -0.05, 1e-12);
}

}  // namespace
}  // namespace clast
