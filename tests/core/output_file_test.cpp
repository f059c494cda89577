#include "core/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(OutputFile, WithoutCommitTheOldFileStaysAndNothingIsLeft) {
  const ScratchFolder folder;
  write_text_file(folder / "a.csv", "old");
  {
    OutputFile file(folder / "a.csv");
    std::ofstream(file.temporary()) << "half";
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
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  EXPECT_TRUE(contains(refusal([&] { OutputFile{folder / "a"}; }), "mend the link"));
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
  constexpr uid_t kNobody = 65534;  // root may write to anything
  const bool root = ::geteuid() == 0;
  if (root) {
    ASSERT_EQ(::seteuid(kNobody), 0);
  }
  const std::string message = refusal([&] { OutputFile{folder / "a.csv"}; });
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_TRUE(contains(message, "a.csv: is write-protected; allow writing to it"));
}

TEST(OutputFile, NamesThatCanBeNoFileAreRefused) {
  const ScratchFolder folder;
  EXPECT_TRUE(contains(refusal([] { OutputFile{""}; }), "the name of the file to write is empty"));
  EXPECT_TRUE(contains(refusal([&] { OutputFile{folder / std::string(300, 'x')}; }),
                       "the name is too long for this disk; give a shorter one"));
}

}  // namespace
}  // namespace clast
