#include "library/make_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "massprops/principal_frame.hpp"
#include "massprops/solid.hpp"
#include "shapes/convex_hull.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// Hull of random points on an ellipsoid: a convex rock.
TriangleMesh random_rock(std::uint64_t seed) {
  Random random(seed);
  const Vec3 axes(random.uniform(0.5, 1.0), random.uniform(0.3, 0.5), random.uniform(0.2, 0.3));
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i) points.push_back(random.unit_vector().cwiseProduct(axes));
  return convex_hull(points);
}

BlockSource source() { return {"rock.stl", "0123", "units=m", ""}; }

bool warns_of(const Block& block, const std::string& part) {
  for (const std::string& warning : block.warnings) {
    if (contains(warning, part)) return true;
  }
  return false;
}

TEST(MakeBlock, CoreBecomesTheSpheroCubeOfTheFormula) {
  const double c = 1.0, r = 0.1;
  BlockOptions options;
  options.core = true;
  options.radius = r;
  const Block block = make_block("cube", cuboid(c, c, c), cuboid(c, c, c), source(), options);
  const double volume = c * c * c + 6 * c * c * r + 3 * kPi * c * r * r + 4 * kPi / 3 * r * r * r;
  const double area = 6 * c * c + 6 * kPi * c * r + 4 * kPi * r * r;
  EXPECT_NEAR(block.mass.volume, volume, 1e-12 * volume);
  EXPECT_NEAR(block.mass.mass, 2650.0 * volume, 1e-9);
  EXPECT_NEAR(block.area, area, 1e-3 * area);
  EXPECT_NEAR(block.box.lengths[0], c + 2 * r, 1e-9);
  EXPECT_NEAR(block.box.lengths[2], c + 2 * r, 1e-9);
  EXPECT_TRUE(block.from_core);
  EXPECT_EQ(block.deviation.hausdorff, 0.0);
  EXPECT_EQ(block.deviation.volume_relative, 0.0);
  EXPECT_EQ(block.body.vertices, cuboid(c, c, c).vertices);
  EXPECT_TRUE(warns_of(block, "principal moments"));
}

class MakeBlockOf : public testing::TestWithParam<std::uint64_t> {};

TEST_P(MakeBlockOf, ARoundedBlockHasTheVolumeOfItsScanAndStaysNearIt) {
  const TriangleMesh rock = random_rock(GetParam());
  const Block block = make_block("rock", rock, rock, source(), {});
  const MassProperties scan = solid_mass_properties(rock, 2650.0);
  EXPECT_NEAR(block.mass.volume, scan.volume, 1e-4 * scan.volume);
  EXPECT_NEAR(block.deviation.volume_relative, block.mass.volume / scan.volume - 1.0, 1e-12);
  const PrincipalFrame frame = principal_frame(scan);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(block.principal.moments[i], frame.moments[i], 5e-3 * frame.moments[i]);
  }
  EXPECT_GT(block.deviation.hausdorff, 0.0);
  EXPECT_LT(block.deviation.hausdorff, 0.02 * block.box.lengths[0]);
  EXPECT_NEAR(block.body.radius, 0.02 * smallest_box(rock.vertices).lengths[2], 1e-12);
}

TEST_P(MakeBlockOf, VolumeAndMomentsScaleWithTheRock) {
  const TriangleMesh rock = random_rock(GetParam());
  const Block one = make_block("rock", rock, rock, source(), {});
  const Block two = make_block("rock", scaled(rock, 2.0), scaled(rock, 2.0), source(), {});
  EXPECT_NEAR(two.mass.volume / one.mass.volume, 8.0, 1e-2);
  EXPECT_NEAR(two.principal.moments[0] / one.principal.moments[0], 32.0, 32.0 * 1e-3);
  EXPECT_NEAR(two.box.lengths[1] / one.box.lengths[1], 2.0, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(RandomRocks, MakeBlockOf, testing::Range<std::uint64_t>(1, 6));

TEST(MakeBlock, TheBoxHoldsTheRoundedBody) {
  const TriangleMesh rock = random_rock(9);
  const Block block = make_block("rock", rock, rock, source(), {});
  for (const Vec3& vertex : block.body.vertices) {
    const Vec3 inside = block.box.axes.transpose() * (vertex - block.box.centre);
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(std::abs(inside[i]) + block.body.radius, block.box.lengths[i] / 2 + 1e-9);
    }
  }
}

/// A cuboid with a cubic cavity of side `c` in its middle.
TriangleMesh hollow(const Vec3& sides, double c) {
  TriangleMesh cavity = cuboid(c, c, c);
  for (TriangleMesh::Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  return merged(cuboid(sides.x(), sides.y(), sides.z()), cavity);
}

// The core's cavity is wider by r on every side; rounding shrinks it back.
TEST(MakeBlock, ACavityKeepsItsSizeUnderRounding) {
  const Vec3 sides(2.0, 1.6, 1.2);
  const TriangleMesh scan = hollow(sides, 0.5);
  BlockOptions options;
  options.radius = 0.05;
  options.accuracy = 1e-5;
  const Block block = make_block("hollow", scan, scan, source(), options);
  const double volume = sides.prod() - 0.125;
  EXPECT_NEAR(block.mass.volume / volume, 1.0, 2e-5);
  EXPECT_LE(block.mass.relative_error, 1e-5);
  Bounds cavity;
  for (std::size_t v = 8; v < 16; ++v) cavity.include(block.body.vertices[v]);
  EXPECT_NEAR((cavity.high - cavity.low).minCoeff(), 0.6, 1e-3);
  EXPECT_NEAR((cavity.high - cavity.low).maxCoeff(), 0.6, 1e-3);
  const PrincipalFrame exact = principal_frame(solid_mass_properties(scan, block.density));
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(block.principal.moments[i] / exact.moments[i], 1.0, 5e-3);
  }
  // A corner of the cavity is sharp in the block too; those outside are rounded.
  EXPECT_LT(block.deviation.hausdorff, 0.05);
}

TEST(MakeBlock, AWallThinnerThanTwoRadiiIsRefusedWithARadiusThatWorks) {
  const TriangleMesh scan = hollow({2.0, 1.6, 1.2}, 1.1);  // walls of 0.05 m
  BlockOptions options;
  options.radius = 0.04;
  const std::string message =
      refusal<GeometryError>([&] { make_block("shell", scan, scan, source(), options); });
  EXPECT_TRUE(contains(message, "block shell"));
  EXPECT_TRUE(contains(message, "0.04 m is too large"));
  EXPECT_TRUE(contains(message, " m works"));
}

TEST(MakeBlock, MassAloneSetsTheDensity) {
  BlockOptions options;
  options.core = true;
  options.radius = 0.0;
  options.mass = 5000.0;
  const Block block = make_block("box", cuboid(2, 1, 1), cuboid(2, 1, 1), source(), options);
  EXPECT_NEAR(block.density, 2500.0, 1e-9);
  EXPECT_NEAR(block.mass.mass, 5000.0, 1e-9);
  EXPECT_NEAR(block.mass.inertia(0, 0), 5000.0 * (1.0 + 1.0) / 12.0, 1e-8);
  EXPECT_EQ(block.field.weighed_mass, 5000.0);
}

TEST(MakeBlock, ADensityNoRockHasIsToldOfWithTheLikelyUnit) {
  const auto warned = [](double density) {
    BlockOptions options;
    options.core = true;
    options.radius = 0.0;
    options.density = density;
    const Block block = make_block("box", cuboid(3, 2, 1), cuboid(3, 2, 1), source(), options);
    return block.warnings.empty() ? std::string() : block.warnings.front();
  };
  EXPECT_TRUE(contains(warned(2.65),
                       "the density 2.65 kg/m3 is outside the range of rocks, 500 to 8000 kg/m3; "
                       "if this is in g/cm3 or t/m3, give `density` 2650"));
  EXPECT_TRUE(
      contains(warned(20000.0), "is outside the range of rocks, 500 to 8000 kg/m3; check mass"));
  EXPECT_EQ(warned(2650.0), "");
}

TEST(MakeBlock, MassBesideDensityIsACheck) {
  BlockOptions options;
  options.core = true;
  options.radius = 0.0;
  options.density = 2500.0;
  options.density_given = true;
  options.mass = 5100.0;
  const TriangleMesh box = cuboid(2, 1, 1);
  const Block fine = make_block("box", box, box, source(), options);
  EXPECT_EQ(fine.density, 2500.0);
  EXPECT_NEAR(fine.mass.mass, 5000.0, 1e-9);
  EXPECT_FALSE(warns_of(fine, "weighed"));
  options.mass = 6000.0;
  EXPECT_TRUE(warns_of(make_block("box", box, box, source(), options), "weighed"));
}

TEST(MakeBlock, AThickRoundingIsWarnedOf) {
  BlockOptions options;
  options.core = true;
  options.radius = 0.6;
  const TriangleMesh plate = cuboid(2, 1.5, 0.1);
  EXPECT_TRUE(warns_of(make_block("plate", plate, plate, source(), options), "quarter of S"));
  options.radius = 0.01;
  EXPECT_FALSE(warns_of(make_block("plate", plate, plate, source(), options), "quarter of S"));
}

TEST(MakeBlock, WhatItWasMadeWithIsKept) {
  BlockOptions options;
  options.radius = 0.01;
  const Block block = make_block("box", cuboid(2, 1.5, 1), cuboid(2, 1.5, 1), source(), options);
  EXPECT_EQ(block.source.file, "rock.stl");
  EXPECT_EQ(block.source.sha256, "0123");
  for (const char* part : {"units=m ", "core=no", "radius_m=0.01", "density_kg_m3=2650"}) {
    EXPECT_TRUE(contains(block.source.options, part)) << block.source.options;
  }
}

TEST(MakeBlock, AnOpenScanIsRefusedWithTheBlocksName) {
  TriangleMesh open = cuboid(1, 1, 1);
  open.triangles.pop_back();
  const std::string message =
      refusal<GeometryError>([&] { make_block("B017", open, open, source(), {}); });
  EXPECT_TRUE(contains(message, "B017")) << message;
}

TEST(MakeBlock, OptionsThatMakeNoSenseAreRefusedByName) {
  const auto refused = [](const auto& change) {
    BlockOptions options;
    change(options);
    return refusal<InputError>([&] { options.check(); });
  };
  EXPECT_TRUE(contains(refused([](BlockOptions& o) { o.core = true; }), "radius"));
  EXPECT_TRUE(contains(refused([](BlockOptions& o) { o.radius = -1.0; }), "radius"));
  EXPECT_TRUE(contains(refused([](BlockOptions& o) { o.radius_fraction = 0.5; }),
                       "radius as a fraction of S"));
  EXPECT_TRUE(contains(refused([](BlockOptions& o) { o.density = 0.0; }), "density"));
  EXPECT_TRUE(contains(refused([](BlockOptions& o) { o.density = std::nan(""); }), "density"));
  EXPECT_TRUE(contains(refused([](BlockOptions& o) { o.mass = -5.0; }), "mass"));
  EXPECT_TRUE(contains(refused([](BlockOptions& o) { o.accuracy = 0.0; }), "accuracy"));
  EXPECT_NO_THROW(BlockOptions().check());
}

}  // namespace
}  // namespace clast
