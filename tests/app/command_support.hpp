#pragma once
/// What the tests of the commands share.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scan_files.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/working_folder.hpp"

namespace clast {

namespace fs = std::filesystem;

/// A failed command: exit code, a message that begins as all do and names `item`, nothing written.
inline void expect_refused(const ScratchFolder& folder, const std::vector<std::string>& arguments,
                           int code, const std::string& item) {
  const std::set<std::string> before = names_in(folder.path());
  const ProgramRun run = run_clast(arguments, folder.path());
  EXPECT_EQ(run.exit_code, code) << run.err;
  EXPECT_TRUE(run.err.starts_with("clast: ")) << run.err;
  EXPECT_TRUE(contains(run.err, item)) << run.err;
  EXPECT_EQ(names_in(folder.path()), before);
}

}  // namespace clast
