// The page of a deposit in a real browser: looking at blocks, correcting them, and applying that.
#include "mesh/labelled_cloud.hpp"
#include "tests/app/browser.hpp"
#include "tests/support/balls_on_floor.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// Four balls on a floor; by x: 1 is the largest, 2 and 3 touch it, 4 lies apart.
const std::vector<FloorBall> kBalls = {{{-0.5, 0.0, 0.48}, 0.5},
                                       {{0.0, 0.62, 0.3}, 0.3},
                                       {{0.42, 0.0, 0.40}, 0.42},
                                       {{1.6, -0.8, 0.33}, 0.35}};

/// Helpers of the probes: clicks at places of the map and of the 3-D view, and keys.
constexpr const char* kDepositProbe = R"(<script>
(async()=>{
const probe={};
try{
  const page=await clastDeposit,{edits,map,scene,selection}=page;
  await scene.start();
  const send=(target,kind,x,y,more)=>target.dispatchEvent(
      new PointerEvent(kind,{clientX:x,clientY:y,bubbles:true,...more}));
  const clickAt=(target,[x,y],more)=>{
    const box=target.getBoundingClientRect();
    for(const kind of ['pointerdown','pointerup'])send(target,kind,box.left+x,box.top+y,more);
  };
  const click=(place,more)=>clickAt(map,page.pixelOf(place),more);
  const press=(key)=>document.body.dispatchEvent(new KeyboardEvent('keydown',{key,bubbles:true}));
  const rows=(name)=>Array.from(document.querySelectorAll('tr.'+name),
      (row)=>row.cells[0].textContent);
  const state=(id)=>Array.from(document.querySelectorAll('.blocks tbody tr'))
      .find((row)=>row.cells[0].textContent===id).cells[1].textContent;
  const status=()=>document.querySelector('[data-deposit=status]').textContent;
  const listed=()=>Array.from(document.querySelectorAll('[data-deposit=edits] li'),
      (item)=>item.firstChild.textContent);
%s
}catch(error){probe.error=error.message+' '+error.stack;}
const pre=document.createElement('pre');pre.id='probe';
pre.textContent=JSON.stringify(probe);document.body.append(pre);
})();
</script></body>)";

std::string probe_with(const std::string& steps) {
  std::string probe = kDepositProbe;
  return probe.replace(probe.find("%s"), 2, steps);
}

class DepositPage : public testing::Test {
 protected:
  void SetUp() override {
    expect_browser();
    write_labelled_cloud(folder / "talus.ply", balls_on_floor(kBalls, 2.5, 0.03, 1), {});
  }
  ProgramRun reconstruct(std::vector<std::string> more) {
    std::vector<std::string> arguments = {"reconstruct", "talus.ply", "-o",   "d.h5",
                                          "--split",     "--report",  "pages"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_clast(arguments, folder.path());
  }
  Json blocks() { return Json::parse(run_clast({"show", "d.h5", "--json"}, folder.path()).out); }
  Json seen(const std::string& steps) {
    const Json page = probed(folder / "pages" / "deposit.html", probe_with(steps), folder);
    EXPECT_FALSE(page.is_null()) << "the page can't be drawn";
    EXPECT_FALSE(page.contains("error")) << page["error"];
    return page;
  }
  ScratchFolder folder;
};

TEST_F(DepositPage, SelectsCorrectsAndContinues) {
  ASSERT_EQ(reconstruct({}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "pages" / "deposit.gpkg"));
  EXPECT_LT(fs::file_size(folder / "pages" / "deposit.html"), 4'000'000u);
  const Json page = seen(R"(
  probe.rows=rows('chosen').length;
  probe.points=+document.querySelector('.space').dataset.points;
  click([1.6,-0.8]);
  probe.clicked=rows('chosen');
  // The same block in 3-D, then a row of the list.
  press('Escape');
  clickAt(document.querySelector('.space canvas'),scene.pixelOf([1.6,-0.8,0.68]));
  probe.picked=rows('chosen');
  document.querySelector('[data-block="1"]').closest('tr').cells[4].click();
  probe.listed=rows('chosen');
  // Ground selects nothing, and nothing is done without a selection.
  press('Escape');
  click([1.6,1.6]);
  probe.none=rows('chosen').length;
  press('d');
  probe.refused=status();
  // Corrections: accept 4, merge 2 and 3, cut 1 and drop its western side.
  click([1.6,-0.8]);
  press('a');
  probe.accepted=state('talus_4');
  click([0,0.62]);
  click([0.42,0],{shiftKey:true});
  press('m');
  probe.merged=state('talus_3');
  press('z');
  probe.undone=state('talus_3');
  press('m');
  click([-0.5,0]);
  press('c');
  click([-0.6,-0.45]);
  click([-0.6,0.45]);
  press('Enter');
  probe.cut=state('talus_1');
  click([-0.8,0]);
  press('d');
  probe.left=page.blockAtPixel(page.pixelOf([-0.8,0]));
  probe.right=page.blockAtPixel(page.pixelOf([-0.3,0]));
  probe.edits=listed();
  probe.command=document.querySelector('[data-deposit=command]').textContent;
  probe.text=edits.text();
)");
  EXPECT_EQ(page["rows"], 0);
  EXPECT_GT(int(page["points"]), 20000);
  EXPECT_EQ(page["clicked"], Json({"talus_4"}));
  EXPECT_EQ(page["picked"], Json({"talus_4"}));
  EXPECT_EQ(page["listed"], Json({"talus_1"}));
  EXPECT_EQ(page["none"], 0);
  EXPECT_EQ(page["refused"], "Select a block first.");
  EXPECT_EQ(page["accepted"], "accepted");
  EXPECT_EQ(page["merged"], "merged with talus_2");
  EXPECT_EQ(page["undone"], "");
  EXPECT_EQ(page["cut"], "cut");
  EXPECT_EQ(page["left"], 0) << "ground now";
  EXPECT_NE(page["right"], 0);
  EXPECT_EQ(page["edits"].size(), 4u);
  EXPECT_EQ(page["command"],
            "clast reconstruct talus.ply --output d.h5 --report pages --split --edits edits.json "
            "--replace");

  const std::string text = page["text"];
  write_text_file(folder / "edits.json", text);
  const Json saved = Json::parse(text);
  EXPECT_EQ(saved["format"], "clast deposit edits");
  const Json before = blocks();
  const ProgramRun run = reconstruct({"--edits", "edits.json", "--replace"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json after = blocks();
  ASSERT_EQ(after.size(), 4u) << "block 4 of the first run is left in the library";
  EXPECT_TRUE(contains(std::string(after[0]["provenance"]["options"]), " edits="));
  // The rest of 1 ends at the cut, 2 and 3 are one block, and 4 is unchanged.
  EXPECT_LT(after[0]["volume_m3"], 0.95 * double(before[0]["volume_m3"]));
  EXPECT_LT(after[0]["deposit"]["points"], 0.8 * double(before[0]["deposit"]["points"]));
  EXPECT_EQ(after[2]["deposit"]["confidence"], 1.0);
  EXPECT_GT(after[1]["box_m"][0], 1.2);
  // Its body depends on the estimated ground, which the drop of points changes a little.
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(after[2]["box_m"][axis], double(before[3]["box_m"][axis]), 1e-6);
  }
  EXPECT_NEAR(after[2]["volume_m3"], double(before[3]["volume_m3"]), 1e-6);

  // The page of the corrected deposit continues the corrections.
  const Json again = seen(R"(
  probe.edits=listed();
  probe.same=edits.text();
  probe.accepted=state('talus_3');
  click([1.6,-0.8]);
  press('d');
  probe.more=JSON.parse(edits.text()).edits;
  document.querySelector('[data-deposit=edits] li button').click();
  probe.fewer=JSON.parse(edits.text()).edits.length;
)");
  EXPECT_EQ(again["edits"].size(), 4u);
  EXPECT_EQ(Json::parse(std::string(again["same"]))["edits"].size(), 4u);
  EXPECT_EQ(again["accepted"], "accepted");
  ASSERT_EQ(again["more"].size(), 5u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(again["more"][i]["kind"], saved["edits"][i]["kind"]);
    EXPECT_EQ(again["more"][i]["points"], saved["edits"][i]["points"]);
  }
  EXPECT_EQ(again["fewer"], 4);
}

}  // namespace
}  // namespace clast
