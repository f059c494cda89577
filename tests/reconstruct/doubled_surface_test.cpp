/// A block's surface that is there twice, a little apart.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "massprops/solid.hpp"
#include "reconstruct/field_scan.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/cut_blocks.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/solid_volume.hpp"

namespace clast {
namespace {

using Triangle = TriangleMesh::Triangle;

const TriangleMesh& doubled_rock() {
  static const TriangleMesh mesh = rock_mesh(10, {0.5, 0.4, 0.3}, 5);
  return mesh;
}

TriangleMesh turned_over(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

std::string block_notes(const FieldBlock& block) {
  std::string text;
  for (const std::string& note : block.scan.notes) text += note + "\n";
  return text;
}

TEST(DuplicateSurface, ACompleteCopyInsideOrOutsideIsNoBubble) {
  for (const double scale : {0.95, 0.97, 0.99, 1.01, 1.03, 1.05}) {
    for (const bool inward : {false, true}) {
      SCOPED_TRACE(std::to_string(scale) + (inward ? " inward" : ""));
      const TriangleMesh copy = scaled(doubled_rock(), scale);
      const FieldBlock block = extract_field_blocks(
          merged(doubled_rock(), inward ? turned_over(copy) : copy), "doubled")[0];
      const RepairReport& report = block.scan.report;
      ASSERT_EQ(report.duplicates.size(), 1u);
      EXPECT_EQ(report.inner_shells, 0u);
      EXPECT_TRUE(report.duplicates[0].closed);
      EXPECT_EQ(report.duplicates[0].retention_reason, RetentionReason::kLarger);
      const double larger = solid_volume(doubled_rock()) * std::max(1.0, scale * scale * scale);
      const double smaller = solid_volume(doubled_rock()) * std::min(1.0, scale * scale * scale);
      EXPECT_NEAR(solid_volume(block.scan.mesh) / larger, 1.0, 1e-9);
      EXPECT_NEAR(report.volume_below / (larger - smaller), 1.0, 1e-6);
      EXPECT_NEAR(report.duplicates[0].scale, scale < 1.0 ? scale : 1.0 / scale, 0.003);
      EXPECT_LT(report.duplicates[0].offset, 0.0);
      EXPECT_TRUE(contains(block_notes(block), "a second copy of the block's whole surface"));
      EXPECT_TRUE(contains(block_notes(block), "not a bubble"));
      EXPECT_TRUE(contains(block_notes(block), "with the other copy it would be"));
    }
  }
}

TEST(DuplicateSurface, AShiftedCopyIsDropped) {
  Random random(2);
  for (const double share : {0.01, 0.03, 0.05}) {
    TriangleMesh copy = doubled_rock();
    const Vec3 shift = share * bounds(doubled_rock()).diagonal() * random.unit_vector();
    for (Vec3& v : copy.vertices) v += shift;
    const FieldBlock block = extract_field_blocks(merged(doubled_rock(), copy), "shifted")[0];
    ASSERT_EQ(block.scan.report.duplicates.size(), 1u);
    EXPECT_NEAR(block.scan.report.duplicates[0].scale, 1.0, 0.003);
    EXPECT_NEAR(solid_volume(block.scan.mesh) / solid_volume(doubled_rock()), 1.0, 1e-9);
  }
}

TEST(DuplicateSurface, TheFinerOfTwoIsKeptAndThatIsSaid) {
  const TriangleMesh fine = rock_mesh(14, {0.5, 0.4, 0.3}, 5);
  for (const double scale : {0.97, 1.03}) {
    const FieldBlock block =
        extract_field_blocks(merged(scaled(doubled_rock(), scale), fine), "two scans")[0];
    EXPECT_NEAR(solid_volume(block.scan.mesh) / solid_volume(fine), 1.0, 1e-9);
    ASSERT_EQ(block.scan.report.duplicates.size(), 1u);
    EXPECT_EQ(block.scan.report.duplicates[0].retention_reason, RetentionReason::kFiner);
    EXPECT_TRUE(contains(block_notes(block), "The kept copy has more triangles"));
  }
}

TEST(DuplicateSurface, ACopyOfAPartIsDroppedAndWhatItWouldChangeIsSaid) {
  for (const double scale : {0.95, 0.98, 1.02, 1.05}) {
    for (const bool inward : {false, true}) {
      SCOPED_TRACE(std::to_string(scale) + (inward ? " inward" : ""));
      TriangleMesh part = scaled(doubled_rock(), scale);
      std::erase_if(part.triangles,
                    [&](const Triangle& t) { return part.vertices[t[0]].z() < 0.05; });
      const FieldBlock block = extract_field_blocks(
          merged(doubled_rock(), inward ? turned_over(part) : part), "part")[0];
      EXPECT_NEAR(solid_volume(block.scan.mesh) / solid_volume(doubled_rock()), 1.0, 1e-9);
      EXPECT_FALSE(block.underside);
      const RepairReport& report = block.scan.report;
      ASSERT_EQ(report.duplicates.size(), 1u);
      EXPECT_FALSE(report.duplicates[0].closed);
      EXPECT_EQ(report.duplicates[0].retention_reason, RetentionReason::kClosed);
      EXPECT_EQ(report.duplicates[0].offset > 0.0, scale > 1.0);
      // Seen from the middle, the layer between the two is (s^3 - 1) / 3 of what lies below it;
      // the mean distance times the area is that to the second order.
      EXPECT_GT(std::abs(report.duplicates[0].volume_change), 0.0);
      EXPECT_LT(std::abs(report.duplicates[0].volume_change),
                std::abs(scale * scale * scale - 1.0) * solid_volume(doubled_rock()));
      EXPECT_TRUE(contains(block_notes(block), "a second copy of "));
    }
  }
}

/// Two open scans of one block on its ground: one is dropped, the unseen side is bracketed.
TEST(DuplicateSurface, OpenCopiesLeaveTheBracketOfTheUnseenSide) {
  const CutBlock cut = cut_blocks(rock_mesh(12, {0.5, 0.4, 0.3}, 2), 2, 5)[0];
  const FieldBlock alone = extract_field_blocks(cut.open, "one")[0];
  const FieldBlock both = extract_field_blocks(merged(cut.open, scaled(cut.open, 0.98)), "two")[0];
  ASSERT_TRUE(both.underside);
  EXPECT_NEAR(both.underside->estimated_volume / alone.underside->estimated_volume, 1.0, 1e-6);
  EXPECT_EQ(both.scan.report.duplicates.size(), 1u);
}

/// A lens-shaped bubble close under the skin faces both ways.
TEST(DuplicateSurface, ABubbleStaysABubble) {
  const TriangleMesh ball = geodesic_sphere(16);
  for (const double depth : {0.1, 0.2, 0.9}) {
    TriangleMesh lens = geodesic_sphere(12);
    for (Vec3& v : lens.vertices) {
      v = Vec3(0.3 * v.x(), 0.3 * v.y(), 0.04 * v.z() + 1.0 - depth - 0.05);
    }
    const FieldBlock block = extract_field_blocks(merged(ball, turned_over(lens)), "bubble")[0];
    EXPECT_EQ(block.scan.report.inner_shells, 1u);
    EXPECT_TRUE(block.scan.report.duplicates.empty());
  }
}

}  // namespace
}  // namespace clast
