// Rock masses cut by joint sets.
#include "shapes/joint_sets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_tree.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

TEST(JointSet, IsWrittenAsGeologistsDo) {
  const JointSet set = parse_joint_set("65/095/1.2/0.3");
  EXPECT_NEAR(set.dip, 65.0 * kRadiansPerDegree, 1e-12);
  EXPECT_NEAR(set.dip_direction, 95.0 * kRadiansPerDegree, 1e-12);
  EXPECT_EQ(set.spacing, 1.2);
  EXPECT_EQ(set.spacing_deviation, 0.3);
  EXPECT_EQ(parse_joint_set("0/0/2").spacing_deviation, 0.0);
  // A plane that dips 30 degrees to the east descends eastwards: its normal leans there.
  const Vec3 normal = parse_joint_set("30/90/1").normal();
  EXPECT_LT((normal - Vec3(0.5, 0.0, std::sqrt(0.75))).norm(), 1e-12);
  EXPECT_LT((parse_joint_set("90/0/1").normal() - Vec3::UnitY()).norm(), 1e-12);
  for (const char* wrong : {"", "65", "65/95", "65/95/1/1/1", "a/95/1", "65//1", "65/95/1x"}) {
    EXPECT_TRUE(contains(refusal([&] { parse_joint_set(wrong); }), "is not a joint set")) << wrong;
  }
  EXPECT_TRUE(
      contains(refusal([] { parse_joint_set("95/0/1"); }), "dip = 95; must be from 0 to 90"));
  EXPECT_TRUE(contains(refusal([] { parse_joint_set("5/-1/1"); }), "dip direction = -1"));
  EXPECT_TRUE(contains(refusal([] { parse_joint_set("5/1/0"); }), "spacing = 0"));
  EXPECT_TRUE(contains(refusal([] { parse_joint_set("5/1/1/4"); }), "scatter = 4"));
}

TEST(ConvexCell, CutsOfABoxAreClosedAndAddUp) {
  Bounds box;
  box.include({-1.0, -2.0, 0.0});
  box.include({3.0, 1.0, 2.0});
  const ConvexCell whole(box);
  EXPECT_NEAR(whole.volume(), 24.0, 1e-12);
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vec3 normal = random.unit_vector();
    const Plane plane{normal, normal.dot(Vec3(1.0, -0.5, 1.0)) + random.uniform(-0.5, 0.5)};
    const auto one = whole.clipped_below(plane, 1e-9),
               other = whole.clipped_below({-normal, -plane.distance}, 1e-9);
    ASSERT_TRUE(one && other);
    EXPECT_NEAR(one->volume() + other->volume(), 24.0, 1e-10);
    for (const ConvexCell& part : {*one, *other}) {
      const MeshReport report = inspect_mesh(part.mesh());
      EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
      EXPECT_EQ(report.euler_characteristic, 2);
      EXPECT_NEAR(signed_volume(part.mesh()), part.volume(), 1e-10);
    }
  }
  // Through vertices, along a face, beside the box.
  EXPECT_NEAR(whole.clipped_below({Vec3(1, 1, 0).normalized(), 0.0}, 1e-9)->volume(), 2.0 * 4.5,
              1e-9);
  EXPECT_EQ(whole.clipped_below({Vec3::UnitZ(), 2.0}, 1e-9)->vertices().size(), 8u);
  EXPECT_FALSE(whole.clipped_below({Vec3::UnitZ(), 0.0}, 1e-9));
  EXPECT_FALSE(whole.clipped_below({Vec3::UnitX(), -5.0}, 1e-9));
}

/// Blocks are closed, convex, inside the mass and share no inner point.
void expect_sound(const JointedRockMass& cut, const TriangleMesh& mass, double slack) {
  const TriangleTree tree(mass);
  for (const TriangleMesh& block : cut.blocks) {
    const MeshReport report = inspect_mesh(block);
    EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
    for (const Vec3& vertex : block.vertices) EXPECT_LT(tree.signed_distance(vertex), slack);
    for (const TriangleMesh::Triangle& t : block.triangles) {
      const Vec3& a = block.vertices[t[0]];
      const Vec3 normal = (block.vertices[t[1]] - a).cross(block.vertices[t[2]] - a).normalized();
      for (const Vec3& vertex : block.vertices) EXPECT_LT(normal.dot(vertex - a), slack);
    }
  }
  Random random(1);
  const Bounds box = bounds(mass);
  std::vector<std::unique_ptr<TriangleTree>> trees;
  for (const TriangleMesh& block : cut.blocks)
    trees.push_back(std::make_unique<TriangleTree>(block));
  for (int i = 0; i < 300; ++i) {
    const Vec3 size = box.high - box.low;
    const Vec3 point = box.low + Vec3(random.uniform() * size.x(), random.uniform() * size.y(),
                                      random.uniform() * size.z());
    int holders = 0;
    for (const auto& block : trees) holders += block->signed_distance(point) < -slack;
    EXPECT_LE(holders, 1);
  }
}

TEST(CutByJoints, ThreeUprightSetsCutABoxIntoBoxes) {
  const TriangleMesh mass = box_mesh({6.0, 4.0, 3.0});
  const std::vector<JointSet> sets = {parse_joint_set("90/90/1"), parse_joint_set("90/0/1"),
                                      parse_joint_set("0/0/1")};
  const JointedRockMass cut = cut_by_joints(mass, sets, {.min_volume = 1e-9});
  EXPECT_NEAR(cut.volume, 72.0, 1e-9);
  EXPECT_NEAR(cut.block_volume, 72.0, 1e-6);
  // Joints lie anywhere: as many cells as spacings fit, and the two ends of each row.
  EXPECT_EQ(cut.blocks.size(), 7u * 5u * 4u);
  for (const TriangleMesh& block : cut.blocks) EXPECT_EQ(block.vertices.size(), 8u);
  expect_sound(cut, mass, 1e-6);
  const JointedRockMass other = cut_by_joints(mass, sets, {.min_volume = 1e-9, .seed = 2});
  EXPECT_NE(signed_volume(other.blocks[0]), signed_volume(cut.blocks[0]));
  EXPECT_EQ(cut_by_joints(mass, sets, {.min_volume = 1e-9}).blocks[7].vertices,
            cut.blocks[7].vertices);
}

// Spacing and scatter of one set, from the volumes of the slabs that it cuts from a long beam.
TEST(CutByJoints, SpacingsHaveTheMeanAndTheScatterAskedFor) {
  const TriangleMesh beam = box_mesh({4000.0, 1.0, 1.0});
  const std::vector<JointSet> sets = {
      {90.0 * kRadiansPerDegree, 90.0 * kRadiansPerDegree, 2.0, 0.8}};
  const JointedRockMass cut = cut_by_joints(beam, sets);
  double sum = 0.0, squares = 0.0;
  for (const TriangleMesh& slab : cut.blocks) {
    const double width = signed_volume(slab);
    sum += width;
    squares += width * width;
  }
  const auto count = static_cast<double>(cut.blocks.size());
  EXPECT_NEAR(sum / count, 2.0, 0.06);
  EXPECT_NEAR(std::sqrt(squares / count - sum * sum / count / count), 0.8, 0.06);
}

// A round mass far out on the map: convex, so that nothing is lost but what is too small.
TEST(CutByJoints, ABallOnTheMapIsCutWithoutLoss) {
  TriangleMesh mass = rock_mesh(12, {4.0, 3.0, 2.5}, 1, 0.0);
  for (Vec3& vertex : mass.vertices) vertex += Vec3(652000.0, 5203000.0, 1800.0);
  const std::vector<JointSet> sets = {parse_joint_set("70/095/1.3/0.4"),
                                      parse_joint_set("60/200/1.1/0.3"),
                                      parse_joint_set("20/310/0.9/0.2")};
  const JointedRockMass cut = cut_by_joints(mass, sets);
  EXPECT_GT(cut.blocks.size(), 60u);
  EXPECT_GT(cut.block_volume, 0.97 * cut.volume);
  EXPECT_LE(cut.block_volume, cut.volume * (1.0 + 1e-9));
  expect_sound(cut, mass, 1e-4);
}

// A rough mass, hollow in places: blocks stay inside all the same.
TEST(CutByJoints, ARoughMassLosesWhatIsHollow) {
  const TriangleMesh mass = rock_mesh(14, {4.0, 3.0, 2.5}, 5);
  const std::vector<JointSet> sets = {parse_joint_set("70/095/1.5/0.4"),
                                      parse_joint_set("60/200/1.2/0.3"),
                                      parse_joint_set("20/310/1.0/0.2")};
  const JointedRockMass cut = cut_by_joints(mass, sets);
  EXPECT_GT(cut.block_volume, 0.8 * cut.volume);
  EXPECT_LT(cut.block_volume, cut.volume);
  EXPECT_NEAR(cut.lost_volume(), cut.volume - cut.block_volume, 1e-12);
  expect_sound(cut, mass, 1e-3);
}

TEST(CutByJoints, RefusesWhatItCanNotCut) {
  const TriangleMesh mass = box_mesh({6.0, 4.0, 3.0});
  const std::vector<JointSet> fine = {parse_joint_set("90/90/0.05"), parse_joint_set("90/0/0.05"),
                                      parse_joint_set("0/0/0.05")};
  EXPECT_TRUE(contains(refusal([&] { cut_by_joints(mass, {}); }), "no joint set"));
  EXPECT_TRUE(contains(refusal([&] { cut_by_joints(mass, fine, {.min_volume = 1e-9}); }),
                       "into more than 10000 blocks"));
  const std::vector<JointSet> one = {parse_joint_set("45/90/1")};
  EXPECT_TRUE(contains(refusal([&] { cut_by_joints(mass, one, {.min_volume = 100.0}); }),
                       "no block of 100 m3"));
  TriangleMesh open = mass;
  open.triangles.pop_back();
  EXPECT_TRUE(contains(refusal<GeometryError>([&] { cut_by_joints(open, one); }),
                       "is not a closed surface"));
  // A mass of kilometres, as in wrong units, is refused at once.
  EXPECT_TRUE(contains(refusal([&] {
                         cut_by_joints(box_mesh({6e4, 4e4, 3e4}), fine);
                       }),
                       "into more than 10000 blocks"));
  TriangleMesh crossed = rock_mesh(4, {4.0, 3.0, 2.5}, 1, 0.0);
  crossed.vertices[20] = Vec3(0.0, 0.0, 0.0) - 2.0 * crossed.vertices[20];
  EXPECT_TRUE(
      contains(refusal<GeometryError>([&] { cut_by_joints(crossed, one); }), "crosses itself"));
  TriangleMesh turned = mass;
  for (auto& triangle : turned.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_TRUE(
      contains(refusal<GeometryError>([&] { cut_by_joints(turned, one); }), "faces inwards"));
}

}  // namespace
}  // namespace clast
