// The sleeping candidates against a search that has forgotten everything.
#include "dem/detail/contact_search.hpp"

#include <gtest/gtest.h>

#include "dem/detail/terrain_impl.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

std::vector<ContactPoint> from_scratch(const TerrainSurface& terrain, const RigidBody& body,
                                       const Pose& pose) {
  const IndexedSurface block = indexed_surface(body.shape);
  ContactSearch search(terrain.impl().surface, block, body.size());
  search.contacts(pose, 0.0);
  return search.contacts(pose, body.bounding_radius());  // every list expired, depths known
}

class LongWalk : public testing::TestWithParam<unsigned> {};

TEST_P(LongWalk, NothingTouchesUnseen) {
  Random random(GetParam());
  const double radius = GetParam() % 3 == 0 ? 0.0 : 0.02;
  const RigidBody body = rock(3, {0.42, 0.36, 0.30}, radius, 2700.0, GetParam());
  const IndexedSurface block = indexed_surface(body.shape);
  const TerrainSurface terrain = ground(rough_slope(30, 0.35, 0.5, 0.10, GetParam()));
  ContactSearch search(terrain.impl().surface, block, body.size());
  Pose pose;
  double travel = 0.0;
  std::size_t seen = 0;
  for (int i = 0; i < 3000; ++i) {
    const double turn = random.uniform(0.0, 0.01);
    const Vec3 shift = random.uniform(0.0, 0.01) * random.direction();
    pose.rotation =
        (Quat(Eigen::AngleAxisd(turn, random.direction())) * pose.rotation).normalized();
    pose.translation += shift;
    travel += shift.norm() + turn * body.bounding_radius();
    // Kept near the ground: between clear of it and a tenth of the block inside.
    const double height = *terrain.height(pose.translation.x(), pose.translation.y(), 0.0);
    const double wanted = std::clamp(pose.translation.z() - height, 0.24, 0.42);
    travel += std::abs(height + wanted - pose.translation.z());
    pose.translation.z() = height + wanted;

    const std::vector<ContactPoint>& found = search.contacts(pose, travel);
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
INSTANTIATE_TEST_SUITE_P(Seeds, LongWalk, testing::Range(1u, 9u));

TEST(SafeTravel, NoContactBeforeIt) {
  Random random(2);
  const RigidBody body = rock(3, {0.42, 0.36, 0.30}, 0.01, 2700.0, 5);
  const IndexedSurface block = indexed_surface(body.shape);
  const TerrainSurface terrain = ground(rough_slope(30, 0.5, 0.4, 0.10));
  for (int i = 0; i < 200; ++i) {
    Pose pose{{random.uniform(-3, 3), random.uniform(-3, 3), 0.0}, random.rotation()};
    pose.translation.z() =
        *terrain.height(pose.translation.x(), pose.translation.y(), 0.0) + random.uniform(0.5, 3.0);
    ContactSearch search(terrain.impl().surface, block, body.size());
    if (!search.contacts(pose, 0.0).empty()) continue;
    const double safe = search.safe_travel();
    for (int trial = 0; trial < 5; ++trial) {
      Pose moved = pose;
      moved.translation += 0.999 * safe * random.direction();
      EXPECT_TRUE(from_scratch(terrain, body, moved).empty());
    }
  }
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
