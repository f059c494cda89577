// Pages of an export of particles.
#include "report/particle_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "library/make_block.hpp"
#include "particles/particle_export.hpp"
#include "report/blocks/particle_shape.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;
using namespace report_detail;

Particle with_balls(std::vector<Ball> balls) {
  Particle particle;
  particle.balls = std::move(balls);
  return particle;
}

TEST(ParticleShape, ASphereIsClosedAndHasItsArea) {
  const ParticleSurface surface = make_particle_surface(with_balls({{{1.0, 2.0, 3.0}, 0.5}}));
  EXPECT_NEAR(signed_volume(surface.mesh), 4.0 / 3.0 * kPi * 0.125, 0.005);
  for (const Vec3& vertex : surface.mesh.vertices) {
    EXPECT_NEAR((vertex - Vec3(1.0, 2.0, 3.0)).norm(), 0.5, 1e-12);
  }
}

TEST(ParticleShape, TrianglesInsideOtherSpheresAreLeftOut) {
  // The inner ball is hidden. The caps of the two others inside each other have a height of 0.5.
  const ParticleSurface surface = make_particle_surface(
      with_balls({{Vec3::Zero(), 1.0}, {Vec3::UnitX(), 1.0}, {Vec3::Zero(), 0.4}}));
  EXPECT_EQ(std::count(surface.components.begin(), surface.components.end(), 2), 0);
  ASSERT_EQ(surface.components.size(), surface.mesh.triangles.size());
  EXPECT_NEAR(surface_area(surface.mesh), 6.0 * kPi, 0.08 * 6.0 * kPi);
  EXPECT_GT(surface_area(surface.mesh), 0.99 * 6.0 * kPi) << "no exposed triangle is left out";
}

TEST(ParticleShape, PartsKeepTheirTriangles) {
  Particle particle;
  particle.parts = {cuboid(1.0, 1.0, 1.0), cuboid(2.0, 1.0, 1.0)};
  const ParticleSurface surface = make_particle_surface(particle);
  EXPECT_EQ(surface.mesh.triangles.size(), 24u);
  EXPECT_NEAR(signed_volume(surface.mesh), 3.0, 1e-12);
  EXPECT_EQ(std::count(surface.components.begin(), surface.components.end(), 1), 12);
}

class ParticleReportTest : public testing::Test {
 protected:
  ParticleReportTest() {
    for (const double length : {3.0, 2.5}) {
      const TriangleMesh mesh = cuboid(length, 2.0, 1.0);
      blocks_.push_back(make_block(length == 3.0 ? "R1" : "R 2", mesh, ScanSurface(mesh), {}, {}));
    }
    options_.engine = "ramms";
  }
  ParticleExport exported() {
    std::vector<const Block*> blocks;
    for (const Block& block : blocks_) blocks.push_back(&block);
    ParticleReport report(folder_ / "pages", options_);
    const ParticleExport result =
        export_particles(blocks, folder_ / "clumps", options_, {}, &report);
    index_ = read_text_file(report.finish(folder_ / "clumps", blocks, result.failures));
    return result;
  }
  bool contains_text(const std::string& text) { return index_.find(text) != std::string::npos; }

  ScratchFolder folder_;
  std::vector<Block> blocks_;
  ParticleExportOptions options_;
  std::string index_;
};

TEST_F(ParticleReportTest, EachBlockHasAPageAndARowWithItsErrors) {
  options_.engine = "dem-engine";
  options_.clump.balls = 3;
  exported();
  for (const char* name : {"R1", "R_2"}) {
    EXPECT_TRUE(fs::exists(folder_ / "pages/particles" / (std::string(name) + ".html")));
    EXPECT_TRUE(contains_text("href=\"particles/" + std::string(name) + ".html\""));
  }
  const std::string page = read_text_file(folder_ / "pages/particles/R_2.html");
  EXPECT_NE(page.find("Block R 2 for DEM-Engine"), std::string::npos);
  EXPECT_NE(page.find("3 spheres"), std::string::npos);
  EXPECT_NE(page.find("distance of the spheres from the block"), std::string::npos);
  EXPECT_NE(page.find("L, m</td><td"), std::string::npos) << "sides of block and shape";
  const auto manifest = nlohmann::json::parse(read_text_file(folder_ / "clumps/particles.json"));
  const double error = manifest["blocks"][1]["particles"][0]["error_surface"];
  char text[32];
  std::snprintf(text, sizeof text, ">%.2f<", 100.0 * error);
  EXPECT_TRUE(contains_text(text)) << text;
}

TEST_F(ParticleReportTest, ARepeatedExportMakesMissingPagesOnly) {
  exported();
  const fs::path page = folder_ / "pages/particles/R1.html";
  const std::string before = read_text_file(page);
  fs::remove(page);
  const ParticleExport again = exported();
  EXPECT_EQ(again.written, 1u);
  EXPECT_EQ(again.kept, 1u);
  EXPECT_TRUE(read_text_file(page) == before);
}

TEST_F(ParticleReportTest, AChangedBlockGetsANewPage) {
  exported();
  const TriangleMesh longer = cuboid(3.5, 2.0, 1.0);
  blocks_[0] = make_block("R1", longer, ScanSurface(longer), {}, {});
  const fs::path page = folder_ / "pages/particles/R1.html";
  const std::string before = read_text_file(page);
  EXPECT_EQ(exported().written, 1u);
  EXPECT_TRUE(read_text_file(page) != before);
}

TEST_F(ParticleReportTest, PagesOfAnotherExportAreNotReplacedUnasked) {
  exported();
  options_.hull = true;
  EXPECT_TRUE(contains(refusal<InputError>([&] { ParticleReport(folder_ / "pages", options_); }),
                       "other options"));
  options_.replace = true;
  exported();
  EXPECT_NE(read_text_file(folder_ / "pages/particles/R1.html").find("hull=true"),
            std::string::npos);
}

TEST_F(ParticleReportTest, BlocksThatWereLeftOutAreListed) {
  blocks_[1].source.unscaled = true;
  exported();
  EXPECT_TRUE(contains_text("1 block left out"));
  EXPECT_TRUE(contains_text("R 2 is unscaled"));
}

}  // namespace
}  // namespace clast
