/// What the commands say of a block whose size nobody knows: never a mass, never metres.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/slope_campaign.hpp"
#include "tests/support/markup.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// "cube" in metres and "model", 1.2 x 0.4 x 0.4 units without a scale.
class UnscaledBlock : public SlopeCampaign {
 protected:
  void SetUp() override {
    SlopeCampaign::SetUp();
    BlockLibrary library = BlockLibrary::read(folder / "blocks.h5");
    Block model = library.find_block("bar");
    library.remove("bar");
    model.id = "model";
    model.source.unscaled = true;
    model.volume_bracket =
        VolumeBracket{.lower_volume = 0.9 * model.mass.volume,
                      .estimated_volume = model.mass.volume,
                      .upper_volume = 1.1 * model.mass.volume,
                      .sides = BoxSideBounds{model.box.lengths, model.box.lengths},
                      .filled_fraction = 0.2,
                      .assumption = "the flanks go on"};
    library.add(model);
    library.write(folder / "blocks.h5");
  }
  ProgramRun run(const std::vector<std::string>& arguments) {
    const ProgramRun result = run_clast(arguments, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result;
  }
};

TEST_F(UnscaledBlock, IsShownWithoutMassAndMetres) {
  const std::string all = run({"show", "blocks.h5"}).out;
  EXPECT_TRUE(
      contains(all, "Unscaled (u is the unit of the model; its length is not known): model;"))
      << all;
  EXPECT_TRUE(contains(all, "1.240 u"));
  const std::string one = run({"show", "blocks.h5", "model"}).out;
  const std::size_t details = one.find("\nmodel\n");
  ASSERT_NE(details, std::string::npos);
  EXPECT_TRUE(contains(one, "--scale-bar"));
  for (const char* metric : {" kg m2", "area m2", "centre m ", "mass kg  ", "volume m3  "}) {
    EXPECT_EQ(one.find(metric, details), std::string::npos) << metric << one;
  }
  EXPECT_TRUE(contains(one.substr(details), "volume u3"));
  const std::string metric = run({"show", "blocks.h5", "cube"}).out;
  EXPECT_FALSE(contains(metric, "nscaled")) << metric;
}

/// Names of everything in a JSON value, however deep, that a reader takes for metric.
void metric_keys(const Json& json, std::set<std::string>& found) {
  for (const auto& [key, value] : json.items()) {
    for (const char* unit : {"_m", "_m2", "_m3", "_kg", "_kg_m2"}) {
      if (key.ends_with(unit) && !value.is_null()) found.insert(key);
    }
    if (value.is_object()) metric_keys(value, found);
  }
}

TEST_F(UnscaledBlock, HasNoMetricKeysInJson) {
  const Json blocks = Json::parse(run({"show", "blocks.h5", "--json"}).out);
  ASSERT_EQ(blocks[1]["id"], "model");
  std::set<std::string> found;
  metric_keys(blocks[1], found);
  EXPECT_EQ(found,
            (std::set<std::string>{"density_kg_m3", "density_lower_kg_m3", "density_upper_kg_m3"}))
      << "the density is the rock's";
  EXPECT_TRUE(blocks[1]["mass_kg"].is_null());
  EXPECT_NEAR(double(blocks[1]["box_units"][0]), 1.24, 1e-9);
  EXPECT_TRUE(contains(std::string(blocks[1]["unscaled"]), "the mass is unknown"));
  EXPECT_FALSE(blocks[0].contains("unscaled"));
  EXPECT_GT(double(blocks[0]["mass_kg"]), 0.0);
}

TEST_F(UnscaledBlock, IsClassifiedByItsShapeAlone) {
  const ProgramRun text = run({"classify", "blocks.h5"});
  EXPECT_TRUE(contains(text.out, "1.240 u"));
  EXPECT_TRUE(contains(text.err, "not in sizes and masses: model")) << text.err;
  const Json json = Json::parse(run({"classify", "blocks.h5", "--json"}).out);
  EXPECT_EQ(json["size"]["by_number"]["blocks"], 1);
  EXPECT_FALSE(json["blocks"][1].contains("mass_kg"));
  EXPECT_TRUE(json["blocks"][1].contains("box_units"));
  EXPECT_FALSE(json["blocks"][1].contains("box_m"));
  run({"classify", "blocks.h5", "-o", "classes"});
  EXPECT_TRUE(contains(read_text_file(folder / "classes" / "classes.csv"), "model,,,,,,"));
}

TEST_F(UnscaledBlock, AloneMakesAReportWithoutSizes) {
  run({"library", "remove", "blocks.h5", "cube"});
  const ProgramRun text = run({"classify", "blocks.h5", "-o", "classes"});
  EXPECT_TRUE(contains(text.out, "no sizes, because all blocks are unscaled"));
  const std::string page = read_text_file(folder / "classes" / "report.html");
  EXPECT_EQ(unbalanced(page), "");
  EXPECT_EQ(count_of(page, "there are no sizes"), 1u);
  EXPECT_FALSE(fs::exists(folder / "classes" / "size.svg"));
  const Json json = Json::parse(run({"classify", "blocks.h5", "--json"}).out);
  EXPECT_TRUE(json["size"]["by_number"].is_null());
  run({"classify", "blocks.h5", "--against", "blocks.h5", "-o", "two"});
}

TEST_F(UnscaledBlock, DoesNotFallWithoutASize) {
  refuse_campaign(slope_campaign(), "block model of ");
  write_text_file(folder / "sized.toml", replaced(slope_campaign(), "\"blocks.h5\"",
                                                  "\"blocks.h5\"\nscale = { mass_kg = 400 }"));
  EXPECT_TRUE(contains(run({"simulate", "sized.toml", "--dry-run"}).out, "8 runs"));
}

TEST_F(UnscaledBlock, IsExportedWithANote) {
  const ProgramRun model = run({"export", "blocks.h5", "model", "--format", "shp,stl"});
  EXPECT_TRUE(
      contains(model.err, "block model is unscaled, so its exported coordinates are not in"));
  EXPECT_TRUE(run({"export", "blocks.h5", "cube"}).err.empty());
}

TEST_F(UnscaledBlock, FieldNotesSayWhatTheUnitIs) {
  const std::string said =
      run({"library", "set", "blocks.h5", "model", "--taped", "0.62,0.22,0.22", "--weighed", "90"})
          .out;
  EXPECT_TRUE(
      contains(said, "0.5000 m (L) 0.5000 m (I) 0.5000 m (S); to make the block again in metres"))
      << said;
  EXPECT_TRUE(contains(said, "no mass to compare with"));
  const Json block = Json::parse(run({"show", "blocks.h5", "model", "--json"}).out)[0];
  EXPECT_EQ(block["field"]["taped_m"][0], 0.62) << "a tape reads metres";
  EXPECT_EQ(block["field"]["weighed_kg"], 90);
}

}  // namespace
}  // namespace clast
