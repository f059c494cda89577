#include "particles/particle_export.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "library/make_block.hpp"
#include "samples/rock_shapes.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

/// Convex blocks, whose rounded surface is a small mesh.
Block cuboid_block(const std::string& id, double length) {
  const TriangleMesh mesh = cuboid(length, 2.0, 1.0);
  return make_block(id, mesh, ScanSurface(mesh), {}, {});
}

class ParticleExportTest : public testing::Test {
 protected:
  ParticleExport exported(const std::string& engine) {
    options_.engine = engine;
    options_.clump.error = {0.5, 0.5, 0.3};
    const bool fixed = options_.levels.empty() && options_.max_parts.value_or(0) == 0 &&
                       find_particle_engine(engine).shapes.front() == ParticleShape::kSpheres;
    options_.clump.balls.reset();
    if (fixed) options_.clump.balls = 3;
    std::vector<const Block*> blocks;
    for (const Block& block : blocks_) blocks.push_back(&block);
    return export_particles(blocks, folder_.path(), options_);
  }
  std::string text(const std::string& name) { return read_text_file(folder_ / name); }
  nlohmann::json manifest() { return nlohmann::json::parse(text("particles.json")); }

  ScratchFolder folder_;
  std::vector<Block> blocks_ = {cuboid_block("R1", 3.0), cuboid_block("R 2", 2.5)};
  ParticleExportOptions options_;
};

TEST_F(ParticleExportTest, EveryEngineGetsItsFilesAndAManifest) {
  blocks_.pop_back();
  for (const ParticleEngine& engine : particle_engines()) {
    options_.replace = true;
    if (engine.shapes.front() == ParticleShape::kParts)
      options_.max_parts = 2;
    else
      options_.max_parts.reset();
    options_.hull = engine.shapes.front() == ParticleShape::kPolyhedron;
    EXPECT_EQ(exported(engine.name).written, 1u) << engine.name;
    const nlohmann::json rows = manifest()["blocks"];
    ASSERT_EQ(rows.size(), 1u);
    for (const nlohmann::json& file : rows[0]["particles"][0]["file_list"]) {
      EXPECT_TRUE(std::filesystem::exists(folder_ / file.get<std::string>())) << file;
    }
  }
}

TEST_F(ParticleExportTest, ManifestHasTheTrueMassAndTheErrors) {
  exported("dem-engine");
  const nlohmann::json row = manifest()["blocks"][1]["particles"][0];
  const Block& block = blocks_[0];
  EXPECT_EQ(row["block"], "R1");
  EXPECT_DOUBLE_EQ(row["mass_kg"].get<double>(), block.mass.mass);
  EXPECT_DOUBLE_EQ(row["J1_kg_m2"].get<double>(), block.principal.moments[0]);
  EXPECT_DOUBLE_EQ(row["centre_x_m"].get<double>(), block.mass.centre.x());
  EXPECT_DOUBLE_EQ(row["L_m"].get<double>(), block.box.lengths[0]);
  EXPECT_GT(row["error_surface"].get<double>(), 0.0);
  EXPECT_EQ(row["spheres"], 3);
  EXPECT_TRUE(text("particles.csv").starts_with("name,block,shape,spheres,parts,"));
}

TEST_F(ParticleExportTest, NamesHaveLettersDigitsAndUnderscores) {
  exported("dem-engine");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "R_2.csv"));
  EXPECT_EQ(particle_name("7-a"), "b7_a");
  blocks_[0].id = "R_2";
  options_.replace = true;
  EXPECT_TRUE(contains(refusal<InputError>([&] { exported("yade"); }), "both be written as R_2"));
}

TEST_F(ParticleExportTest, ARepeatedExportKeepsWhatIsThere) {
  exported("dem-engine");
  const std::string before = text("particles.json");
  std::filesystem::remove(folder_ / "R1.csv");
  const ParticleExport again = exported("dem-engine");
  EXPECT_EQ(again.kept, 1u);
  EXPECT_EQ(again.written, 1u);
  EXPECT_EQ(text("particles.json"), before);
}

TEST_F(ParticleExportTest, AChangedBlockIsWrittenAgain) {
  exported("dem-engine");
  blocks_[0] = cuboid_block("R1", 2.7);
  EXPECT_EQ(exported("dem-engine").written, 1u);
}

TEST_F(ParticleExportTest, FilesDoNotDependOnTheNumberOfThreads) {
  options_.threads = 1;
  exported("dem-engine");
  const std::string one = text("R1.csv") + text("R_2.csv") + text("particles.json");
  options_.threads = 3;
  std::filesystem::remove(folder_ / "particles.json");
  options_.replace = true;
  exported("dem-engine");
  EXPECT_EQ(text("R1.csv") + text("R_2.csv") + text("particles.json"), one);
}

TEST_F(ParticleExportTest, AnInterruptedExportContinuesToTheSameFiles) {
  for (const double length : {2.2, 2.1, 2.7, 2.8}) {
    blocks_.push_back(cuboid_block("S" + std::to_string(blocks_.size()), length));
  }
  std::vector<const Block*> blocks;
  for (const Block& block : blocks_) blocks.push_back(&block);
  options_.engine = "ramms";
  const ScratchFolder whole;
  export_particles(blocks, whole.path(), options_);
  options_.threads = 3;
  const auto interrupt = [](const ProgressUpdate& step) {
    if (step.done == 2) throw InputError("interrupted");
  };
  EXPECT_THROW(export_particles(blocks, folder_.path(), options_, interrupt), InputError);
  EXPECT_EQ(export_particles(blocks, folder_.path(), options_).kept, 2u);
  for (const char* name : {"particles.json", "R1.pts", "S2.pts", "S5.pts"}) {
    EXPECT_EQ(text(name), read_text_file(whole / name)) << name;
  }
}

TEST_F(ParticleExportTest, OtherExportsAreNotReplacedUnasked) {
  exported("dem-engine");
  EXPECT_TRUE(contains(refusal<InputError>([&] { exported("yade"); }), "other options"));
}

TEST_F(ParticleExportTest, ADamagedManifestIsRefused) {
  exported("edem");
  const std::string whole = text("particles.json");
  const auto refusal_of = [&](const std::string& damaged) {
    write_text_file(folder_ / "particles.json", damaged);
    return refusal<InputError>([&] { exported("edem"); });
  };
  Random random(5);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    std::string damaged = whole;
    char& byte = damaged[random.uniform_index(whole.size())];
    byte = static_cast<char>(byte ^ (1 << random.uniform_index(8)));
    const std::string message = refusal_of(damaged);
    if (!message.empty()) {
      ++refused;
      EXPECT_TRUE(contains(message, folder_.path().string()));
      EXPECT_TRUE(contains(message, "use `replace`"));
    }
    EXPECT_TRUE(!message.empty() || text("particles.json") == whole) << damaged;
  }
  EXPECT_GT(refused, 250u);
  for (const std::string& other : {whole.substr(0, whole.size() / 2), std::string(),
                                   std::string("[1]"), std::string("{\"format\": 1}")}) {
    EXPECT_TRUE(contains(refusal_of(other), "particles.json: is damaged")) << other;
    EXPECT_EQ(text("particles.json"), other);
  }
}

TEST_F(ParticleExportTest, ADamagedManifestCanBeReplaced) {
  exported("edem");
  const std::string whole = text("particles.json");
  write_text_file(folder_ / "particles.json", whole.substr(0, 100));
  options_.replace = true;
  EXPECT_EQ(exported("edem").written, 2u);
  EXPECT_EQ(text("particles.json"), whole);
}

TEST_F(ParticleExportTest, LevelsAreSeveralFiles) {
  options_.levels = {0.4, 0.3};
  exported("edem");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "R1_s0_4.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "R1_s0_3.csv"));
}

TEST_F(ParticleExportTest, UnscaledBlocksAreLeftOutWithTheReason) {
  blocks_[1].source.unscaled = true;
  const ParticleExport result = exported("edem");
  EXPECT_EQ(result.written, 1u);
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_TRUE(contains(result.failures[0], "R 2 is unscaled")) << result.failures[0];
}

TEST_F(ParticleExportTest, AConcaveBlockNeedsHullForAPolyhedron) {
  const TriangleMesh mesh = rock({.name = "N", .notch = 0.6, .roughness = 0.0, .frequency = 6});
  BlockOptions block_options;
  block_options.tolerance = 0.1;
  blocks_ = {make_block("N", mesh, ScanSurface(mesh), {}, block_options)};
  options_.clump.error = {0.01, 0.02, 0.02};
  options_.engine = "ramms";
  const std::vector<const Block*> blocks = {&blocks_[0]};
  const ParticleExport refused = export_particles(blocks, folder_.path(), options_);
  ASSERT_EQ(refused.failures.size(), 1u);
  EXPECT_TRUE(contains(refused.failures[0], "is concave")) << refused.failures[0];
  options_.hull = true;
  options_.replace = true;
  EXPECT_EQ(export_particles(blocks, folder_.path(), options_).written, 1u);
}

TEST_F(ParticleExportTest, OptionsThatDoNotFitAreRefused) {
  const auto refused = [&](const std::string& engine) {
    return refusal<InputError>([&] { exported(engine); });
  };
  EXPECT_TRUE(contains(refused("abaqus"), "\"abaqus\" is not known"));
  options_.shape = ParticleShape::kParts;
  EXPECT_TRUE(contains(refused("yade"), "not taken by YADE"));
  options_.shape.reset();
  options_.max_parts = 3;
  EXPECT_TRUE(contains(refused("yade"), "`parts` applies to the shape parts"));
}

TEST(Particle, BalancedMassesHaveTheCentreAndAxesOfTheParticle) {
  Particle particle;
  particle.mass = 5.0;
  particle.lengths = {2.0, 2.0, 2.0};
  for (int i = 0; i < 12; ++i) {
    particle.balls.push_back({Vec3(std::sin(i), std::cos(2.0 * i), std::sin(3.0 * i)), 0.3});
  }
  const std::vector<double> masses = balanced_masses(particle);
  double sum = 0.0;
  Vec3 first = Vec3::Zero(), products = Vec3::Zero();
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const Vec3& x = particle.balls[i].centre;
    EXPECT_GT(masses[i], 0.0);
    sum += masses[i];
    first += masses[i] * x;
    products += masses[i] * Vec3(x.y() * x.z(), x.z() * x.x(), x.x() * x.y());
  }
  EXPECT_NEAR(sum, 5.0, 1e-12);
  EXPECT_LT(first.norm(), 1e-12);
  EXPECT_LT(products.norm(), 1e-12);
}

TEST(ParticleEngines, DocumentationHasTheTable) {
  const std::string page =
      read_text_file(std::string(CLAST_SOURCE_DIR) + "/docs/howto/other-engines.md");
  EXPECT_TRUE(contains(page, particle_engine_table())) << particle_engine_table();
}

}  // namespace
}  // namespace clast
