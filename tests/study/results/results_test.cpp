#include "study/results/results.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "core/files/hdf5_file.hpp"
#include "core/files/text_file.hpp"
#include "study/results/block_stiffness.hpp"
#include "study/results/results_journal.hpp"
#include "tests/study/sample_results.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

using namespace study_detail;
namespace {

namespace fs = std::filesystem;

TEST(Results, TwoWritersOfOneFileDoNotMixTheirRuns) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "r.h5";
  ResultsWriter writer = ResultsWriter::create(file, sample_header());
  add_run(writer, 0);
  const char* const busy = "r.h5: another program is writing to it; wait until it ends";
  EXPECT_TRUE(contains(refusal([&] { ResultsWriter::resume(file, sample_header()); }), busy));
  EXPECT_TRUE(contains(refusal([&] { ResultsWriter::create(file, sample_header()); }), busy));
  add_run(writer, 1);
  writer.finish();
  EXPECT_EQ(read_results(file).runs.size(), 2u);
  EXPECT_EQ(refusal([&] { ResultsWriter::create(file, sample_header()); }), "");
}

TEST(Results, EverythingComesBackInRunOrder) {
  const ScratchFolder folder;
  const fs::path target = folder / "new folder/results.h5";
  const CampaignResults header = sample_header();
  {
    ResultsWriter writer = ResultsWriter::create(target, header);
    for (const std::uint32_t run : {5u, 0u, 3u, 2u}) add_run(writer, run);
    EXPECT_FALSE(fs::exists(target));
    writer.finish();
  }
  EXPECT_FALSE(fs::exists(results_journal_path(target)));
  expect_runs(target, {0, 2, 3, 5});
  const CampaignResults results = read_results(target);
  EXPECT_EQ(results.file, target);
  EXPECT_EQ(results.campaign_text, header.campaign_text);
  EXPECT_EQ(results.campaign_sha256, header.campaign_sha256);
  EXPECT_EQ(results.inputs, header.inputs);
  EXPECT_EQ(results.program_version, version());
  ASSERT_EQ(results.blocks.size(), 2u);
  EXPECT_EQ(results.blocks[1].id, "B2");
  EXPECT_EQ(results.blocks[1].mass, 514.14);
  EXPECT_EQ(results.blocks[0].axes.L, 1.1);
  EXPECT_EQ(results.blocks[0].axes.I, 0.9);
  EXPECT_EQ(results.blocks[0].axes.S, 0.5);
  EXPECT_EQ(results.blocks[1].garcia, "elongated");
  EXPECT_EQ(results.blocks[1].sneed_folk, "E");
  EXPECT_EQ(results.blocks[1].zingg, "rod");
  ASSERT_EQ(results.barriers.size(), 2u);
  EXPECT_EQ(results.barriers[1].name, "EC12");
  EXPECT_EQ(results.barriers[0].counted, CountedDirection::kEither);
  EXPECT_EQ(results.barriers[1].counted, CountedDirection::kForward);
  EXPECT_EQ(results.barriers[0].vertices, (std::vector<Vec2>{{25, -400}, {25, -340}}));
  EXPECT_EQ(results.barriers[1].vertices, (std::vector<Vec2>{{36, -400}, {36, -370}, {40, -340}}));
  EXPECT_EQ(results.release_points, header.release_points);
  EXPECT_EQ(results.zone_names, header.zone_names);
  ASSERT_EQ(results.ground.size(), 2u);
  EXPECT_EQ(results.ground[0].rolling_friction, 0.35);
  EXPECT_EQ(results.ground[0].rolling_length, 0.12);
  EXPECT_EQ(results.ground[1].rolling_length, 0.0);
  EXPECT_EQ(results.ground[0].slip_growth, 3.0);
  EXPECT_EQ(results.ground[0].scar_drag, 1.5);
  EXPECT_EQ(results.ground_sets[0].zones[0].soil_density, 1800.0);
  EXPECT_EQ(results.ground_sets[0].zones[0].soil_memory, 0.2);
  EXPECT_EQ(results.ground[1].energy_restitution, 0.04);
  EXPECT_EQ(results.ground[1].friction, 0.3);
  EXPECT_EQ(results.weighting, ContactWeighting::kOverlap);
  EXPECT_EQ(name_of(results.law), "spring-dashpot");
  EXPECT_EQ(results.warnings, header.warnings);
  EXPECT_EQ(results.frame.origin, header.frame.origin);
  EXPECT_EQ(results.frame.crs, "EPSG:2154");
  EXPECT_EQ(*results.downslope, *header.downslope);
  EXPECT_EQ(results.terrain.surface.vertices, header.terrain.surface.vertices);
  EXPECT_EQ(results.terrain.surface.triangles, header.terrain.surface.triangles);
  EXPECT_EQ(results.terrain.zone, header.terrain.zone);
  EXPECT_EQ(results.terrain.zone_names, header.zone_names);
  EXPECT_EQ(results.terrain.sources, header.terrain.sources);
  EXPECT_EQ(results.planned_runs, 8u);
  EXPECT_EQ(results.release_sets, header.release_sets);
  EXPECT_EQ(results.set_of_point, header.set_of_point);
  EXPECT_EQ(results.blocks[1].library_block(), "B");
  EXPECT_EQ(results.blocks[1].group, "hard");
  EXPECT_EQ(results.blocks[1].scale, 1.25);
  EXPECT_EQ(results.blocks[1].volume, 0.2);
  EXPECT_EQ(results.blocks[1].shape, 1u);
  EXPECT_EQ(results.blocks[1].moments, Vec3(3, 4, 5));
  ASSERT_EQ(results.shapes.size(), 2u);
  EXPECT_EQ(results.shapes[1].vertices, header.shapes[1].vertices);
  EXPECT_EQ(results.shapes[1].edges, header.shapes[1].edges);
  EXPECT_EQ(results.shapes[1].faces, header.shapes[1].faces);
  EXPECT_EQ(results.shapes[1].radius, 0.05);
  ASSERT_EQ(results.ground_sets.size(), 2u);
  EXPECT_EQ(results.ground_sets[1].group, "hard");
  EXPECT_EQ(results.ground_sets[1].member, 1u);
  EXPECT_EQ(results.ground_sets[1].zones[0].friction, 0.6);
  EXPECT_EQ(results.ground_sets[1].zones[1].rolling_friction, 0.1);
  EXPECT_EQ(results.ground_sets[0].zones[1].energy_restitution, 0.04);
}

// Files of the first weeks of schema 4 do not hold them.
TEST(Results, WithoutRollingLengthsOrSoilAreReadAsStatingNone) {
  const ScratchFolder folder;
  const fs::path target = folder / "r.h5";
  ResultsWriter::create(target, sample_header()).finish();
  {
    Hdf5File file = Hdf5File::open(target, "clast results", 4, true);
    for (const char* group : {"ground", "ground_sets"}) {
      file.root().open_group(group).remove("rolling_length_m");
      for (const char* soil : {"friction_min", "slip_growth_per_m", "slip_memory_s", "scar_drag",
                               "soil_density_kg_m3", "soil_memory_m"}) {
        file.root().open_group(group).remove(soil);
      }
    }
    file.flush();
  }
  const CampaignResults results = read_results(target);
  EXPECT_EQ(results.ground[0].rolling_friction, 0.35);
  EXPECT_EQ(results.ground[0].rolling_length, 0.0);
  EXPECT_EQ(results.ground[0].scar_drag, 0.0);
  EXPECT_EQ(results.ground_sets[0].zones[0].rolling_length, 0.0);
  EXPECT_EQ(results.ground_sets[0].zones[0].slip_growth, 0.0);
}

// Files of schema 3 hold one stiffness and step for all runs, and no depths.
TEST(Results, OneStiffnessForAllRunsIsReadAsEveryRuns) {
  const ScratchFolder folder;
  const fs::path target = folder / "r.h5";
  {
    ResultsWriter writer = ResultsWriter::create(target, sample_header());
    for (const std::uint32_t run : {0u, 1u}) add_run(writer, run);
    writer.finish();
  }
  {
    Hdf5File file = Hdf5File::open(target, "clast results", 4, true);
    Hdf5Group root = file.root(), runs = root.open_group("runs"),
              contact = root.open_group("contact");
    root.set_attribute<std::int64_t>("schema_version", 3);
    double value = 1e8;
    for (const char* name : {"stiffness_n_m", "tangential_stiffness_n_m",
                             "rolling_stiffness_n_m_rad", "time_step_s"}) {
      runs.remove(name);
      contact.set_attribute<double>(name, value);
      value *= 2.0;
    }
    for (const char* name : {"rest_depth_m", "impact_depth_m"}) runs.remove(name);
    file.flush();
  }
  const CampaignResults results = read_results(target);
  ASSERT_EQ(results.runs.size(), 2u);
  for (const RunRecord& run : results.runs) {
    EXPECT_EQ(run.stiffness.normal, 1e8);
    EXPECT_EQ(run.stiffness.tangential, 2e8);
    EXPECT_EQ(run.stiffness.rolling, 4e8);
    EXPECT_EQ(run.stiffness.time_step, 8e8);
    EXPECT_TRUE(std::isnan(run.settled_depth) && std::isnan(run.impact_depth));
  }
  const std::vector<BlockStiffnessRanges> blocks =
      collect_stiffness_by_block(results, results.runs);
  EXPECT_EQ(
      format_stiffness_cells(blocks[0]),
      (std::vector<std::string>{"1e+08", "2e+08", "1.44e+06 to 4e+08", "8e+08", "-", "-", "-"}));
}

TEST(Results, CampaignWithoutBarriersDownslopeAndTrajectoriesIsStored) {
  const ScratchFolder folder;
  CampaignResults header = sample_header();
  header.barriers.clear();
  header.downslope.reset();
  header.warnings.clear();
  ResultsWriter writer = ResultsWriter::create(folder / "r.h5", header);
  StoredRun run;
  run.record = sample_run(0).record;
  writer.add(run);
  writer.finish();
  const CampaignResults results = read_results(folder / "r.h5");
  EXPECT_TRUE(results.barriers.empty());
  EXPECT_TRUE(results.warnings.empty());
  EXPECT_FALSE(results.downslope);
  EXPECT_EQ(results.runs.size(), 1u);
  const std::string message = refusal([&] { read_trajectory(folder / "r.h5", 0); });
  EXPECT_TRUE(contains(message, "r.h5: no trajectory of run 0; none are stored")) << message;
}

TEST(Results, UnknownRunHasNoTrajectory) {
  const ScratchFolder folder;
  ResultsWriter writer = ResultsWriter::create(folder / "r.h5", sample_header());
  add_run(writer, 1);
  writer.finish();
  const std::string message = refusal([&] { read_trajectory(folder / "r.h5", 7); });
  EXPECT_TRUE(contains(message, "no trajectory of run 7; there is no such run")) << message;
}

TEST(Results, InterruptedCampaignGoesOnWhereItStopped) {
  const ScratchFolder folder;
  const fs::path target = folder / "r.h5";
  {
    ResultsWriter writer = ResultsWriter::create(target, sample_header());
    for (const std::uint32_t run : {4u, 1u, 2u}) add_run(writer, run);
  }
  EXPECT_FALSE(fs::exists(target));
  ResultsWriter writer = ResultsWriter::resume(target, sample_header());
  EXPECT_EQ(writer.completed_runs(), (std::vector<std::uint32_t>{1, 2, 4}));
  for (const std::uint32_t run : {0u, 3u}) add_run(writer, run);
  writer.finish();
  expect_runs(target, {0, 1, 2, 3, 4});
}

TEST(Results, HalfARunLeftByAKillIsDropped) {
  const ScratchFolder folder;
  const fs::path target = folder / "r.h5";
  const fs::path part = results_journal_path(target);
  { ResultsWriter writer = ResultsWriter::create(target, sample_header()); }
  const std::uint64_t begin = fs::file_size(part);
  {
    ResultsWriter writer = ResultsWriter::resume(target, sample_header());
    for (const std::uint32_t run : {1u, 2u}) add_run(writer, run);
  }
  const std::string whole = read_text_file(part);
  const auto stored_after = [&](const std::string& bytes) {
    write_text_file(part, bytes);
    return ResultsWriter::resume(target, sample_header()).completed_runs();
  };
  const std::vector<std::uint32_t> both{1, 2}, first{1}, none;
  EXPECT_EQ(stored_after(whole), both);
  EXPECT_EQ(stored_after(whole.substr(0, whole.size() - 1)), first);
  EXPECT_EQ(stored_after(whole + "\x01\x02\x03"), both);
  EXPECT_EQ(stored_after(whole.substr(0, begin + 5)), none);
  EXPECT_EQ(stored_after(whole.substr(0, begin)), none);
  std::string flipped = whole;
  flipped[whole.size() - 100] ^= 1;
  EXPECT_EQ(stored_after(flipped), first);

  write_text_file(part, whole.substr(0, whole.size() - 1));
  ResultsWriter writer = ResultsWriter::resume(target, sample_header());
  for (const std::uint32_t run : {2u, 0u}) add_run(writer, run);
  writer.finish();
  expect_runs(target, {0, 1, 2});
}

TEST(Results, FileDoesNotDependOnTheOrderOfRunsOrOnInterruptions) {
  const ScratchFolder folder;
  {
    ResultsWriter writer = ResultsWriter::create(folder / "a.h5", sample_header());
    for (const std::uint32_t run : {0u, 1u, 2u}) add_run(writer, run);
    writer.finish();
  }
  {
    ResultsWriter writer = ResultsWriter::create(folder / "b.h5", sample_header());
    for (const std::uint32_t run : {2u, 0u}) add_run(writer, run);
  }
  ResultsWriter writer = ResultsWriter::resume(folder / "b.h5", sample_header());
  add_run(writer, 1);
  writer.finish();
  expect_equal_results(folder / "a.h5", folder / "b.h5");
}

TEST(Results, KilledWriterLosesNoRunItReported) {
  const ScratchFolder folder;
  CampaignResults header = sample_header();
  header.planned_runs = 100000;
  header.release_points.assign(25000, Vec3::Zero());
  header.set_of_point.assign(25000, 0);
  for (int kill = 0; kill < 3; ++kill) {
    const fs::path target = folder / ("r" + std::to_string(kill) + ".h5");
    int reports[2];
    ASSERT_EQ(::pipe(reports), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ResultsWriter writer = ResultsWriter::create(target, header);
      for (std::uint32_t run = 0; run < header.planned_runs; ++run) {
        add_run(writer, run);
        if (::write(reports[1], "r", 1) != 1) break;
      }
      ::_exit(0);
    }
    ::close(reports[1]);
    char report;
    const std::uint32_t minimum = 3 + static_cast<std::uint32_t>(kill);
    for (std::uint32_t run = 0; run < minimum; ++run) ASSERT_EQ(::read(reports[0], &report, 1), 1);
    ::usleep(1000u * static_cast<unsigned>(kill));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(reports[0]);

    ResultsWriter writer = ResultsWriter::resume(target, header);
    const std::vector<std::uint32_t> stored = writer.completed_runs();
    ASSERT_GE(stored.size(), minimum);
    std::vector<std::uint32_t> expected(stored.size() + 1);
    for (std::uint32_t i = 0; i < expected.size(); ++i) expected[i] = i;
    add_run(writer, static_cast<std::uint32_t>(stored.size()));
    writer.finish();
    expect_runs(target, expected);
  }
}

TEST(Results, AnotherCampaignIsNotResumed) {
  const ScratchFolder folder;
  const fs::path target = folder / "r.h5";
  const auto refused = [&](const CampaignResults& header) {
    return refusal([&] { ResultsWriter::resume(target, header); });
  };
  EXPECT_TRUE(contains(refused(sample_header()), "r.h5.part: no such file"));
  for (const char* text : {"", "something else altogether", "clast results journal 1\nxyz"}) {
    write_text_file(results_journal_path(target), text);
    EXPECT_TRUE(contains(refused(sample_header()), "r.h5.part: is not the journal")) << text;
  }
  { ResultsWriter writer = ResultsWriter::create(target, sample_header()); }
  CampaignResults other = sample_header();
  other.campaign_sha256 = std::string(64, 'd');
  EXPECT_TRUE(contains(refused(other), "r.h5.part: was begun with another campaign file"));
  other = sample_header();
  other.inputs[0] = "some folder/b.h5 " + std::string(64, 'e');
  EXPECT_TRUE(contains(refused(other), "other input files (some folder/b.h5 has changed)"));
  other = sample_header();
  other.program_version = "0.0.1";
  EXPECT_TRUE(contains(refused(other), "this is clast 0.0.1"));
  // The same file in another place is the same input.
  other = sample_header();
  other.inputs[0] = "elsewhere/b.h5 " + std::string(64, 'b');
  EXPECT_EQ(refused(other), "");
}

TEST(Results, FilesThatAreNoResultsAreNotReplaced) {
  const ScratchFolder folder;
  const fs::path target = folder / "campaign.toml", whole = folder / "r.h5";
  write_text_file(target, "[blocks]\n");
  const std::string problem =
      "campaign.toml: already exists and holds \"text\", not \"clast results\", so it is not";
  EXPECT_TRUE(contains(refusal([&] { ResultsWriter::create(target, sample_header()); }), problem));
  EXPECT_TRUE(contains(refusal([&] { ResultsWriter::resume(target, sample_header()); }), problem));
  {
    ResultsWriter writer = ResultsWriter::create(whole, sample_header());
    for (std::uint32_t run = 0; run < sample_header().planned_runs; ++run) add_run(writer, run);
    writer.finish();
  }
  EXPECT_TRUE(contains(refusal([&] { merge_results({whole}, target); }), problem));
  EXPECT_EQ(read_text_file(target), "[blocks]\n");
  // Results are, and so is what a shell or a queue made beforehand.
  EXPECT_EQ(refusal([&] { ResultsWriter::create(whole, sample_header()); }), "");
  write_text_file(target, "");
  EXPECT_EQ(refusal([&] { ResultsWriter::create(target, sample_header()); }), "");
}

}  // namespace
}  // namespace clast
