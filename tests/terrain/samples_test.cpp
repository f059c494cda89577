// The files in samples/: that the generator makes them, and that they are what they say.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "classify/schemes.hpp"
#include "core/files/text_file.hpp"
#include "massprops/solid.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/mesh_topology.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

const fs::path kSamples = fs::path(CLAST_SOURCE_DIR) / "samples";

std::set<fs::path> made_files(const fs::path& folder) {
  std::set<fs::path> files;
  for (const char* part : {"blocks", "dirty", "terrain"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder / part)) {
      if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder));
    }
  }
  files.insert("shape-effects/B01_fine.ply");
  return files;
}

TEST(Samples, TheGeneratorMakesTheSameBytesAgain) {
  const ScratchFolder folder;
  const std::string command =
      std::string(CLAST_MAKE_SAMPLES) + " \"" + folder.path().string() + "\"";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::set<fs::path> files = made_files(kSamples);
  EXPECT_EQ(made_files(folder.path()), files);
  for (const fs::path& file : files) {
    EXPECT_TRUE(read_text_file(folder.path() / file) == read_text_file(kSamples / file)) << file;
  }
}

TEST(Samples, TheGeneratorRefusesAMissingFolderName) {
  const int status = std::system((std::string(CLAST_MAKE_SAMPLES) + " 2> /dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

TEST(Samples, AllTogetherAreUnderFiveMegabytes) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kSamples)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  EXPECT_LT(bytes, 5'000'000u);
}

/// A clean scan with the class its name promises.
struct Scan {
  std::string file;
  std::string sneed_folk;
};
void PrintTo(const Scan& scan, std::ostream* out) { *out << scan.file; }

class CleanScan : public testing::TestWithParam<Scan> {
 protected:
  const TriangleMesh mesh_ = read_mesh(kSamples / "blocks" / GetParam().file);
};

TEST_P(CleanScan, IsClosedOutwardAndInOnePiece) {
  const MeshReport report = inspect_mesh(mesh_);
  EXPECT_EQ(report.summary(), "closed");
  EXPECT_TRUE(report.is_closed() && report.is_oriented());
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.euler_characteristic, 2);
  EXPECT_GE(report.triangles, 1500u);
  EXPECT_LE(report.triangles, 3000u);
  EXPECT_GT(solid_mass_properties(mesh_, 1.0).mass, 0.0);
}

// When every triangle spans a positive cone with one inner point and the cones fill the sphere
// once, no two triangles can meet.
TEST_P(CleanScan, DoesNotCrossItself) {
  const Vec3 centre = solid_mass_properties(mesh_, 1.0).centre;
  double solid_angle = 0.0;
  for (const auto& [ia, ib, ic] : mesh_.triangles) {
    const Vec3 a = (mesh_.vertices[ia] - centre).normalized();
    const Vec3 b = (mesh_.vertices[ib] - centre).normalized();
    const Vec3 c = (mesh_.vertices[ic] - centre).normalized();
    const double volume = a.dot(b.cross(c));
    EXPECT_GT(volume, 0.0);
    solid_angle += 2.0 * std::atan2(volume, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  EXPECT_NEAR(solid_angle, 4.0 * kPi, 1e-9);
}

TEST_P(CleanScan, HasTheSizeAndClassItsNamePromises) {
  const OrientedBox box = smallest_box(mesh_.vertices);
  const Axes axes = Axes::sorted(box.lengths[0], box.lengths[1], box.lengths[2]);
  EXPECT_GE(axes.L, 0.3);
  EXPECT_LE(axes.L, 1.5);
  EXPECT_EQ(sneed_folk_class(axes), GetParam().sneed_folk);
}

INSTANTIATE_TEST_SUITE_P(Blocks, CleanScan,
                         testing::Values(Scan{"B01_compact.ply", "C"}, Scan{"B02_platy.ply", "P"},
                                         Scan{"B03_bladed.ply", "B"},
                                         Scan{"B04_elongated.ply", "E"},
                                         Scan{"B05_very_elongated.ply", "VE"},
                                         Scan{"B06_cuboid.ply", "CB"},
                                         Scan{"B07_concave.ply", "CP"}),
                         [](const auto& scan) { return scan.param.file.substr(0, 3); });

// Share of the convex hull that is rock.
TEST(Samples, OnlyTheConcaveBlockIsClearlyConcave) {
  for (const auto& entry : fs::directory_iterator(kSamples / "blocks")) {
    const TriangleMesh mesh = read_mesh(entry.path());
    const double share = signed_volume(mesh) / signed_volume(convex_hull(mesh.vertices));
    if (entry.path().stem() == "B07_concave") {
      EXPECT_LT(share, 0.90);
    } else {
      EXPECT_GT(share, 0.94) << entry.path();
    }
  }
}

TEST(Samples, DirtyScansAreAsDirtyAsTheirNamesSay) {
  const auto report = [](const std::string& name) {
    return inspect_mesh(read_mesh(kSamples / "dirty" / (name + ".ply")));
  };
  const MeshReport patch = report("D01_ground_patch");
  EXPECT_GT(patch.components, 1u);
  EXPECT_GT(patch.boundary_edges, 20u);
  const MeshReport open = report("D02_open_bottom");
  EXPECT_EQ(open.components, 1u);
  EXPECT_GT(open.boundary_edges, 20u);
  EXPECT_GT(report("D03_spikes_and_hole").boundary_edges, 10u);
}

/// Nodes of all zones by their place in half metres.
std::map<std::pair<int, int>, double> quarry_heights() {
  std::map<std::pair<int, int>, double> heights;
  for (const char* zone : {"blue", "gray", "red"}) {
    const TriangleMesh mesh =
        read_mesh(kSamples / "terrain" / ("quarry_" + std::string(zone) + ".ply"));
    for (const Vec3& v : mesh.vertices) {
      const std::pair place{static_cast<int>(2 * v.x()), static_cast<int>(2 * v.y())};
      const auto [entry, is_new] = heights.emplace(place, v.z());
      EXPECT_EQ(entry->second, v.z()) << "zones must share their border to the bit";
    }
  }
  return heights;
}

TEST(Quarry, CoversTheWholeGrid) {
  EXPECT_EQ(quarry_heights().size(), (2u * 86 + 1) * (2u * 140 + 1));
}

// The section of lane P1 between its published points; noise of 0.10 m that falls to 1/e at 2 m.
// The lane holds some 800 patches of noise, so its deviation is known to about 3 %.
TEST(Quarry, FollowsTheSectionWithTheNoiseItClaims) {
  const std::vector<Vec2> section = {{-6, 213.5}, {-4, 211},   {0, 205.5}, {4, 203},  {22, 191.5},
                                     {26, 189.5}, {28, 188.5}, {30, 186},  {32, 173}, {34, 171.5},
                                     {41, 171},   {44, 162},   {52, 160},  {80, 158}};
  const auto heights = quarry_heights();
  std::map<std::pair<int, int>, double> noise;
  double sum = 0.0, squares = 0.0;
  for (const auto& [at, z] : heights) {
    if (at.second < -60 || at.second > 60) continue;
    const double x = at.first / 2.0;
    std::size_t i = 1;
    while (section[i].x() < x) ++i;
    const Vec2 &a = section[i - 1], &b = section[i];
    const double expected = a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
    noise[at] = z - expected;
    sum += z - expected;
    squares += (z - expected) * (z - expected);
  }
  const double count = static_cast<double>(noise.size());
  EXPECT_NEAR(sum / count, 0.0, 0.015);
  EXPECT_NEAR(std::sqrt(squares / count), 0.10, 0.01);
  double products = 0.0, pairs = 0.0;
  for (const auto& [at, value] : noise) {
    const auto other = noise.find({at.first + 4, at.second});
    if (other == noise.end()) continue;
    products += value * other->second;
    pairs += 1.0;
  }
  EXPECT_NEAR(products / pairs / (squares / count), std::exp(-1.0), 0.08);
}

TEST(Quarry, CliffEdgeIsOneCrispLine) {
  const auto heights = quarry_heights();
  for (int y = -60; y <= 60; ++y) {
    double sharpest = 0.0;
    int edge = 0;
    for (int x = 50; x <= 70; ++x) {
      const double bend =
          heights.at({x - 1, y}) - 2.0 * heights.at({x, y}) + heights.at({x + 1, y});
      if (bend < sharpest) {
        sharpest = bend;
        edge = x;
      }
    }
    EXPECT_EQ(edge, 60) << "y " << y / 2.0;  // x = 30 m
    // The slope falls from -1.25 to -6.5 there; over half a metre that bends by 2.625 m.
    EXPECT_NEAR(sharpest, -2.625, 0.3) << "y " << y / 2.0;
  }
}

TEST(Quarry, ZonesChangeWhereTheLanesSay) {
  struct Span {
    double y, x_from, x_to;
    std::string zone;
  };
  const double far = 80.0;
  for (const Span& span :
       {Span{0, -6, 27, "blue"}, Span{0, 27, far, "gray"}, Span{80, -6, 21, "blue"},
        Span{80, 21, 25, "gray"}, Span{80, 25, 37, "red"}, Span{80, 37, 55, "gray"},
        Span{80, 55, far, "blue"}}) {
    const TriangleMesh mesh = read_mesh(kSamples / "terrain" / ("quarry_" + span.zone + ".ply"));
    double area = 0.0;
    for (const auto& [ia, ib, ic] : mesh.triangles) {
      const Vec3 &a = mesh.vertices[ia], &b = mesh.vertices[ib], &c = mesh.vertices[ic];
      const Vec3 middle = (a + b + c) / 3.0;
      if (middle.x() < span.x_from || middle.x() > span.x_to) continue;
      if (middle.y() < span.y - 10.0 || middle.y() > span.y + 10.0) continue;
      area += ((b - a).cross(c - a)).z() / 2.0;
    }
    EXPECT_NEAR(area, 20.0 * (span.x_to - span.x_from), 1e-3) << span.zone << " " << span.x_from;
  }
}

}  // namespace
}  // namespace clast
