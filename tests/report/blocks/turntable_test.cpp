// What a turntable draws.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mesh/triangle_tree.hpp"
#include "report/blocks/turntable.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/packed_numbers.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

using namespace report_detail;

using Json = nlohmann::json;

/// A cuboid of 3 x 2 x 1 m as the block of a rough scan.
Block scanned_block() {
  Block block = filled_block("B1");
  block.from_core = false;
  block.surface = rock_mesh(12, {1.6, 1.1, 0.6}, 4);
  block.deviation.hausdorff = 0.5;
  return block;
}

std::vector<Vec3> places(const Json& mesh, const Json& data) {
  const std::vector<std::int16_t> steps = packed_numbers<std::int16_t>(mesh.at("vertices"));
  const double size = data.at("size");
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < steps.size(); i += 3) {
    result.push_back(size / 32767.0 * Vec3(steps[i], steps[i + 1], steps[i + 2]) +
                     Vec3(data["centre"][0], data["centre"][1], data["centre"][2]));
  }
  return result;
}

TEST(Turntable, HoldsBlockScanAndBoxWhereTheyAre) {
  const Block block = scanned_block();
  const Json data = Json::parse(format_turntable_json(block));
  const double step = double(data["size"]) / 32767.0;
  const TriangleMesh skin = rounded_surface_mesh(block.body, 2);
  const std::vector<Vec3> corners = places(data["block"], data);
  ASSERT_EQ(corners.size(), skin.vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_LT((corners[i] - skin.vertices[i]).cwiseAbs().maxCoeff(), 0.51 * step);
  }
  const std::vector<Vec3> scan = places(data["scan"], data);
  ASSERT_EQ(scan.size(), block.surface.vertices.size());
  EXPECT_LT((scan.back() - block.surface.vertices.back()).norm(), step);
  EXPECT_EQ(data["box"]["lengths"], Json::parse("[3.0, 2.0, 1.0]"));
  EXPECT_EQ(data["box"]["axes"][0], Json::parse("[-1.0, 0.0, 0.0]")) << "the axis of L";
  EXPECT_EQ(data["unit"], "m");
}

TEST(Turntable, MarksTrianglesThatWereNotObserved) {
  const Block block = scanned_block();
  const Json all_observed = Json::parse(format_turntable_json(block));
  EXPECT_FALSE(all_observed["block"].contains("unobserved"));
  const auto is_below = [&](const Vec3& place) { return place.z() < block.box.centre.z(); };
  const Json data = Json::parse(format_turntable_json(block, {}, is_below));
  for (const char* name : {"block", "scan"}) {
    const Json& mesh = data[name];
    const std::vector<Vec3> corners = places(mesh, data);
    const auto triangles = packed_numbers<std::uint32_t>(mesh["triangles"]);
    const auto unobserved = packed_numbers<std::uint8_t>(mesh["unobserved"]);
    ASSERT_EQ(unobserved.size(), triangles.size() / 3);
    for (std::size_t t = 0; t < unobserved.size(); ++t) {
      const Vec3 middle = (corners[triangles[3 * t]] + corners[triangles[3 * t + 1]] +
                           corners[triangles[3 * t + 2]]) /
                          3.0;
      const double height = middle.z() - block.box.centre.z();
      if (std::abs(height) > 1e-3) {
        EXPECT_EQ(unobserved[t], height < 0.0 ? 1 : 0);
      }
    }
  }
}

// Each distance is that of its corner between those of a triangle, searched through all triangles.
TEST(Turntable, HasTheDistanceOfEveryCornerFromTheScan) {
  const Block block = scanned_block();
  const Json deviation = Json::parse(format_turntable_json(block))["deviation"];
  const TriangleMesh skin = rounded_surface_mesh(block.body, 2);
  const auto pieces = packed_numbers<std::uint8_t>(deviation["pieces"]);
  const auto shares = packed_numbers<std::int8_t>(deviation["shares"]);
  ASSERT_EQ(pieces.size(), skin.triangles.size());
  const TriangleTree tree(block.surface);
  std::size_t at = 0;
  bool is_inside = false, is_outside = false;
  for (std::size_t t = 0; t < pieces.size(); ++t) {
    const auto& [a, b, c] = skin.triangles[t];
    const double n = pieces[t];
    EXPECT_LE(std::max({(skin.vertices[a] - skin.vertices[b]).norm(),
                        (skin.vertices[b] - skin.vertices[c]).norm(),
                        (skin.vertices[c] - skin.vertices[a]).norm()}) /
                  n,
              3.0 / 48.0 + 1e-12);
    for (double row = 0.0; row <= n; ++row) {
      for (double column = 0.0; column <= row; ++column, ++at) {
        ASSERT_LT(at, shares.size());
        const Vec3 place = (n - row) / n * skin.vertices[a] +
                           (row - column) / n * skin.vertices[b] + column / n * skin.vertices[c];
        const double expected = std::clamp(tree.signed_distance(place) / 0.5, -1.0, 1.0);
        EXPECT_NEAR(shares[at] / 127.0, expected, 0.5 / 127.0 + 1e-9);
        is_inside |= shares[at] < 0;
        is_outside |= shares[at] > 0;
      }
    }
  }
  EXPECT_EQ(at, shares.size());
  EXPECT_TRUE(is_inside && is_outside) << "corners stand out, faces lie inside";
}

TEST(Turntable, CoarsensAFineScanAndLeavesOutWhatIsNotThere) {
  const Block block = scanned_block();
  const Json coarse = Json::parse(format_turntable_json(block, {.scan_triangles = 300}));
  const std::size_t triangles =
      packed_numbers<std::uint32_t>(coarse["scan"]["triangles"]).size() / 3;
  EXPECT_LE(triangles, 300u);
  EXPECT_GT(triangles, 100u);
  // Every vertex is one of the scan's.
  const TriangleTree tree(block.surface);
  for (const Vec3& place : places(coarse["scan"], coarse)) {
    EXPECT_LT(std::abs(tree.signed_distance(place)), 1e-3);
  }
  const Json core = Json::parse(format_turntable_json(filled_block("B2")));
  EXPECT_FALSE(core.contains("scan")) << "made from a core, it has no scan";
  EXPECT_FALSE(core.contains("deviation"));
  EXPECT_THROW(format_turntable_json(block, {.scan_triangles = 3}), InputError);
  EXPECT_THROW(format_turntable_json(block, {.deviation_cells = 1e9}), InputError);
}

TEST(Turntable, SaysWhatIsMissing) {
  ASSERT_EQ(::setenv("CLAST_THREE", "/nowhere", 1), 0);
  const std::string none = format_turntable_section(scanned_block());
  ::unsetenv("CLAST_THREE");
  EXPECT_TRUE(contains(none, "three.js is not in /nowhere"));
  EXPECT_TRUE(contains(format_turntable_section(scanned_block()), "class=\"turntable\""));
}

}  // namespace
}  // namespace clast
