// That no command writes over what is to be kept, waits for what never comes, or finds out after
// the work that its result can't be written.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/slope_campaign.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// Files no larger than this while it lasts, for the programs started meanwhile too. Their answer
/// to SIGXFSZ is left as it is.
class LargestFile {
 public:
  explicit LargestFile(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small = {bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~LargestFile() { ::setrlimit(RLIMIT_FSIZE, &old_); }

 private:
  rlimit old_;
};

class FileSafety : public SlopeCampaign {
 protected:
  ProgramRun run(const std::vector<std::string>& arguments) {
    return run_clast(arguments, folder.path());
  }
  void make(const std::vector<std::string>& arguments) {
    const ProgramRun made = run(arguments);
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  /// Refused, and the file is as it was.
  void expect_kept(const std::string& file, const std::vector<std::string>& arguments,
                   const std::string& why) {
    const std::string before = read_text_file(folder / file);
    expect_refused(folder, arguments, 1, why);
    EXPECT_TRUE(read_text_file(folder / file) == before) << file;
  }
};

TEST_F(FileSafety, OneHdf5FileNeverTakesThePlaceOfAnother) {
  make({"simulate", "campaign.toml", "-o", "results.h5"});
  make({"terrain", "slope.obj", "flat.obj", "--zones", "slope,flat", "-o", "terrain.h5"});
  for (const char* replace : {"", "--replace"}) {
    for (const std::string file : {"results.h5", "blocks.h5"}) {
      std::vector<std::string> words = {"terrain", "slope.obj", "-o", file};
      if (*replace) words.push_back(replace);
      expect_kept(file, words, file + ": already exists and holds \"clast ");
    }
    for (const std::string file : {"results.h5", "terrain.h5"}) {
      std::vector<std::string> words = {"reconstruct", "slope.obj", "-o", file};
      if (*replace) words.push_back(replace);
      expect_kept(file, words, file + ": is a \"clast ");
      words = {"library", "merge", file, "blocks.h5"};
      if (*replace) words.push_back(replace);
      expect_kept(file, words, file + ": is a \"clast ");
    }
  }
  for (const std::string file : {"terrain.h5", "blocks.h5", "campaign.toml"}) {
    expect_kept(file, {"simulate", "campaign.toml", "-o", file},
                file + ": already exists and holds");
    expect_kept(file, {"simulate", "--merge", "results.h5", "-o", file},
                file + ": already exists and holds");
  }
}

TEST_F(FileSafety, FinishedTerrainsAndTheirPicturesNeedReplace) {
  const std::vector<std::string> command = {"terrain",   "slope.obj", "-o",       "t.h5",
                                            "--picture", "slope.svg", "--export", "s.ply"};
  make(command);
  expect_kept("t.h5", {"terrain", "flat.obj", "-o", "t.h5"}, "t.h5: already exists; --replace");
  expect_kept("slope.svg", {"terrain", "flat.obj", "-o", "u.h5", "--picture", "slope.svg"},
              "slope.svg: already exists; --replace replaces it");
  expect_kept("s.ply", {"terrain", "flat.obj", "-o", "u.h5", "--export", "s.ply"},
              "s.ply: already exists");
  std::vector<std::string> again = command;
  again.push_back("--replace");
  make(again);
  write_text_file(folder / "notes.svg", "no picture");
  expect_kept("notes.svg",
              {"terrain", "flat.obj", "-o", "u.h5", "--picture", "notes.svg", "--replace"},
              "notes.svg: already exists and holds \"text\", not \"SVG\"");
}

TEST_F(FileSafety, ExportsNeverReplaceTheScansTheyCameFrom) {
  write_obj(folder / "rock.obj", noisy_ellipsoid(4, {0.5, 0.4, 0.3}));
  make({"reconstruct", "rock.obj", "-o", "rock.h5"});
  const std::vector<std::string> command = {"export", "rock.h5", "--format", "shp,obj", "-o", "."};
  expect_kept("rock.obj", command, "rock.obj: already exists; --replace replaces it");
  EXPECT_FALSE(fs::exists(folder / "rock.shp"));
  std::vector<std::string> replaced = command;
  replaced.push_back("--replace");
  make(replaced);
  EXPECT_TRUE(fs::exists(folder / "rock.shp"));
}

TEST_F(FileSafety, ReportsAppearWholeAndNeedReplace) {
  make({"simulate", "campaign.toml", "-o", "r.h5"});
  make({"compare", "r.h5", "-o", "out"});
  const std::string report = read_text_file(folder / "out/report.html");
  const std::vector<std::string> again = {"compare", "r.h5", "-o", "out", "--replace"};
  expect_refused(folder, {"compare", "r.h5", "-o", "out"}, 1, "out: holds a comparison already");
  // Nothing is stored to animate, which shows after all else is written.
  write_text_file(folder / "out" / "notes.txt", "mine");
  std::vector<std::string> fails = again;
  fails.insert(fails.end(), {"--animate", "1", "--by", "point"});
  expect_refused(folder, fails, 1, "nothing can be animated");
  EXPECT_TRUE(read_text_file(folder / "out/report.html") == report);
  make(again);
  EXPECT_EQ(read_text_file(folder / "out/notes.txt"), "mine");

  write_text_file(folder / "talus.csv", "id,L,I,S\na,3,2,1\nb,2,1.5,1\n");
  make({"classify", "talus.csv", "-o", "classes"});
  expect_refused(folder, {"classify", "talus.csv", "-o", "classes"}, 1,
                 "classes: holds a classification already");
  expect_refused(folder, {"classify", "talus.csv", "-o", "out", "--replace"}, 1,
                 "out: holds report.html, but is not a classification of clast");
  expect_refused(folder, {"compare", "r.h5", "-o", "classes", "--replace"}, 1,
                 "classes: holds report.html, but is not a comparison of clast");
  make({"classify", "talus.csv", "-o", "classes", "--replace"});
  expect_refused(folder, {"classify", "talus.csv", "--replace"}, 2, "--replace");
}

TEST_F(FileSafety, PagesOfScansNeedReplaceOrResume) {
  write_obj(folder / "a.obj", cuboid(1, 0.8, 0.6));
  const std::vector<std::string> command = {"reconstruct", "a.obj", "-o", "a.h5", "--report", "p"};
  make(command);
  expect_kept("p/index.html", {"reconstruct", "a.obj", "-o", "b.h5", "--report", "p"},
              "p/summary.csv: already exists; --replace replaces it");
  std::vector<std::string> words = command;
  words.push_back("--resume");
  make(words);
  words.back() = "--replace";
  make(words);
  fs::create_directory(folder / "q");
  write_text_file(folder / "q" / "summary.csv", "block,volume\n");
  expect_kept("q/summary.csv", {"reconstruct", "a.obj", "-o", "b.h5", "--report", "q", "--replace"},
              "q/summary.csv: already exists and is not a summary of scan pages");
  fs::remove(folder / "q" / "summary.csv");
  write_text_file(folder / "q" / "index.html", "<!DOCTYPE html>\n<title>Mine</title>\n");
  expect_kept("q/index.html", {"reconstruct", "a.obj", "-o", "b.h5", "--report", "q", "--replace"},
              "q/index.html: already exists and holds \"HTML\", not \"page of clast\"");
}

TEST_F(FileSafety, FourScansIntoOneLibraryAtOnceAreFourBlocks) {
  std::vector<std::unique_ptr<RunningProgram>> programs;
  for (const std::string name : {"a", "b", "c", "d"}) {
    write_obj(folder / (name + ".obj"), cuboid(1, 0.9, 0.5));
    // Two of them go on with what is there, which makes no difference.
    std::vector<std::string> words = {"reconstruct", name + ".obj", "-o", "same.h5"};
    if (name > "b") words.push_back("--resume");
    programs.push_back(std::make_unique<RunningProgram>(clast_words(words), folder.path()));
  }
  for (const auto& program : programs) {
    const ProgramRun done = program->wait();
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_TRUE(contains(done.out, "1 block written"));
  }
  const Json shown = Json::parse(run({"show", "same.h5", "--json"}).out);
  ASSERT_EQ(shown.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(shown[i]["id"], std::string(1, static_cast<char>('a' + i)));
  EXPECT_FALSE(fs::exists(folder / ".same.h5.lock"));
}

TEST_F(FileSafety, WhatAnotherProcessAddedMeanwhileIsNotWrittenOver) {
  // All four make the same block; one is first, the others say so and fail.
  write_obj(folder / "a.obj", noisy_ellipsoid(4, {0.5, 0.4, 0.3}));
  std::vector<std::unique_ptr<RunningProgram>> programs;
  for (const std::string density : {"2100", "2200", "2300", "2400"}) {
    programs.push_back(std::make_unique<RunningProgram>(
        clast_words({"reconstruct", "a.obj", "-o", "same.h5", "--density", density, "--json"}),
        folder.path()));
  }
  int written = 0;
  double density = 0.0;
  for (const auto& program : programs) {
    const ProgramRun done = program->wait();
    if (done.exit_code == 0) {
      ++written;
      density = Json::parse(done.out)["blocks"][0]["density_kg_m3"];
      continue;
    }
    EXPECT_TRUE(contains(done.err, "is in the library already") ||
                contains(done.err, "is in same.h5 already"));
    EXPECT_TRUE(!contains(done.out, "\"id\"")) << "is said to be written and is not";
  }
  EXPECT_EQ(written, 1);
  EXPECT_EQ(Json::parse(run({"show", "same.h5", "--json"}).out)[0]["density_kg_m3"], density);
}

TEST_F(FileSafety, OfManyProgramsThatWriteTheSameNewFileOneDoes) {
  write_obj(folder / "rock.obj", cuboid(1, 0.8, 0.6));
  make({"reconstruct", "rock.obj", "-o", "rock.h5"});
  make({"simulate", "campaign.toml", "-o", "r.h5"});
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"terrain", "slope.obj", "-o", "same.h5"},
        {"export", "rock.h5", "--format", "ply", "-o", "same"},
        {"compare", "r.h5", "-o", "same_report"}}) {
    std::vector<std::unique_ptr<RunningProgram>> programs;
    for (int i = 0; i < 4; ++i) {
      programs.push_back(std::make_unique<RunningProgram>(clast_words(command), folder.path()));
    }
    int written = 0;
    for (const auto& program : programs) {
      const ProgramRun done = program->wait();
      if (done.exit_code == 0) ++written;
      EXPECT_TRUE(done.exit_code == 0 || contains(done.err, "another program wrote it meanwhile") ||
                  contains(done.err, "--replace replaces it"))
          << done.err;
    }
    EXPECT_EQ(written, 1) << command[0];
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
      const std::string name = entry.path().filename();
      EXPECT_TRUE(!contains(name, ".part")) << name;
    }
  }
  make({"compare", "r.h5", "-o", "same_report", "--replace"});
}

TEST_F(FileSafety, TheOriginOfAnExportIsKeptAsTheExportIs) {
  // So far out that floats would spoil it.
  std::string far = "v 700000 5200000 0\nv 700004 5200000 0\nv 700004 5200003 1\nf 1 2 3\n";
  write_text_file(folder / "far.obj", far);
  const std::vector<std::string> command = {"terrain",  "far.obj", "-o",       "t.h5",
                                            "--export", "far.stl", "--replace"};
  write_text_file(folder / "far.stl.origin.txt", "what the surveyor says of the origin");
  expect_kept("far.stl.origin.txt", command,
              "far.stl.origin.txt: already exists and holds \"text\"");
  EXPECT_FALSE(fs::exists(folder / "t.h5")) << "refused after the work";
  fs::remove(folder / "far.stl.origin.txt");
  make(command);
  EXPECT_TRUE(contains(read_text_file(folder / "far.stl.origin.txt"), "origin x 7000"));
  // Left by a former export it would be wrong beside a new one.
  fs::remove(folder / "far.stl");
  fs::remove(folder / "t.h5");
  expect_kept("far.stl.origin.txt", {"terrain", "slope.obj", "-o", "t.h5", "--export", "far.stl"},
              "far.stl.origin.txt: already exists; --replace replaces it");
  make({"terrain", "slope.obj", "-o", "t.h5", "--export", "far.stl", "--replace"});
  EXPECT_FALSE(fs::exists(folder / "far.stl.origin.txt"));
}

TEST_F(FileSafety, PlacesThatCantBeWrittenAreRefusedBeforeTheRuns) {
  fs::create_symlink("loop.h5", folder / "loop.h5");
  write_text_file(folder / "file", "");
  for (const auto& [place, why] :
       {std::pair{"/dev/null", "/dev/null: is a device or a pipe"},
        std::pair{"loop.h5", "loop.h5: Too many levels of symbolic links; repair the link"},
        std::pair{"file/r.h5", "file: can't make this folder"}}) {
    for (const char* how : {"--threads=1", "--dry-run"}) {
      const ProgramRun refused = run({"simulate", "campaign.toml", "-o", place, how});
      EXPECT_EQ(refused.exit_code, 1) << place;
      EXPECT_TRUE(contains(refused.err, why)) << place;
      EXPECT_EQ(refused.out, "") << "before anything is done";
    }
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"reconstruct", "slope.obj", "-o", place},
          {"library", "merge", place, "blocks.h5"}}) {
      EXPECT_EQ(run(command).exit_code, 1) << command[0] << " " << place;
    }
  }
  EXPECT_FALSE(fs::exists("/dev/null.part"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(FileSafety, ALinkAsOutputIsFollowed) {
  fs::create_directory(folder / "store");
  fs::create_symlink("store/real.h5", folder / "results.h5");
  make({"simulate", "campaign.toml"});
  EXPECT_TRUE(fs::is_symlink(folder / "results.h5"));
  EXPECT_TRUE(fs::is_regular_file(folder / "store" / "real.h5"));
  write_obj(folder / "a.obj", cuboid(1, 0.8, 0.6));
  fs::create_symlink("../blocks.h5", folder / "store" / "link.h5");
  make({"reconstruct", "a.obj", "-o", "store/link.h5"});
  EXPECT_TRUE(fs::is_symlink(folder / "store" / "link.h5"));
  EXPECT_EQ(Json::parse(run({"show", "blocks.h5", "--json"}).out).size(), 3u);
}

TEST_F(FileSafety, AFullDiskIsReportedBeforeTheRunsWhereItCanBeKnown) {
  write_text_file(folder / "many.toml",
                  replaced(slope_campaign(), "random = 2, seed", "random = 2000, seed"));
  {
    const LargestFile limit(20'000);  // the ground alone takes more
    expect_refused(folder, {"simulate", "campaign.toml"}, 1,
                   "can't be written (File too large); free some space");
  }
  const LargestFile limit(1'000'000);  // 8,000 runs take some 4 MB, whatever happens in them
  expect_refused(folder, {"simulate", "many.toml"}, 1, "results.h5: at least 4");
  expect_refused(folder, {"simulate", "many.toml"}, 1,
                 "MB will be written, and files must not be larger (ulimit -f) than 1 MB");
}

TEST_F(FileSafety, ADiskThatFillsDuringTheRunsIsReportedAndKeepsThem) {
  // Trajectories, which nobody can foresee, fill it.
  std::string text = replaced(slope_campaign(), "random = 2, seed", "random = 20, seed");
  text = replaced(text, "trajectory_interval_s = 0", "trajectory_interval_s = 0.0005");
  write_text_file(folder / "campaign.toml", text);
  {
    const LargestFile limit(1'000'000);
    const ProgramRun full = run({"simulate", "campaign.toml"});
    EXPECT_EQ(full.exit_code, 1) << full.exit_code;
    EXPECT_TRUE(contains(full.err, "results.h5.part: writing failed; is the disk full?"));
  }
  make({"simulate", "campaign.toml", "--resume"});
}

TEST_F(FileSafety, OnlyACampaignIsReplacedByACampaign) {
  make({"terrain", "slope.obj", "-o", "terrain.h5"});
  const std::vector<std::string> words = {"new",       "campaign",   "--library", "blocks.h5",
                                          "--terrain", "terrain.h5", "--replace", "-o"};
  const auto onto = [&](const std::string& file) {
    std::vector<std::string> all = words;
    all.push_back(file);
    return all;
  };
  for (const auto& [file, content] :
       std::map<std::string, std::string>{{"notes.txt", "what the field book says\n"},
                                          {"talus.csv", "L,I,S\n3,2,1\n"},
                                          {"study.toml", "design = { members = 8 }\n"},
                                          {"pyproject.toml", "[project]\nname = \"x\"\n"}}) {
    write_text_file(folder / file, content);
    expect_kept(file, onto(file), "holds \"text\", not \"campaign\", so it is not replaced");
  }
  expect_kept("slope.obj", onto("slope.obj"), "not \"campaign\"");
  write_text_file(folder / "mine.toml", read_text_file(folder / "campaign.toml"));
  make(onto("mine.toml"));
  EXPECT_TRUE(contains(read_text_file(folder / "mine.toml"), "written by clast new campaign"));
  make(onto("mine.toml"));
}

/// Every file of a folder and of those in it.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    contents[entry.path().lexically_relative(folder).string()] = read_text_file(entry.path());
  }
  return contents;
}

// No clock, process number or order of threads is in anything that is written.
TEST_F(FileSafety, EqualRunsWriteEqualFiles) {
  write_text_file(folder / "talus.csv", "id,L,I,S\na,1.2,0.9,0.5\nb,0.8,0.7,0.6\nc,2,1,0.8\n");
  write_text_file(folder / "stops.csv", "x,y\n12,1\n13,0\n14,-1\n15,2\n11,0\n12,3\n");
  std::map<std::string, std::string> first;
  for (const int round : {1, 2}) {
    for (const char* made : {"results.h5", "map.h5", "picture.svg", "campaign2.toml"}) {
      fs::remove(folder / made);
    }
    for (const char* made : {"out", "classes", "gallery", "shapes", "scenes"}) {
      fs::remove_all(folder / made);
    }
    make({"terrain", "slope.obj", "-o", "map.h5", "--picture", "picture.svg"});
    make({"new", "campaign", "--library", "blocks.h5", "--terrain", "map.h5", "-o",
          "campaign2.toml"});
    make({"simulate", "campaign.toml", "-o", "results.h5", "--threads", round == 1 ? "1" : "2"});
    make({"compare", "results.h5", "-o", "out", "--measured", "stops.csv"});
    make({"classify", "talus.csv", "-o", "classes"});
    make({"show", "blocks.h5", "--report", "gallery"});
    make({"export", "blocks.h5", "-o", "shapes", "--format", "shp,stl,ply,obj,glb"});
    make({"export", "campaign.toml", "-o", "scenes", "--to", "rockable"});
    if (round == 1) {
      first = contents_of(folder.path());
      ::sleep(1);  // what counts seconds would show it
      continue;
    }
    const std::map<std::string, std::string> second = contents_of(folder.path());
    ASSERT_EQ(first.size(), second.size());
    EXPECT_TRUE(first.contains("out/stops.gpkg"));
    for (const auto& [file, content] : first) {
      EXPECT_TRUE(second.contains(file) && second.at(file) == content) << file;
    }
  }
}

// A report killed while it is written leaves a folder, a lock and perhaps files.
TEST_F(FileSafety, WhatAKillLeavesIsRemovedByTheNextRun) {
  make({"simulate", "campaign.toml", "-o", "results.h5"});
  const auto hidden = [&] {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(".")) names.push_back(name);
    }
    return names;
  };
  const std::vector<std::string> compare = {"compare", "results.h5", "-o", "out", "--replace"};
  RunningProgram program(clast_words(compare), folder.path());
  while (!program.ended() && hidden().empty()) ::usleep(500);
  program.signal(SIGKILL);
  ASSERT_EQ(program.wait().exit_code, 128 + SIGKILL);
  ASSERT_FALSE(hidden().empty());
  make(compare);
  EXPECT_TRUE(hidden().empty()) << hidden().front();
}

TEST_F(FileSafety, PipesAndDevicesAreNoInput) {
  for (const char* name : {"pipe.obj", "pipe.las", "pipe.tif", "pipe.csv", "pipe.toml", "pipe.h5",
                           "pipe.shp", "pipe.xyz"}) {
    ASSERT_EQ(::mkfifo((folder / name).c_str(), 0600), 0);
  }
  const auto refuse = [&](std::vector<std::string> words, const std::string& item) {
    RunningProgram program(clast_words(words), folder.path());
    for (int i = 0; i < 2000 && !program.ended(); ++i) ::usleep(10'000);
    const bool ended = program.ended();
    if (!ended) program.signal(SIGKILL);
    const ProgramRun done = program.wait();
    EXPECT_TRUE(ended) << words[0] << " waits for " << item;
    EXPECT_EQ(done.exit_code, 1) << words[0] << " " << item;
    EXPECT_TRUE(contains(done.err, item)) << words[0];
  };
  for (const char* scan : {"pipe.obj", "pipe.xyz", "pipe.shp"}) {
    refuse({"reconstruct", scan, "-o", "n.h5"}, scan);
  }
  for (const char* ground : {"pipe.obj", "pipe.las", "pipe.tif", "pipe.h5", "/dev/zero"}) {
    refuse({"terrain", ground, "-o", "n.h5"}, ground);
  }
  refuse({"terrain", "slope.obj", "-o", "n.h5", "--release", "pipe.xyz"}, "pipe.xyz");
  refuse({"terrain", "slope.obj", "-o", "n.h5", "--zones", "pipe.tif"}, "pipe.tif");
  refuse({"classify", "pipe.csv"}, "pipe.csv");
  refuse({"show", "pipe.h5"}, "pipe.h5");
  refuse({"simulate", "pipe.toml"}, "pipe.toml");
  refuse({"compare", "pipe.h5"}, "pipe.h5");
}

}  // namespace
}  // namespace clast
