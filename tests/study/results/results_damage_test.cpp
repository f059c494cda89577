#include <gtest/gtest.h>

#include "core/files/hdf5_file.hpp"
#include "core/files/text_file.hpp"
#include "tests/study/sample_results.hpp"
#include "tests/support/flipped_bits.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/without_checksums.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

TEST(Results, WhatIsNotAResultsFileIsRefused) {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& name) {
    return refusal([&] { read_results(folder / name); });
  };
  EXPECT_TRUE(contains(refused("none.h5"), "none.h5: no such file"));
  write_text_file(folder / "unfinished.h5.part", "clast results journal 1\n");
  EXPECT_TRUE(contains(refused("unfinished.h5.part"), "unfinished campaign; continue it first"));
  write_text_file(folder / "empty.h5", "");
  EXPECT_TRUE(contains(refused("empty.h5"), "empty.h5: is empty"));
  write_text_file(folder / "text.h5", "no HDF5 at all");
  EXPECT_TRUE(contains(refused("text.h5"), "text.h5: is not an HDF5 file"));
  Hdf5File::create(folder / "blocks.h5", "clast block library", 1);
  EXPECT_TRUE(contains(refused("blocks.h5"), "blocks.h5: is a \"clast block library\" file"));
  Hdf5File::create(folder / "newer.h5", "clast results", 5);
  EXPECT_TRUE(contains(refused("newer.h5"), "newer.h5: has schema version 5"));
  Hdf5File::create(folder / "older.h5", "clast results", 1);
  EXPECT_TRUE(contains(refused("older.h5"), "has schema version 1 of an older clast"));
  Hdf5File::create(folder / "bare.h5", "clast results", 2);
  EXPECT_TRUE(contains(refused("bare.h5"), "campaign_sha256 is missing"));
}

TEST(Results, StraightBarriersOfSchema2AreRead) {
  const ScratchFolder folder;
  {
    ResultsWriter writer = ResultsWriter::create(folder / "old.h5", sample_header());
    add_run(writer, 0);
    writer.finish();
    Hdf5File file = Hdf5File::open(folder / "old.h5", "clast results", 4, true);
    Hdf5Group barriers = file.root().open_group("barriers");
    barriers.remove("point_count");
    barriers.remove("points_m");
    barriers.write<double>("from_m", std::vector<double>{25, -400, 36, -400}, {2, 2});
    barriers.write<double>("to_m", std::vector<double>{25, -340, 36, -340}, {2, 2});
    file.flush();
  }
  const CampaignResults results = read_results(folder / "old.h5");
  ASSERT_EQ(results.barriers.size(), 2u);
  EXPECT_EQ(results.barriers[1].vertices, (std::vector<Vec2>{{36, -400}, {36, -340}}));
}

TEST(Results, DamageIsNamed) {
  const ScratchFolder folder;
  const fs::path good = folder / "good.h5";
  {
    ResultsWriter writer = ResultsWriter::create(good, sample_header());
    for (const std::uint32_t run : {0u, 1u, 2u}) add_run(writer, run);
    writer.finish();
  }
  const fs::path bad = folder / "bad.h5";
  const auto after = [&](const auto& change) {
    fs::copy_file(good, bad, fs::copy_options::overwrite_existing);
    {
      Hdf5File file = Hdf5File::open(bad, "clast results", 4, true);
      Hdf5Group root = file.root();
      change(root);
      file.flush();
    }
    return refusal([&] { read_results(bad); });
  };
  const auto replaced = [&](const std::string& group, const std::string& name, auto values,
                            const std::vector<std::size_t>& shape = {}) {
    return after([&](Hdf5Group& root) {
      Hdf5Group parent = root.open_group(group);
      parent.remove(name);
      parent.write<typename decltype(values)::value_type>(name, values, shape);
    });
  };
  EXPECT_EQ(after([](Hdf5Group&) {}), "");
  EXPECT_TRUE(contains(after([](Hdf5Group& root) { root.open_group("runs").remove("stop_x_m"); }),
                       "bad.h5: /runs/stop_x_m is missing"));
  EXPECT_TRUE(contains(after([](Hdf5Group& root) { root.remove("terrain"); }),
                       "bad.h5: /terrain is missing"));
  EXPECT_TRUE(contains(replaced("runs", "duration_s", std::vector<double>{1.0, 2.0}),
                       "bad.h5: /runs/duration_s has 2 values where 3 belong"));
  EXPECT_TRUE(contains(replaced("runs", "block", std::vector<std::uint32_t>{0, 1, 2}),
                       "bad.h5: /runs/block holds 2, which must be below 2"));
  EXPECT_TRUE(contains(replaced("runs", "run", std::vector<std::uint32_t>{0, 1, 1}),
                       "bad.h5: /runs/run holds 1 after 1"));
  // The sample has barriers of two and three points.
  EXPECT_TRUE(contains(replaced("barriers", "point_count", std::vector<std::uint32_t>{2, 4}),
                       "bad.h5: /barriers/point_count does not fit points_m"));
  EXPECT_TRUE(contains(replaced("barriers", "point_count", std::vector<std::uint32_t>{1, 4}),
                       "bad.h5: /barriers/point_count does not fit points_m"));
  EXPECT_TRUE(
      contains(replaced("barriers", "point_count", std::vector<std::uint32_t>{2, 2}),
               "bad.h5: /barriers/points_m has more points than the barriers have in total"));
  EXPECT_TRUE(contains(replaced("barriers", "direction", std::vector<std::string>{"either", "up"}),
                       "bad.h5: /barriers/direction is neither either nor forward"));
  EXPECT_TRUE(contains(replaced("runs", "stop_reason", std::vector<std::uint8_t>{0, 1, 9}),
                       "bad.h5: /runs/stop_reason holds 9"));
  EXPECT_TRUE(contains(replaced("crossings", "run", std::vector<std::uint32_t>{1, 2, 5}),
                       "bad.h5: /crossings/run holds run 5, which is not stored"));
  EXPECT_TRUE(contains(replaced("crossings", "barrier", std::vector<std::uint32_t>{0, 0, 7}),
                       "bad.h5: /crossings/barrier holds 7, which must be below 2"));
  EXPECT_TRUE(contains(replaced("terrain", "triangles", std::vector<std::uint32_t>{0, 1, 4}),
                       "bad.h5: /terrain/triangles holds 4, which must be below 4"));
  EXPECT_TRUE(contains(replaced("shapes/1", "face_vertices", std::vector<std::uint32_t>(36, 8)),
                       "bad.h5: /shapes/1: face_vertices refers to a vertex that does not exist"));
  EXPECT_TRUE(contains(replaced("blocks", "mass_kg", std::vector<double>{1.0}),
                       "bad.h5: /blocks/mass_kg has 1 values where 2 belong"));
}

// Joining one part that is whole reads all of it, trajectories too, and writes the same bytes.
TEST(Results, NoFlippedBitIsReadAsAnotherNumber) {
  const ScratchFolder folder;
  CampaignResults header = sample_header();
  header.planned_runs = 4;
  ResultsWriter writer = ResultsWriter::create(folder / "r.h5", header);
  for (const std::uint32_t run : {0u, 1u, 2u, 3u}) add_run(writer, run);
  writer.finish();
  expect_no_flip_unnoticed(folder / "r.h5", 900, [&](const fs::path& file) {
    merge_results({file}, folder / "again.h5");
    return read_text_file(folder / "again.h5");
  });
}

TEST(Results, FilesOfVersionsWithoutChecksumsAreRead) {
  const ScratchFolder folder;
  CampaignResults header = sample_header();
  header.planned_runs = 4;
  ResultsWriter writer = ResultsWriter::create(folder / "r.h5", header);
  for (const std::uint32_t run : {0u, 1u, 2u, 3u}) add_run(writer, run);
  writer.finish();
  const std::string whole = read_text_file(folder / "r.h5");
  remove_checksums(folder / "r.h5");
  EXPECT_NE(read_text_file(folder / "r.h5"), whole);
  expect_runs(folder / "r.h5", {0, 1, 2, 3});
  merge_results({folder / "r.h5"}, folder / "again.h5");
  EXPECT_EQ(read_text_file(folder / "again.h5"), whole);
}

TEST(Results, BlocksThatCantBeAreRefused) {
  const ScratchFolder folder;
  const auto after = [&](const auto& change) {
    CampaignResults header = sample_header();
    change(header.blocks[1]);
    ResultsWriter writer = ResultsWriter::create(folder / "r.h5", header);
    add_run(writer, 1);
    writer.finish();
    return refusal([&] { read_results(folder / "r.h5"); });
  };
  EXPECT_EQ(after([](BlockSummary&) {}), "");
  const auto refused = [&](const auto& change, const std::string& name) {
    EXPECT_TRUE(contains(after(change), "/blocks/" + name + " is "));
    EXPECT_TRUE(contains(after(change),
                         ", which is impossible for block B2; the file is damaged: restore a "
                         "backup, or run the campaign again"));
  };
  refused([](BlockSummary& block) { block.mass = 0.0; }, "mass_kg");
  refused([](BlockSummary& block) { block.volume = -0.2; }, "volume_m3");
  refused([](BlockSummary& block) { block.axes.S = 0.95; }, "L_m");
  refused([](BlockSummary& block) { block.moments[0] = 2e-307; }, "principal_moments_kg_m2");
}

TEST(Results, TruncatedFileIsRefusedAtAnyLength) {
  const ScratchFolder folder;
  const fs::path good = folder / "good.h5";
  {
    ResultsWriter writer = ResultsWriter::create(good, sample_header());
    add_run(writer, 2);
    writer.finish();
  }
  const std::string bytes = read_text_file(good);
  for (int part = 1; part < 20; ++part) {
    write_text_file(folder / "cut.h5", bytes.substr(0, bytes.size() * part / 20));
    const std::string message = refusal([&] { read_results(folder / "cut.h5"); });
    EXPECT_TRUE(contains(message, "cut.h5")) << part << ": " << message;
  }
}

}  // namespace
}  // namespace clast
