// Damaged meshes: what is repaired, what is refused, and what is said about it.
#include <gtest/gtest.h>

#include <optional>

#include "tests/terrain/ground_damage.hpp"

namespace clast {
namespace {

double wavy_slope(double x, double y) { return 50.0 - 0.6 * x + 0.1 * std::sin(y); }

class Mending : public testing::Test {
 protected:
  Terrain read(const TriangleMesh& mesh, TerrainOptions options = {}) {
    write_mesh(folder_ / "ground.ply", mesh);
    options.surface = {folder_ / "ground.ply"};
    return read_terrain(options);
  }
  std::string refused(const TriangleMesh& mesh) {
    write_mesh(folder_ / "ground.ply", mesh);
    return refusal(TerrainOptions{.surface = {folder_ / "ground.ply"}});
  }
  static std::string notes(const Terrain& terrain) {
    std::string text;
    for (const std::string& note : terrain.report.notes) text += note + "\n";
    return text;
  }
  const ScratchFolder folder_;
};

// A sound ground of n x n squares has 4 n border edges and is one piece; so has a repaired one, but
// for the vertices that T-junctions add along the cut.
void expect_sound(const Terrain& terrain, std::size_t n) {
  EXPECT_EQ(terrain.report.components, 1u);
  EXPECT_EQ(terrain.report.boundary_edges, 4 * n);
  EXPECT_EQ(terrain.report.open_holes, 0u);
  EXPECT_EQ(facing_down(terrain), 0u);
}

TEST_F(Mending, CracksBetweenTilesAreClosed) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const TriangleMesh ground = squares(10, 1.0, wavy_slope);
    const Terrain terrain = read(cracked(ground, 5.0, 0.008, random));
    expect_sound(terrain, 10);
    EXPECT_EQ(terrain.report.closed_cracks, 11u);
    EXPECT_EQ(terrain.surface.triangles.size(), 200u);
    EXPECT_EQ(terrain.surface.vertices.size(), 121u);
    EXPECT_TRUE(contains(notes(terrain), "cracks were closed: 11 border vertices joined"));
    EXPECT_TRUE(contains(notes(terrain), "at x 5.0"));
    for (const Vec3& v : terrain.surface.vertices) {
      EXPECT_NEAR(v.z(), wavy_slope(v.x(), v.y()), 0.015);
    }
  }
}

TEST_F(Mending, WiderGapsThanAskedStayOpen) {
  Random random(1);
  const TriangleMesh apart = cracked(squares(10, 1.0, wavy_slope), 5.0, 0.008, random);
  const Terrain terrain = read(apart, {.crack = 0.0});
  EXPECT_EQ(terrain.report.closed_cracks, 0u);
  EXPECT_EQ(terrain.report.components, 2u);
  EXPECT_TRUE(
      contains(notes(terrain), "the ground is in 2 components with gaps or steps between them"));
}

// Eleven vertices on either side; the corners see the other tile within a cell as well.
TEST_F(Mending, GapsAndStepsBetweenTilesAreTold) {
  for (const Vec3& shift : {Vec3(0.4, 0.0, 0.0), Vec3(0.0, 0.0, 3.0)}) {
    TriangleMesh right = squares(10, 1.0, [](double, double) { return 5.0; });
    const TriangleMesh left = right;
    for (Vec3& v : right.vertices) v += Vec3(10.0, 0.0, 0.0) + shift;
    const Terrain terrain = read(merged(left, right));
    EXPECT_EQ(terrain.report.components, 2u);
    const std::string text = notes(terrain);
    EXPECT_TRUE(contains(
        text,
        "border vertices are near another component without touching it, the smallest gap is " +
            std::string(shift.z() > 0.0 ? "3" : "0.4") + " m, at x 10."))
        << text;
  }
  // Ground that is far away is meant to be.
  TriangleMesh far = squares(10, 1.0, [](double, double) { return 5.0; });
  const TriangleMesh near = far;
  for (Vec3& v : far.vertices) v.x() += 30.0;
  EXPECT_FALSE(contains(notes(read(merged(near, far))), "gaps or steps"));
}

TEST_F(Mending, TJunctionsBecomeCorners) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const Terrain terrain =
        read(with_t_junctions(squares(10, 1.0, wavy_slope), 5.0, seed < 5 ? 0.0 : 0.008, random));
    expect_sound(terrain, 10);
    EXPECT_EQ(terrain.surface.vertices.size(), 121u + 10u);
    EXPECT_EQ(terrain.surface.triangles.size(), 200u + 20u);
    EXPECT_TRUE(contains(notes(terrain), "10 made corners of the neighbouring triangle"));
  }
}

// A triangle of no height between two others leaves a T-junction when it is dropped.
TEST_F(Mending, ADroppedTriangleLeavesNoCrack) {
  TriangleMesh mesh{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 0}},
                    {{0, 1, 2}, {0, 4, 3}, {4, 2, 3}, {0, 2, 4}}};
  const Terrain terrain = read(mesh);
  EXPECT_EQ(terrain.report.removed_degenerate, 1u);
  EXPECT_EQ(terrain.report.closed_cracks, 1u);
  EXPECT_EQ(terrain.report.components, 1u);
  EXPECT_EQ(terrain.report.boundary_edges, 4u);
  EXPECT_EQ(terrain.surface.triangles.size(), 4u);
}

// The border of the hole is that of the plane it was cut from, so the filling must lie in it.
TEST_F(Mending, SmallHolesAreFilled) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const auto plane = [](double x, double y) { return 3.0 + 0.7 * x - 0.2 * y; };
    const Terrain terrain = read(with_holes(squares(16, 1.0, plane), 3, 0.9, random));
    expect_sound(terrain, 16);
    EXPECT_GE(terrain.report.filled_holes, 3u) << "one that is pinched in a vertex counts twice";
    double area = 0.0;
    for (std::size_t t = 0; t < terrain.surface.triangles.size(); ++t) {
      area += normal_of(terrain, t).z() / 2.0;
    }
    EXPECT_NEAR(area, 256.0, 1e-9);
    EXPECT_TRUE(contains(notes(terrain), " holes were filled, the widest, "));
  }
}

TEST_F(Mending, WideHolesStayOpenWithTheirPlace) {
  const TriangleMesh holed = part_of(squares(16, 1.0, wavy_slope), [](const Vec3& p) {
    return !(p.x() > 4.0 && p.x() < 10.0 && p.y() > 5.0 && p.y() < 11.0);
  });
  const Terrain open = read(holed);
  EXPECT_EQ(open.report.open_holes, 1u);
  EXPECT_EQ(open.report.boundary_edges, 64u + 24u);
  EXPECT_TRUE(
      contains(notes(open), "1 holes remain open, the widest, 6 m, around x 7.000, y 8.000"));
  const Terrain filled = read(holed, {.fill = 6.0});
  expect_sound(filled, 16);
  EXPECT_EQ(filled.surface.triangles.size(), 512u - 72u + 22u);
}

TEST_F(Mending, SpikesAndPitsAreLevelled) {
  for (const double height : {6.0, -6.0}) {
    const auto plane = [](double x, double y) { return 3.0 + 0.7 * x - 0.2 * y; };
    TriangleMesh mesh = squares(12, 1.0, plane);
    mesh.vertices[5 * 13 + 7].z() += height;  // at (7, 5)
    const Terrain terrain = read(mesh);
    EXPECT_EQ(terrain.report.levelled_spikes, 1u);
    for (const Vec3& v : terrain.surface.vertices) EXPECT_NEAR(v.z(), plane(v.x(), v.y()), 1e-9);
    EXPECT_TRUE(contains(notes(terrain), "the farthest by 6 m, at x 7.000, y 5.000"));
    EXPECT_EQ(read(mesh, {.spike_steepness = 0.0}).report.levelled_spikes, 0u);
  }
}

TEST_F(Mending, TwoSpikesSideBySideAreLevelled) {
  const auto plane = [](double x, double y) { return 3.0 + 0.7 * x - 0.2 * y; };
  for (const double second : {9.0, -9.0}) {
    TriangleMesh mesh = squares(12, 1.0, plane);
    mesh.vertices[5 * 13 + 7].z() += 6.0;
    mesh.vertices[5 * 13 + 8].z() += second;
    const Terrain terrain = read(mesh);
    EXPECT_EQ(terrain.report.levelled_spikes, 2u);
    for (const Vec3& v : terrain.surface.vertices) EXPECT_NEAR(v.z(), plane(v.x(), v.y()), 1e-9);
  }
}

TEST_F(Mending, CrestsAndBouldersAreNoSpikes) {
  // A crest of 4 m across the grid, one vertex wide.
  TriangleMesh mesh = squares(12, 1.0, wavy_slope);
  for (int k = 0; k <= 12; ++k) mesh.vertices[static_cast<std::size_t>(k * 13 + k)].z() += 4.0;
  EXPECT_EQ(read(mesh).report.levelled_spikes, 0u);
  // A boulder of 2 m.
  mesh = squares(12, 1.0, wavy_slope);
  mesh.vertices[6 * 13 + 6].z() += 2.0;
  EXPECT_EQ(read(mesh).report.levelled_spikes, 0u);
}

TEST_F(Mending, SliversAreKeptAndCounted) {
  Random random(3);
  const Terrain terrain = read(with_slivers(squares(10, 1.0, wavy_slope), 4, {}, random));
  EXPECT_EQ(terrain.surface.triangles.size(), 208u);
  EXPECT_EQ(terrain.report.slivers, 8u);
  EXPECT_TRUE(contains(notes(terrain), "8 slivers, triangles less than 1 mm high, were kept"));
  expect_sound(terrain, 10);
}

TEST_F(Mending, ATileThatIsThereTwiceIsDroppedOrRefused) {
  const TriangleMesh ground = squares(10, 1.0, wavy_slope);
  const Terrain terrain = read(with_a_tile_twice(ground, 5.0, 0.0));
  EXPECT_EQ(terrain.report.removed_duplicates, 100u);
  expect_sound(terrain, 10);
  EXPECT_TRUE(contains(notes(terrain), "100 copies of triangles were removed, the first at x 5."));
  const std::string higher = refused(with_a_tile_twice(ground, 5.0, 0.3));
  EXPECT_TRUE(contains(higher, "the ground has two surfaces over 50 m2, the first at x 5."));
  EXPECT_TRUE(contains(higher, "remove one of the tiles"));
  const std::string little_higher = refused(with_a_tile_twice(ground, 5.0, 0.004));
  EXPECT_TRUE(contains(little_higher, "the ground has two surfaces over 49")) << little_higher;
}

// Far from the border, in the rim of a hole, on the border and in its corner; side by side; and on
// one or both sides of a cut, where the crack must be closed as well.
TEST_F(Mending, SpikesInGroupsAndOnBordersAreLevelled) {
  const auto plane = [](double x, double y) { return 3.0 + 0.7 * x - 0.2 * y; };
  const auto node = [](std::size_t x, std::size_t y) { return y * 13 + x; };
  const TriangleMesh sound = squares(12, 1.0, plane);
  const std::vector<std::vector<std::size_t>> groups = {
      {node(6, 5), node(7, 5), node(7, 6)},
      {node(6, 5), node(7, 5), node(6, 6), node(7, 6), node(5, 5)},
      {node(0, 6)},
      {node(0, 0)},
      {node(12, 4), node(11, 4), node(12, 5)},
      {node(5, 12), node(6, 12)}};
  for (const std::vector<std::size_t>& group : groups) {
    TriangleMesh mesh = sound;
    double height = 9.0;
    for (const std::size_t v : group) mesh.vertices[v].z() += height = -1.2 * height;
    const Terrain terrain = read(mesh);
    EXPECT_EQ(terrain.report.levelled_spikes, group.size());
    for (const Vec3& v : terrain.surface.vertices) EXPECT_NEAR(v.z(), plane(v.x(), v.y()), 1e-9);
    EXPECT_TRUE(contains(notes(terrain), " vertices far above or below the ground, in groups"));
    EXPECT_EQ(read(mesh, {.spike_steepness = 0.0}).report.levelled_spikes, 0u);
    // However far off: nothing is lost to rounding.
    for (const std::size_t v : group) mesh.vertices[v].z() *= 1e30;
    for (const Vec3& v : read(mesh).surface.vertices) {
      EXPECT_NEAR(v.z(), plane(v.x(), v.y()), 1e-9);
    }
  }

  // The hole is 3 m wide in plan, and 12 m high as long as the spike is there.
  const TriangleMesh holed = part_of(sound, [](const Vec3& p) {
    return !(p.x() > 4.0 && p.x() < 6.0 && p.y() > 4.0 && p.y() < 6.0);
  });
  TriangleMesh mesh = holed;
  for (Vec3& v : mesh.vertices) {
    if (v.head<2>() == Vec2(4.0, 5.0)) v.z() += 12.0;
  }
  const Terrain filled = read(mesh);
  expect_sound(filled, 12);
  EXPECT_EQ(filled.report.filled_holes, 1u);
  for (const Vec3& v : filled.surface.vertices) EXPECT_NEAR(v.z(), plane(v.x(), v.y()), 1e-9);
}

TEST_F(Mending, SpikesAtCutsBetweenTilesLeaveNoCrack) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    TriangleMesh ground = squares(10, 1.0, wavy_slope);
    if (seed % 2 == 0) ground = with_a_spike_at(std::move(ground), 5.0, random);  // on both sides
    TriangleMesh cut = seed < 10 ? cracked(ground, 5.0, 0.008, random)
                                 : with_t_junctions(ground, 5.0, 0.004, random);
    if (seed % 2 == 1) cut = with_a_spike_at(std::move(cut), 5.0, random);  // on one of them
    const Terrain terrain = read(cut);
    expect_sound(terrain, 10);
    EXPECT_GT(terrain.report.levelled_spikes, 0u);
    for (const Vec3& v : terrain.surface.vertices) {
      EXPECT_NEAR(v.z(), wavy_slope(v.x(), v.y()), 0.2) << "seed " << seed << ": " << v.transpose();
    }
  }
}

TEST_F(Mending, TowersAndCliffsOnTheBorderAreNoSpikes) {
  // Nine vertices 8 m up; and a cliff across a corner, with 14 vertices at its top.
  TriangleMesh mesh = squares(12, 1.0, wavy_slope);
  for (std::size_t k = 0; k < 9; ++k) mesh.vertices[(4 + k / 3) * 13 + 4 + k % 3].z() += 8.0;
  EXPECT_EQ(read(mesh).report.levelled_spikes, 0u);
  mesh = squares(12, 1.0, [](double x, double y) { return 0.6 * x + y < 3.2 ? 9.0 : 0.0; });
  EXPECT_EQ(read(mesh).report.levelled_spikes, 0u);
}

TEST_F(Mending, FinsAreDroppedWhereTheGroundGoesOnWithoutThem) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const TriangleMesh ground = squares(12, 1.0, wavy_slope);
    const Terrain terrain = read(with_fins(ground, 3, random));
    expect_sound(terrain, 12);
    EXPECT_EQ(terrain.surface.triangles.size(), 288u);
    EXPECT_EQ(terrain.surface.vertices.size(), 169u);
    EXPECT_GT(terrain.report.removed_components, 0u);
    EXPECT_TRUE(
        contains(notes(terrain), ", which were attached to the ground by one edge, were removed"));
  }
}

// A box on the ground is closed by the ground under it: which of the two is the ground is not said.
TEST_F(Mending, ABoxOverItsOwnFloorIsRefusedWithThePlace) {
  TriangleMesh mesh = squares(20, 1.0, [](double, double) { return 0.0; });
  const auto node = [](std::uint32_t x, std::uint32_t y) { return y * 21 + x; };
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(5.5, 5.5, 1.0);
  const std::uint32_t ring[] = {node(5, 5), node(6, 5), node(6, 6), node(5, 6)};
  for (int k = 0; k < 4; ++k) mesh.triangles.push_back({ring[k], ring[(k + 1) % 4], top});
  EXPECT_TRUE(contains(refused(mesh),
                       "the ground has 4 edges where more than two triangles meet, "
                       "the first at x 5.5"));
}

TEST_F(Mending, ASmallPieceOverTheGroundIsDroppedAndOneBesideItIsKept) {
  TriangleMesh shred = squares(1, 0.5, [](double, double) { return 56.0; });
  for (Vec3& v : shred.vertices) v += Vec3(3.2, 4.1, 0.0);
  const TriangleMesh ground = squares(10, 1.0, wavy_slope);
  const Terrain terrain = read(merged(ground, shred));
  EXPECT_EQ(terrain.report.removed_components, 1u);
  expect_sound(terrain, 10);
  EXPECT_EQ(terrain.surface.triangles.size(), 200u);
  EXPECT_TRUE(
      contains(notes(terrain), "1 small components of 0.25 m2 in plan that lie over other"));
  for (Vec3& v : shred.vertices) v.x() += 20.0;
  const Terrain beside = read(merged(ground, shred));
  EXPECT_EQ(beside.report.components, 2u);
  EXPECT_EQ(beside.surface.triangles.size(), 202u);
}

TEST_F(Mending, SmoothingKeepsAPlaneAndLessensRoughness) {
  const auto plane = [](double x, double y) { return 3.0 + 0.7 * x - 0.2 * y; };
  const TerrainOptions twice{.smoothing = 2};
  const Terrain flat = read(squares(10, 1.0, plane), twice);
  for (const Vec3& v : flat.surface.vertices) EXPECT_NEAR(v.z(), plane(v.x(), v.y()), 1e-12);
  Random random(4);
  TriangleMesh rough = squares(10, 1.0, plane);
  for (Vec3& v : rough.vertices) v.z() += 0.1 * random.normal();
  const auto roughness = [&](const Terrain& terrain) {
    double sum = 0.0;
    for (const Vec3& v : terrain.surface.vertices) {
      sum += (v.z() - plane(v.x(), v.y())) * (v.z() - plane(v.x(), v.y()));
    }
    return sum;
  };
  EXPECT_LT(roughness(read(rough, twice)), 0.8 * roughness(read(rough)));
  EXPECT_TRUE(contains(notes(read(rough, twice)), "smoothed 2 times; the largest change, 0."));
}

}  // namespace
}  // namespace clast
