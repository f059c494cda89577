#include "study/results.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "core/error.hpp"
#include "core/hdf5_file.hpp"
#include "core/random.hpp"
#include "core/text_file.hpp"
#include "core/version.hpp"
#include "study/results_journal.hpp"
#include "tests/study/results_equal.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

CampaignResults sample_header() {
  CampaignResults header;
  header.campaign_text = "[blocks]\nlibrary = \"b.h5\"\n";
  header.campaign_sha256 = std::string(64, 'a');
  header.inputs = {"some folder/b.h5 " + std::string(64, 'b'), "t.stl " + std::string(64, 'c')};
  header.program_version = version();
  header.blocks = {{"B1", 343.68, {1.1, 0.9, 0.5}, "compact", "CB", "blade"},
                   {"B2", 514.14, {2.1, 0.9, 0.5}, "elongated", "E", "rod"}};
  header.barriers = {{"EC11", {25, -400}, {25, -340}}, {"EC12", {36, -400}, {36, -340}}};
  header.release_points = {{1, 2, 3}, {4, 5, 6}};
  header.zone_names = {"blue", "gray"};
  header.ground = {{0.01, 0.7, 0.35}, {0.04, 0.3, 0.0}};
  header.stiffness = {1e8, 2e8, 3e7, 2e-5};
  header.law = SpringDashpotLaw{};
  header.weights = ContactWeights::kOverlap;
  header.warnings = {"mind the gap"};
  header.downslope = Vec2(1.0, 0.25);
  header.terrain.surface.vertices = {{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0.25}, {0, 1, 0}};
  header.terrain.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  header.terrain.zone = {1, 0};
  header.terrain.zone_names = header.zone_names;
  header.terrain.report.notes = {"2 triangles turned"};
  header.terrain.sources = {"t.stl " + std::string(64, 'c')};
  header.terrain.frame = {Vec3(888600, 6671300, 0), "EPSG:2154"};
  header.frame = header.terrain.frame;
  header.planned_runs = 8;
  return header;
}

RigidState random_state(Random& random) {
  const auto vector = [&] { return Vec3(random.normal(), random.normal(), random.normal()); };
  RigidState state;
  state.position = vector();
  state.orientation = random.rotation();
  state.velocity = vector();
  state.angular_velocity = vector();
  return state;
}

// A run with a value of its own in every field.
StoredRun sample_run(std::uint32_t number) {
  Random random(number);
  StoredRun run;
  run.record.run = number;
  run.record.block = number % 2;
  run.record.point = number / 4;
  run.record.orientation = number % 4;
  run.record.start = random_state(random);
  ReleaseResult& result = run.record.result;
  result.stop_reason = static_cast<StopReason>(number % 4);
  result.message = result.stop_reason == StopReason::kError ? "the sky fell (Gallien, -335)" : "";
  result.final_state = random_state(random);
  for (double* value :
       {&result.duration, &result.path_length, &result.max_speed, &result.max_penetration,
        &result.settled_penetration, &result.energy.initial, &result.energy.final,
        &result.energy.normal, &result.energy.friction, &result.energy.rolling,
        &result.energy.reassigned, &result.energy.error}) {
    *value = random.normal();
  }
  result.below_ground = number % 3 == 0;
  result.contact_steps = 5'000'000'000ULL + number;
  result.impacts = number;
  for (std::uint32_t i = 0; i < number % 3; ++i) {
    Crossing crossing;
    crossing.run = number;
    crossing.barrier = i;
    crossing.forward = i == 0;
    const RigidState state = random_state(random);
    crossing.position = state.position;
    crossing.velocity = state.velocity;
    crossing.angular_velocity = state.angular_velocity;
    for (double* value : {&crossing.time, &crossing.height, &crossing.clearance,
                          &crossing.translational_energy, &crossing.rotational_energy}) {
      *value = random.uniform();
    }
    run.crossings.push_back(crossing);
  }
  for (std::uint32_t i = 0; i < 50 + number; ++i) {
    run.trajectory.time.push_back(0.1 * i);
    run.trajectory.states.push_back(random_state(random));
  }
  return run;
}

void add_run(ResultsWriter& writer, std::uint32_t number) {
  const StoredRun run = sample_run(number);
  writer.add(run.record, run.crossings, run.trajectory);
}

// That the file holds the sample runs `numbers` (sorted), whole.
void expect_runs(const fs::path& file, const std::vector<std::uint32_t>& numbers) {
  const CampaignResults results = read_results(file);
  ASSERT_EQ(results.runs.size(), numbers.size());
  std::size_t crossing = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const StoredRun run = sample_run(numbers[i]);
    expect_equal(results.runs[i], run.record);
    for (const Crossing& expected : run.crossings) {
      ASSERT_LT(crossing, results.crossings.size());
      expect_equal(results.crossings[crossing++], expected);
    }
    expect_equal(read_trajectory(file, numbers[i]), run.trajectory);
  }
  EXPECT_EQ(crossing, results.crossings.size());
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
  EXPECT_FALSE(fs::exists(partial_results(target)));
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
  EXPECT_EQ(results.barriers[1].from, Vec2(36, -400));
  EXPECT_EQ(results.barriers[1].to, Vec2(36, -340));
  EXPECT_EQ(results.release_points, header.release_points);
  EXPECT_EQ(results.zone_names, header.zone_names);
  ASSERT_EQ(results.ground.size(), 2u);
  EXPECT_EQ(results.ground[0].rolling_friction, 0.35);
  EXPECT_EQ(results.ground[1].energy_restitution, 0.04);
  EXPECT_EQ(results.ground[1].friction, 0.3);
  EXPECT_EQ(results.stiffness.normal, 1e8);
  EXPECT_EQ(results.stiffness.tangential, 2e8);
  EXPECT_EQ(results.stiffness.rolling, 3e7);
  EXPECT_EQ(results.stiffness.time_step, 2e-5);
  EXPECT_EQ(results.weights, ContactWeights::kOverlap);
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
}

TEST(Results, CampaignWithoutBarriersDownslopeAndTrajectoriesIsStored) {
  const ScratchFolder folder;
  CampaignResults header = sample_header();
  header.barriers.clear();
  header.downslope.reset();
  header.warnings.clear();
  ResultsWriter writer = ResultsWriter::create(folder / "r.h5", header);
  writer.add(sample_run(0).record, {}, {});
  writer.finish();
  const CampaignResults results = read_results(folder / "r.h5");
  EXPECT_TRUE(results.barriers.empty());
  EXPECT_TRUE(results.warnings.empty());
  EXPECT_FALSE(results.downslope);
  EXPECT_EQ(results.runs.size(), 1u);
  const std::string message = refusal([&] { read_trajectory(folder / "r.h5", 0); });
  EXPECT_TRUE(contains(message, "r.h5: no trajectory of run 0; none were stored")) << message;
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
  EXPECT_EQ(writer.stored_runs(), (std::vector<std::uint32_t>{1, 2, 4}));
  for (const std::uint32_t run : {0u, 3u}) add_run(writer, run);
  writer.finish();
  expect_runs(target, {0, 1, 2, 3, 4});
}

TEST(Results, HalfARunLeftByAKillIsDropped) {
  const ScratchFolder folder;
  const fs::path target = folder / "r.h5";
  const fs::path part = partial_results(target);
  { ResultsWriter writer = ResultsWriter::create(target, sample_header()); }
  const std::uint64_t begin = fs::file_size(part);
  {
    ResultsWriter writer = ResultsWriter::resume(target, sample_header());
    for (const std::uint32_t run : {1u, 2u}) add_run(writer, run);
  }
  const std::string whole = read_text_file(part);
  const auto stored_after = [&](const std::string& bytes) {
    write_text_file(part, bytes);
    return ResultsWriter::resume(target, sample_header()).stored_runs();
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
    const std::uint32_t least = 3 + static_cast<std::uint32_t>(kill);
    for (std::uint32_t run = 0; run < least; ++run) ASSERT_EQ(::read(reports[0], &report, 1), 1);
    ::usleep(1000u * static_cast<unsigned>(kill));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(reports[0]);

    ResultsWriter writer = ResultsWriter::resume(target, header);
    const std::vector<std::uint32_t> stored = writer.stored_runs();
    ASSERT_GE(stored.size(), least);
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
    write_text_file(partial_results(target), text);
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

TEST(Results, WhatIsNotAResultsFileIsRefused) {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& name) {
    return refusal([&] { read_results(folder / name); });
  };
  EXPECT_TRUE(contains(refused("none.h5"), "none.h5: no such file"));
  write_text_file(folder / "unfinished.h5.part", "clast results journal 1\n");
  EXPECT_TRUE(contains(refused("unfinished.h5.part"), "not finished; go on with it first"));
  write_text_file(folder / "empty.h5", "");
  EXPECT_TRUE(contains(refused("empty.h5"), "empty.h5: is empty"));
  write_text_file(folder / "text.h5", "no HDF5 at all");
  EXPECT_TRUE(contains(refused("text.h5"), "text.h5: is not an HDF5 file"));
  Hdf5File::create(folder / "blocks.h5", "clast block library", 1);
  EXPECT_TRUE(contains(refused("blocks.h5"), "blocks.h5: is a \"clast block library\" file"));
  Hdf5File::create(folder / "newer.h5", "clast results", 2);
  EXPECT_TRUE(contains(refused("newer.h5"), "newer.h5: has schema version 2"));
  Hdf5File::create(folder / "bare.h5", "clast results", 1);
  EXPECT_TRUE(contains(refused("bare.h5"), "campaign_sha256 is missing"));
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
      Hdf5File file = Hdf5File::open(bad, "clast results", 1, true);
      Hdf5Group root = file.root();
      change(root);
      file.flush();
    }
    return refusal([&] { read_results(bad); });
  };
  const auto replaced = [&](const std::string& group, const std::string& name, auto values,
                            const std::vector<std::size_t>& shape = {}) {
    return after([&](Hdf5Group& root) {
      Hdf5Group parent = root.group(group);
      parent.remove(name);
      parent.write<typename decltype(values)::value_type>(name, values, shape);
    });
  };
  EXPECT_EQ(after([](Hdf5Group&) {}), "");
  EXPECT_TRUE(contains(after([](Hdf5Group& root) { root.group("runs").remove("stop_x_m"); }),
                       "bad.h5: /runs/stop_x_m is missing"));
  EXPECT_TRUE(contains(after([](Hdf5Group& root) { root.remove("terrain"); }),
                       "bad.h5: /terrain is missing"));
  EXPECT_TRUE(contains(replaced("runs", "duration_s", std::vector<double>{1.0, 2.0}),
                       "bad.h5: /runs/duration_s has 2 values where 3 belong"));
  EXPECT_TRUE(contains(replaced("runs", "block", std::vector<std::uint32_t>{0, 1, 2}),
                       "bad.h5: /runs/block holds 2, which must be below 2"));
  EXPECT_TRUE(contains(replaced("runs", "run", std::vector<std::uint32_t>{0, 1, 1}),
                       "bad.h5: /runs/run holds 1 after 1"));
  EXPECT_TRUE(contains(replaced("runs", "stop_reason", std::vector<std::uint8_t>{0, 1, 9}),
                       "bad.h5: /runs/stop_reason holds 9"));
  EXPECT_TRUE(contains(replaced("crossings", "run", std::vector<std::uint32_t>{1, 2, 5}),
                       "bad.h5: /crossings/run holds run 5, which is not stored"));
  EXPECT_TRUE(contains(replaced("crossings", "barrier", std::vector<std::uint32_t>{0, 0, 7}),
                       "bad.h5: /crossings/barrier holds 7, which must be below 2"));
  EXPECT_TRUE(contains(replaced("terrain", "triangles", std::vector<std::uint32_t>{0, 1, 4}),
                       "bad.h5: /terrain/triangles holds 4, which must be below 4"));
  EXPECT_TRUE(contains(replaced("blocks", "mass_kg", std::vector<double>{1.0}),
                       "bad.h5: /blocks/mass_kg has 1 values where 2 belong"));
  EXPECT_TRUE(contains(replaced("barriers", "to_m", std::vector<double>{1.0, 2.0}, {1, 2}),
                       "bad.h5: /barriers/from_m and to_m do not have one row per name"));
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
