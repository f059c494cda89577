// The report of a small campaign in a real browser.
#include "tests/app/browser.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

const fs::path kSamples = fs::path(CLAST_SOURCE_DIR) / "samples";

/// What the page looks like after a reader has used it, as JSON in an element that the test reads.
constexpr const char* kProbe = R"(<script>
var probe={};
function use(){
var box=document.getElementById('scene'),slider=box.querySelector('[data-scene=time]');
function first(){clastScene.draw();return box.dataset.first}
slider.value=0;slider.dispatchEvent(new Event('input'));probe.at_start=first();
slider.value=400;slider.dispatchEvent(new Event('input'));probe.later=first();
probe.clock=box.querySelector('[data-scene=clock]').textContent;
probe.triangles=+box.dataset.triangles;probe.runs=+box.dataset.runs;
var keys=box.querySelectorAll('[data-group]');
keys.forEach(function(k){k.checked=false;k.dispatchEvent(new Event('change'))});clastScene.draw();
probe.without_blocks=+box.dataset.triangles;
var canvas=box.querySelector('canvas'),sheet=document.createElement('canvas');
sheet.width=canvas.width;sheet.height=canvas.height;
var pen=sheet.getContext('2d');pen.drawImage(canvas,0,0);
var seen={},data=pen.getImageData(0,0,sheet.width,sheet.height).data;
for(var i=0;i<data.length;i+=4)seen[data[i]+','+data[i+1]+','+data[i+2]]=1;
probe.colours=Object.keys(seen).length;
}
var inks='.scatterlayer path,.barlayer path,.imagelayer image,.heatmaplayer image';
var table=Array.from(document.querySelectorAll('table')).find(function(t){return t.tBodies[0].rows.length>2});
var head=table.tHead.rows[0].cells[1];head.click();
probe.sorted=Array.from(table.tBodies[0].rows).map(function(r){return parseFloat(r.cells[1].textContent)});
probe.arrow=head.getAttribute('aria-sort');
clastScene.start().then(use).then(function(){return clastRun('plotly-code')}).then(function(){
  dispatchEvent(new Event('beforeprint'));
  probe.printed=document.querySelectorAll('.chart .main-svg .plot').length;
  return clastCharts.drawAll();
}).then(function(boxes){
  probe.charts=boxes.length;
  probe.inked=boxes.filter(function(b){return b.querySelector(inks)}).length;
  var map=boxes.find(function(b){return b.classList.contains('map')});
  var bar=map.querySelector('.modebar').getBoundingClientRect(),names=map.querySelector('.legend').getBoundingClientRect();
  probe.buttons_and_names=bar.width>0&&names.width>0;
  probe.names_covered=bar.bottom>names.top&&bar.top<names.bottom&&bar.right>names.left&&bar.left<names.right;
  probe.relief=map.querySelectorAll('.imagelayer image').length;
  var width=map.layout.xaxis.range[1]-map.layout.xaxis.range[0],shown=map.data[0].visible;
  return Plotly.relayout(map,{'xaxis.range[0]':0,'xaxis.range[1]':0.5*width}).then(function(){
    probe.zoomed=(map.layout.xaxis.range[1]-map.layout.xaxis.range[0])/width;
    var points=map.querySelectorAll('.scatterlayer .point').length;
    return Plotly.restyle(map,{visible:'legendonly'},[0]).then(function(){
      probe.hidden_points=points-map.querySelectorAll('.scatterlayer .point').length;
    });
  });
}).then(tell,function(error){probe.failed=String(error);tell()});
function tell(){
  var told=document.createElement('pre');told.id='probe';told.textContent=JSON.stringify(probe);
  document.body.appendChild(told);
}
</script></body>)";

class ReportPage : public testing::Test {
 protected:
  void SetUp() override { expect_browser(); }
  void make_report() {
    for (const std::string block : {"B01_compact", "B04_elongated"}) {
      const std::string scan = (kSamples / "blocks" / (block + ".ply")).string();
      ASSERT_EQ(run_clast({"reconstruct", scan, "-o", "blocks.h5"}, folder.path()).exit_code, 0);
    }
    const std::string terrain = (kSamples / "terrain" / "quarry_").string();
    std::string text = "[blocks]\nlibrary = \"blocks.h5\"\n[terrain]\nsurface = [\"" + terrain +
                       "blue.ply\", \"" + terrain + "gray.ply\", \"" + terrain +
                       "red.ply\"]\nzones = [\"blue\", \"gray\", \"red\"]\n";
    for (const char* zone : {"blue", "gray", "red"}) {
      text += "[ground." + std::string(zone) +
              "]\nenergy_restitution = 0.01\nfriction = 0.7\nrolling_friction = 0.3\n";
    }
    text +=
        "[release]\npoints = [[2.3, 82.0]]\nheight_m = 1.0\norientations = { random = 6, seed = "
        "1 }\n[[barrier]]\nname = \"EC21\"\nfrom = [16.25, 50]\nto = [16.25, 110]\n[run]\n"
        "max_time_s = 20\n";
    write_text_file(folder / "campaign.toml", text);
    const ProgramRun run =
        run_clast({"simulate", "campaign.toml", "-o", "results.h5"}, folder.path());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    ASSERT_EQ(run_clast({"compare", "results.h5", "-o", "report"}, folder.path()).exit_code, 0);
  }
  Json used() { return probed(folder / "report" / "report.html", kProbe, folder); }
  ScratchFolder folder;
};

TEST_F(ReportPage, DrawsItsChartsAndMovesItsBlocks) {
  make_report();
  const Json probe = used();
  ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
  EXPECT_EQ(probe["runs"], 12);
  EXPECT_NE(probe["at_start"], probe["later"]) << "the slider moves the blocks";
  EXPECT_NE(probe["clock"], "0.0 s");
  EXPECT_GT(double(probe["triangles"]), double(probe["without_blocks"]))
      << "blocks are drawn, and hidden with their class";
  EXPECT_GT(double(probe["without_blocks"]), 1000) << "the ground is drawn";
  EXPECT_GT(double(probe["colours"]), 100) << "the picture is shaded";
  EXPECT_FALSE(probe.contains("failed")) << probe["failed"];
  // Map, four of runouts, three along the slope, the cut, three of the barrier.
  EXPECT_EQ(probe["charts"], 12);
  EXPECT_EQ(probe["inked"], probe["charts"]);
  EXPECT_EQ(probe["printed"], probe["charts"]) << "paper does not wait until a chart is seen";
  EXPECT_TRUE(probe["buttons_and_names"]);
  EXPECT_FALSE(probe["names_covered"]) << "the map's buttons lie over its legend";
  EXPECT_EQ(probe["relief"], 1);
  EXPECT_NEAR(double(probe["zoomed"]), 0.5, 0.01);
  EXPECT_EQ(probe["hidden_points"], 6) << "a block hidden by the legend takes its stops along";
  const auto sorted = probe["sorted"].get<std::vector<double>>();
  EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
  EXPECT_EQ(probe["arrow"], "ascending");
}

}  // namespace
}  // namespace clast
