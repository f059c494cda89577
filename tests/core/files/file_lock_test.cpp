#include "core/files/file_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/as_nobody.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

std::size_t entries(const ScratchFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), {}));
}

// Reading, adding one and renaming loses counts where two hold the lock at once: the lock file is
// made and removed some thousand times meanwhile.
TEST(FileLock, OfManyProcessesOneHasIt) {
  constexpr int kProcesses = 6, kRounds = 300;
  const ScratchFolder folder;
  const fs::path count = folder / "count";
  write_text_file(count, "0");
  std::vector<pid_t> children;
  for (int p = 0; p < kProcesses; ++p) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int i = 0; i < kRounds; ++i) {
        const FileLock lock(count);
        write_text_file(count, std::to_string(std::stoi(read_text_file(count)) + 1));
      }
      ::_exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(read_text_file(count), std::to_string(kProcesses * kRounds));
  EXPECT_EQ(entries(folder), 1u) << "the lock file stays behind";
}

TEST(FileLock, IsWaitedForWithAWordAndNotForEver) {
  const ScratchFolder folder;
  const fs::path file = folder / "blocks.h5";
  int said = 0;
  FileLockOptions options{.timeout = std::chrono::milliseconds(60), .on_wait = [&] { ++said; }};
  {
    const FileLock held(file);
    EXPECT_TRUE(fs::exists(FileLock::lock_path(file)));
    const std::string message = refusal([&] { FileLock(file, options); });
    EXPECT_TRUE(contains(message, "blocks.h5: another program is writing to it; wait"));
    EXPECT_EQ(said, 1);
  }
  FileLock(file, options);
  EXPECT_EQ(said, 1);
  std::thread release;
  {
    auto held = std::make_unique<FileLock>(file);
    options.timeout = std::chrono::seconds(60);
    release = std::thread([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      held.reset();
    });
    FileLock(file, options);
    release.join();
  }
  EXPECT_EQ(said, 2);
  EXPECT_EQ(entries(folder), 0u);
}

TEST(FileLock, OfAKilledProcessIsFree) {
  const ScratchFolder folder;
  const fs::path file = folder / "blocks.h5";
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const FileLock lock(file);
    if (::write(ready[1], "r", 1) == 1) ::pause();
    ::_exit(0);
  }
  char byte;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(FileLock::lock_path(file)));
  EXPECT_EQ(refusal([&] { FileLock(file, {.timeout = {}}); }), "");
  EXPECT_FALSE(fs::exists(FileLock::lock_path(file)));
}

TEST(FileLock, IsTheSameByEveryNameOfTheFile) {
  const ScratchFolder folder;
  write_text_file(folder / "real.h5", "");
  fs::create_symlink("real.h5", folder / "link.h5");
  const FileLock held(folder / "link.h5");
  EXPECT_FALSE(refusal([&] { FileLock(folder / "real.h5", {.timeout = {}}); }).empty());
}

TEST(FileLock, LeftByAnotherUserMayBeReadOnly) {
  const ScratchFolder folder;
  const fs::path file = folder / "blocks.h5", lock = FileLock::lock_path(file);
  fs::permissions(folder.path(), fs::perms::all);
  write_text_file(lock, "");
  fs::permissions(lock, fs::perms(0444));
  {
    const AsNobody nobody;
    EXPECT_EQ(refusal([&] {
                const FileLock held(file, {.timeout = {}});
                EXPECT_TRUE(contains(refusal([&] { FileLock(file, {.timeout = {}}); }),
                                     "another program is writing to it"));
              }),
              "");
  }
  EXPECT_FALSE(fs::exists(lock));
  write_text_file(lock, "");
  fs::permissions(lock, fs::perms::none);
  const AsNobody nobody;
  EXPECT_TRUE(contains(refusal([&] { FileLock(file, {.timeout = {}}); }),
                       ".blocks.h5.lock: can't be opened (Permission denied), so "));
  EXPECT_TRUE(contains(refusal([&] { FileLock(file, {.timeout = {}}); }),
                       "delete this lock file, or have its owner delete it"));
}

TEST(FileLock, ThatCantBeMadeIsNamed) {
  const ScratchFolder folder;
  write_text_file(folder / "file", "");
  EXPECT_TRUE(contains(refusal([&] { FileLock(folder / "file" / "blocks.h5"); }),
                       ".blocks.h5.lock: can't be made"));
}

}  // namespace
}  // namespace clast
