// The picture and the figures in README.md are those of the demo that is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = CLAST_SOURCE_DIR;

/// The text of the chunk "Description" of a PNG.
std::string description_of(const fs::path& png) {
  const std::string bytes = read_text_file(png), key = std::string("tEXtDescription") + '\0';
  const std::size_t at = bytes.find(key);
  if (at == bytes.npos || at < 4) return "";
  std::size_t length = 0;
  for (std::size_t i = at - 4; i < at; ++i) {
    length = 256 * length + static_cast<unsigned char>(bytes[i]);
  }
  return bytes.substr(at + key.size(), length - (key.size() - 4));
}

/// The answer of the demo, line by line as `samples/demo.sh` makes it.
std::string answer_of_demo(const fs::path& folder) {
  fs::copy(kSource / "samples", folder / "samples", fs::copy_options::recursive);
  std::vector<std::string> scans = {"reconstruct"};
  for (const char* block : {"B01_compact", "B02_platy", "B04_elongated"}) {
    scans.push_back("samples/blocks/" + std::string(block) + ".ply");
  }
  scans.insert(scans.end(), {"-o", "out/blocks.h5", "--jobs", "2"});
  for (const std::vector<std::string>& words :
       {scans, {"simulate", "samples/campaign.toml", "-o", "out/results.h5"}}) {
    const ProgramRun run = run_clast(words, folder);
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  const ProgramRun compared = run_clast({"compare", "out/results.h5", "--summary"}, folder);
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  return compared.out;
}

TEST(DemoPicture, IsOfTheDemoThatIsThere) {
  const ScratchFolder folder;
  const std::string answer = answer_of_demo(folder.path());
  const std::string shown = description_of(kSource / "docs/demo.png");
  ASSERT_FALSE(shown.empty());
  EXPECT_TRUE(contains(answer, shown))
      << "make it again: docs/site/demo_picture.py out/report/report.html docs/demo.png\n"
      << answer;
  // The words beside the picture are the beginning of the answer.
  const std::string readme = read_text_file(kSource / "README.md");
  std::smatch words;
  ASSERT_TRUE(std::regex_search(
      readme, words, std::regex(R"(!\[The report of the demo: ([^;]*);.*\]\(docs/demo.png\))")));
  EXPECT_TRUE(shown.starts_with(words[1].str())) << words[1];
}

}  // namespace
}  // namespace clast
