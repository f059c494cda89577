// clast terrain as a process: what it prints, writes, and refuses.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/command_support.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

class TerrainCommand : public testing::Test {
 protected:
  void SetUp() override {
    // 20 x 10 squares of 1 m: 60 degrees steep up to x = 10, level beyond, with a hole and a spike.
    TriangleMesh mesh;
    for (int j = 0; j <= 10; ++j) {
      for (int i = 0; i <= 20; ++i) {
        mesh.vertices.emplace_back(i, j, std::sqrt(3.0) * std::max(0, 10 - i));
      }
    }
    for (std::uint32_t j = 0; j < 10; ++j) {
      for (std::uint32_t i = 0; i < 20; ++i) {
        const std::uint32_t a = 21 * j + i, c = a + 22;
        if (i != 15 || j != 5) mesh.triangles.push_back({a, a + 1, c});
        mesh.triangles.push_back({a, c, c - 1});
      }
    }
    mesh.vertices[21 * 3 + 17].z() = 7.0;
    write_obj(folder / "ground.obj", mesh);
    write_text_file(folder / "points.xyz", "2 5 20\n3 9.5 20\n");
  }
  ScratchFolder folder;
};

TEST_F(TerrainCommand, MendsZonesChecksAndDraws) {
  const ProgramRun run =
      run_clast({"terrain", "ground.obj", "--zones", "cliff=slope>50,meadow=else", "--release",
                 "points.xyz", "--border-distance", "1", "--block-size", "0.2", "--picture",
                 "map.svg", "-o", "t.h5", "--json"},
                folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report["triangles"], 400);
  EXPECT_EQ(report["filled_holes"], 1);
  EXPECT_EQ(report["levelled_spikes"], 1);
  EXPECT_EQ(report["open_holes"], 0);
  EXPECT_EQ(report["zones"][0]["zone"], "cliff");
  EXPECT_NEAR(report["zones"][0]["plan_area_m2"], 100.0, 1e-9);
  const std::string notes = report["notes"].dump();
  EXPECT_TRUE(contains(notes, "at x 17.000, y 3.000, z 7.000")) << notes;
  EXPECT_TRUE(contains(notes, "1 of 2 release points are nearer than 1 m to the border")) << notes;
  EXPECT_TRUE(contains(notes, "much longer than the blocks, 0.2 m")) << notes;
  const std::string map = read_text_file(folder / "map.svg");
  EXPECT_TRUE(map.starts_with("<?xml") && map.ends_with("</svg>\n"));
  for (const char* word : {"release point 0", "release point 1", ">cliff<", ">meadow<"}) {
    EXPECT_TRUE(contains(map, word)) << word;
  }
  EXPECT_TRUE(fs::exists(folder / "t.h5"));
}

TEST_F(TerrainCommand, TellsEveryMendInPlainWords) {
  const ProgramRun run =
      run_clast({"terrain", "ground.obj", "--tolerance", "0.01", "-o", "t.h5"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "note: 1 holes were filled, the widest, ")) << run.out;
  EXPECT_TRUE(contains(run.out, "note: simplified within 0.01 m: ")) << run.out;
}

TEST_F(TerrainCommand, RefusesWithoutLeavingFiles) {
  write_text_file(folder / "off.xyz", "2 5 20\n31 5 20\n");
  expect_refused(folder, {"terrain", "ground.obj", "--release", "off.xyz", "-o", "t.h5"}, 1,
                 "off.xyz: release point 2 at x 31.000, y 5.000, z 20.000 is off the ground");
  expect_refused(folder, {"terrain", "ground.obj", "--zones", "cliff=slope>50", "-o", "t.h5"}, 1,
                 "without a zone");
  expect_refused(folder, {"terrain", "ground.obj", "--percentile", "5", "-o", "t.h5"}, 1,
                 "percentile and outliers apply only to clouds");
}

TEST_F(TerrainCommand, ATerrainFileMayBeWrittenAnew) {
  ASSERT_EQ(run_clast({"terrain", "ground.obj", "-o", "t.h5"}, folder.path()).exit_code, 0);
  EXPECT_EQ(run_clast({"terrain", "t.h5", "-o", "t.h5", "--replace"}, folder.path()).exit_code, 0);
}

}  // namespace
}  // namespace clast
