#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "core/comma_separated.hpp"
#include "core/number_text.hpp"
#include "study/compare/comparison.hpp"
#include "study/results/block_scale.hpp"

namespace clast {
namespace {

/// Mean block masses of two classes that differ by more than this share are named.
constexpr double kNotableMassDifference = 0.01;
/// Share of the dissipated energy that a run's balance may miss before it is named.
constexpr double kNotableEnergyError = 0.01;

/// p95 of the runs' largest speeds above which a warning is given, m/s.
constexpr double kSeldomSpeed = 30.0;

/// Energies below this share of all that there is are rounding.
constexpr double kRoundedEnergy = 1e-9;

/// Fraction of the runs from which on their fate could reverse a result.
constexpr double kTurningFraction = 0.01;
/// The same for energy that contacts lose or gain, which cancels in part over the runs.
constexpr double kReassignedFraction = 0.1;

std::string of(std::size_t part, std::size_t all) {
  return std::to_string(part) + " of " + std::to_string(all);
}

/// Adds a warning without or with a caution about it.
void warn(Comparison& comparison, const std::string& text, const std::string& brief = {}) {
  comparison.warnings.push_back(text);
  if (!brief.empty()) comparison.cautions.push_back({brief, {text}});
}

void warn_of_unfinished(Comparison& comparison) {
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    if (results.runs.size() >= results.planned_runs) continue;
    const std::string unfinished = "file " + std::to_string(file + 1) + " is unfinished: " +
                                   of(results.runs.size(), results.planned_runs) +
                                   " planned runs are stored";
    warn(comparison,
         unfinished + "; if it is a shard, join it with the others with `merge_results`",
         "F" + unfinished.substr(1) + ".");
  }
}

void warn_of_lost_runs(Comparison& comparison) {
  const DepositStatistics& all = comparison.deposits.front();
  // The caution repeats the count; the warning adds advice.
  const auto count_of = [&](std::size_t count, const std::string& what, const std::string& advice) {
    if (count == 0) return;
    const std::string happened = of(count, all.started) + " runs " + what;
    const bool turning =
        static_cast<double>(count) >= kTurningFraction * static_cast<double>(all.started);
    warn(comparison, happened + advice, turning ? happened + "." : "");
  };
  const std::string in_none = "; they are excluded from deposit statistics";
  const std::string too_short = ", so their runouts are not known";
  count_of(all.stops.error, "failed with an error", in_none);
  count_of(all.stops.max_time, "were still moving at max_time" + too_short,
           in_none + ". Raise [run] max_time_s");
  count_of(all.stops.left_terrain, "left the surveyed terrain" + too_short,
           in_none + ". Extend the terrain");
  std::size_t below = 0, unbalanced = 0;
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.below_ground) ++below;
    // Written so that a balance that is not a number counts too.
    if (comparison.results[row.file].has_contacts() &&
        row.record->result.stop_reason != StopReason::kError &&
        !(row.record->result.energy.error <= kNotableEnergyError)) {
      ++unbalanced;
    }
  }
  count_of(below, "ended below ground", "; their stops are unreliable");
  count_of(unbalanced,
           "have an error of more than 1 % of the dissipated energy in their energy balance",
           "; try a smaller [contact] time_step_s");
}

void warn_of_reassigned(Comparison& comparison) {
  std::size_t count = 0;
  double largest = 0.0;
  const RunRow* worst = nullptr;
  for (const RunRow& row : comparison.rows) {
    const std::optional<double> share = reassigned_energy_fraction(row.record->result.energy);
    if (!share || !(*share > kNotableReassignedFraction)) continue;
    ++count;
    if (*share > largest) worst = &row;
    largest = std::max(largest, *share);
  }
  if (count == 0) return;
  const std::string happened =
      of(count, comparison.rows.size()) +
      " runs lose or gain more than 10 % of the energy they dissipate when contacts begin or end "
      "or when their stiffness is redistributed";
  const bool turning = static_cast<double>(count) >=
                       kReassignedFraction * static_cast<double>(comparison.rows.size());
  warn(comparison,
       happened + " (at most " + format_significant(100.0 * largest, 3) + " %, run " +
           std::to_string(worst->record->run) + ", block " + worst->block->id +
           "), with an effect like stronger or weaker friction. Simulate some of them with half "
           "the [contact] time_step_s to see whether the results depend on it",
       turning
           ? of(count, comparison.rows.size()) +
                 " runs lose or gain more than 10 % of the energy they dissipate through numerical "
                 "errors at contacts, with an effect like stronger or weaker friction."
           : "");
}

/// Speeds that observers of rockfall seldom report.
void warn_of_speeds(Comparison& comparison) {
  std::vector<double> speeds;
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason != StopReason::kError) {
      speeds.push_back(row.record->result.max_speed);
    }
  }
  if (speeds.empty()) return;
  const double p95 = summarise_sample(speeds).p95;
  if (!(p95 > kSeldomSpeed)) return;
  const std::string fast = "5 % of the runs exceed a speed of " + format_significant(p95, 3) +
                           " m/s; rockfall speeds rarely exceed " +
                           format_significant(kSeldomSpeed, 3) + " m/s";
  warn(comparison,
       fast +
           ". Check units and heights of the terrain, drop heights and velocities of the "
           "release, and ground parameters (energy_restitution is a fraction of energy); air "
           "resistance is not modelled",
       fast + ".");
}

/// Mean mass of the blocks of every Garcia class, each block once.
std::map<std::string, double> mean_masses(const Comparison& comparison) {
  std::map<std::string, std::map<std::string, double>> masses;
  for (const RunRow& row : comparison.rows) {
    masses[row.block->garcia][row.block->id] = row.block->mass;
  }
  std::map<std::string, double> means;
  for (const auto& [name, blocks] : masses) {
    double sum = 0.0;
    for (const auto& [id, mass] : blocks) sum += mass;
    means[name] = sum / static_cast<double>(blocks.size());
  }
  return means;
}

void warn_of_masses(Comparison& comparison) {
  const std::map<std::string, double> means = mean_masses(comparison);
  double low = INFINITY, high = 0.0;
  std::string list, in_short;
  for (const auto& [name, mean] : means) {
    low = std::min(low, mean);
    high = std::max(high, mean);
    list += (list.empty() ? "" : ", ") + name + " " + format_significant(mean, 4) + " kg";
    in_short += (in_short.empty() ? "" : ", ") + name + " " +
                (mean < 1000.0 ? format_significant(mean, 3) : format_decimals(mean, 0)) + " kg";
  }
  if (means.size() > 1 && high > low * (1.0 + kNotableMassDifference)) {
    warn(comparison,
         "mass differs between classes (mean block: " + list +
             "); differences between classes are effects of both shape and mass. Run with [blocks] "
             "scale = \"equal-mass\" to compare shapes alone",
         "The classes differ in mass (" + in_short +
             "): differences are effects of shape and mass.");
  }
}

/// Area-weighted mean slope of each ground zone along the runs, rad; empty for zones elsewhere.
std::vector<std::optional<double>> zone_slopes(const CampaignResults& results) {
  Bounds runs;
  for (const RunRecord& run : results.runs) {
    for (const Vec3& place : {run.start.position, run.result.final_state.position}) {
      if (place.allFinite()) runs.include(place);
    }
  }
  std::vector<double> area(results.zone_names.size(), 0.0), weighted(area);
  const TriangleMesh& mesh = results.terrain.surface;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    Bounds triangle;
    for (const std::uint32_t corner : {a, b, c}) triangle.include(mesh.vertices[corner]);
    if ((triangle.high.head<2>().array() < runs.low.head<2>().array()).any() ||
        (triangle.low.head<2>().array() > runs.high.head<2>().array()).any()) {
      continue;
    }
    const Vec3 normal =
        0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    const double size = normal.norm();
    if (!(size > 0.0)) continue;
    area[results.terrain.zone[t]] += size;
    weighted[results.terrain.zone[t]] += size * std::acos(std::clamp(normal.z() / size, -1.0, 1.0));
  }
  std::vector<std::optional<double>> slopes(area.size());
  for (std::size_t zone = 0; zone < area.size(); ++zone) {
    if (area[zone] > 0.0) slopes[zone] = weighted[zone] / area[zone];
  }
  return slopes;
}

/// Stops that show that a zone stops blocks: not a stray one.
bool are_many(std::size_t stops, std::size_t runs) { return 50 * stops > runs; }

/// Counts the runs that came to rest on each ground zone.
std::vector<std::size_t> stops_by_zone(const CampaignResults& results) {
  std::vector<std::size_t> stops(results.zone_names.size(), 0);
  if (results.terrain.surface.triangles.empty()) return stops;
  const TerrainSurface ground = make_terrain_surface(results.terrain);
  for (const RunRecord& run : results.runs) {
    if (run.result.stop_reason != StopReason::kRest) continue;
    const Vec3& place = run.result.final_state.position;
    const std::optional<std::uint16_t> zone = ground.zone_at(place.x(), place.y(), place.z());
    if (zone && *zone < stops.size()) ++stops[*zone];
  }
  return stops;
}

void warn_of_slopes(Comparison& comparison) {
  const auto degrees = [](double angle) {
    return format_significant(angle * kDegreesPerRadian, 3) + " deg";
  };
  std::vector<std::string> sliding_texts, rolling_texts;
  std::set<std::string> sliding_zones, rolling_zones;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    const std::vector<std::optional<double>> slopes = zone_slopes(results);
    const std::vector<std::size_t> stops = stops_by_zone(results);
    for (std::size_t zone = 0; zone < slopes.size() && zone < results.ground.size(); ++zone) {
      if (!slopes[zone]) continue;
      const double sliding = std::atan(results.ground[zone].friction);
      const double rolling = std::atan(results.ground[zone].rolling_friction);
      const std::string where =
          (comparison.results.size() > 1 ? "file " + std::to_string(file + 1) + ": " : "") +
          "zone " + results.zone_names[zone] + " slopes " + degrees(*slopes[zone]) +
          " on average, ";
      if (*slopes[zone] > sliding && are_many(stops[zone], results.runs.size())) {
        comparison.warnings.push_back(where + "above atan mu = " + degrees(sliding) + ", but " +
                                      of(stops[zone], results.runs.size()) +
                                      " runs stopped on its flatter parts, so the mean slope of "
                                      "the zone is not representative");
      } else if (*slopes[zone] > sliding) {
        sliding_zones.insert(results.zone_names[zone]);
        sliding_texts.push_back(
            where + "above atan mu = " + degrees(sliding) +
            ": friction cannot stop a block there, so shape may have little effect");
      } else if (*slopes[zone] > rolling) {
        rolling_zones.insert(results.zone_names[zone]);
        rolling_texts.push_back(where + "between atan mu_R = " + degrees(rolling) +
                                " and atan mu = " + degrees(sliding) +
                                ": rolling blocks keep moving and sliding blocks stop, so the "
                                "effect of shape is larger than on other slopes");
      }
    }
  }
  const auto add = [&](const std::vector<std::string>& texts, const std::set<std::string>& zones,
                       const std::string& effect) {
    if (texts.empty()) return;
    comparison.warnings.insert(comparison.warnings.end(), texts.begin(), texts.end());
    const std::vector<std::string> names(zones.begin(), zones.end());
    comparison.cautions.push_back({(names.size() == 1 ? "In the zone " : "In the zones ") +
                                       comma_separated(names) + " " + effect,
                                   texts});
  };
  add(sliding_texts, sliding_zones,
      "the slope is too steep for friction to stop a block, so shape may have little effect "
      "there.");
  add(rolling_texts, rolling_zones,
      "rolling blocks keep moving and sliding blocks stop, so shape has a larger effect.");
}

void warn_of_changed_blocks(Comparison& comparison) {
  std::map<std::string, const BlockSummary*> first;
  std::set<std::string> changed;
  for (const RunRow& row : comparison.rows) {
    const BlockSummary& block = *row.block;
    const BlockSummary& known = *first.emplace(block.id, &block).first->second;
    const bool same = known.mass == block.mass && known.axes.L == block.axes.L &&
                      known.axes.I == block.axes.I && known.axes.S == block.axes.S;
    if (!same && changed.insert(block.id).second) {
      const std::string mixed =
          "block " + block.id +
          " has a different mass or size in another file; its groups contain both versions";
      warn(comparison, mixed, changed.size() == 1 ? "B" + mixed.substr(1) + "." : "");
    }
  }
}

/// Measured stops with a name that nothing simulated has, which are in no group but `all`, and
/// those far from every terrain: of another map system, or a slip.
void warn_of_measured(Comparison& comparison) {
  if (!comparison.measured) return;
  std::set<std::string> blocks;
  for (const RunRow& row : comparison.rows) blocks.insert(row.block->id);
  const std::vector<MeasuredStop>& stops = comparison.measured->stops;
  const auto name = [&](const std::string& what, bool turning, const auto& unknown) {
    std::size_t count = 0;
    std::string first;
    for (const MeasuredStop& stop : stops) {
      const std::string text = unknown(stop);
      if (text.empty()) continue;
      if (count++ == 0) first = text;
    }
    if (count > 0) {
      const std::string found = of(count, stops.size()) + " measured stops " + what;
      warn(comparison, found + " (first: " + first + ")", turning ? found + "." : "");
    }
  };
  name("name a block that was not simulated, so they are only in the group \"all\"", false,
       [&](const MeasuredStop& stop) {
         return blocks.contains(stop.block) ? std::string() : stop.block;
       });
  name("have a shape other than compact or elongated, so they are in no shape group", false,
       [&](const MeasuredStop& stop) {
         const bool known = stop.shape == "compact" || stop.shape == "elongated";
         return known ? std::string() : stop.shape;
       });
  std::vector<Bounds> grounds;
  for (const CampaignResults& results : comparison.results) {
    const Bounds extent = bounds(results.terrain.surface);
    grounds.push_back(
        {results.terrain.frame.to_map(extent.low), results.terrain.frame.to_map(extent.high)});
  }
  name("lie outside the terrain; check their map system and units", true,
       [&](const MeasuredStop& stop) {
         const bool over = std::any_of(grounds.begin(), grounds.end(), [&](const Bounds& ground) {
           return (stop.position.array() >= ground.low.head<2>().array()).all() &&
                  (stop.position.array() <= ground.high.head<2>().array()).all();
         });
         return over ? std::string()
                     : "x " + format_significant(stop.position.x(), 9) + ", y " +
                           format_significant(stop.position.y(), 9);
       });
}

/// A barrier drawn the wrong way must not make what lies behind it look safe.
void warn_of_directions(Comparison& comparison) {
  for (const BarrierGroupStatistics& group : comparison.barriers) {
    const BarrierLine& line = comparison.lines[group.line];
    const RunGroup& runs = comparison.groups[group.group_index];
    if (line.counts != BarrierLine::Counts::kForward || runs.kind != RunGroupKind::kAll ||
        runs.file || group.backward <= group.crossed) {
      continue;
    }
    double maximum = 0.0;
    for (const BarrierCrossing& row : comparison.crossings) {
      if (row.barrier != group.line || row.crossing->forward) continue;
      maximum =
          std::max(maximum, row.crossing->translational_energy + row.crossing->rotational_energy);
    }
    const std::string crossed = of(group.backward, group.started) +
                                " runs first crossed it in the opposite direction, with up to " +
                                format_significant(maximum / 1000.0, 4) + " kJ";
    warn(comparison,
         "barrier " + line.name +
             " counts only crossings from the left side of its line to the right side, but " +
             crossed + "; swap its points, or omit direction to count both directions",
         "Barrier " + line.name + " counts one direction only, but " + crossed + ".");
  }
}

}  // namespace

std::optional<double> reassigned_energy_fraction(const EnergyBalance& energy) {
  const double dissipated = energy.normal + energy.friction + energy.rolling;
  // If almost nothing is dissipated, both are rounding errors.
  const double rounding =
      kRoundedEnergy * std::max(std::abs(energy.initial), std::abs(energy.final));
  if (!(dissipated > rounding) || !std::isfinite(energy.reassigned)) return std::nullopt;
  return std::abs(energy.reassigned) / dissipated;
}

void add_comparison_warnings(Comparison& comparison) {
  warn_of_directions(comparison);
  warn_of_unfinished(comparison);
  warn_of_lost_runs(comparison);
  warn_of_reassigned(comparison);
  warn_of_speeds(comparison);
  warn_of_masses(comparison);
  warn_of_slopes(comparison);
  warn_of_changed_blocks(comparison);
  warn_of_measured(comparison);
  // Warnings common to all files are given once.
  const auto in_all_files = [&](const std::string& warning) {
    return std::all_of(
        comparison.results.begin(), comparison.results.end(), [&](const CampaignResults& results) {
          return std::count(results.warnings.begin(), results.warnings.end(), warning) > 0;
        });
  };
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    for (const std::string& warning : results.warnings) {
      const bool asked = std::any_of(
          results.blocks.begin(), results.blocks.end(),
          [&](const BlockSummary& block) { return warning == describe_block_scale(block); });
      if (asked) continue;
      if (!in_all_files(warning)) {
        warn(comparison, "file " + std::to_string(file + 1) + ": " + warning);
      } else if (file == 0) {
        warn(comparison, warning);
      }
    }
  }
}

}  // namespace clast
