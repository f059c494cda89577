#include "library/block_export.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/mesh_io.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

/// Sides of the box along x, y and z of the block's scan in a file.
Vec3 extents(const std::filesystem::path& file) {
  const Bounds box = bounds(read_mesh(file));
  return box.high - box.low;
}

class BlockExport : public testing::Test {
 protected:
  std::vector<std::filesystem::path> exported(const BlockExportOptions& options) {
    return export_blocks({&block_}, folder_.path(), options);
  }

  const ScratchFolder folder_;
  Block block_ = filled_block("B1");  // a scan of 3 x 2 x 1 m, z up
};

TEST_F(BlockExport, GlbIsYUpAsItsStandardHasItAndOtherFormatsAreZUp) {
  exported({.formats = {"glb", "obj"}, .surface = ExportedSurface::kSurface});
  EXPECT_EQ(extents(folder_ / "B1.obj"), Vec3(3.0, 2.0, 1.0));
  EXPECT_EQ(extents(folder_ / "B1.glb"), Vec3(3.0, 1.0, 2.0));
  exported({.formats = {"glb", "obj"},
            .surface = ExportedSurface::kSurface,
            .up = "z",
            .replace = true});
  EXPECT_EQ(extents(folder_ / "B1.glb"), Vec3(3.0, 2.0, 1.0));
  exported({.formats = {"glb", "obj"},
            .surface = ExportedSurface::kSurface,
            .up = "y",
            .replace = true});
  EXPECT_EQ(extents(folder_ / "B1.obj"), Vec3(3.0, 1.0, 2.0));
}

TEST_F(BlockExport, ThePrincipalFrameHasNoUp) {
  exported({.formats = {"glb", "obj"},
            .surface = ExportedSurface::kSurface,
            .frame = ExportFrame::kPrincipal});
  EXPECT_LT((extents(folder_ / "B1.glb") - extents(folder_ / "B1.obj")).norm(), 1e-6);
  EXPECT_TRUE(contains(
      refusal<InputError>([&] { exported({.frame = ExportFrame::kPrincipal, .up = "y"}); }),
      "has no upward axis"));
}

TEST_F(BlockExport, FilesAreThoseThatWereAskedFor) {
  const auto files = exported({.formats = {"ply", "shp"}, .surface = ExportedSurface::kBoth});
  const std::vector<std::filesystem::path> expected = {folder_ / "B1.ply", folder_ / "B1_core.ply",
                                                       folder_ / "B1.shp"};
  EXPECT_EQ(files, expected);
}

TEST_F(BlockExport, NothingIsWrittenWhereOneFileIsThereAlready) {
  write_mesh(folder_ / "B1.obj", block_.surface);
  EXPECT_TRUE(contains(refusal<InputError>([&] {
                         exported({.formats = {"ply", "obj"}});
                       }),
                       "B1.obj: already exists"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "B1.ply"));
}

TEST_F(BlockExport, WhatMakesNoSenseIsRefused) {
  const auto refused = [&](const BlockExportOptions& options) {
    return refusal<Error>([&] { exported(options); });
  };
  EXPECT_TRUE(contains(refused({.formats = {}}), "is empty"));
  EXPECT_TRUE(contains(refused({.formats = {"dae"}}), "\"dae\" is not known"));
  EXPECT_TRUE(contains(refused({.formats = {"ply"}, .segments = 65}), "from 1 to 64"));
  EXPECT_TRUE(contains(refused({.up = "x"}), "up = \"x\""));
  block_.body = {.vertices = {Vec3::Zero()}, .edges = {}, .faces = {}, .radius = 0.5};
  EXPECT_TRUE(
      contains(refused({.formats = {"ply"}, .surface = ExportedSurface::kCore}), "is a ball"));
  EXPECT_TRUE(contains(refusal<InputError>([&] { export_blocks({}, folder_.path()); }),
                       "no block to export"));
}

}  // namespace
}  // namespace clast
