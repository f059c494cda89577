#include "mesh/point_cloud.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "tests/mesh/cloud_files.hpp"
#include "tests/support/cloud_bytes.hpp"

namespace clast {
namespace {

TEST_F(Clouds, TextIsReadHoweverItIsSeparated) {
  const std::vector<Vec3> two = {{1.5, 2.5, 3.5}, {-4, 5e6, 0.25}};
  expect_points("a.xyz", "1.5 2.5 3.5\n-4 5e6 0.25\n", two);
  expect_points("a.txt", "1.5\t2.5\t3.5\t99\r\n-4\t5e6\t0.25\t99", two);
  expect_points("a.csv", "1.5,2.5,3.5,a\n-4, 5e6, 0.25, b\n", two);
  expect_points("b.csv", "1.5;2.5;3.5\n\n-4;5e6;0.25\n", two);
  expect_points("c.csv", "1,5;2,5;3,5\n-4;5e6;0,25\n", two);
  expect_points("d.txt", "1,5 2,5 3,5\n-4 5000000 0,25\n", two);
  expect_points("a.pts", "2\n1.5 2.5 3.5 -120 10 20 30\n-4 5e6 0.25 -80 1 2 3\n", two);
}

TEST_F(Clouds, HeadingsAndRemarksAreUnderstood) {
  const std::vector<Vec3> one = {{1, 2, 3}};
  expect_points("a.csv", "\xEF\xBB\xBF\"Z\",\"X\",\"Y\"\n3,1,2\n", one);
  expect_points("b.csv", "id;x_m;y_m;z [m]\n7;1;2;3\n", one);
  expect_points("c.xyz", "//X Y Z R G B\n# a remark\n1 2 3 255 255 255\n", one);
  expect_points("d.txt", "easting northing height\n1 2 3\n", one);
  expect_points("e.csv", "PointID,Northing,Easting,Elevation_m\n7,2,1,3\n", one);
  expect_points("f.csv", "Nr;E;N;H;code\n7;1;2;3;4\n", one);
  expect_points("h.xyz", "1 2 3\n1,5 2,25 3\n", {{1, 2, 3}, {1.5, 2.25, 3}});
  expect_points("i.csv", "x;y;z;q\n1;2;3;;\n", one);
  expect_points("g.txt", "scan of May\nsite: quarry\nby hand\nid y x z\n7 2 1 3\n", one);
}

TEST_F(Clouds, WordsOfPcdHaveAnyCase) {
  for (const char* fields : {"FIELDS X Y Z", "FIELDS x Y z", "fields X Y Z", "Fields x y z"}) {
    for (const char* data : {"DATA ascii", "data ASCII", "DATA Ascii"}) {
      expect_points("a.pcd",
                    std::string("VERSION 0.7\n") + fields +
                        "\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n" +
                        data + "\n1 2 3\n",
                    {{1, 2, 3}});
    }
  }
}

TEST_F(Clouds, TextThatIsNoneOfPointsIsRefusedByName) {
  using namespace std::string_literals;
  EXPECT_TRUE(contains(
      refused("a.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n4 5 6\n"),
      "is an Esri grid of heights, not a point cloud"));
  EXPECT_TRUE(
      contains(refused("b.csv", "\xFF\xFEX\0;\0Y\0;\0Z\0\r\0\n\0"s), "text in UTF-16; save it as"));
}

TEST_F(Clouds, SeveralScansOfAFileFollowEachOther) {
  expect_points("a.pts", "2\n1 2 3 17\n4 5 6 17\n1\n7 8 9 17\n", {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  expect_points("b.pts", "1\r\n1 2 3 -5 1 2 3\r\n2 \r\n4 5 6 -5 1 2 3\r\n7 8 9 1 2 3 4\r\n",
                {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  EXPECT_TRUE(contains(refused("f.pts", "5\n1 2 3\n4 5 6\n"),
                       "5 points are announced before a scan, but 2 follow"));
  EXPECT_TRUE(contains(refused("g.pts", "1\n1 2 3\n4 5 6\n"), "but 2 follow"));
  EXPECT_EQ(read("g.xyz", "2024\n1 2 3\n4 5 6\n").size(), 2u) << "a title";
  // A number alone that counts nothing is a line cut short.
  EXPECT_TRUE(
      contains(refused("c.pts", "3\n1 2 3\n4 5 6\n1\n7 8 9\n"), "line 4: fewer than three"));
  EXPECT_TRUE(contains(refused("d.xyz", "1 2 3\n4\n7 8 9\n"), "line 2: fewer than three"));
}

TEST_F(Clouds, TextLongerThanAReadingBlockLosesNothing) {
  std::string text;
  std::vector<Vec3> expected;
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    expected.emplace_back(random.uniform(-1e4, 1e4), i, -i);
    text += std::to_string(expected.back().x());
    expected.back().x() = std::stod(text.substr(text.rfind('\n') + 1));
    text += ' ' + std::to_string(i) + ' ' + std::to_string(-i) + '\n';
  }
  const std::vector<Vec3> points = read("long.xyz", text);
  EXPECT_EQ(points, expected);
}

TEST_F(Clouds, BadTextIsRefusedByLine) {
  EXPECT_TRUE(contains(refused("a.xyz", "1 2 3\n1 2\n"), "a.xyz: line 2: fewer than three"));
  EXPECT_TRUE(contains(refused("b.xyz", "1 2 3\n\n1 x 3\n"),
                       "line 3: \"x\" is not a number, where y is needed"));
  EXPECT_TRUE(contains(refused("c.xyz", ""), "c.xyz: holds no points: the file is empty"));
  EXPECT_TRUE(contains(refused("n.xyz", "nan 1 2\nnan 1 2\n"),
                       "2 have a coordinate that is not finite; export it again"));
  EXPECT_TRUE(contains(refused("d.xyz", "# nothing\n"), "holds no points"));
  EXPECT_TRUE(contains(refused("e.xyz", "1 2 3\n1 2 1,5,2\n"), "line 2: \"1,5,2\""));
  // Decimal commas between commas: (1.5, 2.5, 3.5).
  EXPECT_TRUE(contains(refused("e.csv", "x,y,z\n1,5,2,5,3,5\n"),
                       "line 2: has 6 fields, but line 1 has 3; where commas are decimal signs"));
  EXPECT_TRUE(contains(refused("e.csv", "1,2,3\n1,5,2,5,3,5\n"), "line 2: has 6 fields"));
  EXPECT_TRUE(contains(refused("e.csv", "id;x;y;z\n7;1;2;3\n8;;2;3\n"),
                       "line 3: the field for x is empty"));
  EXPECT_TRUE(
      contains(refused("f.xyz", std::string(3 << 20, 'x')), "line 1: is longer than a megabyte"));
  EXPECT_TRUE(contains(refusal([&] { read_cloud(folder / "none.xyz"); }), "no such file"));
  EXPECT_TRUE(contains(refusal([&] { read_cloud(folder.path()); }), "folder"));
}

TEST_F(Clouds, PointsWithoutPlaceAreCounted) {
  write_text_file(folder / "nan.xyz", "1 2 3\nnan nan nan\n4 5 6\n1 inf 3\n");
  const CloudSummary summary = stream_cloud(folder / "nan.xyz", [](const PointBatch&) {});
  EXPECT_EQ(summary.point_count, 2u);
  EXPECT_EQ(summary.non_finite_points, 2u);
}

class LasVersions : public testing::TestWithParam<std::array<int, 3>> {};

TEST_P(LasVersions, GivePointsClassesAndSystem) {
  const auto [minor, format, size] = GetParam();
  ScratchFolder folder;
  const Vec3 scale(0.001, 0.01, 0.001), offset(652000, 5203000, 0);
  // One more byte per record than the format needs: extra bytes are allowed.
  write_text_file(
      folder / "a.las",
      las_file(minor, static_cast<std::uint8_t>(format), static_cast<std::size_t>(size) + 1,
               {{{1250, -75, 789123}, 2}, {{0, 0, 1}, 5}, {{1, 1, 1}, 7}, {{2, 2, 2}, 2, true}},
               scale, offset));
  std::vector<Vec3> points;
  std::vector<std::uint8_t> classes;
  const CloudSummary summary = stream_cloud(folder / "a.las", [&](const PointBatch& batch) {
    points.insert(points.end(), batch.points.begin(), batch.points.end());
    classes.insert(classes.end(), batch.classes.begin(), batch.classes.end());
  });
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT((points[0] - Vec3(652001.25, 5202999.25, 789.123)).norm(), 1e-8);
  EXPECT_LT((points[1] - Vec3(652000, 5203000, 0.001)).norm(), 1e-8);
  EXPECT_EQ(classes, (std::vector<std::uint8_t>{2, 5}));
  EXPECT_EQ(summary.point_count, 2u);
  EXPECT_EQ(summary.withheld_points, 2u);  // one flagged, one of class noise
  EXPECT_EQ(summary.crs, "EPSG:25832");
}
INSTANTIATE_TEST_SUITE_P(Formats, LasVersions,
                         testing::Values(std::array{0, 0, 20}, std::array{1, 1, 28},
                                         std::array{2, 2, 26}, std::array{2, 3, 34},
                                         std::array{3, 5, 63}, std::array{4, 6, 30},
                                         std::array{4, 7, 36}, std::array{4, 10, 67}));

TEST_F(Clouds, DamagedLasIsRefused) {
  const std::string good =
      las_file(2, 0, 20, {{{1, 2, 3}}, {{4, 5, 6}}}, Vec3::Ones(), Vec3::Zero());
  ASSERT_EQ(read("good.las", good).size(), 2u);
  EXPECT_TRUE(contains(refused("cut.las", good.substr(0, good.size() - 1)),
                       "cut.las: its header says 2 points, the file has 1"));
  EXPECT_TRUE(contains(refused("short.las", good.substr(0, 100)), "ends within"));
  EXPECT_TRUE(contains(refused("other.las", "ply\n"), "does not start with LASF"));
  std::string bad = good;
  put<double>(bad, 131, 0.0);
  EXPECT_TRUE(contains(refused("scale.las", bad), "scale"));
  bad = good;
  put<std::uint8_t>(bad, 104, 11);
  EXPECT_TRUE(contains(refused("format.las", bad), "point format 11"));
  bad = good;
  put<std::uint16_t>(bad, 105, 12);
  EXPECT_TRUE(contains(refused("record.las", bad), "12 bytes"));
  bad = good;
  put<std::uint32_t>(bad, 96, 4000000000u);
  EXPECT_TRUE(contains(refused("offset.las", bad), "outside the file"));
}

TEST_F(Clouds, PcdInItsThreeForms) {
  const std::vector<Vec3> two = {{1, 2, 3.1}, {4, 5, 6}};
  expect_points("a.pcd", kPcdHeader + "DATA ascii\n1 2 3.1 7\n4 5 6 7\nnan nan 0 7\n", two);
  expect_points("b.pcd", kPcdHeader + "DATA binary\n" + pcd_points(false), two);

  expect_points("c.pcd", packed_pcd(), two);
}

TEST_F(Clouds, DamagedPcdIsRefused) {
  EXPECT_TRUE(contains(refused("a.pcd", kPcdHeader), "no DATA line"));
  EXPECT_TRUE(contains(refused("b.pcd", kPcdHeader + "DATA ascii\n1 2 3 7\n"), "2 are missing"));
  EXPECT_TRUE(contains(refused("c.pcd", kPcdHeader + "DATA ascii\n1 2 x 7\n"), "number is needed"));
  EXPECT_TRUE(
      contains(refused("d.pcd", kPcdHeader + "DATA ascii\n1 2 3\n4 5 6\n"), "fewer values"));
  EXPECT_TRUE(contains(refused("e.pcd", kPcdHeader + "DATA binary\n" + std::string(40, 'x')),
                       "the file has 2"));
  EXPECT_TRUE(contains(refused("f.pcd", kPcdHeader + "DATA zip\n"), "\"zip\""));
  EXPECT_TRUE(contains(refused("g.pcd",
                               "FIELDS x y\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\nPOINTS 1\n"
                               "DATA ascii\n1 2\n"),
                       "has no field z"));
  EXPECT_TRUE(contains(refused("h.pcd", "FIELDS x y z\nPOINTS -4\nDATA ascii\n"), "can't be"));
  std::string file = kPcdHeader + "DATA binary_compressed\n";
  put(file, file.size(), std::uint32_t{3});
  put(file, file.size(), std::uint32_t{60});
  EXPECT_TRUE(contains(refused("i.pcd", file + "\x60\x05\x05"), "corrupt"));
}

TEST_F(Clouds, VerticesOfAMeshArePoints) {
  expect_points("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                "property double z\nproperty uchar red\nend_header\n1 2 3 9\n4 5 6 9\n",
                {{1, 2, 3}, {4, 5, 6}});
}

TEST_F(Clouds, MutatedFilesNeverCrash) {
  const std::vector<std::pair<std::string, std::string>> seeds = {
      {"f.las", las_file(4, 6, 30, {{{1, 2, 3}}, {{4, 5, 6}}}, Vec3::Ones(), Vec3::Zero())},
      {"f.pcd", kPcdHeader + "DATA binary\n" + pcd_points(false)},
      {"old.las", las_file(2, 0, 20, {{{1, 2, 3}}, {{4, 5, 6}}}, Vec3::Ones(), Vec3::Zero())},
      {"text.pcd", kPcdHeader + "DATA ascii\n1 2 3.1 7\n4 5 6 7\n"},
      {"packed.pcd", packed_pcd()},
      {"f.ply",
       "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
       "property double z\nend_header\n1 2 3\n4 5 6\n"},
      {"f.csv", "id;x;y;z\n1;1,5;2,5;3,5\n2;4,0;5,0;6,0\n"},
      {"f.xyz", "x y z\n1.5 2.5 3.5\n4 5 6\n"}};
  Random random(5);
  int refused_count = 0;
  for (const auto& [name, good] : seeds) {
    for (int i = 0; i < 500; ++i) {
      std::string bad = good;
      for (int k = 0; k < 3; ++k) {
        bad[static_cast<std::size_t>(random.uniform(0.0, 0.999) *
                                     static_cast<double>(bad.size()))] =
            static_cast<char>(random.uniform(0.0, 255.9));
      }
      if (i % 3 == 0)
        bad.resize(
            static_cast<std::size_t>(random.uniform(0.0, 1.0) * static_cast<double>(bad.size())));
      std::ofstream(folder / name, std::ios::binary) << bad;  // no wait for the disk
      try {
        read_cloud(folder / name);
      } catch (const InputError& error) {
        ++refused_count;
        EXPECT_TRUE(contains(error.what(), name));
      }
    }
  }
  EXPECT_GT(refused_count, 1000);
}

}  // namespace
}  // namespace clast
