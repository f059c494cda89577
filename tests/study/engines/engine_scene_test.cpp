// Campaigns as scenes of other engines, read back from their files.
#include "study/engines/engine_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "massprops/solid.hpp"
#include "massprops/sphero.hpp"
#include "mesh/mesh_io.hpp"
#include "shapes/shp_file.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

struct RockableBody {
  std::string shape;
  int group = -1;
  double scale = 0.0;
  RigidState state;
};

/// What a conf file says, by key and groups.
struct Conf {
  std::map<std::string, std::string> value;
  std::map<std::string, double> pair;  ///< "muContact 2 0"
  std::vector<RockableBody> bodies;
};

Conf read_conf(const fs::path& file) {
  Conf conf;
  std::istringstream lines(read_text_file(file));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key, rest;
    if (!(words >> key) || key[0] == '#') continue;
    if (key.ends_with("Contact") || key == "density") {
      std::string groups;
      double number = 0.0;
      for (int i = 0; i < (key == "density" ? 1 : 2); ++i) {
        words >> rest;
        groups += " " + rest;
      }
      words >> number;
      conf.pair[key + groups] = number;
      continue;
    }
    std::getline(words, rest);
    conf.value[key] = rest;
    if (key != "Particles") continue;
    for (int i = std::stoi(rest); i > 0 && std::getline(lines, line); --i) {
      std::istringstream body(line);
      RockableBody read;
      int cluster = 0;
      Vec3 none;
      Quat& q = read.state.orientation;
      const auto take = [&](Vec3& v) { body >> v.x() >> v.y() >> v.z(); };
      body >> read.shape >> read.group >> cluster >> read.scale;
      take(read.state.position);
      take(read.state.velocity);
      take(none);
      body >> q.w() >> q.x() >> q.y() >> q.z();
      take(read.state.angular_velocity);
      take(none);
      EXPECT_TRUE(body) << line;
      conf.bodies.push_back(read);
    }
  }
  return conf;
}

class EngineScenesOf : public CampaignRun {
 protected:
  static EngineScenes write(const CampaignPlan& prepared, const std::string& engine,
                            const std::vector<std::uint32_t>& runs = {}) {
    fs::remove_all(*folder_ / "scenes");
    fs::create_directories(*folder_ / "scenes");
    return write_engine_scenes(prepared, {.engine = engine, .runs = runs}, *folder_ / "scenes");
  }
  static fs::path at(const std::string& file) { return *folder_ / "scenes" / file; }
};

TEST_F(EngineScenesOf, RockableHaveTheStartsBitByBit) {
  const CampaignPlan plan = prepared(with("turns.txt\"",
                                          "turns.txt\"\nvelocity_m_s = [1, 0, 0]"
                                          "\nangular_velocity_rad_s = [0, 2, 0]"));
  const EngineScenes scenes = write(plan, "rockable");
  ASSERT_EQ(scenes.folders.size(), plan.runs.size());
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const RunRecord& run = plan.runs[i];
    const Conf conf = read_conf(at(scenes.folders[i]) / "input.txt");
    ASSERT_EQ(conf.bodies.size(), 3u) << "two zones and a block";
    const RockableBody& block = conf.bodies.back();
    EXPECT_EQ(block.shape, plan.header.blocks[run.block].id);
    EXPECT_EQ(block.state.position, run.start.position);
    EXPECT_EQ(block.state.orientation.coeffs(), run.start.orientation.coeffs());
    EXPECT_EQ(block.state.velocity, Vec3(1, 0, 0));
    EXPECT_EQ(block.state.angular_velocity, Vec3(0, 2, 0));
    EXPECT_EQ(conf.value.at("nDriven"), " 2");
    EXPECT_EQ(conf.value.at("forceLaw"), " Avalanche");
    EXPECT_EQ(conf.value.at("gravity"), " 0 0 -9.81");
  }
}

TEST_F(EngineScenesOf, RockableHaveMassInertiaAndGround) {
  const CampaignPlan plan = prepared(
      with("library = \"blocks.h5\"", "library = \"blocks.h5\"\nscale = { mass_kg = 800 }"));
  const EngineScenes scenes = write(plan, "rockable");
  std::map<std::string, ShpShape> shapes;
  for (const ShpShape& shape : read_shp(at("shapes.shp"))) shapes[shape.name] = shape;
  ASSERT_EQ(shapes.size(), 4u);
  EXPECT_TRUE(shapes.at("ground1").is_surface);
  EXPECT_FALSE(shapes.at("cube").is_surface);
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const Conf conf = read_conf(at(scenes.folders[i]) / "input.txt");
    const RockableBody& block = conf.bodies.back();
    const ShpShape& shape = shapes.at(block.shape);
    const RigidBody body = plan.bodies[plan.runs[i].block];
    const double density = conf.pair.at("density " + std::to_string(block.group));
    const double mass = std::pow(block.scale, 3) * density * shape.volume;
    EXPECT_NEAR(mass, 800.0, 1e-9);
    const Vec3 moments = mass * block.scale * block.scale * shape.inertia_per_mass;
    EXPECT_LT((moments - body.moments).norm(), 1e-12 * body.moments.norm());
    // A second way to the volume: the body that the file holds.
    EXPECT_NEAR(sphero_mass_properties(shape.body, 1.0).volume, shape.volume, 1e-10);
    for (int zone = 0; zone < 2; ++zone) {
      EXPECT_EQ(conf.bodies[zone].shape, "ground" + std::to_string(zone + 1));
      const std::string pair =
          " " + std::to_string(conf.bodies[zone].group) + " " + std::to_string(block.group);
      EXPECT_EQ(conf.pair.at("knContact" + pair), plan.runs[i].stiffness.normal);
      EXPECT_EQ(conf.pair.at("ktContact" + pair), plan.runs[i].stiffness.tangential);
      EXPECT_EQ(conf.pair.at("krContact" + pair), plan.runs[i].stiffness.rolling);
      EXPECT_EQ(conf.pair.at("en2Contact" + pair), 0.1);
      EXPECT_EQ(conf.pair.at("muContact" + pair), zone == 0 ? 0.4 : 0.6);
      EXPECT_EQ(conf.pair.at("murContact" + pair), zone == 0 ? 0.1 : 0.3);
    }
  }
  // The ground is where it was.
  EXPECT_EQ(bounds(core_mesh(shapes.at("ground2").body)).high.z(),
            bounds(plan.header.terrain.surface).low.z());
}

TEST_F(EngineScenesOf, RockableStepsResolveAContactAndSearchesTheFall) {
  const CampaignPlan plan = prepared();
  write(plan, "rockable", {3});
  const Conf conf = read_conf(at("run00003/input.txt"));
  EXPECT_FALSE(fs::exists(at("run00000")));
  const RunRecord& run = plan.runs[3];
  const double half_period = kPi * std::sqrt(plan.bodies[run.block].mass / run.stiffness.normal);
  EXPECT_LE(std::stod(conf.value.at("dt")), half_period / 350.0);
  // Fallen from 9.5 m above the lowest ground.
  EXPECT_LE(std::stod(conf.value.at("interVerlet")) * std::sqrt(2.0 * 9.81 * 9.5),
            0.51 * std::stod(conf.value.at("dVerlet")));
  EXPECT_TRUE(contains(read_text_file(at("run00003/dataExtractors.txt")), "TrackRockfall 2 0.02"));
}

TEST_F(EngineScenesOf, SayWhatIsWhatAndWhatDiffers) {
  BlockLibrary library = BlockLibrary::read(*folder_ / "blocks.h5"), named;
  Block block = library.blocks().front();
  for (const char* id : {"a block with a very long name", "block1", "ground1"}) {
    block.id = id;
    named.add(block);
  }
  named.write(*folder_ / "named.h5");
  const EngineScenes scenes = write(prepared(with("blocks.h5", "named.h5")), "rockable");
  const std::string text = read_text_file(at("SCENE.txt"));
  EXPECT_TRUE(contains(text, "block a block with a very long name")) << text;
  EXPECT_TRUE(contains(text, "ground zone flat") && contains(text, "map = scene + (")) << text;
  for (const std::string& note : scenes.notes) EXPECT_TRUE(contains(text, note));
  // 9.5 m of fall are far more than the radius of 5 cm bears.
  EXPECT_TRUE(contains(scenes.notes.front(), "radius_m = 0.")) << scenes.notes.front();
  const EngineScenes thick =
      write(prepared(with("[terrain]", "[terrain]\nradius_m = 0.5")), "rockable");
  EXPECT_TRUE(contains(thick.notes.front(), "larger than the deepest impact"));
  write(prepared(with("blocks.h5", "named.h5")), "rockable");
  std::set<std::string> names;
  for (const ShpShape& shape : read_shp(at("shapes.shp"))) {
    EXPECT_LE(shape.name.size(), 15u);
    names.insert(shape.name);
  }
  EXPECT_EQ(names.size(), 5u) << "three blocks and two zones, each with a name of its own";
}

TEST_F(EngineScenesOf, ExademHaveDriversDampingAndAllPairsOfGroups) {
  const CampaignPlan plan = prepared();
  const EngineScenes scenes = write(plan, "exadem", {0});
  ASSERT_EQ(scenes.folders, std::vector<std::string>{"run00000"});
  const std::string text = read_text_file(at("run00000/input.msp"));
  // e_n^2 = 0.1: -ln e_n = 1.151293, sqrt(pi^2 + ln^2 e_n) = 3.345905.
  const std::string key = "damprate: [";
  ASSERT_TRUE(contains(text, key)) << text;
  EXPECT_NEAR(std::stod(text.substr(text.find(key) + key.size())), 1.151293 / 3.345905, 1e-6);
  EXPECT_TRUE(contains(text, "group1: [0]") && contains(text, "driver_id: [0, 1]")) << text;
  EXPECT_TRUE(contains(text, "filename: ../ground1.stl")) << text;
  EXPECT_EQ(read_mesh(at("ground1.stl")).triangles.size(), 4u);
  const Conf conf = read_conf(at("run00000/bodies.conf"));
  ASSERT_EQ(conf.bodies.size(), 1u);
  EXPECT_EQ(conf.bodies[0].state.position, plan.runs[0].start.position);
  // The reader there takes density by the number of the shape in the file.
  EXPECT_EQ(read_shp(at("shapes.shp"))[conf.bodies[0].group].name, conf.bodies[0].shape);
}

TEST_F(EngineScenesOf, AMassAreOnePerRealisationWithContactsBetweenBlocks) {
  std::string text = campaign_text();
  const std::size_t begin = text.find("[release]");
  text.replace(begin, text.find("[[barrier]]") - begin,
               "[[mass]]\npolygon = [[-4, -1.5], [-1, -1.5], [-1, 1.5], [-4, 1.5]]\n"
               "realisations = 2\n");
  text = replaced_once(text, "[terrain]", "draw = { count = 8 }\n[terrain]") +
         "[contact.blocks]\nenergy_restitution = 0.2\nfriction = 0.5\nrolling_friction = 0.2\n";
  const CampaignPlan plan = prepared(text);
  const EngineScenes scenes = write(plan, "rockable");
  EXPECT_EQ(scenes.folders, (std::vector<std::string>{"realisation0000", "realisation0001"}));
  const Conf conf = read_conf(at("realisation0001/input.txt"));
  ASSERT_EQ(conf.bodies.size(), 10u);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(conf.bodies[2 + i].state.position, plan.runs[8 + i].start.position);
  }
  EXPECT_EQ(conf.pair.at("en2Contact 0 1"), 0.2);
  EXPECT_EQ(conf.pair.at("muContact 0 0"), 0.5);
  EXPECT_EQ(conf.pair.at("muContact 1 1"), 0.5);
  EXPECT_EQ(conf.pair.at("muContact 3 1"), 0.6);
}

TEST_F(EngineScenesOf, AreRefusedWhereTheOtherEngineCannotDoIt) {
  const CampaignPlan plan = prepared();
  const auto said = [&](const CampaignPlan& campaign, const std::string& engine,
                        const std::vector<std::uint32_t>& runs = {}) {
    return clast::refusal<InputError>([&] { write(campaign, engine, runs); });
  };
  EXPECT_TRUE(contains(said(plan, "bullet"), "bullet"));
  const std::string beyond = said(plan, "rockable", {12});
  EXPECT_TRUE(contains(beyond, "12") && contains(beyond, "0 to 11")) << beyond;
  const CampaignPlan dashpot = prepared(campaign_text() + "[contact]\nlaw = \"spring-dashpot\"\n");
  EXPECT_TRUE(contains(said(dashpot, "rockable"), "spring-dashpot"));
  EXPECT_NO_THROW(write(dashpot, "exadem", {0}));
  const CampaignPlan stay = prepared(
      with("orientations = \"turns.txt\"",
           "orientations = { random = 1, fresh = true }\nsequence = \"stay\"\nrealisations = 2") +
      "[contact.blocks]\nenergy_restitution = 0.2\nfriction = 0.5\nrolling_friction = 0.2\n");
  EXPECT_TRUE(contains(said(stay, "rockable"), "one after the other"));
}

}  // namespace
}  // namespace clast
