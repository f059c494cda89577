// Blocks in 3-D, in a real browser: the gallery of a library, and the pages of scans.
#include "tests/app/browser.hpp"
#include "tests/support/samples_folder.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// Functions that both probes use: what a turntable shows, and a drag over it.
constexpr const char* kTurning = R"(<script>
const turning={
  picture:(table)=>table.querySelector('canvas').toDataURL(),
  colours:(table)=>{
    const canvas=table.querySelector('canvas'),sheet=document.createElement('canvas');
    sheet.width=canvas.width;sheet.height=canvas.height;
    const pen=sheet.getContext('2d');pen.drawImage(canvas,0,0);
    const d=pen.getImageData(0,0,sheet.width,sheet.height).data,seen={};
    let red=0,blue=0;
    for(let i=0;i<d.length;i+=4){
      seen[d[i]+','+d[i+1]+','+d[i+2]]=1;
      if(d[i]>1.25*d[i+2])red++;else if(d[i+2]>1.25*d[i])blue++;
    }
    return {count:Object.keys(seen).length,red,blue};
  },
  drag:async(table)=>{
    const canvas=table.querySelector('canvas');
    const fire=(target,type,x)=>target.dispatchEvent(new MouseEvent(type,
        {clientX:x,clientY:100,button:0,bubbles:true,cancelable:true}));
    fire(canvas,'mousedown',100);fire(document,'mousemove',180);fire(document,'mouseup',180);
    clastTurntable(table).draw();
  },
  choose:(table,what)=>{
    const list=table.querySelector('[data-turn=what]');list.value=what;
    list.dispatchEvent(new Event('change'));clastTurntable(table).draw();
  },
  tell:(probe)=>{
    probe.width=innerWidth;
    probe.widest=Math.max(...Array.from(document.querySelectorAll('main *'),(e)=>{
      const box=e.getBoundingClientRect();return box.width?box.right:0}));
    probe.scrolls=document.documentElement.scrollWidth;
    const told=document.createElement('pre');told.id='probe';told.textContent=JSON.stringify(probe);
    document.body.appendChild(told);
  },
};
</script>)";

constexpr const char* kGalleryProbe = R"(<script>
(async()=>{
const probe={};
const names=()=>clastGallery.cards().map((card)=>card.dataset.name);
const part=(name)=>document.querySelector(`[data-gallery=${name}]`);
const set=(name,value)=>{part(name).value=value;part(name).dispatchEvent(new Event('change'))};
probe.all=names();
set('class','shape:elongated');probe.elongated=names();probe.count=part('count').textContent;
set('class','all:');
set('order','mass');
const masses=()=>clastGallery.cards().map((card)=>parseFloat(card.dataset.mass));
probe.masses=masses();part('turn').click();probe.turned=masses();
probe.pictures=Array.from(document.querySelectorAll('.card img')).filter((i)=>i.naturalWidth>0).length;
const first=clastGallery.cards()[0],table=await clastGallery.open(first);
probe.opened=document.querySelector('dialog h2').textContent===first.dataset.name;
probe.numbers=document.querySelectorAll('dialog .numbers td').length;
probe.triangles=+table.dataset.triangles;
const before=turning.picture(table);await turning.drag(table);
probe.turns=before!==turning.picture(table);
const other=clastGallery.cards()[1];document.querySelector('dialog').close();
const shown=turning.picture(table);await clastGallery.open(other);
probe.other=shown!==turning.picture(table);
document.querySelector('dialog').close();
turning.tell(probe);
})();
</script></body>)";

constexpr const char* kBlockProbe = R"(<script>
(async()=>{
const probe={shown:{}},table=document.querySelector('.turntable');
await clastTurntable(table).show(table.dataset.source);
for(const what of ['block','scan','both','deviation']){
  turning.choose(table,what);
  probe.shown[what]={picture:turning.picture(table),triangles:+table.dataset.triangles,...turning.colours(table)};
}
probe.distances=table.querySelector('[data-turn=distances]').textContent;
const box=table.querySelector('[data-turn=box]'),before=turning.picture(table);
box.checked=false;box.dispatchEvent(new Event('change'));clastTurntable(table).draw();
probe.box=before!==turning.picture(table);
const still=turning.picture(table);await turning.drag(table);
probe.turns=still!==turning.picture(table);
turning.tell(probe);
})();
</script></body>)";

constexpr const char* kIndexProbe = R"(<script>
window.addEventListener('load',()=>{
const probe={cells:[]};
for(const cell of document.querySelectorAll('table.cards td')){
  const box=cell.getBoundingClientRect();
  probe.cells.push({head:cell.dataset.head,text:cell.textContent,right:box.right,cut:cell.scrollWidth>cell.clientWidth+1});
}
turning.tell(probe);
});
</script></body>)";

class GalleryPage : public testing::Test {
 protected:
  void SetUp() override { expect_browser(); }
  void reconstruct(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"reconstruct", "--vertices", "60"};
    for (const std::string block : {"B01_compact", "B02_platy", "B04_elongated"}) {
      arguments.push_back((kSamples / "blocks" / (block + ".ply")).string());
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = run_clast(arguments, folder.path());
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  Json seen(const fs::path& path, const std::string& probe, int width = 0) {
    return probed(path, kTurning + probe, folder, width);
  }
  ScratchFolder folder;
};

TEST_F(GalleryPage, ChoosesSortsAndTurnsBlocks) {
  reconstruct({"-o", "blocks.h5"});
  ASSERT_EQ(run_clast({"show", "blocks.h5", "--report", "gallery"}, folder.path()).exit_code, 0);
  for (const int width : {0, 400}) {
    const Json probe = seen(folder / "gallery/gallery.html", kGalleryProbe, width);
    ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
    EXPECT_EQ(probe["all"].size(), 3u);
    EXPECT_EQ(probe["elongated"], Json::parse("[\"B04_elongated\"]"));
    EXPECT_EQ(probe["count"], "1 of 3");
    const auto masses = probe["masses"].get<std::vector<double>>();
    EXPECT_TRUE(std::is_sorted(masses.begin(), masses.end()));
    auto turned = probe["turned"].get<std::vector<double>>();
    std::reverse(turned.begin(), turned.end());
    EXPECT_EQ(turned, masses);
    EXPECT_EQ(probe["pictures"], 3);
    EXPECT_TRUE(probe["opened"]);
    EXPECT_GT(double(probe["numbers"]), 20.0);
    EXPECT_GT(double(probe["triangles"]), 100.0);
    EXPECT_TRUE(probe["turns"]) << "pixels differ after a drag";
    EXPECT_TRUE(probe["other"]) << "another block is another picture";
    EXPECT_LE(double(probe["widest"]), double(probe["width"]) + 0.5);
    EXPECT_LE(double(probe["scrolls"]), double(probe["width"]) + 0.5);
  }
}

TEST_F(GalleryPage, EveryPageOfABlockHasATurntable) {
  reconstruct({"--report", "pages"});
  const Json probe = seen(folder / "pages/blocks/B04_elongated.html", kBlockProbe);
  ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
  std::set<std::string> pictures;
  for (const auto& [what, shown] : probe["shown"].items()) {
    pictures.insert(shown["picture"]);
    EXPECT_GT(double(shown["triangles"]), 100.0) << what;
    EXPECT_GT(double(shown["count"]), 50.0) << what << " is shaded";
  }
  EXPECT_EQ(pictures.size(), 4u);
  const Json& deviation = probe["shown"]["deviation"];
  EXPECT_GT(double(deviation["blue"]), 1000.0) << "faces cut through the scan's bumps";
  EXPECT_GT(double(deviation["red"]), 100.0) << "corners stand out";
  EXPECT_EQ(double(probe["shown"]["scan"]["red"]), 0.0);
  EXPECT_TRUE(contains(std::string(probe["distances"]), " m outside"));
  EXPECT_TRUE(probe["box"]) << "the box can be hidden";
  EXPECT_TRUE(probe["turns"]) << "pixels differ after a drag";

  const Json narrow = seen(folder / "pages/blocks/B04_elongated.html", kBlockProbe, 400);
  ASSERT_FALSE(narrow.is_null());
  EXPECT_LE(double(narrow["scrolls"]), 400.5);
}

TEST_F(GalleryPage, EveryPageOfAParticleHasATurntable) {
  reconstruct({"-o", "blocks.h5"});
  const ProgramRun run = run_clast({"export", "blocks.h5", "B04_elongated", "--to", "lammps",
                                    "--equal-spheres", "10", "-o", "clumps", "--report", "pages"},
                                   folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "Report: pages/particles.html")) << run.out;
  const Json probe = seen(folder / "pages/particles/B04_elongated.html", kBlockProbe);
  ASSERT_FALSE(probe.is_null()) << "the script of the page stopped";
  std::set<std::string> pictures;
  for (const auto& [what, shown] : probe["shown"].items()) {
    pictures.insert(shown["picture"]);
    EXPECT_GT(double(shown["triangles"]), 100.0) << what;
  }
  EXPECT_EQ(pictures.size(), 4u) << "spheres, block, both and distances";
  EXPECT_GT(double(probe["shown"]["deviation"]["blue"]), 1000.0) << "grooves between spheres";
  EXPECT_GT(double(probe["shown"]["deviation"]["red"]), 1000.0) << "spheres stand out";
  EXPECT_TRUE(contains(std::string(probe["distances"]), " m outside"));
}

TEST_F(GalleryPage, TheIndexOfScansCutsNothingOffOnATelephone) {
  reconstruct({"--report", "pages"});
  const Json probe = seen(folder / "pages/index.html", kIndexProbe, 400);
  ASSERT_FALSE(probe.is_null());
  EXPECT_EQ(probe["width"], 400);
  EXPECT_LE(double(probe["scrolls"]), 400.5);
  std::size_t masses = 0, classes = 0;
  for (const Json& cell : probe["cells"]) {
    EXPECT_LE(double(cell["right"]), 400.5) << cell;
    EXPECT_FALSE(cell["cut"]) << cell;
    masses += cell["head"] == "mass kg" && !std::string(cell["text"]).empty();
    classes += cell["head"] == "class" && !std::string(cell["text"]).empty();
  }
  EXPECT_EQ(masses, 3u);
  EXPECT_EQ(classes, 3u);
}

TEST_F(GalleryPage, ReplacesAGalleryAndNothingElse) {
  reconstruct({"-o", "blocks.h5"});
  const std::vector<std::string> show = {"show", "blocks.h5", "--report", "gallery"};
  ASSERT_EQ(run_clast(show, folder.path()).exit_code, 0);
  EXPECT_EQ(run_clast(show, folder.path()).exit_code, 1) << "there is one already";
  write_text_file(folder / "gallery/notes.txt", "mine");
  std::vector<std::string> again = show;
  again.insert(again.end(), {"B01_compact", "--replace"});
  const ProgramRun run = run_clast(again, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "Report: gallery/gallery.html"));
  const std::string page = read_text_file(folder / "gallery/gallery.html");
  EXPECT_TRUE(contains(page, "B01_compact"));
  EXPECT_FALSE(contains(page, "B02_platy")) << "these blocks alone";
  EXPECT_EQ(read_text_file(folder / "gallery/notes.txt"), "mine");
  EXPECT_EQ(run_clast({"show", "blocks.h5", "--report", ""}, folder.path()).exit_code, 2);
  EXPECT_EQ(run_clast({"show", "blocks.h5", "--replace"}, folder.path()).exit_code, 2);
  write_text_file(folder / "other/gallery.html", "<html>not ours</html>");
  EXPECT_EQ(
      run_clast({"show", "blocks.h5", "--report", "other", "--replace"}, folder.path()).exit_code,
      1);
  EXPECT_EQ(read_text_file(folder / "other/gallery.html"), "<html>not ours</html>");
}

}  // namespace
}  // namespace clast
