#include "core/files/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/error.hpp"
#include "core/files/hdf5_file.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

// Reading a pipe would wait for a writer that never comes.
TEST(InputFile, PipesDevicesAndFoldersAreRefused) {
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const std::filesystem::path& path : {folder / "pipe", std::filesystem::path("/dev/zero")}) {
    EXPECT_TRUE(contains(refusal([&] { check_input_file(path); }), "is a pipe or a device"));
    EXPECT_TRUE(contains(refusal([&] { read_text_file(path); }), "is a pipe or a device"));
    EXPECT_TRUE(contains(refusal([&] { Hdf5File::open(path, "x", 1); }), "is a pipe or a device"));
  }
  EXPECT_TRUE(contains(refusal([&] { check_input_file(folder / "none"); }), "no such file"));
  EXPECT_TRUE(contains(refusal([&] { check_input_file(folder.path()); }), "is a folder"));
  write_text_file(folder / "a", "text");
  EXPECT_EQ(refusal([&] { check_input_file(folder / "a"); }), "");
}

}  // namespace
}  // namespace clast
