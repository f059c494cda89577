#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "mesh/point_cloud.hpp"
#include "tests/support/laz_bytes.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/variable.hpp"
#include "tests/support/working_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

struct ReadCloud {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> classes;
  CloudSummary summary;
};

ReadCloud read_batches(const CloudFile& file) {
  ReadCloud cloud;
  cloud.summary = file.stream([&](const PointBatch& batch) {
    cloud.points.insert(cloud.points.end(), batch.points.begin(), batch.points.end());
    cloud.classes.insert(cloud.classes.end(), batch.classes.begin(), batch.classes.end());
  });
  return cloud;
}

void expect_same(const ReadCloud& cloud, const ReadCloud& expected) {
  EXPECT_EQ(cloud.points, expected.points);
  EXPECT_EQ(cloud.classes, expected.classes);
  EXPECT_EQ(cloud.summary.withheld_points, expected.summary.withheld_points);
  EXPECT_EQ(cloud.summary.crs, expected.summary.crs);
}

/// Points of a slope, some with other classes, some withheld, with steps of all widths.
std::vector<LasPoint> slope_points(int count) {
  std::vector<LasPoint> points;
  Random random(3);
  for (int i = 0; i < count; ++i) {
    const double jump = i % 50 == 0 ? 1e9 : i % 7 == 0 ? 3e5 : 40.0;
    points.push_back({{static_cast<std::int32_t>(random.uniform(-jump, jump)),
                       static_cast<std::int32_t>(random.uniform(-jump, jump)),
                       static_cast<std::int32_t>(1000 - i + random.uniform(-jump, jump))},
                      static_cast<std::uint8_t>(i % 11 == 0   ? 5
                                                : i % 13 == 0 ? 7
                                                              : 2),
                      i % 17 == 3});
  }
  return points;
}

std::string slope_file(int count, int minor = 2, std::uint8_t format = 0,
                       std::size_t record_size = 20) {
  return las_file(minor, format, record_size, slope_points(count), Vec3(0.001, 0.002, 0.01),
                  Vec3(652000, 5203000, 0));
}

/// A folder that is PATH, with programs that each test puts there.
class Laz : public WorkingFolder {
 protected:
  void put_program(const std::string& name, const std::string& script) {
    write_text_file(programs_ / name, "#!/bin/sh\n" + script + "\n");
    fs::permissions(programs_ / name, fs::perms::owner_all);
  }
  /// cloud.las and a cloud.laz whose points no program can read.
  ReadCloud write_clouds(const std::string& las) {
    write_text_file("cloud.las", las);
    std::string packed = las;
    put<std::uint8_t>(packed, 104, static_cast<std::uint8_t>(las[104] | 0x80));
    write_text_file("cloud.laz", packed.substr(0, 600));
    return read_batches(CloudFile("cloud.las"));
  }
  std::string refused() const {
    return refusal([] { read_batches(CloudFile("cloud.laz")); });
  }

  ScratchFolder programs_;
  Variable path_{"PATH", programs_.path().string()};
};

/// Gives cloud.las where the arguments are those of LAStools.
const std::string kUnpack =
    "[ $# = 4 ] && [ \"$1\" = -i ] && [ \"$3 $4\" = '-stdout -olas' ] || exit 9\n"
    "file=${2%.laz}.las\n";

class LazPrograms : public Laz, public testing::WithParamInterface<const char*> {};

TEST_P(LazPrograms, GiveTheSameBitsAsTheLasFile) {
  const ReadCloud expected = write_clouds(slope_file(40000));
  put_program(GetParam(), kUnpack + "exec /bin/cat \"$file\"");
  const CloudFile file("cloud.laz");
  expect_same(read_batches(file), expected);
  // The copy is read now.
  fs::remove(programs_ / GetParam());
  expect_same(read_batches(file), expected);
  EXPECT_TRUE(contains(refused(), "at hand"));
}
INSTANTIATE_TEST_SUITE_P(Names, LazPrograms, testing::Values("laszip", "laszip64", "las2las"));

TEST_F(Laz, PdalMayWriteItsHeaderLast) {
  const ReadCloud expected = write_clouds(slope_file(5000, 4, 6, 30));
  put_program("pdal",
              "[ \"$1 $2 $3 $4 $5\" = 'translate --reader readers.las --writer writers.las' ] && "
              "[ \"$6\" = --writers.las.forward=all ] || exit 9\n"
              "file=${7%.laz}.las\n"
              "/bin/cat \"$file\" \"$file\" >\"$8\"\n"
              "/bin/dd if=\"$file\" of=\"$8\" conv=notrunc 2>/dev/null");
  expect_same(read_batches(CloudFile("cloud.laz")), expected);
}

TEST_F(Laz, WithoutRoomForACopyTheFileIsUnpackedAgain) {
  const ReadCloud expected = write_clouds(slope_file(40000));
  put_program("laszip", "echo . >>runs\n" + kUnpack + "exec /bin/cat \"$file\"");
  const CloudFile file("cloud.laz");
  struct rlimit before {};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  struct rlimit small = before;
  small.rlim_cur = 1000;
  ::setrlimit(RLIMIT_FSIZE, &small);
  expect_same(read_batches(file), expected);
  expect_same(read_batches(file), expected);
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_EQ(read_text_file("runs"), ".\n.\n");
}

TEST_F(Laz, AllWaysAreNamedWhereNoneIsAtHand) {
  write_clouds(slope_file(10));
  const std::string message = refused();
  EXPECT_TRUE(contains(message, "cloud.laz: its points are compressed (LAZ)"));
  for (const char* way : {"laszip", "laszip64", "las2las", "npm install -g laz-perf", "pdal"}) {
    EXPECT_TRUE(contains(message, way));
  }
}

TEST_F(Laz, TheNextProgramIsTriedWhereOneGivesNoPoints) {
  const ReadCloud expected = write_clouds(slope_file(100));
  put_program("laszip", "echo 'only version 1' >&2; exit 3");
  EXPECT_TRUE(
      contains(refused(), "could not be unpacked: laszip ended with code 3: only version 1"));
  put_program("laszip64", kUnpack + "exec /bin/cat \"${file%.las}.laz\"");
  EXPECT_TRUE(contains(refused(),
                       "only version 1; laszip64 gave no LAS file of its points: its "
                       "points are compressed"));
  put_program("las2las", kUnpack + "exec /bin/cat \"$file\"");
  expect_same(read_batches(CloudFile("cloud.laz")), expected);
}

TEST_F(Laz, OtherPointsThanTheFilesAreRefused) {
  write_clouds(slope_file(100));
  write_text_file("other.las", slope_file(99));
  put_program("laszip", "exec /bin/cat other.las");
  EXPECT_TRUE(contains(refused(), "its header says 99 points instead of 100"));
  write_text_file("other.las", las_file(2, 0, 20, slope_points(100), Vec3::Constant(0.01),
                                        Vec3(652000, 5203000, 0)));
  EXPECT_TRUE(contains(refused(), "another scale or offset"));
}

TEST_F(Laz, AProgramThatEndsEarlyIsReported) {
  const std::string las = slope_file(100);
  write_clouds(las);
  const std::string head = kUnpack + "/bin/dd if=\"$file\" bs=" + std::to_string(las.size() - 30) +
                           " count=1 2>/dev/null\n";
  put_program("laszip", head + "echo 'chunk 2 is bad' >&2; exit 1");
  EXPECT_TRUE(contains(refused(),
                       "cloud.laz: its header says 100 points, and 98 could be unpacked; "
                       "it was cut short or is damaged (laszip ended with code 1: chunk "
                       "2 is bad)"));
  put_program("laszip", head + "kill -9 $$");
  EXPECT_TRUE(contains(refused(), "laszip was ended by signal 9"));
  put_program("laszip", kUnpack + "/bin/cat \"$file\"; echo 'bad checksum' >&2; exit 1");
  EXPECT_TRUE(contains(refused(), "laszip ended with code 1: bad checksum"));
}

#ifdef CLAST_HAS_LAZ_PERF

/// Node is in PATH; the package laz-perf is not found unless a test says where.
class LazPerf : public Laz {
 protected:
  LazPerf() { fs::create_symlink(CLAST_NODE, programs_ / "node"); }
  void see_package() { fs::create_symlink(CLAST_NPM, "node_modules"); }
  /// Reads the LAS file and its LAZ file, packed in chunks.
  void expect_same_bits(const std::string& las, std::uint32_t chunk_size) {
    write_text_file("cloud.las", las);
    write_text_file("cloud.laz", packed_las(las, chunk_size));
    expect_same(read_batches(CloudFile("cloud.laz")), read_batches(CloudFile("cloud.las")));
  }
  std::string refused_bytes(const std::string& bytes) {
    write_text_file("cloud.laz", bytes);
    return refused();
  }
};

TEST_F(LazPerf, GivesTheSameBitsAsTheLasFile) {
  see_package();
  expect_same_bits(slope_file(20000), 50000);
  expect_same_bits(slope_file(20000), 1234);
  expect_same_bits(slope_file(1), 50000);
}

TEST_F(LazPerf, ReadsAllFormatsThatItKnows) {
  see_package();
  for (const auto& [minor, format, size] :
       {std::array{0, 0, 20}, std::array{1, 1, 28}, std::array{2, 2, 26}, std::array{2, 3, 34},
        std::array{4, 6, 30}, std::array{4, 7, 36}, std::array{4, 8, 38}}) {
    SCOPED_TRACE(format);
    const int extra_bytes = format % 2 == 0 ? 0 : 3;
    expect_same_bits(slope_file(60, minor, static_cast<std::uint8_t>(format),
                                static_cast<std::size_t>(size + extra_bytes)),
                     1);
  }
}

TEST_F(LazPerf, IsFoundWhereNpmKeepsGlobalPackages) {
  const std::string las = slope_file(100);
  write_text_file("cloud.laz", packed_las(las, 50));
  EXPECT_TRUE(contains(refused(), "npm install -g laz-perf"));
  put_program("npm", "[ \"$1 $2\" = 'root -g' ] && echo " CLAST_NPM);
  expect_same_bits(las, 50);
}

TEST_F(LazPerf, OtherFormatsAreRefusedByName) {
  see_package();
  std::string bytes = packed_las(slope_file(10, 3, 5, 63), 1);
  EXPECT_TRUE(contains(refused_bytes(bytes), "laz-perf can't unpack LAS point format 5"));
  bytes = packed_las(slope_file(10), 50);
  put<std::uint16_t>(bytes, bytes.find("laszip encoded") + 52, 1);
  EXPECT_TRUE(contains(refused_bytes(bytes), "laz-perf can't unpack compressor 1"));
  bytes = packed_las(slope_file(10), 50);
  bytes.replace(bytes.find("laszip encoded"), 14, "laszip renamed");
  EXPECT_TRUE(contains(refused_bytes(bytes), "no record of its compression"));
}

TEST_F(LazPerf, AFileCutShortIsRefused) {
  see_package();
  const std::string bytes = packed_las(slope_file(5000), 1000);
  ASSERT_EQ(refused_bytes(bytes), "");
  for (const std::size_t left : {bytes.size() - 30, bytes.size() / 2, std::size_t{500}}) {
    EXPECT_TRUE(contains(refused_bytes(bytes.substr(0, left)), "it was cut short")) << left;
  }
}

TEST_F(LazPerf, DamageNeverHangsOrCrashes) {
  see_package();
  const std::string bytes = packed_las(slope_file(300), 100);
  Random random(5);
  int refusals = 0;
  for (int i = 0; i < 12; ++i) {
    std::string damaged = bytes;
    for (int k = 0; k < 3; ++k) {
      damaged[random.uniform_index(damaged.size())] = static_cast<char>(random.uniform_index(256));
    }
    refusals += refused_bytes(damaged).empty() ? 0 : 1;
  }
  EXPECT_GT(refusals, 0);
}

#endif

}  // namespace
}  // namespace clast
