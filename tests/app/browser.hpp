#pragma once
/// Pages in a real browser: headless Chromium without a graphics card.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/command_support.hpp"

namespace clast {

/// Fails where the browser is not installed.
inline void expect_browser() {
  ASSERT_EQ(RunningProgram({"chromium", "--version"}, ".").wait().exit_code, 0)
      << "the browser that draws pages is missing: install chromium";
}

/// What a page tells of itself: `probe` is a script that is put at its end and writes JSON into an
/// element <pre id="probe">. Also expects that nothing is said to the console and nothing is asked
/// of the network. Null where the script did not come to its end.
/// @param width   of the page, px; windows are no narrower than 500, so it is then a frame in one
/// @param window  width and height, px
inline nlohmann::json probed(const fs::path& path, const std::string& probe,
                             const ScratchFolder& folder, int width = 0,
                             const std::string& window = "1280,800") {
  std::string page = read_text_file(path);
  page.replace(page.rfind("</body>"), 7, probe);
  if (width > 0) {
    write_text_file(folder / "framed.html", page + R"(<script>
setInterval(function(){
  var told=document.getElementById('probe');
  if(told)parent.postMessage(told.textContent,'*');
},50)</script>)");
    page = "<body><iframe src=\"framed.html\" style=\"border:0;height:900px;width:" +
           std::to_string(width) + R"(px"></iframe><script>
onmessage=function(event){
  if(document.getElementById('probe'))return;
  var told=document.createElement('pre');told.id='probe';told.textContent=event.data;
  document.body.appendChild(told);
}</script></body>)";
  }
  write_text_file(folder / "page.html", page);
  const std::vector<std::string> command = {
      "chromium",
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
      "--host-resolver-rules=MAP * ~NOTFOUND",
      "--user-data-dir=" + (folder / "profile").string(),
      "--window-size=" + window,
      "--virtual-time-budget=20000",  // what is drawn later than the page
      "--dump-dom",
      "file://" + (folder / "page.html").string()};
  const ProgramRun run = RunningProgram(command, ".").wait();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err.find("CONSOLE"), std::string::npos) << run.err;
  const std::string open = "<pre id=\"probe\">";
  const std::size_t at = run.out.find(open);
  if (at == std::string::npos) return nlohmann::json();
  const std::size_t begin = at + open.size();
  return nlohmann::json::parse(run.out.substr(begin, run.out.find("</pre>", begin) - begin));
}

}  // namespace clast
