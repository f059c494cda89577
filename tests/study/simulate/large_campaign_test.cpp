// A campaign of 100,000 runs: it is compared in bounded memory, and its report stays usable.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <ctime>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "report/comparison_report.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

constexpr std::uint32_t kRuns = 100'000;
constexpr std::uint32_t kReleasePoints = 20;
constexpr int kFrames = 12;

/// Sixteen blocks, half of each class, from twenty points; with crossings and trajectories.
void store_many(const std::filesystem::path& file) {
  CampaignResults header = hand_made_results();
  const std::vector<BlockSummary> kinds = header.blocks;
  header.blocks.clear();
  for (int i = 0; i < 16; ++i) {
    header.blocks.push_back(kinds[i % 2]);
    header.blocks.back().id = "block " + std::to_string(i);
  }
  header.release_points.clear();
  for (std::uint32_t i = 0; i < kReleasePoints; ++i)
    header.release_points.emplace_back(0.0, i, 2.0);
  header.release_sets = {""};
  header.set_of_point.assign(kReleasePoints, 0);
  header.ground_sets = {{"", 0, header.ground}};
  header.planned_runs = kRuns;
  Random random(4);
  ResultsWriter writer = ResultsWriter::create(file, header);
  for (std::uint32_t run = 0; run < kRuns; ++run) {
    StoredRun stored;
    stored.record =
        hand_made_run(run, run % 16, random.uniform(5.0, 45.0), random.uniform(-15.0, 15.0));
    stored.record.point = run / 16 % kReleasePoints;
    stored.crossings = {hand_made_crossing(run, 0, 1.0, random.uniform(1.0, 9.0))};
    for (int frame = 0; frame <= kFrames; ++frame) {
      RigidState state = stored.record.start;
      const double share = static_cast<double>(frame) / kFrames;
      state.position += share * (stored.record.result.final_state.position - state.position);
      stored.trajectory.time.push_back(0.1 * frame);
      stored.trajectory.states.push_back(state);
    }
    writer.add(stored);
  }
  writer.finish();
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TEST(LargeCampaign, IsComparedInMemoryAndReportedInLessThan30Megabytes) {
  const ScratchFolder folder;
  store_many(folder / "many.h5");
  const double begin = cpu_seconds();
  const Comparison comparison = compared(read_results(folder / "many.h5"));
  write_comparison(comparison, folder / "out");
  const double cpu = cpu_seconds() - begin;
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const double gigabytes = static_cast<double>(usage.ru_maxrss) / (1 << 20);
  const std::filesystem::path page = folder / "out" / "report.html";
  const double megabytes = static_cast<double>(std::filesystem::file_size(page)) / (1 << 20);
  std::printf("100,000 runs: compared in %.0f CPU s, %.2f GiB at most, report %.1f MiB\n", cpu,
              gigabytes, megabytes);
  EXPECT_LT(gigabytes, 2.0);
  EXPECT_LT(megabytes, 30.0);
  const std::string html = read_text_file(page);
  EXPECT_TRUE(contains(
      html, "The 100000 stops are too many to show one by one, so the map shows their density"));
  EXPECT_TRUE(contains(html, "16 blocks are too many: at most 12 are compared pair by pair"));
  EXPECT_TRUE(contains(html, " of 100000 runs are drawn"));
}

}  // namespace
}  // namespace clast
