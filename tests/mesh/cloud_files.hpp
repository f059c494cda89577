#pragma once
/// Clouds that tests write and read.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/files/text_file.hpp"
#include "mesh/point_cloud.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

class Clouds : public testing::Test {
 protected:
  std::vector<Vec3> read(const std::string& name, const std::string& content) {
    write_text_file(folder / name, content);
    return read_cloud(folder / name);
  }
  std::string refused(const std::string& name, const std::string& content) {
    write_text_file(folder / name, content);
    return refusal([&] { read_cloud(folder / name); });
  }
  void expect_points(const std::string& name, const std::string& content,
                     const std::vector<Vec3>& expected) {
    const std::vector<Vec3> points = read(name, content);
    ASSERT_EQ(points.size(), expected.size()) << content;
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], expected[i]) << content;
  }
  ScratchFolder folder;
};

}  // namespace clast
