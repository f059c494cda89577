#include "study/compare/detail/comparison_barriers.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/statistics/bootstrap.hpp"
#include "study/campaign/barrier_line.hpp"

namespace clast::study_detail {
namespace {

/// Lines of all files, and for every file the first line that each of its barriers is.
struct Lines {
  std::vector<BarrierLine> lines;
  std::vector<std::vector<std::size_t>> line_of;
};

/// Crossings of one ring lie at two lines, entries first.
Lines collect_lines(const std::vector<CampaignResults>& results) {
  using Counts = BarrierLine::Counts;
  Lines found;
  std::vector<std::string> plain_names;
  for (std::uint32_t file = 0; file < results.size(); ++file) {
    const Vec2 origin = results[file].frame.origin.head<2>();
    std::vector<std::size_t> line_of;
    for (const Barrier& barrier : results[file].barriers) {
      std::vector<Vec2> through = barrier.vertices;
      for (Vec2& point : through) point += origin;
      const Counts counts =
          barrier.counted == CountedDirection::kForward ? Counts::kForward : Counts::kEither;
      std::size_t line = 0;
      bool name_taken = false;
      for (; line < found.lines.size(); ++line) {
        if (plain_names[line] != barrier.name) continue;
        if (found.lines[line].vertices == through &&
            (is_ring(through) || found.lines[line].counts == counts)) {
          break;
        }
        name_taken = true;
      }
      const bool ring = is_ring(through);
      if (line == found.lines.size()) {
        const std::string name =
            barrier.name + (name_taken ? " (file " + std::to_string(file + 1) + ")" : "");
        if (ring) {
          found.lines.push_back({name + " (in)", through, {}, Counts::kEntries});
          found.lines.push_back({name + " (out)", through, {}, Counts::kExits});
        } else {
          found.lines.push_back({name, through, {}, counts});
        }
        plain_names.resize(found.lines.size(), barrier.name);
      }
      for (std::size_t i = line; i < line + (ring ? 2 : 1); ++i) {
        std::vector<std::uint32_t>& files = found.lines[i].files;
        if (files.empty() || files.back() != file) files.push_back(file);
      }
      line_of.push_back(line);
    }
    found.line_of.push_back(std::move(line_of));
  }
  return found;
}

/// Row of every (file, run number).
std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> rows_by_run(
    const std::vector<CampaignResults>& results, const std::vector<RunRow>& rows) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> found;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!found.emplace(std::pair(rows[i].file, rows[i].record->run), i).second) {
      throw InputError(results[rows[i].file].file.string() + ": run " +
                       std::to_string(rows[i].record->run) +
                       " is stored twice; the file is damaged, run the campaign again");
    }
  }
  return found;
}

std::vector<BarrierCrossing> collect_crossings(const std::vector<CampaignResults>& results,
                                               const std::vector<RunRow>& rows,
                                               const Lines& lines) {
  const auto row_of = rows_by_run(results, rows);
  std::vector<BarrierCrossing> crossings;
  for (std::uint32_t file = 0; file < results.size(); ++file) {
    for (const Crossing& crossing : results[file].crossings) {
      const auto row = row_of.find({file, crossing.run});
      if (row == row_of.end() || crossing.barrier >= results[file].barriers.size()) {
        throw InputError(results[file].file.string() + ": a crossing of run " +
                         std::to_string(crossing.run) + " at barrier number " +
                         std::to_string(crossing.barrier) +
                         " belongs to no run or barrier of the file; the file is damaged, run the "
                         "campaign again");
      }
      std::size_t line = lines.line_of[file][crossing.barrier];
      if (lines.lines[line].belongs_to_ring() && !lines.lines[line].counted(crossing))
        ++line;  // an exit
      crossings.push_back(
          {&crossing, row->second, line, results[file].frame.to_map(crossing.position), false});
    }
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const BarrierCrossing& a, const BarrierCrossing& b) {
                     return std::pair(a.row, a.crossing->time) < std::pair(b.row, b.crossing->time);
                   });
  std::map<std::pair<std::size_t, std::size_t>, bool> counted;  // by row and barrier
  for (BarrierCrossing& crossing : crossings) {
    if (!lines.lines[crossing.barrier].counted(*crossing.crossing)) continue;
    crossing.counted = counted.emplace(std::pair(crossing.row, crossing.barrier), true).second;
  }
  return crossings;
}

/// Largest distance of a block's surface from its centre, m, for each row.
std::vector<double> farthest_skin_points(const std::vector<CampaignResults>& results,
                                         const std::vector<RunRow>& rows) {
  std::map<const BlockSummary*, double> of_block;
  std::vector<double> farthest;
  for (const RunRow& row : rows) {
    const auto [found, is_new] = of_block.emplace(row.block, 0.0);
    if (is_new) {
      const SpheroPolyhedron& shape = results[row.file].shapes.at(row.block->shape);
      for (const Vec3& vertex : shape.vertices) {
        found->second = std::max(found->second, row.block->scale * (vertex.norm() + shape.radius));
      }
    }
    farthest.push_back(found->second);
  }
  return farthest;
}

/// @param farthest  skin point of each crossing's block, m from its centre
BarrierGroupStatistics measure_crossings(const std::vector<const Crossing*>& crossings,
                                         const std::vector<double>& farthest) {
  BarrierGroupStatistics group;
  std::vector<double> tops;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    tops.push_back(crossings[i]->height + farthest[i]);
  }
  group.top = summarise_sample(tops);
  const auto over = [&](auto value) {
    std::vector<double> values;
    for (const Crossing* crossing : crossings) values.push_back(value(*crossing));
    return summarise_sample(values);
  };
  group.height = over([](const Crossing& c) { return c.height; });
  group.clearance = over([](const Crossing& c) { return c.clearance; });
  group.speed = over([](const Crossing& c) { return c.velocity.norm(); });
  group.translational = over([](const Crossing& c) { return c.translational_energy; });
  group.rotational = over([](const Crossing& c) { return c.rotational_energy; });
  group.total =
      over([](const Crossing& c) { return c.translational_energy + c.rotational_energy; });
  group.rotation_rate = over([](const Crossing& c) { return c.angular_velocity.norm(); });
  return group;
}

/// Crossings of one line, by row; none where a run has none.
struct CrossingsOfLine {
  std::vector<const Crossing*> first;  ///< that counts
  std::vector<const Crossing*> any;    ///< first, counted or not
};

CrossingsOfLine first_crossings(const std::vector<BarrierCrossing>& crossings, std::size_t line,
                                std::size_t rows) {
  CrossingsOfLine found{std::vector<const Crossing*>(rows, nullptr),
                        std::vector<const Crossing*>(rows, nullptr)};
  for (const BarrierCrossing& crossing : crossings) {
    if (crossing.barrier != line) continue;
    if (crossing.counted) found.first[crossing.row] = crossing.crossing;
    if (found.any[crossing.row] == nullptr) found.any[crossing.row] = crossing.crossing;
  }
  return found;
}

/// Runs at a barrier; the group's name and index are still to be set.
/// @param farthest  skin point of the block of every row, m from its centre
/// @return none where no run met the barrier
std::optional<BarrierGroupStatistics> group_at_line(const std::vector<CampaignResults>& results,
                                                    const std::vector<RunRow>& rows,
                                                    const BarrierLine& line,
                                                    const CrossingsOfLine& of_line,
                                                    const std::vector<double>& farthest,
                                                    const std::vector<std::size_t>& members) {
  std::size_t started = 0, backward = 0;
  std::vector<const Crossing*> crossings;
  std::vector<double> of_crossings;
  RunClustering clusters(results);
  ClusteredValues hits;
  for (const std::size_t row : members) {
    if (!line.is_in(rows[row].file)) continue;
    // Failed runs are excluded, because they might have passed.
    if (rows[row].record->result.stop_reason == StopReason::kError) continue;
    ++started;
    const Crossing* first = of_line.first[row];
    hits.values.push_back(first != nullptr ? 1.0 : 0.0);
    hits.clusters.push_back(clusters.of(rows[row]));
    if (first != nullptr) {
      crossings.push_back(first);
      of_crossings.push_back(farthest[row]);
    }
    backward +=
        !line.belongs_to_ring() && of_line.any[row] != nullptr && !of_line.any[row]->forward;
  }
  if (started == 0) return std::nullopt;
  BarrierGroupStatistics group = measure_crossings(crossings, of_crossings);
  group.barrier = line.name;
  group.counted = line.counted_direction();
  group.started = started;
  group.crossed = crossings.size();
  group.backward = backward;
  group.probability = static_cast<double>(group.crossed) / static_cast<double>(started);
  if (!clusters.has_single_realisation()) {
    group.interval = clustered_proportion_interval(hits, clusters.count());
  }
  return group;
}

}  // namespace

BarrierComparison compare_barriers(const std::vector<CampaignResults>& results,
                                   const std::vector<RunRow>& rows,
                                   const std::vector<RunGroup>& groups) {
  Lines lines = collect_lines(results);
  BarrierComparison compared;
  compared.crossings = collect_crossings(results, rows, lines);
  compared.lines = std::move(lines.lines);

  const std::vector<double> farthest = farthest_skin_points(results, rows);
  for (std::size_t line = 0; line < compared.lines.size(); ++line) {
    const CrossingsOfLine of_line = first_crossings(compared.crossings, line, rows.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      std::optional<BarrierGroupStatistics> group =
          group_at_line(results, rows, compared.lines[line], of_line, farthest, groups[g].rows);
      if (!group) continue;
      group->group = groups[g].name;
      group->line = line;
      group->group_index = g;
      compared.groups.push_back(std::move(*group));
    }
  }
  return compared;
}

std::vector<BarrierGroupStatistics> barrier_groups_by_draw(
    const Comparison& comparison, std::size_t line, const std::vector<GroundDrawRows>& draws) {
  const CrossingsOfLine of_line =
      first_crossings(comparison.crossings, line, comparison.rows.size());
  const std::vector<double> farthest = farthest_skin_points(comparison.results, comparison.rows);
  std::vector<BarrierGroupStatistics> found;
  for (const GroundDrawRows& draw : draws) {
    std::optional<BarrierGroupStatistics> group = group_at_line(
        comparison.results, comparison.rows, comparison.lines[line], of_line, farthest, draw.rows);
    if (group) found.push_back(std::move(*group));
  }
  return found;
}

}  // namespace clast::study_detail
