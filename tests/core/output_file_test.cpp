#include "core/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/error.hpp"
#include "core/text_file.hpp"
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

}  // namespace
}  // namespace clast
