// The arrows of docs/architecture.md hold in every file, and the rules that say so do find what
// breaks them.
#include "tests/architecture/include_rules.hpp"

#include <gtest/gtest.h>

namespace clast::architecture {
namespace {

TEST(SourceTree, HoldsEveryFolderOfTheMap) {
  std::set<std::string> folders, drawn;
  for (const SourceFile& file : project()) {
    if (file.is_source()) folders.insert(file.folder());
  }
  for (const char* folder : {"benchmarks", "docs", "samples", "tests"}) folders.erase(folder);
  for (const char* top : {"app", "python"}) {
    for (const std::string& part : reachable(top)) drawn.insert(part.substr(0, part.find('/')));
  }
  EXPECT_EQ(folders, drawn);
}

TEST(IncludeRules, EveryIncludeFollowsAnArrow) {
  const Findings findings = in_every_file(include_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(IncludeRules, PackagesStayInTheSourcesOfTheirFolders) {
  const Findings findings = in_every_file(package_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(IncludeRules, EveryLinkFollowsAnArrow) {
  const Findings findings = in_every_file(link_findings);
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(IncludeRules, WhatIsIncludedIsLinked) {
  const Findings findings = unlinked_findings(project());
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

TEST(IncludeRules, EverySourceAndPublicHeaderIsListed) {
  const Findings findings = unlisted_findings(project());
  EXPECT_TRUE(findings.empty()) << lines(findings);
}

// The rules, applied to made-up files.

TEST(IncludeRules, IncludeAgainstAnArrowIsFoundWithItsLine) {
  const SourceFile file =
      source_file("shapes/bad.cpp", "// A comment.\n#include \"dem/simulation/release.hpp\"\n");
  ASSERT_EQ(include_findings(file).size(), 1u);
  EXPECT_EQ(include_findings(file)[0],
            "shapes/bad.cpp:2: shapes may not include dem/simulation/release.hpp, only from core, "
            "core/files, "
            "core/statistics, mesh, shapes");
}

TEST(IncludeRules, ArrowsReachWhatFollows) {
  EXPECT_TRUE(
      include_findings(source_file("study/results/a.cpp", "#include \"core/pose.hpp\"\n")).empty());
  EXPECT_TRUE(include_findings(source_file("terrain/a.cpp", "#include \"dem/a.hpp\"\n")).empty());
}

TEST(IncludeRules, SiblingsDoNotKnowEachOther) {
  for (const std::string text :
       {"#include \"reconstruct/scan.hpp\"\n", "# include  <reconstruct/scan.hpp>  // why\n"}) {
    EXPECT_EQ(include_findings(source_file("study/results/a.cpp", text)).size(), 1u) << text;
  }
  EXPECT_EQ(include_findings(source_file("dem/a.hpp", "#include \"classify/a.hpp\"\n")).size(), 1u);
  EXPECT_EQ(include_findings(source_file("library/a.cpp", "#include \"dem/a.hpp\"\n")).size(), 1u);
  EXPECT_EQ(include_findings(source_file("core/a.cpp", "#include \"shapes/a.hpp\"\n")).size(), 1u);
}

TEST(IncludeRules, AnInnerLibraryIsBuiltOnItsFoldersAndNotTheOtherWayRound) {
  const std::string text = "#include \"reconstruct/photos/lens.hpp\"\n";
  EXPECT_EQ(include_findings(source_file("reconstruct/scan.cpp", text)).size(), 1u);
  EXPECT_TRUE(include_findings(source_file("reconstruct/photos/a.cpp", text)).empty());
  EXPECT_TRUE(include_findings(source_file("app/a.cpp", text)).empty());
  // Pages about runs stay without photographs and scans, which those about blocks need.
  for (const std::string header : {"reconstruct/scan.hpp", "report/scans/block_page.hpp"}) {
    const std::string include = "#include \"" + header + "\"\n";
    EXPECT_EQ(include_findings(source_file("report/pages/a.cpp", include)).size(), 1u) << header;
    EXPECT_TRUE(include_findings(source_file("report/scans/a.cpp", include)).empty()) << header;
  }
  const std::string lists = "clast_library(report PUBLIC clast::photos)\n";
  EXPECT_EQ(link_findings(source_file("report/CMakeLists.txt", lists)).size(), 1u);
  EXPECT_TRUE(link_findings(source_file("report/scans/CMakeLists.txt",
                                        "clast_library(scan_report PUBLIC clast::photos)\n"))
                  .empty());
  EXPECT_TRUE(
      link_findings(source_file("app/CMakeLists.txt", "LINK clast::compare clast::photos\n"))
          .empty());
  EXPECT_EQ(link_findings(source_file("dem/CMakeLists.txt", "PUBLIC clast::photos\n")).size(), 1u);
}

TEST(IncludeRules, RoomsAreInOrderAndKeepWhatIsPrivate) {
  const auto findings = [](const std::string& path, const std::string& header) {
    return include_findings(source_file(path, "#include \"" + header + "\"\n"));
  };
  EXPECT_EQ(findings("dem/surface/a.cpp", "dem/contact/b.hpp"),
            Findings{"dem/surface/a.cpp:1: dem/surface may not include dem/contact/b.hpp, which is "
                     "in a room above it"});
  EXPECT_TRUE(findings("dem/contact/a.cpp", "dem/surface/b.hpp").empty());
  EXPECT_EQ(findings("reconstruct/scan.cpp", "reconstruct/repair/detail/b.hpp"),
            Findings{"reconstruct/scan.cpp:1: reconstruct/repair/detail/b.hpp is private to "
                     "reconstruct/repair"});
  EXPECT_TRUE(findings("reconstruct/scan.cpp", "reconstruct/repair/b.hpp").empty());
  EXPECT_TRUE(
      findings("reconstruct/repair/detail/a.cpp", "reconstruct/repair/detail/b.hpp").empty());
}

TEST(IncludeRules, LibrariesDoNotIncludeTests) {
  const std::string text = "#include \"tests/support/scratch_folder.hpp\"\n";
  EXPECT_EQ(include_findings(source_file("app/a.cpp", text)).size(), 1u);
  EXPECT_TRUE(include_findings(source_file("tests/app/a.cpp", text)).empty());
}

TEST(IncludeRules, IncludeThatIsNotWrittenFromTheRootIsFound) {
  EXPECT_EQ(include_findings(source_file("dem/a.cpp", "#include \"release.hpp\"\n")).size(), 1u);
  EXPECT_EQ(include_findings(source_file("dem/a.cpp", "#include \"../core/a.hpp\"\n")).size(), 1u);
}

TEST(IncludeRules, DetailHeaderInPublicHeaderIsFound) {
  const std::string text = "#include \"mesh/detail/cgal_mesh.hpp\"\n";
  EXPECT_EQ(include_findings(source_file("shapes/a.hpp", text)).size(), 1u);
  EXPECT_TRUE(include_findings(source_file("shapes/a.cpp", text)).empty());
  EXPECT_TRUE(include_findings(source_file("shapes/detail/a.hpp", text)).empty());
}

class HeavyHeader : public testing::TestWithParam<const char*> {};

TEST_P(HeavyHeader, InPublicHeaderIsFound) {
  const std::string text = std::string("#include <") + GetParam() + ">\n";
  // Some folder may use each of them, but none in a public header.
  for (const std::string folder :
       {"core", "core/files", "mesh", "shapes", "reconstruct", "massprops", "classify", "dem",
        "terrain", "library", "study/results", "pipeline", "report"}) {
    EXPECT_FALSE(package_findings(source_file(folder + "/a.hpp", text)).empty()) << folder;
  }
}
INSTANTIATE_TEST_SUITE_P(IncludeRules, HeavyHeader,
                         testing::Values("CGAL/Surface_mesh.h", "assimp/scene.h",
                                         "pcl/point_types.h", "opencv2/core.hpp", "hdf5.h",
                                         "H5Cpp.h", "gdal_priv.h", "ogrsf_frmts.h", "toml++/toml.h",
                                         "mpi.h", "CLI/CLI.hpp", "nlohmann/json.hpp"));

TEST(IncludeRules, JsonIsInPublicHeadersAboutItOnly) {
  const std::string json = "#include <nlohmann/json.hpp>\n";
  EXPECT_TRUE(package_findings(source_file("report/json/a.hpp", json)).empty());
  EXPECT_EQ(package_findings(source_file("report/pages/a.hpp", json)).size(), 1u);
  EXPECT_EQ(package_findings(source_file("report/json/a.hpp", "#include <png.h>\n")).size(), 2u);
}

TEST(IncludeRules, PackagesAreOnlyForTheirFolders) {
  const SourceFile hdf5_in_study = source_file("study/results/results.cpp", "#include <hdf5.h>\n");
  ASSERT_EQ(package_findings(hdf5_in_study).size(), 1u);
  EXPECT_EQ(package_findings(hdf5_in_study)[0],
            "study/results/results.cpp:1: HDF5 is not for study/results, only for core/files");
  EXPECT_TRUE(
      package_findings(source_file("core/files/hdf5_file.cpp", "#include <hdf5.h>\n")).empty());
  EXPECT_TRUE(
      package_findings(source_file("shapes/detail/a.hpp", "#include <CGAL/a.h>\n")).empty());
  EXPECT_EQ(package_findings(source_file("dem/a.cpp", "#include <CGAL/a.h>\n")).size(), 1u);
}

TEST(IncludeRules, GdalIsCalledInTwoRooms) {
  const std::string gdal = "#include <gdal_priv.h>\n";
  EXPECT_EQ(
      package_findings(source_file("terrain/input/a.cpp", gdal)),
      Findings{"terrain/input/a.cpp:1: GDAL is called in terrain/gdal and report/gdal alone"});
  for (const std::string room : {"terrain/gdal/", "terrain/gdal/detail/", "report/gdal/"}) {
    EXPECT_TRUE(package_findings(source_file(room + "a.cpp", gdal)).empty()) << room;
  }
}

TEST(IncludeRules, DemOpensNoFileAndPrintsNothing) {
  EXPECT_EQ(package_findings(source_file("dem/a.cpp", "#include <fstream>\n")).size(), 1u);
  EXPECT_TRUE(package_findings(source_file("study/results/a.cpp", "#include <fstream>\n")).empty());
}

TEST(IncludeRules, LinkAgainstAnArrowIsFound) {
  const SourceFile lists = source_file("dem/CMakeLists.txt",
                                       "clast_library(dem\n"
                                       "  # not clast::app\n"
                                       "  PUBLIC clast::massprops clast::terrain\n"
                                       "  PRIVATE CGAL::CGAL)\n");
  EXPECT_EQ(link_findings(lists),
            (Findings{"dem/CMakeLists.txt:3: dem may not link clast::terrain, only core, "
                      "core/files, core/statistics, dem, massprops, mesh, shapes",
                      "dem/CMakeLists.txt:4: CGAL is not for dem, only for mesh, reconstruct, "
                      "shapes, terrain"}));
}

TEST(IncludeRules, IncludeThatIsNotLinkedIsFound) {
  const std::vector<SourceFile> two = {
      source_file("dem/CMakeLists.txt", "clast_library(dem PUBLIC clast::massprops)\n"),
      source_file("dem/a.cpp", "#include \"core/a.hpp\"\n#include \"shapes/a.hpp\"\n"),
      source_file("massprops/CMakeLists.txt", "clast_library(massprops PUBLIC clast::shapes)\n")};
  ASSERT_EQ(unlinked_findings(two).size(), 1u);
  EXPECT_EQ(unlinked_findings(two)[0],
            "dem/a.cpp:1: includes core/a.hpp, but dem/CMakeLists.txt does not link clast::core");
}

TEST(IncludeRules, SourceThatIsNotListedIsFound) {
  const std::vector<SourceFile> files = {
      source_file("dem/CMakeLists.txt",
                  "clast_library(dem HEADERS a.hpp\n  SOURCES a.cpp)  # b.cpp\n"),
      source_file("dem/a.cpp", ""),
      source_file("dem/a.hpp", ""),
      source_file("dem/b.cpp", ""),
      source_file("dem/detail/c.hpp", ""),
      source_file("dem/d.hpp", "")};
  EXPECT_EQ(unlisted_findings(files), (Findings{"dem/b.cpp:1: not listed in dem/CMakeLists.txt",
                                                "dem/d.hpp:1: not listed in dem/CMakeLists.txt"}));
}

}  // namespace
}  // namespace clast::architecture
