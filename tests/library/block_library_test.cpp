#include "library/block_library.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/files/hdf5_file.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "library/library_update.hpp"
#include "library/unscaled.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/flipped_bits.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/without_checksums.hpp"

namespace clast {
namespace {

std::filesystem::path written(const ScratchFolder& folder, const std::string& id = "SP1A") {
  BlockLibrary library;
  library.add(filled_block(id));
  library.write(folder / "blocks.h5");
  return folder / "blocks.h5";
}

/// The group of block SP1A, for damage.
Hdf5Group writable_block(const Hdf5File& file) {
  return file.root().open_group("blocks").open_group("SP1A");
}

TEST(BlockLibrary, EveryMemberOfABlockComesBack) {
  const ScratchFolder folder;
  const Block was = filled_block("SP1A");
  const BlockLibrary library = BlockLibrary::read(written(folder));
  const Block& is = library.find_block("SP1A");
  EXPECT_EQ(is.id, was.id);
  EXPECT_EQ(is.source.file, was.source.file);
  EXPECT_EQ(is.source.sha256, was.source.sha256);
  EXPECT_EQ(is.source.options, was.source.options);
  EXPECT_EQ(is.source.program_version, was.source.program_version);
  EXPECT_EQ(is.surface.vertices, was.surface.vertices);
  EXPECT_EQ(is.surface.triangles, was.surface.triangles);
  EXPECT_EQ(is.body.vertices, was.body.vertices);
  EXPECT_EQ(is.body.edges, was.body.edges);
  EXPECT_EQ(is.body.faces, was.body.faces);
  EXPECT_EQ(is.body.radius, was.body.radius);
  EXPECT_EQ(is.density, was.density);
  EXPECT_EQ(is.mass.volume, was.mass.volume);
  EXPECT_EQ(is.mass.mass, was.mass.mass);
  EXPECT_EQ(is.mass.centre, was.mass.centre);
  EXPECT_EQ(is.mass.inertia, was.mass.inertia);
  EXPECT_EQ(is.mass.relative_error, was.mass.relative_error);
  EXPECT_EQ(is.area, was.area);
  EXPECT_EQ(is.principal.moments, was.principal.moments);
  EXPECT_EQ(is.principal.rotation.coeffs(), was.principal.rotation.coeffs());
  EXPECT_EQ(is.principal.has_near_equal_moments, was.principal.has_near_equal_moments);
  EXPECT_EQ(is.box.centre, was.box.centre);
  EXPECT_EQ(is.box.axes, was.box.axes);
  EXPECT_EQ(is.box.lengths, was.box.lengths);
  EXPECT_EQ(is.deviation.hausdorff, was.deviation.hausdorff);
  EXPECT_EQ(is.deviation.mean, was.deviation.mean);
  EXPECT_EQ(is.deviation.volume_relative, was.deviation.volume_relative);
  EXPECT_EQ(is.deviation.scan_to_body, was.deviation.scan_to_body);
  EXPECT_EQ(is.deviation.body_to_scan, was.deviation.body_to_scan);
  EXPECT_EQ(is.deviation.area_relative, was.deviation.area_relative);
  EXPECT_EQ(is.deviation.moments_relative, was.deviation.moments_relative);
  EXPECT_EQ(is.from_core, was.from_core);
  ASSERT_TRUE(is.volume_bracket.has_value());
  EXPECT_EQ(is.volume_bracket->lower_volume, was.volume_bracket->lower_volume);
  EXPECT_EQ(is.volume_bracket->estimated_volume, was.volume_bracket->estimated_volume);
  EXPECT_EQ(is.volume_bracket->upper_volume, was.volume_bracket->upper_volume);
  EXPECT_EQ(is.volume_bracket->filled_fraction, was.volume_bracket->filled_fraction);
  ASSERT_TRUE(is.volume_bracket->sides.has_value());
  EXPECT_EQ(is.volume_bracket->sides->lower, was.volume_bracket->sides->lower);
  EXPECT_EQ(is.volume_bracket->sides->upper, was.volume_bracket->sides->upper);
  EXPECT_EQ(is.volume_bracket->assumption, was.volume_bracket->assumption);
  EXPECT_EQ(is.warnings, was.warnings);
  EXPECT_EQ(is.field.site, was.field.site);
  EXPECT_EQ(is.field.note, was.field.note);
  EXPECT_EQ(is.field.taped_axes->L, was.field.taped_axes->L);
  EXPECT_EQ(is.field.taped_axes->S, was.field.taped_axes->S);
  EXPECT_EQ(is.field.weighed_mass, was.field.weighed_mass);
}

TEST(BlockLibrary, ABlockWithoutUpperBoundStaysWithout) {
  const ScratchFolder folder;
  BlockLibrary library;
  Block block = filled_block("SP1A");
  block.volume_bracket->upper_volume.reset();
  block.volume_bracket->sides.reset();
  library.add(block);
  library.write(folder / "blocks.h5");
  const BlockLibrary read = BlockLibrary::read(folder / "blocks.h5");
  const VolumeBracket& unseen = *read.find_block("SP1A").volume_bracket;
  EXPECT_FALSE(unseen.upper_volume.has_value());
  EXPECT_FALSE(unseen.sides.has_value());
  EXPECT_EQ(unseen.lower_volume, 5.5);
}

// Older files hold the boxes of two shapes in place of bounds of each axis.
TEST(BlockLibrary, TheVolumeBracketOfAnOlderFileIsRead) {
  const ScratchFolder folder;
  const auto path = written(folder);
  {
    const Hdf5File file = Hdf5File::open(path, "clast block library", 1, true);
    Hdf5Group unseen = writable_block(file).open_group("unseen");
    unseen.remove("axes_lower");
    unseen.remove("axes_upper");
    for (const auto& [name, sides] : {std::pair{"box_lower", std::vector{3.0, 2.3, 0.9}},
                                      {"box_upper", std::vector{2.9, 2.0, 1.2}}}) {
      unseen.write<double>(name, sides);
      unseen.set_unit(name, "m");
    }
  }
  const BlockLibrary library = BlockLibrary::read(path);
  const BoxSideBounds& sides = *library.find_block("SP1A").volume_bracket->sides;
  EXPECT_EQ(sides.lower[0], 2.9);
  EXPECT_EQ(sides.upper[0], 3.0);
  EXPECT_EQ(sides.lower[1], 2.0);
  EXPECT_EQ(sides.upper[1], 2.3);
  EXPECT_EQ(sides.upper[2], 1.2);
}

TEST(BlockLibrary, AnUnscaledBlockStaysUnscaled) {
  const ScratchFolder folder;
  EXPECT_FALSE(is_unscaled(BlockLibrary::read(written(folder)).find_block("SP1A")));
  BlockLibrary library;
  Block block = filled_block("SP1A");
  block.source.unscaled = true;
  library.add(block);
  library.write(folder / "blocks.h5");
  EXPECT_TRUE(is_unscaled(BlockLibrary::read(folder / "blocks.h5").find_block("SP1A")));
}

TEST(BlockLibrary, WhatWasNotMeasuredInTheFieldStaysUnknown) {
  const ScratchFolder folder;
  Block block = filled_block("SP1A");
  block.field = {};
  BlockLibrary library;
  library.add(block);
  library.write(folder / "blocks.h5");
  const BlockLibrary read = BlockLibrary::read(folder / "blocks.h5");
  EXPECT_FALSE(read.find_block("SP1A").field.taped_axes.has_value());
  EXPECT_FALSE(read.find_block("SP1A").field.weighed_mass.has_value());
}

TEST(BlockLibrary, ABlockSeenFromAllSidesHasNoBracketAndSoHaveOlderFiles) {
  const ScratchFolder folder;
  Block block = filled_block("SP1A");
  block.volume_bracket.reset();  // what is written then is what older versions wrote
  BlockLibrary library;
  library.add(block);
  library.write(folder / "blocks.h5");
  EXPECT_FALSE(
      BlockLibrary::read(folder / "blocks.h5").find_block("SP1A").volume_bracket.has_value());
}

TEST(BlockLibrary, BlocksAreInOrderOfIdAndFoundByIt) {
  BlockLibrary library;
  for (const char* id : {"SP3A", "a b", "B2", "SP1A"}) library.add(filled_block(id));
  std::vector<std::string> ids;
  for (const Block& block : library.blocks()) ids.push_back(block.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"B2", "SP1A", "SP3A", "a b"}));
  EXPECT_TRUE(library.contains("SP3A"));
  library.remove("SP3A");
  EXPECT_FALSE(library.contains("SP3A"));
  const std::string message = refusal([&] { library.find_block("SP3A"); });
  EXPECT_TRUE(contains(message, "SP3A") && contains(message, "B2, SP1A, a b")) << message;
  EXPECT_TRUE(contains(refusal([&] { library.remove("SP3A"); }), "SP3A"));
}

TEST(BlockLibrary, AnIdThatIsThereNeedsReplace) {
  BlockLibrary library;
  library.add(filled_block("SP1A"));
  Block other = filled_block("SP1A");
  other.density = 2700.0;
  EXPECT_TRUE(contains(refusal([&] { library.add(other); }), "SP1A"));
  EXPECT_EQ(library.find_block("SP1A").density, 2500.0);
  library.add(other, true);
  EXPECT_EQ(library.find_block("SP1A").density, 2700.0);
  EXPECT_EQ(library.blocks().size(), 1u);
}

TEST(BlockLibrary, NamesThatCantBeIdsAreRefused) {
  BlockLibrary library;
  for (const char* id : {"", ".", "..", "a/b", "a\nb"}) {
    EXPECT_THROW(library.add(filled_block(id)), InputError) << id;
  }
  EXPECT_NO_THROW(library.add(filled_block("Éboulis 3.2")));
}

TEST(BlockLibrary, AnEmptyLibraryIsALibrary) {
  const ScratchFolder folder;
  BlockLibrary().write(folder / "blocks.h5");
  EXPECT_TRUE(BlockLibrary::read(folder / "blocks.h5").blocks().empty());
}

TEST(BlockLibrary, WritingLeavesNothingElseBehind) {
  const ScratchFolder folder;
  written(folder);
  written(folder);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(BlockLibrary, ACutFileIsRefusedByName) {
  const ScratchFolder folder;
  const std::string whole = read_text_file(written(folder));
  for (const double share : {0.0, 0.01, 0.2, 0.5, 0.9, 0.999}) {
    write_text_file(folder / "cut.h5", whole.substr(0, std::size_t(share * double(whole.size()))));
    EXPECT_TRUE(contains(refusal([&] { BlockLibrary::read(folder / "cut.h5"); }), "cut.h5"))
        << share;
  }
}

TEST(BlockLibrary, AMissingDatasetIsNamedWithItsBlock) {
  const ScratchFolder folder;
  const auto path = written(folder);
  for (const char* name : {"surface", "core", "centre", "inertia", "box_lengths", "warnings",
                           "source_from_body", "field"}) {
    written(folder);
    { writable_block(Hdf5File::open(path, "clast block library", 1, true)).remove(name); }
    const std::string message = refusal([&] { BlockLibrary::read(path); });
    EXPECT_TRUE(contains(message, std::string("/blocks/SP1A/") + name)) << message;
  }
}

TEST(BlockLibrary, ImpossibleContentIsRefusedWithTheBlocksName) {
  const ScratchFolder folder;
  const auto path = written(folder);
  const auto refused_after = [&](const auto& damage) {
    written(folder);
    {
      Hdf5Group group = writable_block(Hdf5File::open(path, "clast block library", 1, true));
      damage(group);
    }
    return refusal([&] { BlockLibrary::read(path); });
  };
  const std::vector<std::uint32_t> far = {0, 1, 99};
  const std::vector<double> nan = {1.0, std::nan(""), 1.0};
  const std::vector<double> no_rotation = {1.0, 1.0, 0.0, 0.0};
  const std::string triangle = refused_after([&](Hdf5Group group) {
    group.open_group("surface").remove("triangles");
    group.open_group("surface").write<std::uint32_t>("triangles", far, {1, 3});
  });
  EXPECT_TRUE(contains(triangle, "block SP1A") && contains(triangle, "triangles")) << triangle;
  EXPECT_TRUE(contains(refused_after([&](Hdf5Group group) {
                         group.remove("centre");
                         group.write<double>("centre", nan);
                       }),
                       "centre is not finite"));
  EXPECT_TRUE(contains(refused_after([&](Hdf5Group group) {
                         group.remove("source_from_body");
                         group.write<double>("source_from_body", no_rotation);
                       }),
                       "source_from_body is not a rotation"));
  EXPECT_TRUE(contains(
      refused_after([&](Hdf5Group group) { group.set_attribute<double>("mass_kg", -1.0); }),
      "mass_kg"));
  EXPECT_TRUE(contains(refused_after([&](Hdf5Group group) {
                         group.open_group("core").remove("face_sizes");
                         group.open_group("core").write<std::uint32_t>("face_sizes", far);
                       }),
                       "face_sizes"));
  EXPECT_TRUE(contains(refused_after([&](Hdf5Group group) {
                         group.open_group("unseen").set_attribute<double>("volume_upper_m3", 5.9);
                       }),
                       "volume_upper_m3"));
}

// Each number is one that a reader takes for itself; only the others give it away.
TEST(BlockLibrary, NumbersThatDoNotFitTheOthersAreRefused) {
  const ScratchFolder folder;
  const auto after = [&](const auto& change) {
    Block block = filled_block("SP1A");
    change(block);
    BlockLibrary library;
    library.add(block);
    library.write(folder / "blocks.h5");
    return refusal([&] { BlockLibrary::read(folder / "blocks.h5"); });
  };
  EXPECT_EQ(after([](Block&) {}), "");
  const auto expect = [&](const auto& change, const std::string& why) {
    const std::string message = after(change);
    EXPECT_TRUE(contains(message, "block SP1A: " + why)) << message;
  };
  expect([](Block& block) { block.mass.mass *= 1.00001; }, "mass_kg is ");
  expect([](Block& block) { block.density *= 2.0; }, "mass_kg is ");
  expect([](Block& block) { block.principal.moments[0] = 2e-307; },
         "principal_moments are impossible for a solid: the largest exceeds the sum of the others; "
         "the file is damaged: restore a backup, or make it again");
  expect([](Block& block) { block.principal.moments[2] = 3.1; },
         "principal_moments are impossible");
  expect([](Block& block) { block.principal.moments[0] = 2.2; }, "principal_moments are not posi");
  expect([](Block& block) { block.mass.inertia(1, 1) *= 1.001; }, "inertia does not agree");
  expect([](Block& block) { block.box.lengths[0] *= 1.0001; }, "the box is not around the core");
  expect([](Block& block) { block.box.centre.y() += 1e-4; }, "the box is not around the core");
  expect([](Block& block) { block.box.axes(0, 1) = 0.01; }, "box_axes are not unit vectors");
  expect([](Block& block) { block.body.vertices[3].z() -= 1e-4; }, "the box is not around");
  expect(
      [](Block& block) {
        block.mass.volume = 6.1;
        block.mass.mass = 6.1 * block.density;
      },
      "volume_m3 is 6.1, more than the box's, 6");
  // Volume and inertia of a convex core have a closed form, and are recomputed.
  expect(
      [](Block& block) {
        block.mass.relative_error = 0.0;
        block.mass.volume *= 1.00001;
        block.mass.mass = block.mass.volume * block.density;
      },
      "volume_m3 is ");
  expect([](Block& block) { block.mass.relative_error = 0.0; }, "the trace of inertia is 5.5, but");
}

TEST(BlockLibrary, NoFlippedBitIsReadAsAnotherNumber) {
  const ScratchFolder folder;
  BlockLibrary library;
  library.add(filled_block("SP1A"));
  Block large = filled_block("SP2");  // some of it in compressed chunks
  Random random(5);
  while (large.surface.vertices.size() < 400)
    large.surface.vertices.push_back(random.unit_vector());
  library.add(large);
  library.write(folder / "blocks.h5");
  expect_no_flip_unnoticed(folder / "blocks.h5", 700, [&](const std::filesystem::path& file) {
    BlockLibrary::read(file).write(folder / "again.h5");
    return read_text_file(folder / "again.h5");
  });
}

TEST(BlockLibrary, FilesOfVersionsWithoutChecksumsAreRead) {
  const ScratchFolder folder;
  const auto path = written(folder);
  const std::string whole = read_text_file(path);
  remove_checksums(path);
  EXPECT_NE(read_text_file(path), whole);
  BlockLibrary::read(path).write(folder / "again.h5");
  EXPECT_EQ(read_text_file(folder / "again.h5"), whole);
}

TEST(BlockLibrary, OfFourAtOnceEveryChangeIsInTheFile) {
  const ScratchFolder folder;
  std::vector<pid_t> children;
  for (const char* name : {"a", "b", "c", "d"}) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int i = 0; i < 8; ++i) {
        update_library(
            folder / "blocks.h5", {.create_if_missing = true},
            [&](BlockLibrary& library) { library.add(filled_block(name + std::to_string(i))); });
      }
      ::_exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(BlockLibrary::read(folder / "blocks.h5").blocks().size(), 32u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(BlockLibrary, AChangeThatThrowsLeavesTheFileAndTheLock) {
  const ScratchFolder folder;
  const std::string whole = read_text_file(written(folder));
  const auto add = [&] {
    update_library(folder / "blocks.h5", {},
                   [](BlockLibrary& library) { library.add(filled_block("SP1A")); });
  };
  EXPECT_TRUE(contains(refusal(add), "SP1A is in the library already"));
  EXPECT_TRUE(contains(refusal(add), "SP1A is in the library already"));
  EXPECT_EQ(read_text_file(folder / "blocks.h5"), whole);
  EXPECT_TRUE(contains(refusal([&] { update_library(folder / "none.h5", {}, [](auto&) {}); }),
                       "none.h5: no such file"));
}

TEST(BlockLibrary, IsNotWrittenOverAnythingElse) {
  const ScratchFolder folder;
  write_text_file(folder / "notes.h5", "taped in the field");
  Hdf5File::create(folder / "t.h5", "clast terrain", 1);
  for (const char* name : {"notes.h5", "t.h5"}) {
    const std::string before = read_text_file(folder / name);
    EXPECT_TRUE(contains(refusal([&] { BlockLibrary().write(folder / name); }),
                         std::string(name) + ": already exists and holds"));
    EXPECT_EQ(read_text_file(folder / name), before);
  }
}

TEST(BlockLibrary, EveryDatasetHasAUnit) {
  const ScratchFolder folder;
  const auto path = written(folder);
  const Hdf5Group block = writable_block(Hdf5File::open(path, "clast block library", 1));
  for (const char* group : {"surface", "core", "field", "unseen"}) {
    for (const std::string& name : block.open_group(group).child_names()) {
      EXPECT_NE(block.open_group(group).unit(name), "") << group << "/" << name;
    }
  }
  for (const char* name : {"centre", "inertia", "principal_moments", "source_from_body",
                           "box_centre", "box_axes", "box_lengths", "warnings"}) {
    EXPECT_NE(block.unit(name), "") << name;
  }
}

TEST(BlockLibraryFile, TellsOtherReadersHowEdgesBendAndKeepsPolygons) {
  const ScratchFolder folder;
  const auto path = folder / "blocks.h5";
  Block block = filled_block("SP1A");
  // A cube with a roof that is pressed in: floor and walls are quads, eight edges are convex.
  block.body.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},   {0, 0, 1},
                         {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {.5, .5, .8}};
  block.body.faces = {{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7},
                      {4, 5, 8},    {5, 6, 8},    {6, 7, 8},    {7, 4, 8}};
  block.body.edges = face_edges(block.body.faces);
  block.box.centre = {0.5, 0.5, 0.5};
  block.box.lengths = Vec3::Constant(1.0 + 2.0 * block.body.radius);
  block.mass.volume = 1.0;
  block.mass.mass = block.density;
  BlockLibrary library;
  library.add(block);
  library.write(path);
  EXPECT_EQ(BlockLibrary::read(path).find_block("SP1A").body.faces, block.body.faces);
  const Hdf5Group core =
      writable_block(Hdf5File::open(path, "clast block library", 1)).open_group("core");
  const std::vector<std::uint8_t> bends = core.read<std::uint8_t>("edge_bends");
  ASSERT_EQ(bends.size(), 16u);
  for (std::size_t e = 0; e < bends.size(); ++e) {
    const bool in_roof = block.body.edges[e][1] == 8;
    EXPECT_EQ(bends[e], in_roof ? 2 : 1) << e;
  }
}

}  // namespace
}  // namespace clast
