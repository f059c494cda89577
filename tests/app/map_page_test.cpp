// The map of a report in a real browser: its layers, paths, scale bar and north arrow.
#include "tests/app/browser.hpp"
#include "tests/app/slope_campaign.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// Every layer as a reader chooses it, and what is then to be seen.
constexpr const char* kMapProbe = R"(<script>
(async()=>{
const probe={layers:{}};
const root=document.querySelector('.layered-map'),box=root.querySelector('.chart');
await clastCharts.draw(box);await root.ready;
const part=(name)=>root.querySelector(`[data-map=${name}]`);
const points=()=>box.querySelectorAll('.scatterlayer .point').length;
const text=(found)=>found?found.textContent:'';
const picture=()=>Plotly.toImage(box,{format:'png',width:700,height:600});
const furniture=()=>{
  const axis=box._fullLayout.xaxis,bar=box.layout.shapes.filter((s)=>s.type==='rect').pop();
  const words=box.layout.annotations.filter((a)=>a.name==='furniture').map((a)=>a.text);
  const metres=words.find((w)=>/ k?m$/.test(w));
  return {metres:parseFloat(metres)*(/km/.test(metres)?1000:1),
          drawn:(bar.x1-14)*(axis.range[1]-axis.range[0])/axis._length,north:words.includes('<b>N</b>')};
};
probe.points=points();probe.stops=await picture();probe.first=furniture();
for(const {value} of part('layer').options){
  await clastMaps.show(root,value);
  probe.layers[value]={picture:await picture(),unit:text(box.querySelector('.cbtitle')),points:points(),
    row:Array.from(part('colours').querySelectorAll('span'),(cell)=>cell.textContent),rowText:text(part('colours'))};
}
await clastMaps.show(root,'E_95');
const opacity=()=>box.querySelector('.heatmaplayer image').style.opacity;
probe.opaque=opacity();
part('opacity').value=.3;part('opacity').dispatchEvent(new Event('change'));
await new Promise((done)=>setTimeout(done,300));
probe.pale=opacity();
const lines=()=>box.querySelectorAll('.scatterlayer .lines path').length;
const before=lines();
part('paths').checked=true;await clastMaps.show(root,'stops');
probe.paths=lines()-before;probe.again=points();
await Plotly.relayout(box,{'xaxis.range[1]':box.layout.xaxis.range[0]+.3*(box.layout.xaxis.range[1]-box.layout.xaxis.range[0])});
await new Promise((done)=>setTimeout(done,300));
probe.zoomed=furniture();
// What lies inside a drawing is clipped by it.
const boxes=Array.from(root.querySelectorAll('*')).filter((e)=>!e.ownerSVGElement);
probe.widest=Math.max(...boxes.map((e)=>e.getBoundingClientRect().right));
probe.width=innerWidth;
const told=document.createElement('pre');told.id='probe';told.textContent=JSON.stringify(probe);
document.body.appendChild(told);
})();
</script></body>)";

class MapPage : public SlopeCampaign {
 protected:
  void SetUp() override {
    expect_browser();
    SlopeCampaign::SetUp();
    write_text_file(
        folder / "campaign.toml",
        replaced(slope_campaign(), "trajectory_interval_s = 0", "trajectory_interval_s = 0.1"));
    const ProgramRun run = run_clast({"simulate", "campaign.toml", "-o", "r.h5"}, folder.path());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    ASSERT_EQ(run_clast({"compare", "r.h5", "-o", "report"}, folder.path()).exit_code, 0);
  }
  Json seen(int width = 0) {
    return probed(folder / "report" / "report.html", kMapProbe, folder, width);
  }
};

TEST_F(MapPage, EveryRasterIsALayerWithItsColourBar) {
  const Json probe = seen(1900);  // wide enough for a bar beside the map
  ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
  std::set<std::string> pictures;
  for (const auto& [name, layer] : probe["layers"].items()) {
    pictures.insert(layer["picture"]);
    if (name == "stops") continue;
    EXPECT_EQ(layer["points"], 2) << name << ": release points alone, no stops";
    EXPECT_TRUE(fs::exists(folder / "report/rasters" / (name + ".tif"))) << name;
    EXPECT_TRUE(fs::exists(folder / "report/rasters" / (name + ".qml"))) << name;
  }
  EXPECT_EQ(probe["layers"].size(), 8u) << "stops and seven rasters";
  // Two maps may be alike: every passage of a cell by one run.
  EXPECT_GE(pictures.size(), 7u) << "a layer that is switched on changes the map";
  EXPECT_FALSE(pictures.contains("")) << "nothing was drawn";
  EXPECT_EQ(probe["layers"]["stops"]["picture"], probe["stops"]) << "and comes back";
  for (const auto& [name, unit] : {std::pair{"Reach_probability", "%"},
                                   {"Nr_passages", "runs"},
                                   {"E_95", "kJ"},
                                   {"Ph_95", "m"},
                                   {"V_max", "m/s"}}) {
    EXPECT_EQ(probe["layers"][name]["unit"], unit) << name;
    EXPECT_TRUE(probe["layers"][name]["row"].empty()) << name;
  }
  EXPECT_GT(double(probe["points"]), 8.0) << "eight stops and two release points";
  EXPECT_EQ(probe["again"], probe["points"]);
}

TEST_F(MapPage, HasOpacityPathsScaleBarAndNorthArrow) {
  const Json probe = seen();
  ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
  EXPECT_EQ(probe["opaque"], "0.85");
  EXPECT_EQ(probe["pale"], "0.3");
  EXPECT_EQ(probe["paths"], 8) << "a line for each run";
  for (const char* state : {"first", "zoomed"}) {
    const Json& bar = probe[state];
    EXPECT_NEAR(double(bar["drawn"]), double(bar["metres"]), 1e-6 * double(bar["metres"])) << state;
    EXPECT_TRUE(bar["north"]);
  }
  EXPECT_LT(double(probe["zoomed"]["metres"]), double(probe["first"]["metres"]))
      << "the bar follows the zoom";
}

TEST_F(MapPage, FitsATelephone) {
  const Json probe = seen(400);
  ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
  EXPECT_EQ(probe["width"], 400);
  EXPECT_LE(double(probe["widest"]), 400.5);
  const Json& energy = probe["layers"]["E_95"];
  EXPECT_EQ(energy["unit"], "") << "a colour bar over the map hides stops";
  EXPECT_GE(energy["row"].size(), 3u) << "the colours stand below it";
  EXPECT_TRUE(contains(energy["rowText"], "kJ")) << energy["rowText"];
  EXPECT_TRUE(probe["layers"]["stops"]["row"].empty());
}

}  // namespace
}  // namespace clast
