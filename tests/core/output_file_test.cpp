#include "core/output_file.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace clast
