#include "reconstruct/scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "mesh/detail/mesh_writers.hpp"
#include "mesh/mesh_io.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TriangleMesh moved_to(TriangleMesh mesh, const Vec3& position) {
  return transformed(std::move(mesh), Pose{position, Quat::Identity()});
}

TriangleMesh inverted(TriangleMesh mesh) {
  for (TriangleMesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

bool sound(const TriangleMesh& mesh) {
  const MeshReport report = inspect_mesh(mesh);
  return report.is_closed() && report.is_oriented() && report.pinched_vertices == 0 &&
         report.components == 1 && enclosed_volume(mesh) > 0.0;
}

std::string all_notes(const Scan& scan) {
  std::string text;
  for (const std::string& note : scan.notes) text += note + "\n";
  return text;
}

std::string scan_refusal(const TriangleMesh& mesh, const ScanOptions& options = {}) {
  try {
    clean_scan(mesh, "B017", options);
  } catch (const GeometryError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("B017: ", 0), 0u) << error.what();
    return error.what();
  }
  return {};
}

#define EXPECT_HAS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

TEST(Scan, SoundMeshKeepsEveryBit) {
  const TriangleMesh rock = random_rock(1);
  const Scan scan = clean_scan(rock, "B017");
  EXPECT_EQ(scan.mesh.vertices, rock.vertices);
  EXPECT_EQ(scan.mesh.triangles, rock.triangles);
  EXPECT_TRUE(scan.notes.empty());
  EXPECT_TRUE(scan.report.as_read.is_closed());
}

TEST(Scan, UnitAndUpAxisAreApplied) {
  const Scan scan = clean_scan(box_mesh({1000, 2000, 3000}), "B017", {.unit = 0.001, .up = "y"});
  const Bounds box = bounds(scan.mesh);
  EXPECT_NEAR((box.low - Vec3(0, -3, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((box.high - Vec3(1, 0, 2)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(enclosed_volume(scan.mesh), 6.0, 1e-14);
}

TEST(Scan, GltfFilesAreYUpUnlessSaidOtherwise) {
  const ScratchFolder folder;
  write_mesh(folder / "b.glb", box_mesh({1.0, 2.0, 3.0}));
  write_mesh(folder / "b.obj", box_mesh({1.0, 2.0, 3.0}));
  const auto height = [&](const std::string& name, const ScanOptions& options) {
    const Bounds box = bounds(read_scan(folder / name, options).mesh);
    return box.high.z() - box.low.z();
  };
  EXPECT_EQ(height("b.glb", {}), 2.0);
  EXPECT_EQ(height("b.glb", {.up = "y"}), 2.0);
  EXPECT_EQ(height("b.glb", {.up = "z"}), 3.0);
  EXPECT_EQ(height("b.obj", {}), 3.0);
}

TEST(Scan, InwardAndMixedWindingTurnOutward) {
  const TriangleMesh rock = random_rock(2);
  EXPECT_NEAR(enclosed_volume(clean_scan(inverted(rock), "B017").mesh), enclosed_volume(rock),
              1e-14);
  TriangleMesh mixed = rock;
  Random random(8);
  for (TriangleMesh::Triangle& t : mixed.triangles) {
    if (random.uniform() < 0.4) std::swap(t[0], t[1]);
  }
  const Scan scan = clean_scan(mixed, "B017");
  EXPECT_TRUE(sound(scan.mesh));
  EXPECT_NEAR(enclosed_volume(scan.mesh), enclosed_volume(rock), 1e-14);
  EXPECT_HAS(all_notes(scan), "turned to agree");
}

TEST(Scan, HolesOfThreeAndFourEdgesAreClosedByAFan) {
  for (const int taken : {1, 2}) {
    TriangleMesh box = box_mesh({1, 1, 1}, 3);
    box.triangles.resize(box.triangles.size() - taken);  // the two triangles of one cell
    const Scan scan = clean_scan(box, "B017");
    EXPECT_TRUE(sound(scan.mesh));
    EXPECT_NEAR(enclosed_volume(scan.mesh), 1.0, 1e-15);
    EXPECT_HAS(all_notes(scan), taken == 1 ? "1 hole with 3 border edges in all closed by a fan"
                                           : "1 hole with 4 border edges in all closed by a fan");
    EXPECT_EQ(scan.report.as_read.boundary_edges, static_cast<std::size_t>(taken + 2));
  }
}

TEST(Scan, FanNeverDoublesAnEdgeThatIsThere) {
  // A tetrahedron without two triangles: one diagonal of its hole is an edge of the rest.
  TriangleMesh open = tetrahedron();
  open.triangles.resize(2);
  EXPECT_TRUE(sound(clean_scan(open, "B017").mesh));
  EXPECT_NEAR(enclosed_volume(clean_scan(open, "B017").mesh), 1.0 / 6.0, 1e-15);
}

TEST(Scan, ACoreWithLargerHolesIsRefusedWithTheirCountSizeAndPlace) {
  TriangleMesh box = box_mesh({1, 1, 1}, 3);
  box.triangles.resize(box.triangles.size() - 4);  // two cells: six border edges
  box.triangles.erase(box.triangles.begin());
  const std::string message = scan_refusal(box, {.repair = {.fill_missing = false}});
  EXPECT_HAS(message,
             "B017: the surface is not closed: 9 open edges in 2 holes: 6 edges and 2 m in "
             "perimeter near (1, ");
  EXPECT_HAS(message, ", 3 edges and 1.14 m in perimeter near (0, ");
  EXPECT_HAS(message, "MeshLab");
  EXPECT_HAS(message, "CloudCompare");
}

TEST(Scan, ACoreWithNonManifoldEdgesIsRefusedWithCountAndPlace) {
  // Two cubes that share one edge, welded: four triangles on it.
  const TriangleMesh two = merged(box_mesh({1, 1, 1}), moved_to(box_mesh({1, 1, 1}), {1, 1, 0}));
  EXPECT_HAS(scan_refusal(two, {.repair = {.fill_missing = false}}),
             "1 edge shared by more than two triangles, near (1, 1, ");
}

TEST(Scan, PlacesInMessagesAreInTheFilesOwnCoordinates) {
  TriangleMesh open = moved_to(box_mesh({1000, 1000, 1000}, 2), {888600000, 0, 0});
  open.triangles.resize(open.triangles.size() - 8);
  EXPECT_HAS(scan_refusal(open, {.unit = 0.001, .up = "y", .repair = {.fill_missing = false}}),
             "8 edges and 4 m in perimeter near (88860");
}

TEST(Scan, InnerShellsAreDroppedAndTheirVolumeTold) {
  const TriangleMesh rock = random_rock(4);
  const TriangleMesh bubble = inverted(scaled(random_rock(5), 0.2));
  const double expected = -enclosed_volume(bubble);
  for (const bool inward : {false, true}) {
    const TriangleMesh both = merged(bubble, rock);
    const Scan scan = clean_scan(inward ? inverted(both) : both, "B017", {.unit = 2.0});
    EXPECT_TRUE(sound(scan.mesh));
    EXPECT_NEAR(scan.report.inner_shell_volume, 8.0 * expected, 1e-12);
    EXPECT_NEAR(enclosed_volume(scan.mesh), 8.0 * enclosed_volume(rock), 1e-12);
    EXPECT_HAS(all_notes(scan), "1 inner shell");
  }
}

TEST(Scan, InnerShellsAreKeptAsCavitiesOnRequest) {
  const TriangleMesh rock = random_rock(4);
  const TriangleMesh first = moved_to(scaled(random_rock(5), 0.2), {0.25, 0, 0});
  const TriangleMesh second = moved_to(scaled(random_rock(7), 0.15), {-0.25, 0, 0});
  const double bubbles = enclosed_volume(first) + enclosed_volume(second);
  // Whatever way the shells face, and the rock too.
  for (int faces = 0; faces < 8; ++faces) {
    SCOPED_TRACE(faces);
    const auto facing = [&](const TriangleMesh& mesh, int bit) {
      return faces & bit ? inverted(mesh) : mesh;
    };
    const TriangleMesh all = merged(merged(facing(first, 1), facing(rock, 2)), facing(second, 4));
    const Scan scan = clean_scan(all, "B017", {.unit = 2.0, .repair = {.keep_inner_shells = true}});
    const MeshReport report = inspect_mesh(scan.mesh);
    EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
    EXPECT_EQ(report.components, 3u);
    EXPECT_EQ(scan.report.inner_shells, 2u);
    EXPECT_NEAR(scan.report.inner_shell_volume, 8.0 * bubbles, 1e-12);
    EXPECT_NEAR(enclosed_volume(scan.mesh), 8.0 * (enclosed_volume(rock) - bubbles), 1e-12);
    EXPECT_HAS(all_notes(scan), "2 inner shells (bubbles) of ");
    EXPECT_HAS(all_notes(scan), "kept as cavities");
    EXPECT_EQ(all_notes(scan).find("tunnel"), std::string::npos) << all_notes(scan);
  }
}

// Boxes that share part of a face: vertices of the one lie on the other, any of them first.
TEST(Scan, ClosedBodiesThatTouchAreNoBubbles) {
  Random random(12);
  const TriangleMesh block = box_mesh({1.0, 1.0, 1.0});
  for (int i = 0; i < 60; ++i) {
    const Vec3 sides(random.uniform(0.5, 0.95), random.uniform(0.5, 0.95),
                     random.uniform(0.5, 0.95));
    // Within the face, over its edges, and flush with them.
    const double y = i % 3 == 0 ? 0.0 : random.uniform(-0.4, 0.5);
    const double z = i % 3 == 1 ? 1.0 - sides.z() : random.uniform(-0.4, 0.5);
    TriangleMesh other = moved_to(box_mesh(sides), {i % 2 == 0 ? 1.0 : -sides.x(), y, z});
    std::rotate(other.triangles.begin(), other.triangles.begin() + i % 12, other.triangles.end());
    for (const TriangleMesh& both :
         {merged(block, other), merged(other, block), merged(block, inverted(other)),
          merged(inverted(other), block)}) {
      EXPECT_HAS(scan_refusal(both), "2 separate components") << i;
    }
  }
}

// ... and a hollow that reaches just to the skin, wherever its vertices touch it.
TEST(Scan, ABubbleThatTouchesTheSkinIsABubble) {
  Random random(13);
  const TriangleMesh block = box_mesh({1.0, 1.0, 1.0});
  for (int i = 0; i < 20; ++i) {
    const Vec3 sides(random.uniform(0.2, 0.6), random.uniform(0.2, 0.6), random.uniform(0.2, 0.6));
    const Vec3 at(i % 2 == 0 ? 0.0 : 1.0 - sides.x(), random.uniform(0.1, 0.3),
                  random.uniform(0.1, 0.3));
    const Scan scan = clean_scan(merged(block, moved_to(box_mesh(sides), at)), "B017");
    EXPECT_EQ(scan.report.inner_shells, 1u) << i;
    EXPECT_NEAR(enclosed_volume(scan.mesh), 1.0, 1e-9) << i;
  }
}

TEST(Scan, ALooseStoneInABubbleIsDropped) {
  const TriangleMesh rock = random_rock(4);
  const TriangleMesh bubble = scaled(random_rock(5), 0.4);
  const TriangleMesh stone = scaled(random_rock(6), 0.1);
  const TriangleMesh all = merged(merged(rock, stone), bubble);
  const Scan scan = clean_scan(all, "B017", {.repair = {.keep_inner_shells = true}});
  EXPECT_EQ(scan.report.inner_shells, 1u);
  EXPECT_NEAR(enclosed_volume(scan.mesh), enclosed_volume(rock) - enclosed_volume(bubble), 1e-12);
  EXPECT_HAS(all_notes(scan), "1 loose scrap dropped");
}

TEST(Scan, LooseScrapsAreDroppedWithANote) {
  TriangleMesh scrap = scaled(tetrahedron(), 0.03);
  scrap.triangles.pop_back();
  const TriangleMesh rock = random_rock(6);
  const TriangleMesh dirty = merged(merged(moved_to(scrap, {2, 0, 0}), rock),
                                    moved_to(scaled(tetrahedron(), 0.05), {0, 3, 0}));
  const Scan scan = clean_scan(dirty, "B017");
  EXPECT_TRUE(sound(scan.mesh));
  EXPECT_NEAR(enclosed_volume(scan.mesh), enclosed_volume(rock), 1e-14);
  EXPECT_HAS(all_notes(scan), "2 loose scraps dropped");
}

TEST(Scan, TwoBlocksInOneFileAreRefused) {
  const TriangleMesh two = merged(random_rock(6), moved_to(scaled(random_rock(7), 0.5), {5, 0, 0}));
  EXPECT_HAS(scan_refusal(two), "2 separate components");
}

TEST(Scan, OverlappingBlocksAreNotTakenForABubble) {
  // The first vertex of the second box lies inside the first box, others lie outside.
  const TriangleMesh box = box_mesh({1, 1, 1});
  const TriangleMesh two = merged(box, moved_to(box, {0.5, 0.3, 0.2}));
  EXPECT_HAS(scan_refusal(two), "2 separate components");
  EXPECT_HAS(scan_refusal(inverted(two)), "2 separate components");
}

TEST(Scan, TouchingAtOneVertexIsSplit) {
  // A strip of boxes bent round so that two corners meet would be one piece; a cheaper way to the
  // same defect: pull two far vertices of one rock to the same point.
  TriangleMesh rock = box_mesh({1, 1, 1}, 4);
  std::uint32_t low = 0, high = 0;
  for (std::uint32_t v = 0; v < rock.vertices.size(); ++v) {
    if ((rock.vertices[v] - Vec3(0.5, 0.5, 0)).norm() < 1e-9) low = v;
    if ((rock.vertices[v] - Vec3(0.5, 0.5, 1)).norm() < 1e-9) high = v;
  }
  rock.vertices[low] = rock.vertices[high] = Vec3(0.5, 0.5, 0.5);
  const Scan scan = clean_scan(rock, "B017");
  EXPECT_EQ(scan.report.as_read.pinched_vertices, 1u);
  EXPECT_TRUE(sound(scan.mesh));
  EXPECT_HAS(all_notes(scan), "touches itself");
}

TEST(Scan, TunnelsAreCounted) {
  // A 3 x 3 x 3 grid box with the middle cells of top and bottom joined by a square tube.
  TriangleMesh box = box_mesh({1, 1, 1}, 3);
  const auto middle = [&](const TriangleMesh::Triangle& t) {
    Vec3 centre = Vec3::Zero();
    for (const std::uint32_t v : t) centre += box.vertices[v] / 3.0;
    return std::abs(centre.x() - 0.5) < 0.17 && std::abs(centre.y() - 0.5) < 0.17 &&
           std::abs(centre.z() - 0.5) > 0.49;
  };
  EXPECT_EQ(std::erase_if(box.triangles, middle), 4u);
  const auto at_place = [&](double x, double y, double z) {
    for (std::uint32_t v = 0; v < box.vertices.size(); ++v) {
      if ((box.vertices[v] - Vec3(x, y, z)).norm() < 1e-9) return v;
    }
    return std::uint32_t(0);
  };
  const double low = 1.0 / 3.0, high = 2.0 / 3.0;
  const std::vector<Vec2> square = {{low, low}, {high, low}, {high, high}, {low, high}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 &p = square[i], &q = square[(i + 1) % 4];
    const std::uint32_t a = at_place(p.x(), p.y(), 0), b = at_place(q.x(), q.y(), 0);
    const std::uint32_t c = at_place(q.x(), q.y(), 1), d = at_place(p.x(), p.y(), 1);
    box.triangles.push_back({a, c, b});
    box.triangles.push_back({a, d, c});
  }
  const Scan scan = clean_scan(box, "B017");
  EXPECT_NEAR(enclosed_volume(scan.mesh), 8.0 / 9.0, 1e-14);
  EXPECT_HAS(all_notes(scan), "1 tunnel (a hole through the block) was kept");
}

TEST(Scan, TwoSidedExportAndFoldedSliversAreMended) {
  const TriangleMesh rock = random_rock(9);
  EXPECT_NEAR(enclosed_volume(clean_scan(merged(rock, inverted(rock)), "B017").mesh),
              enclosed_volume(rock), 1e-14);
  TriangleMesh folded = tetrahedron();
  folded.vertices.push_back({1, 1, 1});  // a fin of two triangles on one edge
  folded.triangles.push_back({1, 2, 4});
  folded.triangles.push_back({1, 4, 2});
  EXPECT_NEAR(enclosed_volume(clean_scan(folded, "B017").mesh), 1.0 / 6.0, 1e-15);
}

TEST(Scan, SheetsAndFlatThingsAreRefused) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}};
  EXPECT_HAS(scan_refusal(sheet), "encloses no volume");
  sheet.triangles = {{0, 1, 1}};
  EXPECT_HAS(scan_refusal(sheet), "no surface is left");
}

TEST(Scan, OneSidedSurfaceIsRefused) {
  TriangleMesh moebius;
  constexpr std::uint32_t n = 30;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double turn = 2.0 * kPi * i / n;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1.0 + side * std::cos(0.5 * turn);
      moebius.vertices.push_back(
          {r * std::cos(turn), r * std::sin(turn), side * std::sin(0.5 * turn)});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = a + 1;
    const std::uint32_t c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    moebius.triangles.push_back({a, c, b});
    moebius.triangles.push_back({b, c, d});
  }
  EXPECT_HAS(scan_refusal(moebius), "non-orientable");
}

TEST(Scan, FilesAreNamedInRefusals) {
  const ScratchFolder folder;
  TriangleMesh open = box_mesh({1, 1, 1}, 2);
  open.triangles.resize(30);
  write_mesh(folder / "B018.stl", open);
  try {
    read_scan(folder / "B018.stl", {.repair = {.fill_missing = false}});
    FAIL();
  } catch (const GeometryError& error) {
    EXPECT_HAS(std::string(error.what()), "B018.stl: the surface is not closed");
  }
  EXPECT_THROW(read_scan(folder / "none.stl"), InputError);
}

/// As programs write it that don't care: `write_mesh` would take an origin off first.
void write_as_floats(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_text_file(path, mesh_detail::encode_stl(mesh));
}

TEST(Scan, DigitsLostInTheFileAreToldOfOrRefused) {
  const ScratchFolder folder;
  const TriangleMesh rock = random_rock(3, 3, 0.05);
  // At 6.67e6 m a float is kept in steps of half a metre, at 8.9e4 m of 1/128 m, at 600 m of
  // 1/16384.
  write_as_floats(folder / "far.stl", moved_to(rock, {0, 6671300, 0}));
  try {
    read_scan(folder / "far.stl");
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_HAS(message,
               "far.stl: precision was lost in the file itself: its coordinates reach 66713");
    EXPECT_HAS(message, " and are stored in steps of 0.5 m, ");
    EXPECT_HAS(message,
               ", so its shape is lost; export it again with a local origin "
               "(CloudCompare: accept the global shift when loading) or as PLY with doubles");
  }
  write_as_floats(folder / "some.stl", moved_to(rock, {0, 88860, 0}));
  const Scan some = read_scan(folder / "some.stl");
  EXPECT_HAS(all_notes(some), "are stored in steps of 0.00781 m, 0.");
  EXPECT_EQ(all_notes(some).find("shape is lost"), std::string::npos);
  write_as_floats(folder / "near.stl", moved_to(rock, {0, 600, 0}));
  EXPECT_EQ(all_notes(read_scan(folder / "near.stl")).find("precision"), std::string::npos);
  // Doubles keep the shape at any place.
  write_mesh(folder / "far.ply", moved_to(rock, {0, 6671300, 0}));
  const Scan far = read_scan(folder / "far.ply");
  EXPECT_TRUE(far.notes.empty()) << all_notes(far);
  EXPECT_NEAR(enclosed_volume(far.mesh) / enclosed_volume(rock), 1.0, 1e-8);
  // Text with seven digits is no better than floats.
  std::string text;
  for (const Vec3& v : rock.vertices) {
    char line[100];
    std::snprintf(line, sizeof line, "v %.6e %.6e %.6e\n", v.x(), v.y() + 6671300, v.z());
    text += line;
  }
  for (const auto& [a, b, c] : rock.triangles) {
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
            std::to_string(c + 1) + "\n";
  }
  write_text_file(folder / "short.obj", text);
  EXPECT_THROW(read_scan(folder / "short.obj"), InputError);
}

TEST(Scan, BadOptionsAreRefusedByName) {
  const auto message = [](const ScanOptions& options) {
    try {
      clean_scan(tetrahedron(), "B017", options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_HAS(message({.unit = 0.0}), "unit");
  EXPECT_HAS(message({.unit = std::nan("")}), "unit");
  EXPECT_HAS(message({.up = "x"}), "up");
  EXPECT_HAS(message({.repair = {.weld_tolerance = -1.0}}), "weld_tolerance");
  EXPECT_HAS(message({.repair = {.weld_tolerance = 0.5}}), "weld_tolerance");
  TriangleMesh nan = tetrahedron();
  nan.vertices[2].x() = std::nan("");
  EXPECT_HAS(scan_refusal(nan), "vertex 3");
}

class DirtyRocks : public testing::TestWithParam<int> {};

/// A sound rock with shuffled soup, flipped triangles, a missing triangle and a bubble.
TEST_P(DirtyRocks, ComeBackSoundWithTheirVolume) {
  const TriangleMesh rock = random_rock(GetParam(), 3, 0.05);
  TriangleMesh dirty = merged(rock, inverted(scaled(random_rock(GetParam() + 50, 1), 0.3)));
  Random random(GetParam());
  dirty.triangles.erase(dirty.triangles.begin() +
                        static_cast<std::ptrdiff_t>(random.uniform_index(rock.triangles.size())));
  for (TriangleMesh::Triangle& t : dirty.triangles) {
    if (random.uniform() < 0.2) std::swap(t[0], t[1]);
  }
  TriangleMesh soup;
  for (const TriangleMesh::Triangle& t : dirty.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : t) {
      soup.vertices.push_back(dirty.vertices[v] + 1e-6 * random.unit_vector());
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const Scan scan = clean_scan(soup, "B017");
  EXPECT_TRUE(sound(scan.mesh));
  EXPECT_NEAR(enclosed_volume(scan.mesh) / enclosed_volume(rock), 1.0, 1e-5);
  EXPECT_GT(scan.report.inner_shell_volume, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DirtyRocks, testing::Range(0, 20));

}  // namespace
}  // namespace clast
