// Unscaled blocks in campaigns: only at a size that the campaign gives them.
#include <gtest/gtest.h>

#include "library/unscaled.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

class UnscaledCampaign : public CampaignRun {
 protected:
  /// The library of the fixture and the slab again, 3.7 times as large and in no known unit.
  void SetUp() override {
    constexpr double kUnits = 3.7;
    BlockLibrary library = BlockLibrary::read(*folder_ / "blocks.h5");
    if (library.contains("model")) return;
    const TriangleMesh mesh =
        transformed(centred_box_mesh(kUnits * Vec3(1.0, 0.6, 0.3)),
                    Pose{Vec3(5.0, 1.0, 2.0), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX()))});
    BlockSource source;
    source.file = "photos";
    source.sha256 = std::string(64, '0');
    source.unscaled = true;
    BlockOptions options;
    options.core = true;
    options.radius = kUnits * 0.05;
    library.add(make_block("model", mesh, mesh, source, options));
    library.write(*folder_ / "blocks.h5");
  }
  static std::string blocks(const std::string& more) {
    return with("[terrain]", more + "\n[terrain]");
  }
};

TEST_F(UnscaledCampaign, IsRefusedByNameWhereItHasNoSize) {
  for (const char* choice :
       {"", "scale = \"equal-mass\"", "select = [\"slab\", \"model\"]",
        "select = { scheme = \"garcia\", class = \"elongated\" }", "draw = { count = 5 }"}) {
    const std::string message = refusal(blocks(choice));
    EXPECT_TRUE(contains(message, "block model of ")) << choice << message;
    EXPECT_TRUE(contains(message, "is unscaled") && contains(message, "`bars`") &&
                contains(message, "mass_kg"))
        << message;
  }
  EXPECT_EQ(prepared(blocks("select = [\"slab\", \"cube\"]")).bodies.size(), 2u);
}

// Whatever the unit of the model, a mass or a volume makes it the block it is a model of.
TEST_F(UnscaledCampaign, RunsAtTheMassOrTheVolumeItIsGiven) {
  for (const char* size : {"scale = { mass_kg = 700 }", "scale = { volume_m3 = 0.3 }",
                           "draw = { count = 2, mass_kg = 700 }"}) {
    const std::string scale = std::string("\n") + size;
    const CampaignPlan model = prepared(blocks("select = [\"model\"]" + scale));
    const CampaignPlan slab = prepared(blocks("select = [\"slab\"]" + scale));
    const RigidBody &a = model.bodies[0], &b = slab.bodies[0];
    EXPECT_NEAR(a.mass, b.mass, 1e-6 * b.mass);
    EXPECT_LT((a.moments - b.moments).norm(), 1e-6 * b.moments.norm());
    EXPECT_NEAR(a.shape.radius, b.shape.radius, 1e-9);
    EXPECT_NEAR(a.smallest_side, b.smallest_side, 1e-9);
    EXPECT_NEAR(model.header.blocks[0].volume, slab.header.blocks[0].volume, 1e-7);
    EXPECT_NEAR(model.header.blocks[0].axes.L, slab.header.blocks[0].axes.L, 1e-7);
  }
}

}  // namespace
}  // namespace clast
