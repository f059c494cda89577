// What the pages hold deflated is unpacked by their script, here in node.
#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "report/html/assets.hpp"
#include "report/html/page_script.hpp"
#include "tests/support/run_program.hpp"

namespace clast {
namespace {

using namespace report_detail;

/// What `expression`, a promise of a text, gives in a page that holds `element`.
std::string evaluated(const std::string& element, const std::string& expression) {
  const ScratchFolder folder;
  const std::size_t begin = element.find('>') + 1;
  const std::string content = element.substr(begin, element.find('<', begin) - begin);
  write_text_file(folder / "page.js", "const document = {getElementById: () => ({textContent: '" +
                                          content + "'}),\n" +
                                          "  createElement: () => ({}), head: {append: (script) => "
                                          "eval(script.textContent)}};\n" +
                                          std::string(assets::unpack_js) + expression +
                                          ".then((text) => process.stdout.write(text));\n");
  const ProgramRun run = RunningProgram({"node", "page.js"}, folder.path()).wait();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run.out;
}

class Unpack : public testing::Test {
 protected:
  void SetUp() override {
    if (RunningProgram({"node", "--version"}, ".").wait().exit_code != 0) {
      GTEST_SKIP() << "node, which runs JavaScript, is not installed";
    }
  }
};

TEST_F(Unpack, GivesBackWhatWasPacked) {
  Random random(7);
  std::string text = "caf\xC3\xA9 </script> \\ \"quoted\"\n";
  for (int i = 0; i < 100'000; ++i) text += static_cast<char>('a' + random.uniform_index(26));
  EXPECT_EQ(evaluated(format_packed_element("a", text), "clastUnpacked('a')"), text);
  EXPECT_EQ(evaluated(format_packed_element("a", ""), "clastUnpacked('a')"), "");
}

TEST_F(Unpack, RunsAScriptOnce) {
  EXPECT_EQ(evaluated(format_packed_element("a", "globalThis.runs = (globalThis.runs || 0) + 1"),
                      "Promise.all([clastRun('a'), clastRun('a')]).then(() => String(runs))"),
            "1");
}

TEST_F(Unpack, SaysWhenTheBrowserIsTooOld) {
  EXPECT_EQ(evaluated(format_packed_element("a", "b"),
                      "delete globalThis.DecompressionStream;\n"
                      "clastUnpacked('a').catch((error) => error.message)"),
            "This browser can't unpack charts and 3-D views: it is older than 2023.");
}

}  // namespace
}  // namespace clast
