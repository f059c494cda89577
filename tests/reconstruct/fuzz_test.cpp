/// Files of every mesh format, cut short and with bytes changed: each gives a sound block or an
/// error that names the file, in bounded time.
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <iostream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text_file.hpp"
#include "reconstruct/field_scan.hpp"
#include "shapes/self_intersection.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/mesh_bytes.hpp"

namespace clast {
namespace {

/// CPU seconds that one file may take; sanitizers cost a factor of five to ten.
#ifdef __SANITIZE_ADDRESS__
constexpr double kMostSeconds = 10.0;
#else
constexpr double kMostSeconds = 2.0;
#endif
/// Of many files, each so-manieth goes the way of a field scan, with a search for ground.
constexpr int kMany = 100, kFieldScans = 5;

/// What `reconstruct` makes of the file.
TriangleMesh block_of(const std::filesystem::path& path, bool field_scan) {
  return field_scan ? read_field_scan(path).blocks[0].scan.mesh : read_scan(path).mesh;
}

std::string mutated(const std::string& sound, Random& random) {
  std::string bytes = sound;
  const auto somewhere = [&] { return static_cast<std::size_t>(random.below(bytes.size())); };
  const std::size_t times = 1 + random.below(4);
  for (std::size_t i = 0; i < times && !bytes.empty(); ++i) {
    const std::size_t place = somewhere();
    const std::size_t length = std::min<std::size_t>(1 + random.below(60), bytes.size() - place);
    switch (random.below(9)) {
      case 0:
        bytes.resize(place);
        break;
      case 1:
        bytes[place] = static_cast<char>(random.below(256));
        break;
      case 2:
        for (std::size_t k = 0; k < length; ++k) {
          bytes[place + k] = static_cast<char>(random.below(256));
        }
        break;
      case 3:
        bytes.erase(place, length);
        break;
      case 4:
        bytes.insert(place, bytes.substr(somewhere(), length));
        break;
      case 5: {
        const char* const words[] = {"nan", "1e308", "-1", "99999999999", " ", "\n", "inf", "0"};
        bytes.insert(place, words[random.below(std::size(words))]);
        break;
      }
      default:  // other numbers in a file that is sound as such, so that the repair has work
        for (std::size_t k = 0; k < length; ++k) {
          char& byte = bytes[somewhere()];
          if (byte >= '0' && byte <= '9') byte = static_cast<char>('0' + random.below(10));
        }
    }
  }
  return bytes;
}

class MutatedFiles : public testing::TestWithParam<std::size_t> {};

TEST_P(MutatedFiles, GiveASoundBlockOrAnErrorThatNamesThem) {
  const MeshFile file = mesh_files(random_rock(2, 2, 0.05)).at(GetParam());
  const ScratchFolder folder;
  write_text_file(folder / file.name, file.bytes);
  ASSERT_TRUE(inspect(read_scan(folder / file.name).mesh).closed()) << file.name;
  Random random(11 + GetParam());
  std::size_t blocks = 0, refusals = 0;
  double longest = 0.0;
  for (int i = 0; i < CLAST_FUZZ_FILES; ++i) {
    SCOPED_TRACE(file.name + " number " + std::to_string(i));
    const std::string bytes = mutated(file.bytes, random);
    write_text_file(folder / file.name, bytes);
    const std::clock_t begin = std::clock();
    try {
      const bool field_scan = CLAST_FUZZ_FILES > kMany && i % kFieldScans == 0;
      const TriangleMesh mesh = block_of(folder / file.name, field_scan);
      const MeshReport report = inspect(mesh);
      EXPECT_TRUE(report.closed() && report.oriented() && report.pinched_vertices == 0)
          << report.summary();
      EXPECT_TRUE(crossing_triangles(mesh).empty());
      ++blocks;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(file.name), std::string::npos) << error.what();
      ++refusals;
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, kMostSeconds);
    longest = std::max(longest, seconds);
  }
  std::cout << file.name << ": " << blocks << " blocks, " << refusals << " refusals, longest "
            << longest << " s\n";
}

INSTANTIATE_TEST_SUITE_P(Formats, MutatedFiles, testing::Range<std::size_t>(0, 10));

}  // namespace
}  // namespace clast
