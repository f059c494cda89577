#include "core/files/output_folder.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

OutputFolderKind report() {
  return {"report", "mark.txt", "a report", [](const fs::path& file) {
            return file == "mark.txt" || file == "runs.csv" || file == "old.csv" ||
                   file.parent_path() == "maps";
          }};
}

void write(const fs::path& target, const std::string& text, bool replace) {
  OutputFolder folder(target, report(), replace);
  write_text_file(folder.temporary_path() / "mark.txt", "this is a report");
  write_text_file(folder.temporary_path() / "runs.csv", text);
  write_text_file(folder.temporary_path() / "maps" / "a.tif", text);
  folder.commit();
}

std::set<std::string> files(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    names.insert(entry.path().lexically_relative(folder));
  }
  return names;
}

TEST(OutputFolder, AppearsWholeOrNotAtAll) {
  const ScratchFolder folder;
  {
    OutputFolder half(folder / "out", report(), false);
    write_text_file(half.temporary_path() / "runs.csv", "half");
  }
  EXPECT_TRUE(files(folder.path()).empty());
  write(folder / "a" / "out", "whole", false);
  EXPECT_EQ(files(folder / "a" / "out"),
            (std::set<std::string>{"mark.txt", "runs.csv", "maps", "maps/a.tif"}));
  EXPECT_EQ(files(folder / "a").size(), 5u);
}

TEST(OutputFolder, AFormerOneIsKeptUntilReplaceAndReplacedWhole) {
  const ScratchFolder folder;
  write(folder / "out", "old", false);
  EXPECT_TRUE(contains(refusal([&] { write(folder / "out", "new", false); }),
                       "out: holds a report already; `replace` replaces it"));
  EXPECT_EQ(read_text_file(folder / "out" / "runs.csv"), "old");
  write_text_file(folder / "out" / "old.csv", "of the former report");
  write_text_file(folder / "out" / "maps" / "b.tif", "of the former report");
  write_text_file(folder / "out" / "notes" / "mine.txt", "of the user");
  {
    OutputFolder fails(folder / "out", report(), true);
    write_text_file(fails.temporary_path() / "runs.csv", "half");
  }
  EXPECT_EQ(read_text_file(folder / "out" / "runs.csv"), "old");
  write(folder / "out", "new", true);
  EXPECT_EQ(read_text_file(folder / "out" / "runs.csv"), "new");
  EXPECT_EQ(files(folder / "out"), (std::set<std::string>{"mark.txt", "runs.csv", "maps", "notes",
                                                          "maps/a.tif", "notes/mine.txt"}));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(OutputFolder, WhatIsNotItsOwnIsLeftAlone) {
  const ScratchFolder folder;
  write_text_file(folder / "out" / "runs.csv", "of the user");
  EXPECT_TRUE(contains(refusal([&] { write(folder / "out", "new", true); }),
                       "out: holds runs.csv, but is not a report of clast"));
  EXPECT_EQ(read_text_file(folder / "out" / "runs.csv"), "of the user");
  write_text_file(folder / "file", "taken");
  EXPECT_TRUE(contains(refusal([&] { write(folder / "file", "new", true); }), "file: is a file"));
  // A file of the user's with a name that only this report has.
  write(folder / "own", "old", false);
  write_text_file(folder / "own" / "extra.csv", "of the user");
  OutputFolder more(folder / "own", report(), true);
  write_text_file(more.temporary_path() / "extra.csv", "new");
  EXPECT_TRUE(contains(refusal([&] { more.commit(); }),
                       "extra.csv: does not belong to the existing report"));
  EXPECT_EQ(read_text_file(folder / "own" / "runs.csv"), "old");
}

// Two programs write the same folder, and neither found anything there at its start.
TEST(OutputFolder, WhatAnotherProgramWroteMeanwhileStays) {
  const ScratchFolder folder;
  fs::create_directory(folder / "empty");
  write_text_file(folder / "shared" / "notes.txt", "of the user");
  for (const char* name : {"new", "empty", "shared"}) {
    OutputFolder mine(folder / name, report(), false);
    write_text_file(mine.temporary_path() / "mark.txt", "this is a report");
    write_text_file(mine.temporary_path() / "runs.csv", "mine");
    write(folder / name, "theirs", false);
    EXPECT_TRUE(contains(refusal([&] { mine.commit(); }),
                         "another program wrote it meanwhile, so it is not replaced"))
        << name;
    EXPECT_EQ(read_text_file(folder / name / "runs.csv"), "theirs");
  }
  EXPECT_EQ(read_text_file(folder / "shared" / "notes.txt"), "of the user");
  // To be replaced, but by now it is no report.
  {
    OutputFolder mine(folder / "other", report(), true);
    write_text_file(mine.temporary_path() / "runs.csv", "mine");
    write_text_file(folder / "other" / "runs.csv", "of the user");
    EXPECT_TRUE(contains(refusal([&] { mine.commit(); }), "another program wrote it meanwhile"));
  }
  EXPECT_EQ(read_text_file(folder / "other" / "runs.csv"), "of the user");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4);
}

TEST(OutputFolder, MayBeNamedFromWhereOneIs) {
  const ScratchFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  write("out", "new", false);
  write("deep/../in/", "new", false);
  fs::create_directory("here");
  fs::current_path("here");
  write(".", "old", false);
  write(".", "new", true);
  EXPECT_EQ(read_text_file("runs.csv"), "new") << "whoever is in the folder still is";
  fs::current_path(before);
  for (const char* name : {"out", "in", "here"}) {
    EXPECT_EQ(read_text_file(folder / name / "runs.csv"), "new") << name;
  }
}

TEST(OutputFolder, LinksAreFollowedAndOtherFilesAreNoObstacle) {
  const ScratchFolder folder;
  write_text_file(folder / "real" / "notes.txt", "of the user");
  fs::create_directory_symlink("real", folder / "link");
  write(folder / "link/", "new", false);
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_text_file(folder / "real" / "runs.csv"), "new");
  EXPECT_EQ(read_text_file(folder / "real" / "notes.txt"), "of the user");
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  EXPECT_TRUE(contains(refusal([&] { write(folder / "a", "new", false); }), "repair the link"));
}

}  // namespace
}  // namespace clast
