// The pages of clast reconstruct --report in a real browser: what a reader sees of them.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/command_support.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

const fs::path kSamples = fs::path(CLAST_SOURCE_DIR) / "samples";

/// Pictures as they are drawn, colours counted, as JSON in an element that the test reads.
constexpr const char* kProbe = R"(<script>
window.addEventListener('load',function(){
var probe={strips:[]};
document.querySelectorAll('figure').forEach(function(figure){
  var strip={orange:0,red:0,rock:0,views:0};
  var images=Array.from(figure.querySelectorAll('image'));
  strip.views=images.length;
  probe.strips.push(strip);
  images.forEach(function(image){
    var drawn=new Image();drawn.src=image.getAttribute('href');
    var sheet=document.createElement('canvas');
    (probe.waits=probe.waits||[]).push(drawn.decode().then(function(){
      sheet.width=drawn.naturalWidth;sheet.height=drawn.naturalHeight;
      var pen=sheet.getContext('2d');pen.drawImage(drawn,0,0);
      var d=pen.getImageData(0,0,sheet.width,sheet.height).data;
      for(var i=0;i<d.length;i+=4){
        var r=d[i],g=d[i+1],b=d[i+2];
        if(r>1.4*g&&g>1.8*b&&r>60)strip.orange++;
        else if(r>150&&g<60&&b<80)strip.red++;
        else if(r<250&&Math.abs(r-g)<30&&Math.abs(g-b)<40)strip.rock++;
      }
    }));
  });
});
var table=document.querySelector('table');
probe.sorted=[];
if(table&&table.tHead.rows[0].cells.length>5){
  var head=table.tHead.rows[0].cells[6];head.click();
  probe.sorted=Array.from(table.tBodies[0].rows).map(function(r){return parseFloat(r.cells[6].textContent)});
}
probe.links=Array.from(document.querySelectorAll('td a')).map(function(a){return a.getAttribute('href')});
probe.thumbs=Array.from(document.querySelectorAll('td img')).filter(function(i){return i.naturalWidth>0}).length;
Promise.all(probe.waits||[]).then(function(){
  delete probe.waits;
  var told=document.createElement('pre');told.id='probe';told.textContent=JSON.stringify(probe);
  document.body.appendChild(told);
});
});
</script></body>)";

class ScanPage : public testing::Test {
 protected:
  /// The page's probe, after checking that nothing was said to the console.
  Json seen(const fs::path& path) {
    std::string page = read_text_file(path);
    page.replace(page.rfind("</body>"), 7, kProbe);
    write_text_file(folder / "page.html", page);
    const std::vector<std::string> browser = {"chromium",
                                              "--headless",
                                              "--no-sandbox",
                                              "--use-gl=angle",
                                              "--use-angle=swiftshader",
                                              "--enable-unsafe-swiftshader",
                                              "--disable-quic",
                                              "--no-first-run",
                                              "--disable-background-networking",
                                              "--disable-component-update",
                                              "--disable-sync",
                                              "--enable-logging=stderr",
                                              "--user-data-dir=" + (folder / "profile").string(),
                                              "--virtual-time-budget=20000",
                                              "--dump-dom",
                                              "file://" + (folder / "page.html").string()};
    const ProgramRun run = RunningProgram(browser, ".").wait();
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err.find("CONSOLE"), std::string::npos) << run.err;
    const std::string open = "<pre id=\"probe\">";
    const std::size_t at = run.out.find(open);
    if (at == std::string::npos) return Json();
    const std::size_t begin = at + open.size();
    return Json::parse(run.out.substr(begin, run.out.find("</pre>", begin) - begin));
  }
  ScratchFolder folder;
};

TEST_F(ScanPage, ShowsTheScanBeforeAndAfterAndTheSummarySorts) {
  std::vector<std::string> arguments = {
      "reconstruct", (kSamples / "dirty").string(), "--vertices", "150", "--report", "pages"};
  ASSERT_EQ(run_clast(arguments, folder.path()).exit_code, 0);
  const Json page = seen(folder / "pages" / "blocks" / "D01_ground_patch.html");
  ASSERT_FALSE(page.is_null()) << "the page can't be drawn";
  // As read, the same around the block, closed, deviation.
  ASSERT_EQ(page["strips"].size(), 4u);
  for (const Json& strip : page["strips"]) {
    EXPECT_EQ(strip["views"], 3);
    EXPECT_GT(double(strip["rock"]), 5000.0) << strip;
  }
  EXPECT_GT(double(page["strips"][0]["red"]), 100.0) << "the border of the ground patch";
  EXPECT_EQ(double(page["strips"][0]["orange"]), 0.0);
  EXPECT_GT(double(page["strips"][2]["orange"]), 20000.0) << "the underside, seen from below";
  EXPECT_EQ(double(page["strips"][2]["red"]), 0.0) << "nothing is open any more";

  const Json index = seen(folder / "pages" / "index.html");
  ASSERT_FALSE(index.is_null());
  const auto sorted = index["sorted"].get<std::vector<double>>();
  EXPECT_EQ(sorted.size(), 3u);
  EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
  EXPECT_EQ(index["thumbs"], 3);
  for (const std::string link : index["links"]) {
    EXPECT_TRUE(fs::exists(folder / "pages" / link)) << link;
  }
}

}  // namespace
}  // namespace clast
