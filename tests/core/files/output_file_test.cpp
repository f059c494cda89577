#include "core/files/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/as_nobody.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(OutputFile, WithoutCommitTheOldFileStaysAndNothingIsLeft) {
  const ScratchFolder folder;
  write_text_file(folder / "a.csv", "old");
  {
    OutputFile file(folder / "a.csv");
    std::ofstream(file.temporary_path()) << "half";
  }
  EXPECT_EQ(read_text_file(folder / "a.csv"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(OutputFile, CommitReplacesTheTarget) {
  const ScratchFolder folder;
  write_text_file(folder / "a.csv", "old");
  write_text_file(folder / "a.csv", "new");
  EXPECT_EQ(read_text_file(folder / "a.csv"), "new");
}

TEST(OutputFile, FolderAsTargetIsRefused) {
  const ScratchFolder folder;
  EXPECT_THROW(OutputFile{folder.path()}, InputError);
}

// As root the rename would succeed, and every program on the machine lose its /dev/null.
TEST(OutputFile, DevicesAndPipesAreRefused) {
  EXPECT_THROW(OutputFile{"/dev/null"}, InputError);
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(OutputFile{folder / "pipe"}, InputError);
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
}

TEST(OutputFile, LinksAreFollowedAndStayLinks) {
  const ScratchFolder folder;
  write_text_file(folder / "real.csv", "old");
  std::filesystem::create_symlink("real.csv", folder / "link.csv");
  write_text_file(folder / "link.csv", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.csv"));
  EXPECT_EQ(read_text_file(folder / "real.csv"), "new");
  // What is not there yet is made where the link says.
  std::filesystem::create_symlink("new.csv", folder / "ahead.csv");
  write_text_file(folder / "ahead.csv", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "ahead.csv"));
  EXPECT_EQ(read_text_file(folder / "new.csv"), "new");
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  EXPECT_TRUE(contains(refusal([&] { OutputFile{folder / "a"}; }), "repair the link"));
}

TEST(OutputFile, PermissionsOfTheOldFileStay) {
  const ScratchFolder folder;
  write_text_file(folder / "a.csv", "old");
  std::filesystem::permissions(folder / "a.csv", std::filesystem::perms(0640));
  write_text_file(folder / "a.csv", "new");
  EXPECT_EQ(std::filesystem::status(folder / "a.csv").permissions(), std::filesystem::perms(0640));
}

TEST(OutputFile, WriteProtectedFilesAreLeftAlone) {
  const ScratchFolder folder;
  write_text_file(folder / "a.csv", "old");
  std::filesystem::permissions(folder / "a.csv", std::filesystem::perms(0444));
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  const AsNobody nobody;
  const std::string message = refusal([&] { OutputFile{folder / "a.csv"}; });
  EXPECT_TRUE(contains(message, "a.csv: is write-protected; allow writing to it"));
}

TEST(OutputFile, OnlyItsOwnKindIsReplacedAndOnlyWhenAsked) {
  const ScratchFolder folder;
  write_text_file(folder / "a.png", "\x89PNG\r\n\x1a\nold");
  write_text_file(folder / "empty.png", "");
  write_text_file(folder / "notes.png", "what the field book says");
  const auto refused = [&](const char* name, const OverwritePolicy& rules) {
    return refusal([&] { check_output_target(folder / name, rules); });
  };
  EXPECT_EQ(refused("a.png", {.kind = "PNG"}), "");
  EXPECT_EQ(refused("empty.png", {.kind = "PNG", .replace = false}), "");
  EXPECT_EQ(refused("new.png", {.kind = "PNG", .replace = false}), "");
  EXPECT_TRUE(contains(refused("a.png", {.kind = "PNG", .replace = false}),
                       "a.png: already exists; `replace` replaces it"));
  for (const bool replace : {false, true}) {
    EXPECT_TRUE(contains(refused("notes.png", {.kind = "PNG", .replace = replace}),
                         "notes.png: already exists and holds \"text\", not \"PNG\", so it is not "
                         "replaced; give another name, or delete it first"));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 3);
}

// Two programs write the same file, and neither found anything there at its start.
TEST(OutputFile, WhatAnotherProgramWroteMeanwhileStays) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& name, const OverwritePolicy& rules, const char* there,
                           const char* meanwhile) {
    const std::filesystem::path target = folder / name;
    if (there) write_text_file(target, there);
    OutputFile file(target, rules);
    if (meanwhile) write_text_file(target, meanwhile);
    file.write("mine");
    return refusal([&] { file.commit(); });
  };
  const OverwritePolicy keep{.kind = "text", .replace = false};
  const std::string refused =
      ": another program wrote it meanwhile, so it is not replaced; run again with another name";
  EXPECT_TRUE(contains(message("a.csv", keep, nullptr, "theirs"), "a.csv" + refused));
  EXPECT_EQ(read_text_file(folder / "a.csv"), "theirs");
  // An empty file was there at the start.
  EXPECT_EQ(message("b.csv", keep, "", nullptr), "");
  EXPECT_TRUE(contains(message("c.csv", keep, "", "theirs"), "c.csv" + refused));
  // To be replaced, but by now it is of another kind.
  EXPECT_EQ(message("d.csv", {.kind = "text"}, "old", "theirs"), "");
  EXPECT_EQ(read_text_file(folder / "d.csv"), "mine");
  EXPECT_TRUE(contains(message("e.png", {.kind = "PNG"}, nullptr, "theirs"), "e.png" + refused));
  EXPECT_EQ(read_text_file(folder / "e.png"), "theirs");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 5);
}

TEST(OutputFile, OfTheSameNameHaveDifferentTemporaries) {
  const ScratchFolder folder;
  OutputFile one(folder / "a.csv"), two(folder / "a.csv");
  EXPECT_NE(one.temporary_path(), two.temporary_path());
  EXPECT_EQ(two.temporary_path().extension(), ".csv");
}

TEST(OutputFile, RoomIsForeseen) {
  const ScratchFolder folder;
  const auto refused = [&](std::initializer_list<std::uint64_t> files) {
    return refusal([&] { check_disk_space(folder / "r.h5", files); });
  };
  constexpr std::uint64_t kMega = 1'000'000, kExa = 1'000'000 * kMega * kMega;
  EXPECT_EQ(refused({kMega}), "");
  EXPECT_TRUE(contains(refused({kMega, kExa}),
                       "r.h5: at least 1e+12 MB will be written, and the "
                       "disk has room for "));
  rlimit old;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small = {3 * kMega, old.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_EQ(refused({2 * kMega, 2 * kMega}), "");
  EXPECT_TRUE(contains(
      refused({kMega, 4 * kMega}),
      "at least 4 MB will be written, and files must not be larger (ulimit -f) than 3 MB"));
  ::setrlimit(RLIMIT_FSIZE, &old);
}

TEST(OutputFile, NamesThatCanBeNoFileAreRefused) {
  const ScratchFolder folder;
  EXPECT_TRUE(contains(refusal([] { OutputFile{""}; }), "the name of the file to write is empty"));
  EXPECT_TRUE(contains(refusal([&] { OutputFile{folder / std::string(300, 'x')}; }),
                       "the name is too long for this disk; give a shorter one"));
}

}  // namespace
}  // namespace clast
