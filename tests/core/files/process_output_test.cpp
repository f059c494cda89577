#include "core/files/process_output.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "core/files/unnamed_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/variable.hpp"

namespace clast {
namespace {

using Target = ProcessOutput::Target;

std::vector<std::string> shell(const std::string& script) { return {"/bin/sh", "-c", script}; }

std::string read_all(ProcessOutput& output) {
  std::string text(100, '\0'), all;
  for (std::size_t got; (got = output.read(text.data(), text.size())) > 0;) {
    all.append(text, 0, got);
  }
  return all;
}

class ProcessOutputs : public testing::TestWithParam<bool> {
 protected:
  static Target target() { return GetParam() ? Target::kFile : Target::kPipe; }
};

TEST_P(ProcessOutputs, GiveAllThatIsWritten) {
  ProcessOutput output(shell("i=0; while [ $i -lt 3000 ]; do echo line $i; i=$((i+1)); done"),
                       target(), 60.0);
  std::string expected;
  for (int i = 0; i < 3000; ++i) expected += "line " + std::to_string(i) + "\n";
  EXPECT_EQ(read_all(output), expected);
  EXPECT_EQ(output.wait(), 0);
  EXPECT_EQ(output.last_words(), "");
}

TEST_P(ProcessOutputs, TellHowTheProgramEnded) {
  ProcessOutput failed(shell("echo part; echo first >&2; echo 'no memory' >&2; exit 7"), target(),
                       60.0);
  EXPECT_EQ(read_all(failed), "part\n");
  EXPECT_EQ(failed.wait(), 7);
  EXPECT_EQ(failed.last_words(), "no memory");
  ProcessOutput killed(shell("kill -KILL $$"), target(), 60.0);
  EXPECT_EQ(killed.wait(), 128 + SIGKILL);
  ProcessOutput missing({"/nowhere/program"}, target(), 60.0);
  EXPECT_EQ(missing.wait(), 127);
}

TEST_P(ProcessOutputs, AreStoppedWhenTheyFallSilent) {
  ProcessOutput output(shell("echo part; sleep 100"), target(), 0.3);
  EXPECT_TRUE(contains(refusal([&] { read_all(output); }), "gave no output for 0.3 s"));
  EXPECT_EQ(output.wait(), 128 + SIGKILL);
  ProcessOutput closed(shell("exec >&-; sleep 100"), target(), 0.3);
  EXPECT_TRUE(contains(refusal([&] { closed.wait(); }), "gave no output"));
}

INSTANTIATE_TEST_SUITE_P(Targets, ProcessOutputs, testing::Bool());

TEST(ProcessOutput, OfAFileMayBeWrittenInAnyOrder) {
  const std::string script =
      "printf '....points' >/dev/stdout; printf head | dd of=/dev/stdout conv=notrunc 2>/dev/null";
  ProcessOutput output(shell(script), Target::kFile, 60.0);
  EXPECT_EQ(read_all(output), "headpoints");
}

TEST(ProcessOutput, EndsWithItsChildren) {
  ScratchFolder folder;
  const std::string beat = (folder / "beat").string();
  {
    ProcessOutput output(shell("(while :; do echo . >>" + beat + "; sleep 0.01; done) & wait"),
                         Target::kPipe, 60.0);
    while (!std::filesystem::exists(beat)) std::this_thread::yield();
  }
  const auto size = std::filesystem::file_size(beat);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_EQ(std::filesystem::file_size(beat), size);
}

TEST(UnnamedFile, LeavesNoName) {
  ScratchFolder folder;
  const Variable temporary("TMPDIR", folder.path().string());
  const UnnamedFile file;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(UnnamedFile, IsRefusedWithoutAFolder) {
  const Variable temporary("TMPDIR", "/nowhere");
  EXPECT_TRUE(contains(refusal([] { UnnamedFile(); }), "set TMPDIR to one that can"));
}

}  // namespace
}  // namespace clast
