// `vary` of [blocks]: bodies made of the blocks of a campaign, in place of them.
#include <algorithm>

#include "tests/study/campaign_run.hpp"
#include "tests/study/results_equal.hpp"

namespace clast {
namespace {

class CampaignVary : public CampaignRun {
 protected:
  /// The campaign with more keys in [blocks].
  static std::string with_blocks(const std::string& keys) {
    return with("[terrain]", keys + "\n[terrain]");
  }
  static void expect_refused(const std::string& keys, const std::string& message) {
    std::string said = refusal(with_blocks(keys));
    if (said.empty()) ADD_FAILURE() << keys << " is not refused";
    EXPECT_TRUE(contains(said, message));
  }
  /// What reading alone refuses.
  static void expect_misread(const std::string& keys, const std::string& message) {
    EXPECT_TRUE(contains(clast::refusal<InputError>([&] { campaign(with_blocks(keys)); }), message))
        << keys;
  }
};

TEST_F(CampaignVary, MakesEveryKindOfBodyOfTheSelectedBlocks) {
  const CampaignPlan plan = prepared(with_blocks(R"(select = ["slab"]
[blocks.vary]
to = [[0.8, 0.5], [0.5, 0.5]]
grid = { diagram = "sneed-folk", steps = 1, least = 0.4 }
like = "slab"
convexity = 1
rounding = [0, 0.1]
detail = 1
reference = ["sphere", "box"]
inertia = "ellipsoid")"));
  EXPECT_EQ(plan.choice.parents, (std::vector<std::string>{"slab"}));
  // 2 + 3 + 1 + 1 + 2 + 1 + 2 + 1 of one block.
  ASSERT_EQ(plan.bodies.size(), 13u);
  EXPECT_TRUE(
      std::is_sorted(plan.choice.blocks.begin(), plan.choice.blocks.end(),
                     [](const CampaignBlock& a, const CampaignBlock& b) { return a.id < b.id; }));
  const double mass = prepared(with_blocks("select = [\"slab\"]")).bodies[0].mass;
  for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
    EXPECT_NEAR(plan.bodies[i].mass / mass, 1.0, 1e-3) << plan.choice.blocks[i].id;
    EXPECT_EQ(plan.header.blocks[i].parent, "slab");
  }
  const auto body = [&](const std::string& id) {
    return *std::find_if(plan.header.blocks.begin(), plan.header.blocks.end(),
                         [&](const BlockSummary& block) { return block.id == id; });
  };
  EXPECT_EQ(body("slab_il0.8_sl0.5").variation, "stretch to 0.8, 0.5");
  EXPECT_NEAR(body("slab_il0.8_sl0.5").axes.I / body("slab_il0.8_sl0.5").axes.L, 0.8, 0.004);
  EXPECT_EQ(body("slab_inertia-ellipsoid").variation, "inertia-ellipsoid");
  EXPECT_EQ(body("slab_radius0").variation, "rounding 0");
}

TEST_F(CampaignVary, KeepsVolumeOrLengthAndTakesVerticesOfFinerBlocks) {
  const CampaignPlan plan =
      prepared(with_blocks("vary = { to = [[0.9, 0.4]], vertices = 8, keep = \"L\" }"));
  ASSERT_EQ(plan.bodies.size(), 4u);
  EXPECT_NEAR(plan.header.blocks[0].axes.L, 0.7, 0.003);
  EXPECT_EQ(plan.header.blocks[1].variation, "vertices 8");
  EXPECT_NEAR(plan.header.blocks[2].axes.L, 1.1, 0.005);
}

TEST_F(CampaignVary, RunsTheSameBitsAsALibraryOfTheBodies) {
  const std::string vary = "vary = { to = [[0.8, 0.5]], reference = [\"ellipsoid\", \"box\"] }";
  VariationSeriesRequest request;
  request.library = *folder_ / "blocks.h5";
  request.targets.ratios = {{0.8, 0.5}};
  request.targets.reference = {"ellipsoid", "box"};
  request.output = *folder_ / "series.h5";
  make_variation_series(request);
  run_campaign(prepared(with("blocks.h5", "series.h5")), *folder_ / "two_steps.h5");
  run_campaign(prepared(with_blocks(vary)), *folder_ / "one_step.h5", {.threads = 2});
  expect_equal_results(*folder_ / "two_steps.h5", *folder_ / "one_step.h5");
  run_campaign(prepare_campaign(campaign(with_blocks(vary)), {.threads = 1}), *folder_ / "alone.h5",
               {.threads = 1});
  expect_equal_results(*folder_ / "one_step.h5", *folder_ / "alone.h5");
  const CampaignResults two = read_results(*folder_ / "two_steps.h5");
  const CampaignResults one = read_results(*folder_ / "one_step.h5");
  ASSERT_EQ(one.blocks.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(one.blocks[i].id, two.blocks[i].id);
    EXPECT_EQ(one.blocks[i].mass, two.blocks[i].mass);
    EXPECT_EQ(one.blocks[i].moments, two.blocks[i].moments);
    EXPECT_EQ(one.blocks[i].parent, i < 3 ? "cube" : "slab");
    EXPECT_EQ(one.blocks[i].variation, two.blocks[i].variation);
    EXPECT_EQ(one.shapes[i].vertices, two.shapes[i].vertices);
  }
  EXPECT_EQ(one.blocks[4].id, "slab_ellipsoid");
  EXPECT_EQ(one.blocks[4].variation, "ellipsoid");
}

TEST_F(CampaignVary, ScalesAndGroupsTheBodies) {
  const std::string keys = R"(scale = { mass_kg = 500 }
vary = { to = [[0.8, 0.5], [1, 1]] }
[[block_group]]
name = "cubes"
select = ["slab_il1_sl1"]
ground.slope = { friction = 0.5 })";
  const CampaignPlan plan = prepared(with_blocks(keys));
  ASSERT_EQ(plan.bodies.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(plan.bodies[i].mass, 500.0, 1e-9);
  EXPECT_EQ(plan.header.blocks[3].group, "cubes");
  EXPECT_EQ(plan.header.blocks[2].group, "");
  const std::string group =
      "[[block_group]]\nname = \"g\"\nground.slope = { friction = 0.5 }\nselect = ";
  expect_refused("vary = { to = [[1, 1]] }\n" + group + "[\"slab\"]",
                 "the block group \"g\" names slab, which is none of the 2 bodies made by vary, "
                 "such as cube_il1_sl1");
  expect_refused(group + "[\"slab\", \"slap\"]", "the block group \"g\" names slap, which " +
                                                     (*folder_ / "blocks.h5").string() +
                                                     " does not have");
  // A block that is there and does not run is no mistake.
  EXPECT_NO_THROW(prepared(with_blocks("select = [\"slab\"]\n" + group + "[\"slab\", \"cube\"]")));
}

TEST_F(CampaignVary, DrawsFromATableWhoseHashIsKept) {
  std::string table = "L_cm;I_cm;S_cm\n";
  for (int i = 0; i < 12; ++i) {
    table += std::to_string(80 + 3 * i) + ";" + std::to_string(50 + (7 * i) % 20) + ";" +
             std::to_string(30 + (3 * i) % 11) + "\n";
  }
  write_text_file(*folder_ / "taped.csv", table);
  const CampaignPlan plan = prepared(with_blocks(
      "vary = { population = { count = 3, seed = 5, table = \"taped.csv\", prefix = \"T\" } }"));
  ASSERT_EQ(plan.bodies.size(), 3u);
  EXPECT_EQ(plan.header.blocks[0].id, "T0001");
  EXPECT_TRUE(
      std::any_of(plan.header.inputs.begin(), plan.header.inputs.end(),
                  [](const std::string& input) { return input.find("taped.csv ") != input.npos; }));
  expect_refused("vary = { population = { count = 3 } }", "ten blocks, but there are 2");
  expect_misread("vary = { population = { count = 3, units = \"cm\" } }", "leave units out");
  expect_misread("vary = { population = { count = 3, prefix = \"a/b\" } }", "a/b");
  expect_misread("vary = { population = { table = \"taped.csv\" } }", "count is missing");
}

TEST_F(CampaignVary, SaysWhatCanNotBeMade) {
  expect_refused("vary = { convexity = [0.5, 1] }",
                 "[blocks] vary: 2 of 4 bodies can't be made; leave out the keys that request "
                 "them. First reason: block cube: a convexity of 0.5");
  expect_refused("vary = { vertices = 100 }",
                 "no body could be made; first reason: block cube: 100 "
                 "vertices can't be reached");
  expect_refused("vary = { to = [[0.5, 0.5], [0.5, 0.5]] }",
                 "\"cube_il0.5_sl0.5\" is requested twice");
  expect_refused("vary = { like = \"moss\" }", "moss");
}

TEST_F(CampaignVary, RefusesWhatMakesNoSenseWithLineKeyAndValue) {
  expect_misread("vary = {}",
                 "campaign.toml:3: [blocks] vary: no variation is requested; give to, grid");
  expect_misread("vary = 3", "vary = 3");
  expect_misread("vary = { too = [[1, 1]] }", "too = [[1, 1]]: unknown key; did you mean to?");
  expect_misread("vary = { to = [[0.5, 0.8]] }", "to = [0.5, 0.8]: S/L must be at most I/L");
  expect_misread("vary = { to = [0.5, 0.8] }", "must be a list of [I/L, S/L]");
  expect_misread("vary = { to = [[2, 1]] }", "each from 0.01 to 1");
  expect_misread("vary = { grid = { diagram = \"folk\", steps = 3 } }",
                 "must be \"sneed-folk\" or \"zingg\"");
  expect_misread("vary = { grid = { diagram = \"zingg\" } }", "steps is missing");
  expect_misread("vary = { grid = { diagram = \"zingg\", steps = 200 } }", "steps = 200");
  expect_misread("vary = { convexity = 2 }", "convexity = 2: must be from 0.01 to 1");
  expect_misread("vary = { rounding = [0.1, 0.5] }", "each 0 (sharp edges), or from 0.001 to 0.4");
  expect_misread("vary = { vertices = [20.5] }", "must be whole numbers");
  expect_misread("vary = { vertices = 7 }", "from 8 to 2000");
  expect_misread("vary = { detail = [] }", "must be a number or a list of numbers");
  expect_misread("vary = { degree = 4, convexity = 1 }", "degree = 4: is of detail");
  expect_misread("vary = { exponent = 4, reference = \"box\" }",
                 "exponent = 4: is of the reference");
  expect_misread("vary = { reference = [\"box\", \"cone\"] }", "must be of sphere, box");
  expect_misread("vary = { inertia = \"sphere\" }", "must be of ellipsoid");
  expect_misread("vary = { to = [[1, 1]], keep = \"weight\" }",
                 "keep = \"weight\": must be \"mass\", \"volume\" or \"L\"");
  expect_misread("vary = { to = [[1, 1]] }\ndraw = { count = 3 }",
                 "blocks are either varied or drawn; leave draw out");
}

TEST_F(CampaignVary, IsNotOfAMassInPlace) {
  std::string text = with_blocks("vary = { to = [[1, 1]] }");
  const std::size_t from = text.find("[release]"), to = text.find("[[barrier]]");
  text.replace(from, to - from, "[[mass]]\nin_place = true\n");
  text += "\n[contact.blocks]\nenergy_restitution = 0.1\nfriction = 0.5\nrolling_friction = 0.1\n";
  EXPECT_TRUE(
      contains(clast::refusal<InputError>([&] { campaign(text); }),
               "in_place = true: blocks in place can't be varied; leave [blocks] vary out"));
}

}  // namespace
}  // namespace clast
