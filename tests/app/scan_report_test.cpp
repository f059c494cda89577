// clast reconstruct --report: the pages, judged as text.
#include <nlohmann/json.hpp>

#include "tests/app/command_support.hpp"
#include "tests/support/cut_mesh.hpp"
#include "tests/support/markup.hpp"

namespace clast {
namespace {

class ScanReports : public testing::Test {
 protected:
  /// A closed block with a blank and a letter beyond ASCII in its name, an open one, and no block.
  void write_scans() {
    fs::create_directory(folder / "scans");
    write_obj(folder / "scans" / kOddName, noisy_ellipsoid(3, {0.5, 0.4, 0.3}));
    write_obj(folder / "scans" / "open.obj",
              above_level(noisy_ellipsoid(4, {0.5, 0.4, 0.3}), -0.2101));
    write_text_file(folder / "scans" / "empty.obj", "");
    write_text_file(folder / "scans" / "notes.txt", "not a scan");
  }
  ProgramRun reconstruct(std::vector<std::string> more) {
    std::vector<std::string> arguments = {"reconstruct", "scans", "--vertices", "60"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_clast(arguments, folder.path());
  }
  std::string page(const std::string& path) { return read_text_file(folder / path); }

  static constexpr const char* kOddName =
      "Bl\xC3\xB6"
      "ck 1.obj";
  static constexpr const char* kOddPage =
      "pages/blocks/Bl\xC3\xB6"
      "ck 1.html";
  ScratchFolder folder;
};

TEST_F(ScanReports, EveryBlockHasAPageAndEveryScanALineInTheSummary) {
  write_scans();
  const ProgramRun run = reconstruct({"--report", "pages"});
  EXPECT_EQ(run.exit_code, 1) << "one scan gave no block";
  const std::string index = page("pages/index.html");
  EXPECT_EQ(unbalanced(index), "");
  EXPECT_EQ(index.find("http"), std::string::npos);
  EXPECT_EQ(count_of(index, "href=\"blocks/Bl%C3%B6ck%201.html\""), 1u);
  EXPECT_EQ(count_of(index, "href=\"blocks/open.html\""), 1u);
  EXPECT_EQ(count_of(index, "<img "), 2u);
  EXPECT_EQ(count_of(index, "1 scan without a block"), 1u);
  EXPECT_EQ(count_of(index, "scans/empty.obj"), 2u) << "the scan, and its name in the reason";
  for (const char* name : {kOddPage, "pages/blocks/open.html"}) {
    const std::string html = page(name);
    EXPECT_EQ(unbalanced(html), "") << name;
    expect_self_contained(html);
    for (const char* title : {"Before and after", "Defects found and repaired",
                              "The block against the scan", "Mass", "Source"}) {
      EXPECT_EQ(count_of(html, "<h2>" + std::string(title) + "</h2>"), 1u) << title;
    }
  }
  EXPECT_EQ(count_of(page("pages/blocks/open.html"), "<h2>The unscanned side</h2>"), 1u);
  EXPECT_EQ(count_of(page(kOddPage), "<h2>The unscanned side</h2>"), 0u);

  const std::string csv = page("pages/summary.csv");
  EXPECT_EQ(count_of(csv, "\n"), 4u) << "a heading, two blocks, one failure:\n" << csv;
  const auto commas = [](const std::string& line) { return count_of(line, ","); };
  const std::string heading = csv.substr(0, csv.find('\n'));
  std::size_t begin = heading.size() + 1;
  for (int line = 0; line < 2; ++line) {  // the reason of the last has commas of its own
    const std::size_t end = csv.find('\n', begin);
    const std::string row = csv.substr(begin, end - begin);
    begin = end + 1;
    if (row.starts_with(",failed,")) continue;
    EXPECT_EQ(commas(row), commas(heading)) << row;
    EXPECT_NE(row.find(",made,"), std::string::npos);
  }
  EXPECT_EQ(count_of(csv, ",failed,"), 1u);
}

TEST_F(ScanReports, PagesAreTheSameForAnyNumberOfJobs) {
  write_scans();
  reconstruct({"-o", "a.h5", "--report", "one"});
  reconstruct({"-o", "b.h5", "--report", "three", "--jobs", "3"});
  for (const char* name : {"index.html", "summary.csv", "blocks/open.html"}) {
    EXPECT_EQ(page("one/" + std::string(name)), page("three/" + std::string(name))) << name;
  }
}

TEST_F(ScanReports, WhatWasMadeEarlierIsInTheSummaryToo) {
  write_scans();
  reconstruct({"--report", "pages"});
  const std::string before = page("pages/blocks/open.html");
  const ProgramRun again = reconstruct({"--resume", "--report", "pages"});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(count_of(page("pages/index.html"), "href=\"blocks/open.html\""), 1u);
  EXPECT_EQ(count_of(page("pages/summary.csv"), ",made earlier,"), 2u);
  EXPECT_EQ(page("pages/blocks/open.html"), before);
}

TEST_F(ScanReports, AFolderThatCannotBeMadeIsRefusedBeforeTheWork) {
  write_scans();
  write_text_file(folder / "pages", "a file of that name");
  const ProgramRun run = reconstruct({"--report", "pages"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "pages"));
  EXPECT_FALSE(fs::exists(folder / "blocks.h5"));
}

TEST_F(ScanReports, TheWeighedMassIsHeldAgainstTheVolume) {
  write_obj(folder / "rock.obj", noisy_ellipsoid(3, {0.5, 0.4, 0.3}));
  const auto mass_text = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"reconstruct", "rock.obj", "--vertices", "60",
                                          "--replace",   "--report", "pages"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_clast(arguments, folder.path()).exit_code, 0);
    return page("pages/blocks/rock.html");
  };
  // 4/3 pi 0.5 0.4 0.3 = 0.2513 m3, 666 kg at 2650 kg/m3; the hull of noisy points is larger.
  EXPECT_EQ(count_of(mass_text({}), "No weighed mass was given"), 1u);
  EXPECT_EQ(count_of(mass_text({"--mass", "500"}), "The weighed mass of 500"), 1u);
  EXPECT_EQ(
      count_of(mass_text({"--mass", "500", "--density", "2650"}), "more than the weighed 500"), 1u);
  EXPECT_EQ(
      count_of(mass_text({"--mass", "900", "--density", "2650"}), "less than the weighed 900"), 1u);
}

TEST_F(ScanReports, CoresAndShapesHavePagesToo) {
  write_obj(folder / "rock.obj", noisy_ellipsoid(3, {0.5, 0.4, 0.3}));
  EXPECT_EQ(
      run_clast({"reconstruct", "rock.obj", "--core", "--radius", "0.01", "--report", "pages"},
                folder.path())
          .exit_code,
      0);
  EXPECT_EQ(unbalanced(page("pages/blocks/rock.html")), "");
  ASSERT_EQ(run_clast({"export", "blocks.h5", "-o", "shapes", "--format", "shp"}, folder.path())
                .exit_code,
            0);
  const ProgramRun run =
      run_clast({"reconstruct", "shapes", "-o", "again.h5", "--report", "again"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(unbalanced(page("again/blocks/rock.html")), "");
}

TEST_F(ScanReports, TheLibraryTellsWhereABlockComesFrom) {
  write_obj(folder / "rock.obj", noisy_ellipsoid(3, {0.5, 0.4, 0.3}));
  ASSERT_EQ(run_clast({"reconstruct", "rock.obj", "--vertices", "60"}, folder.path()).exit_code, 0);
  const ProgramRun shown = run_clast({"show", "blocks.h5", "--json"}, folder.path());
  const nlohmann::json block = nlohmann::json::parse(shown.out)[0];
  EXPECT_EQ(block["source"], "rock.obj");
  EXPECT_EQ(std::string(block["provenance"]["sha256"]).size(), 64u);
  EXPECT_TRUE(contains(std::string(block["provenance"]["options"]), "units=m"));
  EXPECT_FALSE(std::string(block["provenance"]["program_version"]).empty());
  EXPECT_GT(double(block["deviation_m"]["scan_to_body"]), 0.0);
  EXPECT_GT(double(block["deviation_m"]["body_to_scan"]), 0.0);
  const std::string told = run_clast({"show", "blocks.h5", "rock"}, folder.path()).out;
  for (const char* name : {"source sha256", "options", "made by", "scan to body at most m",
                           "body to scan at most m"}) {
    EXPECT_TRUE(contains(told, name));
  }
}

}  // namespace
}  // namespace clast
