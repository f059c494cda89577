#include "reconstruct/field_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/mesh_topology.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/cut_blocks.hpp"
#include "tests/support/declared_las.hpp"
#include "tests/support/field_scene.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/solid_volume.hpp"

namespace clast {
namespace {

TriangleMesh turned_rock(int frequency, const Vec3& half_axes, std::uint64_t seed) {
  Random random(seed);
  return transformed(rock_mesh(frequency, half_axes, seed), Pose{Vec3::Zero(), random.rotation()});
}

/// The ground as a mesh, joined to nothing.
TriangleMesh ground_mesh(const FieldGround& ground, double half, int cells) {
  TriangleMesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double x = half * (2.0 * i / cells - 1.0), y = half * (2.0 * j / cells - 1.0);
      mesh.vertices.emplace_back(x, y, ground.at(x, y));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TEST(FieldScan, AClosedMeshIsCleanedAndNothingElse) {
  const TriangleMesh rock = rock_mesh(8, {0.5, 0.4, 0.3}, 1);
  const std::vector<FieldBlock> blocks = extract_field_blocks(rock, "rock");
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_FALSE(blocks[0].underside.has_value());
  EXPECT_EQ(blocks[0].scan.mesh.vertices, clean_scan(rock, "rock").mesh.vertices);
}

TEST(FieldScan, AnOpenMeshIsClosedAsTheBestOfItsBracket) {
  const CutBlock cut = cut_blocks(rock_mesh(10, {0.5, 0.4, 0.3}, 2), 1, 5)[0];
  const FieldBlock block = extract_field_blocks(cut.open, "cut")[0];
  ASSERT_TRUE(block.underside.has_value());
  EXPECT_TRUE(inspect_mesh(block.scan.mesh).is_closed());
  EXPECT_NEAR(solid_volume(block.scan.mesh), block.underside->estimated_volume, 1e-9);
  EXPECT_LT(block.underside->lower_volume, cut.volume);
  EXPECT_GT(block.underside->upper_volume.value(), cut.volume);
}

TEST(FieldScan, UnitsAndAxisHoldForTheBracketToo) {
  const CutBlock cut = cut_blocks(rock_mesh(8, {0.5, 0.4, 0.3}, 2), 1, 5)[0];
  TriangleMesh file = scaled(cut.open, 1000.0);  // mm, y up
  for (Vec3& v : file.vertices) v = Vec3(v.x(), v.z(), -v.y());
  FieldScanOptions options;
  options.scan.unit = 0.001;
  options.scan.up = "y";
  const FieldBlock metres = extract_field_blocks(cut.open, "cut")[0];
  const FieldBlock from_file = extract_field_blocks(file, "cut", options)[0];
  EXPECT_NEAR(from_file.underside->upper_volume.value(), metres.underside->upper_volume.value(),
              1e-6);
  // Axes are looked at on a grid that lies as the block does.
  const Vec3 sides = metres.underside->sides->upper;
  EXPECT_LT((from_file.underside->sides->upper - sides).norm(), 0.02 * sides.norm());
  EXPECT_NEAR(from_file.underside->rim_length, metres.underside->rim_length, 1e-6);
  EXPECT_LT((from_file.underside->down + Vec3::UnitZ()).norm(), 1e-3);
  EXPECT_NEAR(solid_volume(from_file.underside->lower_mesh),
              solid_volume(metres.underside->lower_mesh), 1e-9);
  EXPECT_NEAR(from_file.underside->lower_volume, metres.underside->lower_volume, 1e-6);
}

TEST(FieldScan, AnInwardOpenMeshIsTurned) {
  CutBlock cut = cut_blocks(rock_mesh(8, {0.5, 0.4, 0.3}, 3), 1, 6)[0];
  const double best = extract_field_blocks(cut.open, "cut")[0].underside->estimated_volume;
  for (TriangleMesh::Triangle& t : cut.open.triangles) std::swap(t[1], t[2]);
  EXPECT_NEAR(extract_field_blocks(cut.open, "cut")[0].underside->estimated_volume, best, 1e-6);
}

TEST(FieldScan, GroundIsTakenAwayFromAMesh) {
  const FieldGround slope(0.2, 0.002, 0, 1.0, 3);
  const TriangleMesh rock = buried_at(turned_rock(14, {0.4, 0.3, 0.25}, 3), 0.0, 0.1, 0.1, slope);
  TriangleMesh scene = merged(rock, ground_mesh(slope, 1.2, 60));
  const FieldBlock block = extract_field_blocks(scene, "scene")[0];
  ASSERT_TRUE(block.underside.has_value());
  EXPECT_NEAR(block.underside->estimated_volume, solid_volume(rock), 0.05 * solid_volume(rock));
  EXPECT_LT(block.underside->lower_volume, solid_volume(rock));
  EXPECT_GT(block.underside->upper_volume.value(), solid_volume(rock));
  EXPECT_LT((block.underside->down + Vec3::UnitZ()).norm(), 0.03);  // turned up from the slope
  FieldScanOptions kept;
  kept.up_given = true;
  const FieldBlock as_it_lies = extract_field_blocks(scene, "scene", kept)[0];
  EXPECT_NEAR(as_it_lies.underside->estimated_volume, block.underside->estimated_volume, 1e-6);
  EXPECT_GT(as_it_lies.underside->down.x(), 0.1);
  EXPECT_LT((as_it_lies.scan.mesh.vertices[0] - rock.vertices[0]).norm(), 1.0);
}

TEST(FieldScan, ASlopeIsTurnedLevelAndThatIsTold) {
  const FieldGround slope(0.2, 0.002, 0, 1.0, 3);
  const TriangleMesh rock = buried_at(turned_rock(10, {0.4, 0.3, 0.25}, 3), 0.0, 0.1, 0.1, slope);
  const FieldBlock block =
      extract_field_blocks(merged(rock, ground_mesh(slope, 1.2, 40)), "scene")[0];
  const auto& notes = block.scan.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.starts_with("turned by 11.");  // atan 0.2 = 11.3 degrees
  }));
}

TEST(FieldScan, BareGroundIsRefusedAsSuch) {
  const FieldGround gravel(0.1, 0.004, 100, 1.0, 5);
  const FieldScene scene = field_scene({}, gravel, {.ground = 20000, .noise = 0.001}, 5);
  const std::string message =
      refusal<GeometryError>([&] { extract_field_blocks(scene.points, "slope.las"); });
  EXPECT_TRUE(contains(message,
                       "slope.las: the largest component is the ground (100 % of the scan) and no "
                       "object on it is a block"));
  const std::string of_mesh = refusal<GeometryError>(
      [&] { extract_field_blocks(ground_mesh(gravel, 1.0, 50), "slope.ply"); });
  EXPECT_TRUE(contains(of_mesh, "slope.ply: the largest component is the ground"));
}

TEST(FieldScan, FewPointsAreNoBlock) {
  const std::vector<Vec3> points(100, Vec3(660000.0, 5600000.0, 10.0));
  EXPECT_EQ(refusal([&] { extract_field_blocks(points, "points.xyz"); }),
            "points.xyz: no block: 100 points are too few for a block; at least 500 are "
            "needed");
}

/// Points on a rock that floats in the air, moved.
std::vector<Vec3> rock_points(std::uint64_t seed, int count, const Vec3& by) {
  TriangleMesh rock = rock_mesh(12, {0.4, 0.33, 0.27}, seed);
  for (Vec3& v : rock.vertices) v.z() += 5.0;
  const FieldGround nothing(0.0, 0.0, 0, 1.0, 1);
  std::vector<Vec3> points =
      field_scene({rock}, nothing,
                  {.per_block = count, .ground = 0, .noise = 0.001, .steepest = -1.0}, 2)
          .points;
  for (Vec3& p : points) p += by;
  return points;
}

TEST(FieldScan, TwoBlocksFarApartAreNotTakenForOne) {
  std::vector<Vec3> points = rock_points(4, 8000, Vec3::Zero());
  const std::vector<Vec3> other = rock_points(5, 8000, {40.0, 0.0, 0.0});
  std::vector<Vec3> both = points;
  both.insert(both.end(), other.begin(), other.end());
  const std::string message =
      refusal<GeometryError>([&] { extract_field_blocks(both, "two.xyz"); });
  EXPECT_TRUE(contains(message, "two.xyz: separate sets of points, the second with about "))
      << message;
  EXPECT_TRUE(contains(message, "save each block to a separate file")) << message;
}

TEST(FieldScan, PointsFarFromTheBlockAreLeftOutAndCounted) {
  const std::vector<Vec3> points = rock_points(4, 8000, Vec3::Zero());
  const FieldBlock alone = extract_field_blocks(points, "rock.xyz")[0];
  std::vector<Vec3> with_scrap = points;
  Random random(7);
  for (int i = 0; i < 300; ++i)
    with_scrap.push_back(Vec3(3.0, 0.0, 5.0) + 0.02 * random.unit_vector());
  const FieldBlock block = extract_field_blocks(with_scrap, "rock.xyz")[0];
  EXPECT_NEAR(solid_volume(block.scan.mesh), solid_volume(alone.scan.mesh),
              0.01 * solid_volume(alone.scan.mesh));
  EXPECT_TRUE(
      std::any_of(block.scan.notes.begin(), block.scan.notes.end(), [](const std::string& note) {
        return contains(note, "points far from the block were left out");
      }));
}

TEST(FieldScan, ASecondPieceThatTouchesTheBlockIsNotLeftOutInSilence) {
  const FieldGround gravel(0.0, 0.003, 100, 2.0, 7);
  TriangleMesh scene = ground_mesh(gravel, 2.0, 120);
  scene = merged(std::move(scene),
                 buried_at(rock_mesh(10, {0.4, 0.3, 0.3}, 1), -0.3, 0.0, 0.08, gravel));
  scene = merged(std::move(scene),
                 buried_at(rock_mesh(10, {0.3, 0.3, 0.25}, 2), 0.3, 0.0, 0.08, gravel));
  const std::vector<FieldBlock> blocks = extract_field_blocks(scene, "pair");
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_TRUE(contains(blocks[0].scan.notes.back(), "another component of the scan close"))
      << blocks[0].scan.notes.back();
}

TEST(FieldScan, ThreeBlocksAreSplitInOrder) {
  const FieldGround gravel(0.1, 0.003, 100, 2.0, 7);
  const std::vector<TriangleMesh> rocks = {
      buried_at(rock_mesh(10, {0.3, 0.25, 0.2}, 1), 1.1, 0.2, 0.08, gravel),
      buried_at(rock_mesh(10, {0.4, 0.3, 0.3}, 2), -1.2, -0.3, 0.05, gravel),
      buried_at(rock_mesh(10, {0.25, 0.2, 0.2}, 3), 0.0, 0.1, 0.1, gravel)};
  TriangleMesh scene = ground_mesh(gravel, 2.0, 160);
  for (const TriangleMesh& rock : rocks) scene = merged(std::move(scene), rock);
  FieldScanOptions options;
  const std::vector<FieldBlock> one = extract_field_blocks(scene, "scene", options);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_TRUE(
      contains(one[0].scan.notes[1], "3 blocks stand on the ground; the one near the middle"));
  options.split = true;
  const std::vector<FieldBlock> all = extract_field_blocks(scene, "scene", options);
  ASSERT_EQ(all.size(), 3u);
  const int order[3] = {1, 2, 0};
  for (int k = 0; k < 3; ++k) {
    const double whole = solid_volume(rocks[static_cast<std::size_t>(order[k])]);
    const VolumeBracket& bounds = *all[static_cast<std::size_t>(k)].bounds;
    EXPECT_NEAR(bounds.estimated_volume, whole, 0.15 * whole) << k;
    EXPECT_LT(bounds.lower_volume, whole) << k;
    EXPECT_GT(bounds.upper_volume.value_or(1e300), whole) << k;
  }
}

TEST(FieldScan, MendsOfAnOpenScanAreToldAsThoseOfAClosedOne) {
  TriangleMesh open = cut_blocks(rock_mesh(12, {0.5, 0.4, 0.3}, 4), 1, 11)[0].open;
  const std::size_t vertices = open.vertices.size();
  std::swap(open.triangles[7][0], open.triangles[7][1]);
  open.triangles.push_back(open.triangles[3]);  // stored twice
  // The vertex farthest up has neighbours all around.
  const auto top = static_cast<std::uint32_t>(
      std::max_element(open.vertices.begin(), open.vertices.end(),
                       [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); }) -
      open.vertices.begin());
  open.vertices[top].z() += 0.4;
  FieldScanOptions options;
  options.find_ground = false;
  const FieldBlock block = extract_field_blocks(open, "open", options)[0];
  const RepairReport& report = block.scan.report;
  EXPECT_EQ(report.as_read.vertices, vertices);
  EXPECT_GT(report.as_read.boundary_edges, 0u);
  ASSERT_NE(report.find_defect(DefectKind::kInconsistentOrientation), nullptr);
  EXPECT_EQ(report.find_defect(DefectKind::kInconsistentOrientation)->count, 1u);
  ASSERT_NE(report.find_defect(DefectKind::kDegenerate), nullptr);
  EXPECT_EQ(report.find_defect(DefectKind::kDegenerate)->count, 1u);
  const Defect* spike = report.find_defect(DefectKind::kSpike);
  ASSERT_NE(spike, nullptr);
  EXPECT_NEAR(spike->size, 0.4, 0.1);
  EXPECT_LT((*spike->position - open.vertices[top]).norm(), 0.45);
  EXPECT_TRUE(std::any_of(block.scan.notes.begin(), block.scan.notes.end(),
                          [](const std::string& note) { return contains(note, "spike"); }));
}

TEST(FieldScan, TheWayFromTheFileToTheBlockIsTold) {
  const FieldGround slope(0.2, 0.002, 0, 1.0, 3);
  const TriangleMesh rock = buried_at(turned_rock(10, {0.4, 0.3, 0.25}, 3), 0.0, 0.1, 0.1, slope);
  const FieldBlock block =
      extract_field_blocks(merged(rock, ground_mesh(slope, 1.2, 40)), "scene")[0];
  Vec3 highest = rock.vertices[0];
  for (const Vec3& v : rock.vertices) {
    if (v.z() > highest.z()) highest = v;
  }
  double nearest = 1e9;
  for (const Vec3& v : block.scan.mesh.vertices) {
    nearest = std::min(nearest, (v - block.block_from_file * highest).norm());
  }
  EXPECT_LT(nearest, 1e-9);
}

TEST(FieldScan, AScanThatWasClosedBeforeSaysThatItsBoundsKnowLittle) {
  TriangleMesh mesh = rock_mesh(12, {0.5, 0.4, 0.3}, 4);
  // Six triangles around a vertex: more than a fan closes.
  std::erase_if(mesh.triangles, [](const TriangleMesh::Triangle& t) {
    return t[0] == 40 || t[1] == 40 || t[2] == 40;
  });
  const FieldBlock block = extract_field_blocks(mesh, "rock")[0];
  EXPECT_FALSE(block.underside.has_value());  // a gap, and no unseen side
  EXPECT_GT(block.scan.report.filled_fraction, 0.0);
  EXPECT_LT(block.scan.report.filled_fraction, 0.01);
  EXPECT_TRUE(std::any_of(
      block.scan.notes.begin(), block.scan.notes.end(),
      [](const std::string& note) { return contains(note, "the file does not show"); }));
}

TEST(FieldScan, CoordinatesBeyondAllReasonAreRefused) {
  TriangleMesh mesh = rock_mesh(6, {0.5, 0.4, 0.3}, 4);
  mesh.vertices[5].x() = 1e200;
  EXPECT_TRUE(contains(refusal<GeometryError>([&] { extract_field_blocks(mesh, "rock.ply"); }),
                       "rock.ply: vertex 6 lies 1e+200 m from the origin"));
  EXPECT_TRUE(contains(refusal<InputError>([&] {
                         std::vector<Vec3> points(600, Vec3(1.0, 2.0, 3.0));
                         points[77].y() = -1e200;
                         extract_field_blocks(points, "rock.xyz");
                       }),
                       "rock.xyz: a point is not finite or farther than 1e+15 m"));
}

TEST(FieldScan, AFileWithTooFewDigitsIsRefusedByTheWholeRouteToo) {
  const ScratchFolder folder;
  TriangleMesh far = rock_mesh(6, {0.5, 0.4, 0.3}, 4);
  for (Vec3& v : far.vertices) v.y() += 6671300.0;
  std::string text = "solid far\n";
  for (const TriangleMesh::Triangle& t : far.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : t) {
      char line[120];
      const Vec3& p = far.vertices[v];
      std::snprintf(line, sizeof line, "vertex %.7g %.7g %.7g\n", p.x(), p.y(), p.z());
      text += line;
    }
    text += "endloop\nendfacet\n";
  }
  write_text_file(folder / "far.stl", text + "endsolid far\n");
  EXPECT_TRUE(contains(refusal<InputError>([&] { read_field_scan(folder / "far.stl"); }),
                       "precision was lost in the file itself"));
}

/// A ball with a radius of 0.42 m on a map, in units of so many metres.
std::vector<Vec3> ball_on_map(double unit, const Vec2& position) {
  std::vector<Vec3> points;
  constexpr int kPoints = 3000;
  const double golden = std::acos(-1.0) * (3.0 - std::sqrt(5.0));
  for (int k = 0; k < kPoints; ++k) {
    const double z = 1.0 - 2.0 * (k + 0.5) / kPoints, r = std::sqrt(1.0 - z * z);
    const Vec3 p(r * std::cos(golden * k), r * std::sin(golden * k), z);
    points.push_back(0.42 / unit * p + Vec3(position.x(), position.y(), 100.0));
  }
  return points;
}

// What a terrain is refused for, a scan is too: its unit of length may be given instead.
TEST(FieldScan, ACloudInFeetIsRefusedOrReadInThem) {
  const ScratchFolder folder;
  const double foot = 1200.0 / 3937.0;
  const auto write = [&](const std::vector<LasKey>& keys, double unit, const Vec2& position) {
    write_text_file(folder / "ball.las", declared_las({.keys = keys}, ball_on_map(unit, position)));
  };
  const auto refused = [&](double unit) {
    return refusal([&] { read_field_scan(folder / "ball.las", {.scan = {.unit = unit}}); });
  };
  write({{1024, 1}, {3072, 2232}}, foot, {3140000, 1690000});
  EXPECT_TRUE(contains(refused(1.0), "ball.las: its map unit is the US survey foot (0.3048006 m)"));
  EXPECT_TRUE(contains(refused(1.0), "give `units` 0.3048006096, or bring it to metres"));
  EXPECT_TRUE(contains(refused(1.01), "its map unit is the US survey foot")) << "a correction";
  const FieldScan scan = read_field_scan(folder / "ball.las", {.scan = {.unit = 0.3048}});
  const double ball = 4.0 / 3.0 * std::acos(-1.0) * 0.42 * 0.42 * 0.42;
  EXPECT_NEAR(solid_volume(scan.blocks.at(0).scan.mesh), ball, 0.01 * ball);

  write({{1024, 1}, {3072, 26913}, {4099, 9003}}, 1.0, {500000, 4400000});
  EXPECT_TRUE(contains(refused(1.0), "its heights are in units of the US survey foot"));
  EXPECT_TRUE(contains(refused(0.3048), "its heights are in units of the US survey foot"));
  write({{1024, 1}, {3072, 26913}, {3076, 9003}}, 1.0, {500000, 4400000});
  EXPECT_TRUE(contains(refused(1.0), "correct the one that is wrong"));
  EXPECT_TRUE(contains(refused(1.0), "or give `units`"));
  write({{1024, 2}, {2048, 4326}}, 1.0, {7, 46});
  EXPECT_TRUE(contains(refused(1.0), "coordinates are degrees"));
  EXPECT_TRUE(contains(refused(0.001), "coordinates are degrees"));
  write({{1024, 1}, {3072, 3857}}, 1.0, {1147666, 5903972});
  EXPECT_TRUE(contains(refused(1.0), "times those on the ground"));
  write_text_file(folder / "ball.csv", "X (mm),Y (mm),Z (mm)\n1,2,3\n");
  EXPECT_TRUE(contains(
      refusal([&] { read_field_scan(folder / "ball.csv"); }),
      "ball.csv: its map unit is the mm (0.001 m) (heading \"X (mm)\"); give `units` 0.001"));
}

// Metres by keys, by WKT of a system of one's own, geocentric, or near the origin of a map.
TEST(FieldScan, ACloudInMetresIsRead) {
  const ScratchFolder folder;
  const std::vector<std::pair<std::vector<LasKey>, Vec2>> metres = {
      {{{1024, 1}, {3072, 25832}}, {652000, 5203000}},
      {{{1024, 1}, {2048, 4269}, {3072, 32767}, {3074, 32767}, {3075, 1}, {3076, 9001}},
       {500000, 4400000}},
      {{{1024, 3}, {2048, 4978}}, {4194000, 630000}},
      {{{1024, 1}, {3072, 2154}}, {1.0, 2.0}}};
  for (const auto& [keys, position] : metres) {
    // Too few for a block, which is said only after the lengths were checked.
    std::vector<Vec3> points = ball_on_map(1.0, position);
    points.resize(20);
    write_text_file(folder / "ball.las", declared_las({.keys = keys}, points));
    EXPECT_TRUE(contains(refusal([&] { read_field_scan(folder / "ball.las"); }), "are too few"))
        << keys.back().key;
  }
}

}  // namespace
}  // namespace clast
