#pragma once
/// Runs of one or more campaigns side by side, by block and by shape class.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "study/results.hpp"
#include "study/statistics.hpp"

namespace clast {

/// One row of runs.csv. Positions are on the map.
struct RunRow {
  std::uint32_t file = 0;          ///< which results file
  const RunRecord* record = nullptr;
  const BlockSummary* block = nullptr;
  Vec3 start = Vec3::Zero();
  Vec3 stop = Vec3::Zero();
  double runout = 0.0;             ///< m, along downslope
  double lateral = 0.0;            ///< rad, + to the right looking downslope
};

/// Runs of a group: all, one block ("block SP1A"), or one class ("class compact").
struct Group {
  std::string name;
  std::vector<std::size_t> rows;   ///< into Comparison::rows
};

/// First forward crossings of one group at one barrier.
struct BarrierGroup {
  std::string barrier;
  std::string group;
  std::size_t started = 0;
  std::size_t crossed = 0;
  double probability = 0.0;
  Summary height, clearance, speed;                    ///< m, m, m/s
  Summary translational, rotational, total;            ///< J
  Summary rotation_rate;                               ///< rad/s
};

/// Everything the tables and the report are made from.
struct Comparison {
  std::vector<CampaignResults> results;
  Vec2 downslope = Vec2::UnitX();  ///< unit; as asked for, else along the mean release-to-stop line
  std::vector<RunRow> rows;        ///< in order of file and run
  std::vector<Group> groups;
  std::vector<BarrierGroup> barriers;
  std::vector<std::string> warnings;  ///< for example "mass differs between classes"
};

/// @throws InputError  no runs, or results on terrains with different map frames
Comparison compare(std::vector<CampaignResults> results);

/// runs.csv, barriers.csv, crossings.csv and deposits.csv as text; columns in docs/formats.md.
std::string runs_csv(const Comparison& comparison);
std::string barriers_csv(const Comparison& comparison);
std::string crossings_csv(const Comparison& comparison);
std::string deposits_csv(const Comparison& comparison);

/// Writes the tables, stops.gpkg (stops and crossings as map points) and report.html to `folder`.
void write_comparison(const Comparison& comparison, const std::filesystem::path& folder);

}  // namespace clast
