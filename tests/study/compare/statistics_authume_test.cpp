/// Our summaries against the barrier statistics of the public Authume runs, computed by others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <vector>

#include "core/files/text_file.hpp"
#include "core/statistics/statistics.hpp"
#include "core/types.hpp"
#include "tests/study/csv_reader.hpp"

namespace clast {
namespace {

std::filesystem::path data_folder() {
  const char* folder = std::getenv("CLAST_DATA");
  return folder != nullptr ? std::filesystem::path(folder)
                           : std::filesystem::path(CLAST_SOURCE_DIR) / ".." / "shared" / "data";
}

/// Without lines that have fewer cells than the header: barriers that nothing crossed.
std::string full_lines(const std::string& text) {
  std::istringstream lines(text);
  std::string line, kept;
  std::ptrdiff_t commas = -1;
  while (std::getline(lines, line)) {
    const std::ptrdiff_t here = std::count(line.begin(), line.end(), ',');
    if (commas < 0) commas = here;
    if (here == commas) kept += line + "\n";
  }
  return kept;
}

TEST(AuthumeBarrierStatistics, FollowFromTheCrossings) {
  const std::filesystem::path folder = data_folder() / "authume" / "sim";
  ASSERT_TRUE(std::filesystem::exists(folder / "crossings.csv"))
      << folder << ": the Authume data are not there; set CLAST_DATA to the folder that holds them";
  const CsvTable crossings = read_csv(read_text_file(folder / "crossings.csv"));
  const CsvTable published = read_csv(full_lines(read_text_file(folder / "barrier_stats.csv")));

  std::map<std::string, std::vector<double>> samples;
  for (std::size_t i = 0; i < crossings.rows.size(); ++i) {
    const auto& row = crossings.rows[i];
    const std::string key = row.at("profile") + row.at("block") + row.at("barrier");
    samples[key + "speed_m_s"].push_back(crossings.number(i, "speed"));
    samples[key + "E_trans_kJ"].push_back(crossings.number(i, "E_trans_kJ"));
    samples[key + "E_rot_kJ"].push_back(crossings.number(i, "E_rot_kJ"));
    samples[key + "centroid_height_m"].push_back(crossings.number(i, "height_above_ground"));
    samples[key + "rotation_rps"].push_back(std::hypot(crossings.number(i, "wx"),
                                                       crossings.number(i, "wy"),
                                                       crossings.number(i, "wz")) /
                                            (2.0 * kPi));
  }

  // Both tables are rounded: to 0.005, and crossings to 0.00005.
  constexpr double kRounding = 0.0051;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < published.rows.size(); ++i) {
    const auto& row = published.rows[i];
    const auto sample =
        samples.find(row.at("profile") + row.at("block") + row.at("barrier") + row.at("quantity"));
    ASSERT_NE(sample, samples.end()) << row.at("quantity");
    const SampleSummary summary = summarise_sample(sample->second);
    SCOPED_TRACE(sample->first);
    EXPECT_EQ(static_cast<double>(summary.count), published.number(i, "n_cross_of_256"));
    EXPECT_NEAR(summary.mean, published.number(i, "mean"), kRounding);
    // Theirs divides by n, ours by n - 1.
    const double n = static_cast<double>(summary.count);
    EXPECT_NEAR(summary.std * std::sqrt((n - 1.0) / n), published.number(i, "std"), kRounding);
    EXPECT_NEAR(summary.p95, published.number(i, "p95"), kRounding);
    EXPECT_NEAR(summary.median, published.number(i, "median"), kRounding);
    EXPECT_NEAR(summary.max, published.number(i, "max"), kRounding);
    ++compared;
  }
  EXPECT_EQ(compared, published.rows.size());
}

}  // namespace
}  // namespace clast
