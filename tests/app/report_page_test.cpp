// The report of a small campaign in a real browser.
#include "tests/app/browser.hpp"
#include "tests/support/samples_folder.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// What the page looks like after a reader has used it, as JSON in an element that the test reads.
constexpr const char* kReportProbe = R"(<script>
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
  probe.paper=document.querySelectorAll('details.paper[open]').length;
  probe.picture=document.querySelectorAll('#scene img.paper[src^="data:image/png"]').length;
  dispatchEvent(new Event('afterprint'));
  probe.screen=document.querySelectorAll('details.paper[open], #scene img').length;
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

/// What a reader sees first, without scrolling, and whether anything is wider than the page.
constexpr const char* kLook = R"(<script>
var root=document.documentElement,probe={width:root.getBoundingClientRect().width,height:innerHeight};
function box(e){var r=e.getBoundingClientRect();return {left:r.left,top:r.top,right:r.right,bottom:r.bottom}}
function scrolls(e){for(;e;e=e.parentElement)if(/auto|scroll|hidden/.test(getComputedStyle(e).overflowX)&&e!==document.documentElement&&e!==document.body)return true;return false}
clastRun('plotly-code').then(function(){return clastCharts.drawAll()}).then(function(){
  probe.answer=document.querySelector('.answer').textContent.replaceAll('\u00a0',' ');
  probe.sentence=box(document.querySelector('.answer'));
  probe.numbers=Array.from(document.querySelectorAll('.figures .value')).map(box);
  probe.cautions=Array.from(document.querySelectorAll('#answer .warnings > details > summary')).map(function(e){
    var r=e.getBoundingClientRect();return r.height/parseFloat(getComputedStyle(e).lineHeight)});
  probe.map=box(document.querySelector('.chart.map'));
  probe.wide=Array.from(document.querySelectorAll('main *')).filter(function(e){
    var r=e.getBoundingClientRect();
    return r.width>0&&r.right>probe.width+1&&!scrolls(e.parentElement)&&!e.closest('svg')}).map(function(e){return e.tagName+'.'+e.className});
  probe.titles=Array.from(document.querySelectorAll('h1,h2,h3,.title,summary')).filter(function(e){return e.scrollWidth>e.clientWidth+1}).map(function(e){return e.textContent});
  var terms=document.querySelectorAll('.term'),hint=document.querySelector('.hint');
  probe.terms=terms.length;
  var seen=Array.from(terms).find(function(t){return !t.closest('details:not([open])')});
  seen.focus();probe.hint=hint.hidden?'':hint.textContent;probe.hint_box=box(hint);
  dispatchEvent(new KeyboardEvent('keydown',{key:'Escape'}));probe.hint_gone=hint.hidden;
  probe.links=Array.from(document.querySelectorAll('nav.contents a')).filter(function(a){return document.getElementById(a.hash.slice(1))}).length;
  probe.sections=document.querySelectorAll('main > section, .opening > section').length;
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
    const ProgramRun compared = run_clast({"compare", "results.h5", "-o", "report"}, folder.path());
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    terminal = compared.out;
  }
  Json looked_at(const std::string& window, const std::string& style = {}) {
    return probed(folder / "report" / "report.html", style + kLook, folder, 0, window);
  }
  Json used() { return probed(folder / "report" / "report.html", kReportProbe, folder); }
  ScratchFolder folder;
  std::string terminal;  ///< what `compare` printed
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
  // Map, differences, four of runouts, four along the slope, the cut, three of the barrier.
  EXPECT_EQ(probe["charts"], 14);
  EXPECT_EQ(probe["inked"], probe["charts"]);
  EXPECT_EQ(probe["printed"], probe["charts"]) << "paper does not wait until a chart is seen";
  EXPECT_EQ(probe["paper"], 3) << "both tables of blocks, and the figures of the barrier";
  EXPECT_EQ(probe["picture"], 1) << "of the 3-D view";
  EXPECT_EQ(probe["screen"], 0) << "and folded again on the screen";
  EXPECT_TRUE(probe["buttons_and_names"]);
  EXPECT_FALSE(probe["names_covered"]) << "the map's buttons lie over its legend";
  EXPECT_EQ(probe["relief"], 1);
  EXPECT_NEAR(double(probe["zoomed"]), 0.5, 0.01);
  EXPECT_EQ(probe["hidden_points"], 6) << "a block hidden by the legend takes its stops along";
  const auto sorted = probe["sorted"].get<std::vector<double>>();
  EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
  EXPECT_EQ(probe["arrow"], "ascending");
}

TEST_F(ReportPage, AnswersOnItsFirstScreen) {
  make_report();
  const Json probe = looked_at("1280,943");  // with the frame of the window
  ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
  EXPECT_FALSE(probe.contains("failed")) << probe["failed"];
  const double height = probe["height"];
  EXPECT_NEAR(height, 800.0, 10.0);
  // What the terminal says, too.
  EXPECT_TRUE(contains(probe["answer"], " blocks "));
  EXPECT_TRUE(contains(terminal, probe["answer"].get<std::string>()));
  EXPECT_LT(double(probe["sentence"]["bottom"]), 0.4 * height);
  ASSERT_GE(probe["numbers"].size(), 3u);
  for (const Json& number : probe["numbers"]) EXPECT_LT(double(number["bottom"]), 0.6 * height);
  for (const Json& lines : probe["cautions"]) EXPECT_LT(double(lines), 2.5) << "lines of a caution";
  EXPECT_LT(double(probe["map"]["bottom"]), height) << "the map is seen, with its legend";
  EXPECT_EQ(probe["wide"], Json::array()) << "wider than the page";
  EXPECT_GT(int(probe["terms"]), 2);
  EXPECT_NE(probe["hint"], "") << "a word is explained where it has the focus";
  EXPECT_TRUE(probe["hint_gone"]);
  EXPECT_EQ(int(probe["links"]), int(probe["sections"]) + 1) << "each section, and the answer";
}

TEST_F(ReportPage, FitsATelephone) {
  make_report();
  // A window is no narrower than 500 px, a page is.
  const Json probe = looked_at("400,800", "<style>html{width:400px}</style>");
  ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
  EXPECT_EQ(int(probe["width"]), 400);
  EXPECT_EQ(probe["wide"], Json::array());
  EXPECT_EQ(probe["titles"], Json::array()) << "titles that are cut";
}

TEST_F(ReportPage, IsPrinted) {
  make_report();
  const ProgramRun run =
      run_clast({"compare", "results.h5", "-o", "printed", "--pdf", "--summary"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "printed/report.pdf"));
  EXPECT_TRUE(contains(run.out, "mean runout"));
  const std::string pdf = read_text_file(folder / "printed" / "report.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_TRUE(contains(pdf, "/MediaBox [0 0 594.95"));  // A4 of 595.28 points, rounded to pixels
  std::size_t pages = 0;
  for (std::size_t at = 0; (at = pdf.find("/Type /Page\n", at)) != std::string::npos; ++at) ++pages;
  EXPECT_GE(pages, 3u);
  EXPECT_LE(pages, 9u);
}

}  // namespace
}  // namespace clast
