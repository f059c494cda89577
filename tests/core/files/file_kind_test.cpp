#include "core/files/file_kind.hpp"

#include <gtest/gtest.h>

#include "core/files/hdf5_file.hpp"
#include "core/files/png.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(FileKind, IsSeenFromTheContent) {
  const ScratchFolder folder;
  const auto kind = [&](const std::string& content) {
    write_text_file(folder / "a", content);
    return detect_file_kind(folder / "a");
  };
  EXPECT_EQ(kind(""), "");
  EXPECT_EQ(detect_file_kind(folder / "none"), "");
  EXPECT_EQ(detect_file_kind(folder.path()), "");
  EXPECT_EQ(kind("L,I,S\n3,2,1\n"), "text");
  EXPECT_EQ(kind("<?xml version=\"1.0\"?>\n<svg xmlns=\"\"/>"), "SVG");
  EXPECT_EQ(kind("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">" + std::string(9, '\0')),
            "VTK");
  EXPECT_EQ(kind("<!DOCTYPE html>\n"), "HTML");
  EXPECT_EQ(kind("<!DOCTYPE html>\n<meta name=\"generator\" content=\"clast\">\n"), kPageKind);
  EXPECT_EQ(kind(std::string("II*\0 and so on", 14)), "TIFF");
  EXPECT_EQ(kind(std::string("SQLite format 3\0", 16)), "SQLite");
  EXPECT_EQ(kind("ply\nformat ascii 1.0\n"), "PLY");
  EXPECT_EQ(kind("coordinates = coordinates here + origin, m\norigin 1 2 3\n"),
            "origin of coordinates");
  EXPECT_EQ(kind("solid rock\nfacet normal 0 0 1\n"), "STL");
  std::string stl(84 + 50 * 2, '\0');
  stl[80] = 2;
  EXPECT_EQ(kind(stl), "STL");
  stl.pop_back();
  EXPECT_EQ(kind(stl), "binary");
}

TEST(FileKind, CampaignsAreKnownByTheirTables) {
  const ScratchFolder folder;
  const auto kind = [&](const std::string& content) {
    write_text_file(folder / "a.toml", content);
    return detect_file_kind(folder / "a.toml");
  };
  EXPECT_EQ(kind("# mine\n[blocks]\nlibrary = \"b.h5\"\n[terrain]\nsurface = \"s.h5\"\n"),
            kCampaignKind);
  EXPECT_EQ(kind(" [ blocks ] # all\r\nlibrary = \"b.h5\"\r\n[\"terrain\"]\r\n"), kCampaignKind);
  EXPECT_EQ(kind("blocks.library = \"b.h5\"\nterrain = { surface = \"s.h5\" }\n"), kCampaignKind);
  EXPECT_EQ(
      kind(std::string(9000, '#') + "\n[blocks]\n" + std::string(9000, '#') + "\n[terrain]\n"),
      kCampaignKind)
      << "long comments";
  for (const char* other :
       {"# [blocks] and [terrain] in a field book\n", "[project]\nname = \"x\"\n",
        "[blocks]\nlibrary = \"b.h5\"\n", "[[blocks]]\n[[terrain]]\n", "blocks,terrain\n1,2\n",
        "site = [{ name = \"quarry\", campaign = \"campaign.toml\" }]\n"}) {
    EXPECT_EQ(kind(other), "text") << other;
  }
}

TEST(FileKind, OfOwnHdf5FilesIsTheirFormat) {
  const ScratchFolder folder;
  Hdf5File::create(folder / "t.h5", "clast terrain", 7);
  EXPECT_EQ(detect_file_kind(folder / "t.h5"), "clast terrain");
  const std::string whole = read_text_file(folder / "t.h5");
  write_text_file(folder / "cut.h5", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(detect_file_kind(folder / "cut.h5"), "HDF5");
}

TEST(FileKind, ByNameIsWhatIsWrittenUnderIt) {
  EXPECT_EQ(file_kind_by_extension("a/map.PNG"), "PNG");
  EXPECT_EQ(file_kind_by_extension("dem.tiff"), "TIFF");
  EXPECT_EQ(file_kind_by_extension("runs.csv"), "text");
  EXPECT_EQ(file_kind_by_extension("rock.obj"), "text");
}

}  // namespace
}  // namespace clast
