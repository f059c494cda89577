#pragma once
/// Tests that name files as a user does: without a folder.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "tests/support/scratch_folder.hpp"

namespace clast {

inline std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename());
  }
  return names;
}

/// The process works in the test's own folder meanwhile.
class WorkingFolder : public testing::Test {
 protected:
  WorkingFolder() { std::filesystem::current_path(folder.path()); }
  ~WorkingFolder() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();

 protected:
  ScratchFolder folder;
};

}  // namespace clast
