// What is made beside a target, and what a kill leaves there.
#include "core/files/staging_path.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "core/files/output_file.hpp"
#include "core/files/output_folder.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;
using Kind = StagingPath::Kind;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

/// Runs `work` in a process that is killed at its end, once it says so.
void killed_in(const std::function<void()>& work) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ASSERT_EQ(::write(ready[1], "x", 1), 1);
    while (true) ::pause();
  }
  char said = 0;
  ASSERT_EQ(::read(ready[0], &said, 1), 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

TEST(StagingPath, IsEmptyHasTheExtensionAndIsHeld) {
  const ScratchFolder folder;
  {
    const StagingPath first(folder / "a.csv", Kind::kFile), second(folder / "a.csv", Kind::kFile);
    EXPECT_NE(first.path(), second.path());
    for (const StagingPath* part : {&first, &second}) {
      EXPECT_TRUE(fs::is_empty(part->path()));
      EXPECT_EQ(part->path().extension(), ".csv");
      EXPECT_TRUE(part->path().filename().string().starts_with(".a.part"));
      EXPECT_FALSE(FileLock::try_acquire(part->path())) << "held";
    }
    const StagingPath report(folder / "report", Kind::kFolder);
    EXPECT_TRUE(fs::is_directory(report.path()));
    EXPECT_EQ(report.backup_path().string(), report.path().string() + ".former");
  }
}

TEST(StagingPath, LeftoversOfAKillAreRemovedByTheNextOfTheSameTarget) {
  const ScratchFolder folder;
  killed_in([&] {
    auto* file = new OutputFile(folder / "a.csv");  // never destroyed
    file->write("half");
    auto* other = new OutputFile(folder / "b.csv");
    other->write("half");
  });
  ASSERT_EQ(names_in(folder.path()).size(), 4u) << "two files and their locks";
  write_text_file(folder / "a.csv", "whole");
  std::set<std::string> left = names_in(folder.path());
  EXPECT_EQ(left.size(), 3u) << "those of the other target stay";
  EXPECT_TRUE(left.contains("a.csv"));
  write_text_file(folder / "b.csv", "whole");
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"a.csv", "b.csv"}));
}

TEST(StagingPath, PartsInUseAreLeftToTheirProgram) {
  const ScratchFolder folder;
  OutputFile slow(folder / "a.csv");
  slow.write("slow");
  write_text_file(folder / "a.csv", "quick");
  EXPECT_TRUE(fs::exists(slow.temporary_path()));
  slow.commit();
  EXPECT_EQ(read_text_file(folder / "a.csv"), "slow");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"a.csv"});
}

// Whatever its process number says: folders are shared between machines.
TEST(StagingPath, TheLockDecidesAndNotTheProcessNumber) {
  const ScratchFolder folder;
  const std::string mine = ".a.part" + std::to_string(::getpid()) + ".csv";
  write_text_file(folder / mine, "left by a process of the same number");
  write_text_file(folder / ".a.part1.csv", "process 1 runs everywhere");
  const int held = ::open((folder / ".a.part7.csv").c_str(), O_CREAT | O_RDWR, 0644);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  write_text_file(folder / "a.csv", "new");
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"a.csv", ".a.part7.csv"}));
  ::close(held);
  write_text_file(folder / "a.csv", "new");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"a.csv"});
}

TEST(StagingPath, OtherFilesAreNotTouched) {
  const ScratchFolder folder;
  std::set<std::string> others = {".a.part.csv",  ".a.part12.txt",  ".a.partial12.csv",
                                  "a.part12.csv", ".ab.part12.csv", ".a.part12x.csv"};
  for (const std::string& name : others) write_text_file(folder / name, "keep");
  fs::create_directory(folder / ".a.part99.csv");  // a folder where a file is written
  others.insert({".a.part99.csv", "a.csv"});
  write_text_file(folder / "a.csv", "new");
  EXPECT_EQ(names_in(folder.path()), others);
}

OutputFolderKind kind() {
  return {"comparison", "mark.json", "clast",
          [](const fs::path& file) { return file.extension() == ".csv" || file == "mark.json"; }};
}

void fill(const OutputFolder& folder) {
  write_text_file(folder.temporary_path() / "mark.json", "clast");
  write_text_file(folder.temporary_path() / "runs.csv", "1");
}

TEST(StagingPath, FoldersOfAKilledReportAreRemoved) {
  const ScratchFolder folder;
  killed_in([&] { fill(*new OutputFolder(folder / "report", kind(), false)); });
  ASSERT_EQ(names_in(folder.path()).size(), 2u);
  OutputFolder again(folder / "report", kind(), false);
  fill(again);
  again.commit();
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"report"});
  EXPECT_TRUE(fs::exists(folder / "report/runs.csv"));
}

// A kill between the two renames of an exchange leaves no report under its name.
TEST(StagingPath, WhatWasTakenOutOfTheTargetComesBack) {
  const ScratchFolder folder;
  fs::create_directories(folder / ".report.part5");
  write_text_file(folder / ".report.part5/runs.csv", "new, half");
  fs::create_directories(folder / ".report.part5.former");
  write_text_file(folder / ".report.part5.former/mark.json", "clast");
  write_text_file(folder / ".report.part5.former/runs.csv", "old");
  remove_stale_staging(folder / "report", Kind::kFolder);
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"report"});
  EXPECT_EQ(read_text_file(folder / "report/runs.csv"), "old");
  fs::create_directories(folder / ".report.part6.former");
  write_text_file(folder / ".report.part6.former/runs.csv", "older");
  remove_stale_staging(folder / "report", Kind::kFolder);
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"report"});
  EXPECT_EQ(read_text_file(folder / "report/runs.csv"), "old");
}

}  // namespace
}  // namespace clast
