#pragma once
/// A campaign of two blocks on a slope of two zones, in a folder of its own.
#include "library/block_library.hpp"
#include "library/make_block.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "tests/app/command_support.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/library/core_library.hpp"

namespace clast {

/// A slope that falls by one in two along x, from (0, -10, 20) to (20, 10, 10), and flat ground
/// after.
inline TriangleMesh ground_strip(double from, double to, double z_from, double z_to) {
  TriangleMesh mesh;
  mesh.vertices = {{from, -10, z_from}, {to, -10, z_to}, {to, 10, z_to}, {from, 10, z_from}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

inline std::string slope_campaign(const std::string& more = "") {
  return "[blocks]\nlibrary = \"blocks.h5\"\n"
         "[terrain]\nsurface = [\"slope.obj\", \"flat.obj\"]\nzones = [\"slope\", \"flat\"]\n"
         "[ground.slope]\nenergy_restitution = 0.01\nfriction = 0.4\nrolling_friction = 0.1\n"
         "[ground.flat]\nenergy_restitution = 0.01\nfriction = 0.7\nrolling_friction = 0.3\n"
         "[release]\npoints = [[5, 0, 0], [5, 3, 0]]\nheight_m = 0.5\n"
         "orientations = { random = 2, seed = 4 }\n"
         "[[barrier]]\nname = \"B1\"\nfrom = [12, -9]\nto = [12, 9]\n"
         "[run]\nmax_time_s = 5\ntrajectory_interval_s = 0\n" +
         more;
}

inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
  return text.replace(text.find(part), part.size(), by);
}

class SlopeCampaign : public testing::Test {
 protected:
  void SetUp() override {
    write_obj(folder / "slope.obj", ground_strip(0, 20, 20, 10));
    write_obj(folder / "flat.obj", ground_strip(20, 40, 10, 10));
    write_text_file(folder / "campaign.toml", slope_campaign());
    write_core_library(folder / "blocks.h5",
                       {{"cube", cuboid(0.6, 0.5, 0.4)}, {"bar", cuboid(1.2, 0.4, 0.4)}});
  }
  void refuse_campaign(const std::string& text, const std::string& item) {
    write_text_file(folder / "bad.toml", text);
    const std::string said =
        refusal<Error>([&] { prepare_campaign(read_campaign(folder / "bad.toml")); });
    EXPECT_TRUE(contains(said, item));
  }
  ScratchFolder folder;
};

}  // namespace clast
