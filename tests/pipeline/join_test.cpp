// Several scans of one block: how they are listed, and what is picked in them.
#include <gtest/gtest.h>

#include <fstream>

#include "core/files/text_file.hpp"
#include "library/block_library.hpp"
#include "pipeline/picked_pairs_file.hpp"
#include "pipeline/scan_batch.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/partial_scans.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/scan_files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class JoinedScans : public testing::Test {
 protected:
  std::string add(const std::string& name) {
    std::filesystem::create_directories((folder / name).parent_path());
    write_obj(folder / name, cuboid(1, 0.8, 0.6));
    return (folder / name).string();
  }
  std::filesystem::path write(const std::string& text) {
    write_text_file(folder / "picked.csv", text);
    return folder / "picked.csv";
  }

  ScratchFolder folder;
};

TEST_F(JoinedScans, KeepTheirOrderSinceTheFirstGivesTheFrame) {
  const std::string b = add("b.obj"), a = add("a.obj");
  const ScanFile joined = list_joined_scans({b, a}, "B017");
  EXPECT_EQ(joined.id, "B017");
  ASSERT_EQ(joined.paths().size(), 2u);
  EXPECT_EQ(joined.paths()[0], b);
  EXPECT_EQ(joined.paths()[1], a);
}

TEST_F(JoinedScans, AreTwoToEightDifferentScans) {
  const std::string a = add("a.obj");
  EXPECT_TRUE(contains(refusal([&] { list_joined_scans({a}, "B"); }), "two to eight"));
  EXPECT_TRUE(contains(refusal([&] { list_joined_scans({a, a}, "B"); }), "given twice"));
  std::vector<std::string> nine;
  for (int i = 0; i < 9; ++i) nine.push_back(add("n" + std::to_string(i) + ".obj"));
  EXPECT_TRUE(contains(refusal([&] { list_joined_scans(nine, "B"); }), "9 scans"));
}

TEST_F(JoinedScans, OfFoldersHaveTheNamesOfTheFolders) {
  for (const char* name : {"all/B1/1.obj", "all/B1/2.obj", "all/B2/1.obj"}) add(name);
  const std::vector<ScanFile> joined = list_joined_folders({(folder / "all").string()});
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(joined[0].id, "B1");
  EXPECT_EQ(joined[0].others.size(), 1u);
  EXPECT_EQ(joined[1].id, "B2");
  EXPECT_TRUE(joined[1].others.empty());
}

TEST_F(JoinedScans, PickedPlacesAreReadWithAndWithoutHeading) {
  for (const char* heading : {"", "scan_a,x,y,z,scan_b,x,y,z\n"}) {
    const auto pairs =
        read_picked_pairs(write(std::string(heading) + "top,1,2,3,bottom,4,5,6.5\n"));
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].scan_a, "top");
    EXPECT_EQ(pairs[0].point_a, Vec3(1, 2, 3));
    EXPECT_EQ(pairs[0].scan_b, "bottom");
    EXPECT_EQ(pairs[0].point_b, Vec3(4, 5, 6.5));
  }
}

TEST_F(JoinedScans, PickedPlacesOfAnotherFormAreRefused) {
  const auto said = [&](const std::string& text) {
    return refusal([&] { read_picked_pairs(write(text)); });
  };
  EXPECT_TRUE(contains(said("top,1,2,3,bottom,4,5\n"), "expected scan_a, x, y, z"));
  EXPECT_TRUE(contains(said("top,1,2,3,bottom,4,five,6\n"), "\"five\" is not a coordinate"));
  EXPECT_TRUE(contains(said("scan_a,x,y,z,scan_b,x,y,z\n"), "holds no picked places"));
}

TEST_F(JoinedScans, OfOneBlockAreMadeOneBlockWithPickedPlaces) {
  const TriangleMesh rock = rock_mesh(12, {0.5, 0.4, 0.3}, 3);
  Random random(21);
  PartialScanRecipe recipe;
  recipe.points = 4000;
  recipe.ground_points = 0.0;
  const ScanPair pair = make_scan_pair(PartialScanner(rock), recipe, recipe, 0.4, 0.8, random);
  std::vector<std::string> paths;
  std::string picked;
  const Pose back = pair.second.scan_from_block * pair.first.scan_from_block.inverse();
  for (const PartialScan* scan : {&pair.first, &pair.second}) {
    const std::string name = paths.empty() ? "top.xyz" : "bottom.xyz";
    std::ofstream file(folder / name);
    for (const Vec3& p : scan->points) {
      file << 1000.0 * p.x() << " " << 1000.0 * p.y() << " " << 1000.0 * p.z() << "\n";
    }
    paths.push_back((folder / name).string());
  }
  for (const Vec3& place : {Vec3(0.3, 0.0, 0.1), Vec3(-0.2, 0.2, 0.2), Vec3(0.0, -0.3, 0.3)}) {
    const Vec3 a = 1000.0 * place, b = 1000.0 * (back * place);
    picked += "top," + std::to_string(a.x()) + "," + std::to_string(a.y()) + "," +
              std::to_string(a.z()) + ",bottom.xyz," + std::to_string(b.x()) + "," +
              std::to_string(b.y()) + "," + std::to_string(b.z()) + "\n";
  }
  ScanBatchOptions options;
  options.library = folder / "blocks.h5";
  options.scan.scan.unit = 1e-3;
  options.scan.units = "mm";
  options.scan.vertices = 100;
  options.scan.join.pairs = read_picked_pairs(write(picked));
  options.scan.block.threads = 2;
  const std::vector<ScanFile> scans = {list_joined_scans(paths, "B017")};
  EXPECT_EQ(reconstruct_scan_batch(scans, options).added, 1u);
  const BlockLibrary library = BlockLibrary::read(options.library);
  const Block& block = library.find_block("B017");
  const double volume = signed_volume(rock);
  EXPECT_NEAR(block.mass.volume, volume, 0.02 * volume);
  EXPECT_TRUE(contains(block.source.options, "joined=2"));
  options.resume = true;
  EXPECT_EQ(reconstruct_scan_batch(scans, options).skipped, 1u);
  options.scan.join.pairs[0].scan_a = "side";
  options.resume = false;
  options.replace = true;
  EXPECT_TRUE(contains(refusal([&] { reconstruct_scan_batch(scans, options); }),
                       "\"side\" is the name of none of the joined scans"));
}

}  // namespace
}  // namespace clast
