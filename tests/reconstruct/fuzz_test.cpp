/// Files of every mesh format, cut short and with bytes changed: each gives a sound block or an
/// error that names the file, in bounded time.
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <iostream>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "mesh/self_intersection.hpp"
#include "reconstruct/field_scan.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/fuzzing.hpp"
#include "tests/support/mesh_bytes.hpp"

namespace clast {
namespace {

/// Of the files after so many, each so-manieth goes the way of a field scan, with a search for
/// ground.
constexpr std::uint64_t kMany = 100, kFieldScans = 5;

/// What `reconstruct` makes of the file.
TriangleMesh block_of(const std::filesystem::path& path, bool field_scan) {
  return field_scan ? read_field_scan(path).blocks[0].scan.mesh : read_scan(path).mesh;
}

class MutatedFiles : public testing::TestWithParam<std::size_t> {};

TEST_P(MutatedFiles, GiveASoundBlockOrAnErrorThatNamesThem) {
  const MeshFile file = mesh_files(random_rock(2, 2, 0.05)).at(GetParam());
  const ScratchFolder folder;
  write_text_file(folder / file.name, file.bytes);
  ASSERT_TRUE(inspect_mesh(read_scan(folder / file.name).mesh).is_closed()) << file.name;
  std::size_t blocks = 0, refusals = 0;
  double longest = 0.0;
  FuzzNumbers numbers(file.name, 30);
  while (const std::optional<std::uint64_t> number = numbers.next()) {
    SCOPED_TRACE(file.name + " number " + std::to_string(*number));
    write_text_file(folder / file.name, mutated_file(file.name, file.bytes, *number));
    const std::clock_t begin = std::clock();
    try {
      const bool field_scan = *number > kMany && *number % kFieldScans == 0;
      const TriangleMesh mesh = block_of(folder / file.name, field_scan);
      const MeshReport report = inspect_mesh(mesh);
      EXPECT_TRUE(report.is_closed() && report.is_oriented() && report.pinched_vertices == 0)
          << report.summary();
      EXPECT_TRUE(find_self_intersections(mesh).empty());
      ++blocks;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(file.name), std::string::npos) << error.what();
      ++refusals;
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, kMaxFuzzSeconds);
    longest = std::max(longest, seconds);
  }
  std::cout << file.name << ": " << blocks << " blocks, " << refusals << " refusals, longest "
            << longest << " s\n";
}

INSTANTIATE_TEST_SUITE_P(Formats, MutatedFiles, testing::Range<std::size_t>(0, 10));

}  // namespace
}  // namespace clast
