// The program as its users meet it: run as a process, judged by exit code, output and files.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/files/text_file.hpp"
#include "core/version.hpp"
#include "library/block_library.hpp"
#include "library/library_update.hpp"
#include "report/json/block_json.hpp"
#include "report/json/population_json.hpp"
#include "report/population_reading.hpp"
#include "tests/app/command_support.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/library/core_library.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kCommands = {
    "reconstruct", "cut",   "vary",     "show",    "classify",  "export", "library",
    "terrain",     "check", "simulate", "compare", "calibrate", "help"};

TEST(CommandLine, HelpOfEveryCommandShowsAnExample) {
  EXPECT_EQ(run_clast({"--help"}).exit_code, 0);
  for (const std::string& command : kCommands) {
    EXPECT_TRUE(contains(run_clast({"--help"}).out, command));
    if (command == "library") continue;
    const ProgramRun run = run_clast({command, "--help"});
    EXPECT_EQ(run.exit_code, 0) << command;
    EXPECT_TRUE(contains(run.out, "Example") && contains(run.out, "clast " + command)) << run.out;
  }
  for (const char* part : {"merge", "remove", "set"}) {
    EXPECT_TRUE(contains(run_clast({"library", part, "--help"}).out, "Example")) << part;
  }
}

TEST(CommandLine, VersionIsThatOfTheLibraries) {
  const ProgramRun run = run_clast({"--version"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, std::string("clast ") + version() + "\n");
}

// /dev/full takes nothing: what was printed is lost, and that is no success.
TEST(CommandLine, OutputThatCantBeWrittenIsAFailure) {
  const ScratchFolder folder;
  write_text_file(folder / "a.csv", "L,I,S\n3,2,1\n");
  const std::string program = std::string("'") + CLAST_PROGRAM + "' ";
  const std::string err = folder / "err";
  for (const std::string& words : {std::string("--version"), std::string("classify --help"),
                                   "classify '" + std::string(folder / "a.csv") + "'",
                                   "classify --json '" + std::string(folder / "a.csv") + "'"}) {
    const int status = std::system((program + words + " > /dev/full 2> '" + err + "'").c_str());
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1) << words;
    EXPECT_TRUE(contains(read_text_file(err), "is the disk full?"));
  }
}

TEST(CommandLine, MisuseExitsWithTwoAndNamesTheMistake) {
  const ScratchFolder folder;
  EXPECT_EQ(run_clast({}).exit_code, 2);
  expect_refused(folder, {"launch"}, 2, "\"launch\" is not a command");
  expect_refused(folder, {"reconstruct", "a.obj", "--units", "parsec"}, 2, "--units: \"parsec\"");
}

/// A folder with a library of two blocks: "flat" and "long".
class WithLibrary : public WorkingFolder {
 protected:
  void SetUp() override {
    write_obj("flat.obj", noisy_ellipsoid(1, {0.5, 0.45, 0.15}));
    write_obj("long.obj", noisy_ellipsoid(2, {0.9, 0.3, 0.28}));
    write_core_library("blocks.h5", {{"flat", noisy_ellipsoid(1, {0.5, 0.45, 0.15})},
                                     {"long", noisy_ellipsoid(2, {0.9, 0.3, 0.28})}});
    BlockLibrary library = BlockLibrary::read("blocks.h5");
    for (const char* id : {"flat", "long"}) {
      SurfaceDeviation& off = library.find_block(id).deviation;
      off.hausdorff = off.scan_to_body = off.body_to_scan = 0.01;  // as if it were of a scan
    }
    library.write("blocks.h5");
  }
  /// What `clast show --json` prints of a library.
  Json show_library(const std::string& library = "blocks.h5") {
    Json blocks = Json::array();
    const BlockLibrary read = BlockLibrary::read(library);
    for (const Block& block : read.blocks())
      blocks.push_back(Json::parse(block_json(block).dump()));
    return blocks;
  }
};

TEST_F(WithLibrary, ReconstructPrintsALineForEachBlockAndShowItsJson) {
  const ProgramRun run = run_clast(
      {"reconstruct", "flat.obj", "long.obj", "--vertices", "60", "-o", "again.h5"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string& made = run.out;
  EXPECT_TRUE(contains(made, "flat: ") && contains(made, "long: ")) << made;
  EXPECT_TRUE(contains(made, "elongated")) << made;
  EXPECT_TRUE(contains(made, "2 in all")) << made;
  EXPECT_EQ(Json::parse(run_clast({"show", "again.h5", "--json"}).out), show_library("again.h5"));
  for (const Json& block : show_library("again.h5")) {
    EXPECT_LE(std::abs(double(block["deviation_m"]["volume_relative"])), 1e-3);
    EXPECT_EQ(int(block["vertices"]) - int(block["edges"]) + int(block["faces"]), 2);
  }
}

TEST_F(WithLibrary, ShowGivesEveryPromisedKey) {
  const Json blocks = show_library();
  ASSERT_EQ(blocks.size(), 2u);
  for (const Json& block : blocks) {
    for (const char* key : {"id",
                            "source",
                            "vertices",
                            "edges",
                            "faces",
                            "radius_m",
                            "volume_m3",
                            "area_m2",
                            "density_kg_m3",
                            "mass_kg",
                            "centre_m",
                            "inertia_kg_m2",
                            "principal_moments_kg_m2",
                            "box_m",
                            "boxes_m",
                            "s_c",
                            "sneed_folk",
                            "zingg",
                            "shape",
                            "indices",
                            "deviation_m",
                            "warnings"}) {
      EXPECT_TRUE(block.contains(key)) << key;
    }
    EXPECT_EQ(block["centre_m"].size(), 3u);
    EXPECT_EQ(block["inertia_kg_m2"].size(), 3u);
    EXPECT_EQ(block["inertia_kg_m2"][2].size(), 3u);
    const double L = block["box_m"][0], I = block["box_m"][1], S = block["box_m"][2];
    EXPECT_TRUE(L >= I && I >= S && S > 0.0);
    EXPECT_NEAR(block["s_c"], L / I - 1.0, 1e-12);
    EXPECT_EQ(block["boxes_m"]["smallest"], block["box_m"]);
    for (const char* box : {"inertia", "feret", "pca"}) {
      const Json& sides = block["boxes_m"][box];
      EXPECT_GE(double(sides[0]) * double(sides[1]) * double(sides[2]), L * I * S * (1.0 - 1e-9));
    }
    EXPECT_GE(block["boxes_m"]["feret"][0], block["boxes_m"]["pca"][0]);
    EXPECT_NEAR(block["mass_kg"], 2650.0 * double(block["volume_m3"]), 1e-6);
    const Json& J = block["principal_moments_kg_m2"];
    EXPECT_TRUE(J[0] <= J[1] && J[1] <= J[2]);
    // Euler: both the outer surface and its core are spheres.
    EXPECT_EQ(int(block["vertices"]) - int(block["edges"]) + int(block["faces"]), 2);
    EXPECT_LE(std::abs(double(block["deviation_m"]["volume_relative"])), 1e-3);
  }
  EXPECT_EQ(blocks[0]["shape"], "compact");
  EXPECT_EQ(blocks[1]["shape"], "elongated");
}

TEST_F(WithLibrary, ShowPrintsATableAndDetailsOfNamedBlocks) {
  const ProgramRun all = run_clast({"show", "blocks.h5"}, folder.path());
  EXPECT_TRUE(contains(all.out, "flat") && contains(all.out, "mass kg")) << all.out;
  const ProgramRun one = run_clast({"show", "blocks.h5", "long"}, folder.path());
  EXPECT_TRUE(contains(one.out, "long.obj") && !contains(one.out, "\nflat ")) << one.out;
  expect_refused(folder, {"show", "blocks.h5", "round"}, 1, "flat, long");
}

TEST_F(WithLibrary, AnIdThatIsThereNeedsReplace) {
  const std::string before = read_text_file(folder / "blocks.h5");
  expect_refused(folder, {"reconstruct", "flat.obj"}, 1, "--replace");
  EXPECT_EQ(read_text_file(folder / "blocks.h5"), before);
  EXPECT_EQ(run_clast({"reconstruct", "flat.obj", "--replace", "--density", "2000"}, folder.path())
                .exit_code,
            0);
  EXPECT_EQ(show_library()[0]["density_kg_m3"], 2000.0);
  EXPECT_EQ(show_library().size(), 2u);
}

TEST_F(WithLibrary, ABadScanNeverCostsTheBatch) {
  write_text_file(folder / "bad.obj", "not a mesh\n");
  write_obj(folder / "good.obj", noisy_ellipsoid(5, {0.4, 0.3, 0.2}));
  const ProgramRun run = run_clast({"reconstruct", "bad.obj", "good.obj"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "bad.obj") && contains(run.err, "1 of 2")) << run.err;
  EXPECT_EQ(show_library().size(), 3u);
}

Json classified(const BlockMeasuringOptions& reading) {
  std::ostringstream out;
  write_population_json(out,
                        read_populations({.first = {{"blocks.h5"}, "", ""}, .reading = reading}));
  return Json::parse(out.str());
}

TEST_F(WithLibrary, ClassifyCountsThePopulation) {
  const ProgramRun run = run_clast({"classify", "blocks.h5", "--json", "--scheme", "all"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json, classified({.surfaces = true}));
  EXPECT_EQ(json["blocks"].size(), 2u);
  for (const char* scheme : {"sneed-folk", "zingg", "garcia"}) {
    int blocks = 0;
    double share = 0.0;
    for (const Json& row : json["population"][scheme]) {
      blocks += int(row["blocks"]);
      share += double(row["share"]);
      EXPECT_TRUE(row["low"] <= row["share"] && row["share"] <= row["high"]);
    }
    EXPECT_EQ(blocks, 2) << scheme;
    EXPECT_NEAR(share, 1.0, 1e-12) << scheme;
  }
  const ProgramRun one = run_clast({"classify", "blocks.h5", "--scheme", "zingg"}, folder.path());
  EXPECT_TRUE(contains(one.out, "rod") && !contains(one.out, "garcia")) << one.out;
}

TEST_F(WithLibrary, ClassifyGivesEveryClassItsCertaintyAndEveryIndexItsFormula) {
  const Json json = classified({.surfaces = true, .roundness_edge = 0.08});
  const Json shown_blocks = show_library();
  for (int i = 0; i < 2; ++i) {
    const Json& block = json["blocks"][i];
    for (const char* scheme : {"sneed-folk", "zingg", "garcia", "williams", "erdogan", "blott-pye",
                               "en-933-4", "flakiness"}) {
      const Json& found = block["classes"][scheme];
      EXPECT_NEAR(std::abs(double(found["value"]) - double(found["nearest_limit"])),
                  found["distance"], 1e-12);
      EXPECT_EQ(found["survives"], found["others"].empty()) << scheme;
    }
    EXPECT_EQ(block["classes"]["zingg"]["class"], block["zingg"]);
    EXPECT_NEAR(block["axis_error_m"], 2.0 * double(shown_blocks[i]["deviation_m"]["hausdorff"]),
                1e-15);
    EXPECT_EQ(block["indices"], shown_blocks[i]["indices"]);
    EXPECT_EQ(block["boxes_m"], shown_blocks[i]["boxes_m"]);
    EXPECT_EQ(block["equilibria"], shown_blocks[i]["equilibria"]);
    const Json& roundness = block["roundness"];
    EXPECT_TRUE(0.0 < roundness["wadell_roundness"] && roundness["wadell_roundness"] <= 1.0);
    EXPECT_NEAR(roundness["edge_length_m"], 0.08, 0.03);
    EXPECT_LE(2.0 * double(roundness["inscribed_radius_m"]), double(block["box_m"][2]));
    const double sphericity = block["indices"]["wadell_true_sphericity"];
    EXPECT_TRUE(0.5 < sphericity && sphericity < 1.0) << sphericity;
    const double convexity = block["indices"]["convexity"];
    EXPECT_NEAR(convexity, 1.0, 1e-12) << "the core is a hull";
    const Json& sides = block["equilibria"];
    EXPECT_EQ(int(sides["stable"]) + int(sides["unstable"]) - int(sides["saddle"]), 2);
    for (const auto& [name, value] : block["indices"].items()) {
      EXPECT_TRUE(json["formulas"].contains(name)) << name;
      EXPECT_NE(name, "compactness");
    }
  }
}

TEST_F(WithLibrary, ClassifyMeasuresOnTheNamedBox) {
  const Json blocks = show_library();
  for (const std::string box : {"smallest", "inertia", "feret", "pca"}) {
    const Json json = classified({.box = box, .box_given = true});
    EXPECT_EQ(json["box"], box);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(json["blocks"][i]["box_m"], blocks[i]["boxes_m"][box]);
  }
}

TEST_F(WithLibrary, ExportWritesEveryFormatAndTurnsBack) {
  const ProgramRun run = run_clast(
      {"export", "blocks.h5", "--format", "shp,obj,stl,ply,glb,vtp", "--what", "both", "-o", "out"},
      folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::set<std::string> names = names_in(folder / "out");
  for (const char* extension : {"shp", "obj", "stl", "ply", "glb", "vtp"}) {
    EXPECT_TRUE(names.count(std::string("long.") + extension)) << extension;
    EXPECT_EQ(names.count(std::string("long_core.") + extension),
              std::string(extension) == "shp" ? 0u : 1u);
  }
  EXPECT_EQ(names.size(), 2u * 11u);

  // A block read y up and handed back y up lies where it was; read back, it is the same block.
  ASSERT_EQ(
      run_clast({"reconstruct", "flat.obj", "--up", "y", "-o", "y.h5"}, folder.path()).exit_code,
      0);
  ASSERT_EQ(
      run_clast({"export", "y.h5", "--format", "obj", "--what", "core", "--up", "y", "-o", "y"},
                folder.path())
          .exit_code,
      0);
  ASSERT_EQ(run_clast({"reconstruct", "y/flat.obj", "--up", "y", "--core", "--radius", "0", "-o",
                       "back.h5"},
                      folder.path())
                .exit_code,
            0);
  const Json once = show_library("y.h5")[0], back = show_library("back.h5")[0];
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(once["centre_m"][i], back["centre_m"][i], 1e-4);
  }
}

TEST_F(WithLibrary, LibrariesAreMergedCutAndAnnotated) {
  write_obj(folder / "cube.obj", cuboid(1, 1, 1));
  ASSERT_EQ(run_clast({"reconstruct", "cube.obj", "-o", "other.h5"}, folder.path()).exit_code, 0);
  ASSERT_EQ(
      run_clast({"library", "merge", "all.h5", "blocks.h5", "other.h5"}, folder.path()).exit_code,
      0);
  EXPECT_EQ(show_library("all.h5").size(), 3u);
  EXPECT_EQ(show_library("all.h5")[1], show_library("blocks.h5")[0]);
  const ProgramRun again = run_clast({"library", "merge", "all.h5", "other.h5"}, folder.path());
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_TRUE(contains(again.err, "cube") && contains(again.err, "other.h5")) << again.err;

  ASSERT_EQ(run_clast({"library", "remove", "all.h5", "flat", "long"}, folder.path()).exit_code, 0);
  EXPECT_EQ(show_library("all.h5").size(), 1u);
  expect_refused(folder, {"library", "remove", "all.h5", "flat"}, 1, "flat");
  expect_refused(folder, {"library", "remove", "all.h5", "cube", "nope"}, 1, "nope");
  EXPECT_EQ(show_library("all.h5").size(), 1u) << "all go or none";

  const ProgramRun set =
      run_clast({"library", "set", "all.h5", "cube", "--site", "Authume", "--note", "weathered",
                 "--taped", "0.9,1.1,1.0", "--weighed", "2650"},
                folder.path());
  ASSERT_EQ(set.exit_code, 0) << set.err;
  const Json field = show_library("all.h5")[0]["field"];
  EXPECT_EQ(field["site"], "Authume");
  EXPECT_EQ(field["note"], "weathered");
  EXPECT_EQ(field["taped_m"], Json({1.1, 1.0, 0.9}));
  EXPECT_EQ(field["weighed_kg"], 2650.0);
  expect_refused(folder, {"library", "set", "all.h5", "ball", "--note", "x"}, 1, "ball");
}

TEST_F(WithLibrary, TextThatIsNotUtf8IsConverted) {
  const std::string street =
      "Stra\xdf"
      "e";
  ASSERT_EQ(
      run_clast({"library", "set", "blocks.h5", "flat", "--site", street}, folder.path()).exit_code,
      0);
  EXPECT_EQ(show_library()[0]["field"]["site"],
            "Stra\xc3\x9f"
            "e");
  write_obj(folder /
                "Bl\xf6"
                "ck.obj",
            cuboid(1, 2, 3));
  const ProgramRun run = run_clast({"reconstruct",
                                    "Bl\xf6"
                                    "ck.obj",
                                    "--json"},
                                   folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json block = Json::parse(run.out)["blocks"][0];
  EXPECT_EQ(block["id"],
            "Bl\xc3\xb6"
            "ck");
  EXPECT_EQ(block["source"],
            "Bl\xc3\xb6"
            "ck.obj");
}

TEST_F(WithLibrary, AFullDiskEndsWithAMessageAndTheOldLibrary) {
  const std::string before = read_text_file(folder / "blocks.h5");
  rlimit old;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small = {8192, old.rlim_max};  // a write beyond it fails, as on a full disk
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const ProgramRun run =
      run_clast({"library", "set", "blocks.h5", "flat", "--note", "x"}, folder.path());
  ::setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "can't be written (File too large); free some space")) << run.err;
  EXPECT_EQ(read_text_file(folder / "blocks.h5"), before);
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"blocks.h5", "flat.obj", "long.obj"}));
}

TEST_F(WithLibrary, ADamagedLibraryIsRefusedByEveryCommandAndLeftAlone) {
  const std::string whole = read_text_file(folder / "blocks.h5");
  write_text_file(folder / "cut.h5", whole.substr(0, whole.size() / 2));
  write_text_file(folder / "text.h5", "id,L,I,S\n");
  write_text_file(folder / "empty.h5", "");
  const std::string before = read_text_file("cut.h5");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"show", "cut.h5"},
        {"classify", "cut.h5"},
        {"export", "cut.h5", "-o", "out"},
        {"library", "merge", "all.h5", "blocks.h5", "cut.h5"},
        {"library", "remove", "cut.h5", "flat"},
        {"library", "set", "cut.h5", "flat", "--note", "x"}}) {
    expect_refused(folder, command, 1, "cut.h5");
  }
  EXPECT_EQ(read_text_file("cut.h5"), before);
  for (const std::string file : {"cut.h5", "text.h5", "empty.h5", "none.h5"}) {
    EXPECT_TRUE(contains(refusal<Error>([&] { BlockLibrary::read(file); }), file));
    EXPECT_TRUE(
        contains(refusal<Error>([&] { update_library(file, {}, [](BlockLibrary&) {}); }), file));
    if (file == "none.h5") continue;
    const std::string bytes = read_text_file(file);
    expect_refused(folder, {"reconstruct", "flat.obj", "-o", file}, 1, file);
    EXPECT_EQ(read_text_file(file), bytes);
  }
}

}  // namespace
}  // namespace clast
