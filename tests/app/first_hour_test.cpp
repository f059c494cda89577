// new campaign, check and help as processes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/command_tree.hpp"
#include "tests/app/slope_campaign.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

using FirstHour = SlopeCampaign;

TEST_F(FirstHour, ANewCampaignIsCheckedAndRuns) {
  ASSERT_EQ(run_clast({"terrain", "slope.obj", "flat.obj", "--zones", "scree,soft meadow", "-o",
                       "slope.h5"},
                      folder.path())
                .exit_code,
            0);
  const ProgramRun made = run_clast(
      {"new", "campaign", "--library", "blocks.h5", "--terrain", "slope.h5", "-o", "new.toml"},
      folder.path());
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(contains(made.out, "soft meadow") && contains(made.out, "soil soft")) << made.out;
  EXPECT_TRUE(contains(made.out, "new.toml: written")) << made.out;

  const ProgramRun checked = run_clast({"check", "new.toml"}, folder.path());
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_TRUE(contains(checked.out, "new.toml: would run")) << checked.out;
  EXPECT_FALSE(fs::exists(folder / "results.h5"));

  EXPECT_EQ(run_clast({"simulate", "new.toml", "--dry-run"}, folder.path()).exit_code, 0);
  const ProgramRun run = run_clast({"simulate", "new.toml"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;

  expect_refused(
      folder,
      {"new", "campaign", "--library", "blocks.h5", "--terrain", "slope.h5", "-o", "new.toml"}, 1,
      "new.toml");
  EXPECT_EQ(run_clast({"new", "campaign", "--library", "blocks.h5", "--terrain", "slope.h5", "-o",
                       "new.toml", "--replace"},
                      folder.path())
                .exit_code,
            0);
}

TEST_F(FirstHour, ANewCampaignIsRefusedWithTheReason) {
  write_obj(folder / "level.obj", ground_strip(0, 40, 10, 10));
  const auto refused = [&](const std::string& library, const std::string& terrain, int code,
                           const std::string& item) {
    expect_refused(folder,
                   {"new", "campaign", "--library", library, "--terrain", terrain, "-o", "x.toml"},
                   code, item);
  };
  refused("blocks.h5", "level.obj", 1, "degrees");
  refused("gone.h5", "slope.obj", 1, "gone.h5");
  refused("blocks.h5", "gone.h5", 1, "gone.h5");
  refused("slope.obj", "slope.obj", 1, "slope.obj");
  expect_refused(folder, {"new", "campaign", "--terrain", "slope.obj"}, 2, "--library");
  expect_refused(folder, {"new", "campaign", "--library", "blocks.h5"}, 2, "--terrain");
  expect_refused(folder, {"new"}, 2, "campaign");
  expect_refused(folder, {"new", "study"}, 2, "study");
  // What is there and is no text is never replaced.
  expect_refused(folder,
                 {"new", "campaign", "--library", "blocks.h5", "--terrain", "slope.obj", "-o",
                  "blocks.h5", "--replace"},
                 1, "blocks.h5");
}

TEST_F(FirstHour, CheckListsAllFindings) {
  std::string text = replaced(slope_campaign(), "friction = 0.4", "friction = -0.4");
  text = replaced(text, "max_time_s = 5", "max_time_s = -5");
  text = replaced(text, "\"blocks.h5\"", "\"gone.h5\"");
  write_text_file(folder / "bad.toml", text);
  const ProgramRun run = run_clast({"check", "bad.toml"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "3 findings")) << run.err;
  for (const char* words : {"friction = -0.4", "max_time_s", "gone.h5"}) {
    EXPECT_TRUE(contains(run.out, words)) << run.out;
  }
  const ProgramRun json = run_clast({"check", "bad.toml", "--json"}, folder.path());
  EXPECT_EQ(json.exit_code, 1);
  const Json report = Json::parse(json.out);
  EXPECT_EQ(report["accepted"], false);
  EXPECT_EQ(report["findings"].size(), 3u);

  const ProgramRun good = run_clast({"check", "campaign.toml", "--json"}, folder.path());
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_EQ(Json::parse(good.out)["accepted"], true);
  EXPECT_EQ(Json::parse(good.out)["runs"], 8);
  expect_refused(folder, {"check", "gone.toml"}, 1, "gone.toml");
  expect_refused(folder, {"check"}, 2, "file is required");
}

TEST(Help, ExplainsEveryCommand) {
  EXPECT_EQ(run_clast({"help"}).out, run_clast({"--help"}).out);
  EXPECT_EQ(run_clast({"help", "simulate"}).out, run_clast({"simulate", "--help"}).out);
  EXPECT_EQ(run_clast({"help", "new", "campaign"}).out,
            run_clast({"new", "campaign", "--help"}).out);
  EXPECT_EQ(run_clast({"help", "reconstruct"}).out, run_clast({"reconstruct", "--help"}).out);
  const ScratchFolder folder;
  expect_refused(folder, {"help", "fly"}, 2, "fly");
  expect_refused(folder, {"help", "simulate", "fast"}, 2, "fast");
  expect_refused(folder, {"help", "--completion", "fish"}, 2, "fish");
}

/// All commands with their options, taken from their help texts and not from the tables.
struct HelpText {
  std::string path;  ///< "new campaign"
  std::set<std::string> options;
};

void collect(const std::vector<std::string>& words, std::vector<HelpText>& texts) {
  std::vector<std::string> arguments = words;
  arguments.push_back("--help");
  const ProgramRun run = run_clast(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  HelpText text;
  for (const std::string& word : words) text.path += (text.path.empty() ? "" : " ") + word;
  std::istringstream lines(run.out);
  bool commands = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Subcommands:") commands = true;
    if (!line.starts_with("  ") || line.size() < 3 || line[2] == ' ') continue;
    std::string first = line.substr(2, line.find(' ', 2) - 2);
    if (first[0] == '-') {
      for (std::size_t at = 0; at < first.size();) {
        const std::size_t end = std::min(first.find(',', at), first.size());
        text.options.insert(first.substr(at, end - at));
        at = end + 1;
      }
    } else if (commands && words.size() < 2 && first != "clast") {
      std::vector<std::string> below = words;
      below.push_back(first);
      collect(below, texts);
    }
  }
  texts.push_back(text);
}

std::vector<HelpText> all_help_texts() {
  std::vector<HelpText> texts;
  collect({}, texts);
  return texts;
}

TEST(Help, CompletionHasEveryOptionOfEveryCommand) {
  const std::string bash = run_clast({"help", "--completion", "bash"}).out;
  const std::string zsh = run_clast({"help", "--completion", "zsh"}).out;
  std::size_t options = 0;
  const std::vector<HelpText> texts = all_help_texts();
  for (const HelpText& text : texts) {
    EXPECT_FALSE(text.options.empty()) << text.path;
    const std::string line = "    '" + text.path + "') options='";
    const std::size_t begin = bash.find(line);
    ASSERT_NE(begin, std::string::npos) << text.path;
    const std::string of_bash = bash.substr(begin, bash.find('\n', begin) - begin) + " ";
    const std::size_t zsh_begin = zsh.find("    ('" + text.path + "')\n");
    ASSERT_NE(zsh_begin, std::string::npos) << text.path;
    const std::string of_zsh = zsh.substr(zsh_begin, zsh.find(";;", zsh_begin) - zsh_begin);
    for (const std::string& option : text.options) {
      ++options;
      EXPECT_TRUE(contains(of_bash, "'" + option + " ") || contains(of_bash, " " + option + " ") ||
                  contains(of_bash, option + "'"))
          << text.path << option;
      EXPECT_TRUE(contains(of_zsh, option + "[")) << text.path << option;
    }
  }
  EXPECT_GT(options, 150u);
}

TEST(Help, ManualPagesAreSoundAndHaveEveryOptionOfEveryCommand) {
  if (std::system("command -v help2man > /dev/null && command -v groff > /dev/null") != 0) {
    GTEST_SKIP() << "no help2man or groff";
  }
  const ScratchFolder folder;
  const ProgramRun written =
      RunningProgram({CLAST_SOURCE_DIR "/app/manual_pages.sh", CLAST_PROGRAM, "man"}, folder.path())
          .wait();
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const std::vector<HelpText> texts = all_help_texts();
  EXPECT_EQ(names_in(folder / "man").size(), texts.size());
  for (const HelpText& text : texts) {
    std::string page = "man/clast" + (text.path.empty() ? "" : "-" + text.path) + ".1.gz";
    std::replace(page.begin(), page.end(), ' ', '-');
    const ProgramRun run =
        RunningProgram({"sh", "-c", "zcat " + page + " | groff -ww -man -Tascii -P-cbou"},
                       folder.path())
            .wait();
    EXPECT_EQ(run.exit_code, 0) << page;
    EXPECT_EQ(run.err, "") << page;
    for (const std::string& option : text.options) {
      EXPECT_TRUE(contains(run.out, option)) << page << option;
    }
  }
}

/// What bash offers for the last of the words, in a folder.
std::vector<std::string> completed(const ScratchFolder& folder, std::vector<std::string> words) {
  std::string script = "source completion\nCOMP_WORDS=(";
  for (const std::string& word : words) script += "'" + word + "' ";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
            "\n_clast\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  const ProgramRun run = RunningProgram({"bash", "-c", script}, folder.path()).wait();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  std::vector<std::string> offered;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) offered.push_back(line);
  }
  return offered;
}

TEST(Help, BashCompletesCommandsOptionsValuesAndFiles) {
  using Words = std::vector<std::string>;
  const ScratchFolder folder;
  write_text_file(folder / "completion", run_clast({"help", "--completion", "bash"}).out);
  write_text_file(folder / "my campaign.toml", "");
  EXPECT_EQ(completed(folder, {"clast", "si"}), Words({"simulate"}));
  EXPECT_EQ(completed(folder, {"clast", "new", ""}), Words({"campaign"}));
  EXPECT_EQ(completed(folder, {"clast", "simulate", "--dr"}), Words({"--dry-run"}));
  EXPECT_EQ(completed(folder, {"clast", "simulate", "my"}), Words({"my campaign.toml"}));
  EXPECT_EQ(completed(folder, {"clast", "terrain", "a.tif", "--up", ""}),
            Words({"auto", "y", "z"}));
  EXPECT_EQ(completed(folder, {"clast", "reconstruct", "--marker-s"}), Words({"--marker-size"}));
  EXPECT_EQ(completed(folder, {"clast", "library", "merge", "--repl"}), Words({"--replace"}));
  EXPECT_EQ(completed(folder, {"clast", "help", "--completion", "z"}), Words({"zsh"}));
  EXPECT_EQ(completed(folder, {"clast", "simulate", "x", "-o", "comp"}), Words({"completion"}));
}

// Loading them takes longer than showing blocks.
TEST(Program, LoadsNoLibraryOfMapsScansOrProcesses) {
  if (std::system("command -v readelf > /dev/null") != 0) GTEST_SKIP() << "no readelf";
  const ScratchFolder folder;
  const std::string needed =
      RunningProgram({"readelf", "--dynamic", CLAST_PROGRAM}, folder.path()).wait().out;
  ASSERT_NE(needed.find("libhdf5"), std::string::npos) << needed;
  for (const char* library : {"libgdal", "libmpi", "libpcl", "libopencv"}) {
    EXPECT_EQ(needed.find(library), std::string::npos) << library;
  }
}

TEST(Program, NamesTheExecutableThatIsMissing) {
  const ScratchFolder folder;
  std::filesystem::copy_file(CLAST_PROGRAM, folder / "clast");
  for (const std::string command : {"simulate", "reconstruct"}) {
    const ProgramRun run =
        RunningProgram({(folder / "clast").string(), command}, folder.path()).wait();
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("clast-" + command + ": is missing"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("clast " + command + " needs this program"), std::string::npos);
  }
  const ProgramRun shown =
      RunningProgram({(folder / "clast").string(), "help", "show"}, folder.path()).wait();
  EXPECT_EQ(shown.exit_code, 0) << "the program's own commands need no other";
}

// The tables of a companion come over whole.
TEST(Help, TablesSurviveTheWayThroughJson) {
  CommandEntry command{"a", "does", {}, {}};
  command.options.push_back({{"-x", "--xx"}, false, true, "N", {"1", "2"}, "how many"});
  command.commands.push_back({"b", "", {}, {}});
  const CommandEntry back = parse_command_entry(to_json(command));
  EXPECT_EQ(to_json(back), to_json(command));
  EXPECT_EQ(back.options[0].choices, command.options[0].choices);
  EXPECT_TRUE(back.options[0].repeated);
}

}  // namespace
}  // namespace clast
