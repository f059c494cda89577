#include "study/report/report_sections.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/version.hpp"
#include "study/report/html_page.hpp"
#include "study/report/palette.hpp"
#include "study/report/svg_chart.hpp"
#include "study/report/svg_map.hpp"

namespace clast {
namespace {

constexpr double kDegrees = 180.0 / kPi;
constexpr double kTurn = 2.0 * kPi;             // rad per revolution
constexpr const char* kMinus = "\xE2\x80\x93";  // en dash, for ranges
constexpr const char* kPlusMinus = " \xC2\xB1 ";

bool several_files(const Comparison& comparison) { return comparison.results.size() > 1; }

/// Groups of one kind: per file when there are several files, so that sites do not mix.
std::vector<std::size_t> groups_of(const Comparison& comparison, GroupKind kind) {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const Group& group = comparison.groups[g];
    if (group.kind == kind && group.file.has_value() == several_files(comparison)) {
      found.push_back(g);
    }
  }
  return found;
}

/// The name without what the table's heading says already.
std::string short_name(const Group& group) {
  std::string name = group.kind == GroupKind::kAll ? "all" : group.key;
  if (group.kind == GroupKind::kSneedFolk) name += " (Sneed-Folk)";
  return group.file ? "file " + std::to_string(*group.file + 1) + ": " + name : name;
}

std::string mean_and_std(const Summary& summary, int decimals, double unit = 1.0) {
  if (summary.count == 0) return "-";
  return fixed(summary.mean * unit, decimals) + kPlusMinus + fixed(summary.std * unit, decimals);
}

std::string measured(double value, const Summary& summary, int decimals) {
  return summary.count == 0 ? "-" : fixed(value, decimals);
}

std::string fact(const std::string& name, const std::string& value) {
  return "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>\n";
}

/// One curve per group. Classes keep their colours; with several files the dash tells files apart.
template <class Value>
std::vector<Series> series_of(const Comparison& comparison, GroupKind kind, Value value_of) {
  std::vector<Series> series;
  for (const std::size_t g : groups_of(comparison, kind)) {
    const Group& group = comparison.groups[g];
    Series one;
    one.name = short_name(group);
    one.colour = kind == GroupKind::kGarcia ? class_colour(group.key) : data_colour(series.size());
    one.dash = kind == GroupKind::kGarcia ? kDashes[group.file.value_or(0) % kDashes.size()]
                                          : data_dash(series.size());
    for (const std::size_t row : group.rows) {
      const std::optional<double> value = value_of(row);
      if (value) one.values.push_back(*value);
    }
    series.push_back(std::move(one));
  }
  return series;
}

std::string figure(const std::string& svg, const std::string& caption = {}) {
  return "<figure>" + svg +
         (caption.empty() ? "" : "<figcaption>" + escaped(caption) + "</figcaption>") +
         "</figure>\n";
}

/// The same text for all files, or each file's own.
template <class Text>
std::string per_file(const Comparison& comparison, Text text_of) {
  std::string joined;
  std::set<std::string> seen;
  for (const CampaignResults& results : comparison.results) {
    const std::string text = text_of(results);
    if (seen.insert(text).second) joined += (joined.empty() ? "" : "; ") + text;
  }
  return joined;
}

std::string warning_box(const Comparison& comparison) {
  if (comparison.warnings.empty()) {
    return "<div class=\"fine\">No warnings: every planned run is stored and came to rest on the "
           "terrain with its energy accounted for.</div>\n";
  }
  std::string html = "<div class=\"warnings\" role=\"note\"><h2>Read this first</h2><ul>\n";
  for (const std::string& warning : comparison.warnings) {
    html += "<li>" + escaped(warning) + "</li>\n";
  }
  return html + "</ul></div>\n";
}

}  // namespace

std::string head_section(const Comparison& comparison) {
  std::size_t blocks = 0, classes = 0;
  for (const Group& group : comparison.groups) {
    if (group.file) continue;
    blocks += group.kind == GroupKind::kBlock;
    classes += group.kind == GroupKind::kGarcia;
  }
  const auto many = [](std::size_t count, const std::string& one, const std::string& more) {
    return std::to_string(count) + " " + (count == 1 ? one : more);
  };
  std::string lead = many(comparison.rows.size(), "run", "runs") + " of " +
                     many(blocks, "block", "blocks") + " in " +
                     many(classes, "shape class", "shape classes");
  std::string html = "<h1>Rockfall runs compared by shape</h1>\n<p class=\"lead\">" +
                     escaped(lead) +
                     (several_files(comparison)
                          ? ", from " + std::to_string(comparison.results.size()) + " campaigns"
                          : std::string()) +
                     "</p>\n";
  html += warning_box(comparison);
  html += "<dl class=\"facts\">\n";
  html += fact("Results", per_file(comparison, [](const CampaignResults& results) {
                 return results.file.filename().string();
               }));
  html += fact("Contact law", "energy restitution, weights " +
                                  per_file(comparison, [](const CampaignResults& results) {
                                    return name_of(results.weights);
                                  }));
  html += fact("Normal stiffness k_n", per_file(comparison, [](const CampaignResults& results) {
                 return significant(results.stiffness.normal / 1e6, 4) + " MN/m";
               }));
  html += fact("Time step", per_file(comparison, [](const CampaignResults& results) {
                 return significant(results.stiffness.time_step * 1e6, 4) + " \xC2\xB5s";
               }));
  html += fact("Downslope (x, y)",
               fixed(comparison.downslope.x(), 4) + ", " + fixed(comparison.downslope.y(), 4) +
                   (comparison.downslope_asked ? " (as asked)" : " (mean release to stop)"));
  html += fact("Coordinates", comparison.results.front().frame.crs.empty()
                                  ? "map frame of the terrain, no CRS given"
                                  : comparison.results.front().frame.crs);
  html +=
      fact("Simulated with", "clast " + per_file(comparison, [](const CampaignResults& results) {
                               return results.program_version;
                             }));
  html += fact("Report by", std::string("clast ") + version());
  return html + "</dl>\n";
}

std::string class_section(const Comparison& comparison) {
  std::vector<std::string> heads = {"class",
                                    "blocks",
                                    "runs",
                                    "at rest",
                                    "mean mass, kg",
                                    "runout mean \xC2\xB1 std, m",
                                    "runout median, m",
                                    "runout p95, m",
                                    "runout max, m",
                                    "lateral mean \xC2\xB1 std, deg"};
  for (const BarrierLine& line : comparison.lines) heads.push_back("past " + line.name);
  HtmlTable table(heads, 1);
  std::vector<std::size_t> groups = groups_of(comparison, GroupKind::kGarcia);
  for (const std::size_t g : groups_of(comparison, GroupKind::kSneedFolk)) groups.push_back(g);
  for (const std::size_t g : groups_of(comparison, GroupKind::kAll)) groups.push_back(g);
  for (const std::size_t g : groups) {
    const Group& group = comparison.groups[g];
    const DepositGroup& deposit = comparison.deposits[g];
    std::set<std::string> blocks;
    double mass = 0.0;
    for (const std::size_t row : group.rows) {
      blocks.insert(comparison.rows[row].block->id);
      mass += comparison.rows[row].block->mass;
    }
    std::vector<std::string> cells = {short_name(group),
                                      std::to_string(blocks.size()),
                                      std::to_string(deposit.started),
                                      std::to_string(deposit.stops.rest),
                                      significant(mass / static_cast<double>(group.rows.size()), 4),
                                      mean_and_std(deposit.runout, 1),
                                      measured(deposit.runout.median, deposit.runout, 1),
                                      measured(deposit.runout.p95, deposit.runout, 1),
                                      measured(deposit.runout.max, deposit.runout, 1),
                                      mean_and_std(deposit.lateral, 1, kDegrees)};
    for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
      std::string cell = "-";
      for (const BarrierGroup& barrier : comparison.barriers) {
        if (barrier.line == line && barrier.group_index == g) cell = percent(barrier.probability);
      }
      cells.push_back(cell);
    }
    table.row(std::move(cells));
  }
  return section("Shape classes side by side",
                 paragraph("Compact and elongated after Garcia et al. (2022), two-letter classes "
                           "after Sneed and Folk (1958). Runout and lateral angle are of the runs "
                           "that came to rest; the share past a barrier is of all runs.") +
                     table.html());
}

std::string block_section(const Comparison& comparison) {
  HtmlTable table(
      {"block", "Garcia", "Sneed-Folk", "Zingg", "mass, kg", "L, m", "I, m", "S, m", "runs", "rest",
       "left terrain", "max time", "error", "runout mean \xC2\xB1 std, m", "runout p95, m",
       "lateral mean \xC2\xB1 std, deg", "fastest, m/s"},
      4);
  for (const std::size_t g : groups_of(comparison, GroupKind::kBlock)) {
    const Group& group = comparison.groups[g];
    const DepositGroup& deposit = comparison.deposits[g];
    const BlockSummary& block = *comparison.rows[group.rows.front()].block;
    double fastest = 0.0;
    for (const std::size_t row : group.rows) {
      fastest = std::max(fastest, comparison.rows[row].record->result.max_speed);
    }
    table.row({short_name(group), block.garcia, block.sneed_folk, block.zingg,
               significant(block.mass, 4), significant(block.axes.L), significant(block.axes.I),
               significant(block.axes.S), std::to_string(deposit.started),
               std::to_string(deposit.stops.rest), std::to_string(deposit.stops.left_terrain),
               std::to_string(deposit.stops.max_time), std::to_string(deposit.stops.error),
               mean_and_std(deposit.runout, 1), measured(deposit.runout.p95, deposit.runout, 1),
               mean_and_std(deposit.lateral, 1, kDegrees), fixed(fastest, 1)});
  }
  return section("Blocks", paragraph("L, I, S are the sides of the smallest box around the block. "
                                     "A click on a column's head sorts the table.") +
                               table.html());
}

std::string map_section(const Comparison& comparison) {
  const std::string caption =
      "Centres of mass at the end of each run, in map coordinates. Relief lit from the north-west" +
      std::string(several_files(comparison) ? "; the surface is that of file 1." : ".") +
      " Rest the pointer on a stop to see which run it is.";
  return section("Where the blocks stop", figure(svg_map(comparison), caption));
}

std::string runout_section(const Comparison& comparison) {
  const auto at_rest = [&](std::size_t row) {
    return comparison.rows[row].record->result.stop_reason == StopReason::kRest;
  };
  const auto along = [&](std::size_t row) {
    return at_rest(row) ? std::optional(comparison.rows[row].runout) : std::nullopt;
  };
  const auto lateral = [&](std::size_t row) {
    return at_rest(row) ? std::optional(comparison.rows[row].lateral * kDegrees) : std::nullopt;
  };
  const std::vector<Series> by_class = series_of(comparison, GroupKind::kGarcia, along);
  std::string charts = "<div class=\"charts\">\n";
  charts += figure(histogram_chart({"Runout by class", "runout, m"}, by_class));
  charts += figure(histogram_chart({"Lateral angle by class",
                                    "lateral angle, deg (+ to the right "
                                    "looking downslope)"},
                                   series_of(comparison, GroupKind::kGarcia, lateral)));
  charts +=
      figure(cumulative_chart({"Share of runs that stop before, by class", "runout, m"}, by_class));
  charts += figure(cumulative_chart({"Share of runs that stop before, by block", "runout, m"},
                                    series_of(comparison, GroupKind::kBlock, along)));
  return section(
      "Runout", paragraph("Horizontal distance from each run's own release point to its stop along "
                          "the downslope direction; runs at rest, their number in brackets.") +
                    charts + "</div>\n");
}

namespace {

std::string barrier_table(const Comparison& comparison, std::size_t line) {
  HtmlTable table({"group", "runs", "crossings", "probability", "95 % interval", "height mean, m",
                   "height p95, m", "height max, m", "clearance p95, m", "speed mean, m/s",
                   "speed p95, m/s", "speed max, m/s", "energy mean, kJ", "energy p95, kJ",
                   "energy max, kJ", "rotational share", "rotation p95, rps"},
                  1);
  for (const GroupKind kind :
       {GroupKind::kGarcia, GroupKind::kBlock, GroupKind::kSneedFolk, GroupKind::kAll}) {
    for (const BarrierGroup& group : comparison.barriers) {
      const Group& runs = comparison.groups[group.group_index];
      if (group.line != line || runs.kind != kind ||
          runs.file.has_value() != several_files(comparison)) {
        continue;
      }
      const Interval interval = wilson_interval(group.crossed, group.started);
      std::vector<std::string> cells = {
          short_name(runs), std::to_string(group.started), std::to_string(group.crossed),
          percent(group.probability),
          fixed(100.0 * interval.low, 1) + kMinus + fixed(100.0 * interval.high, 1) + " %"};
      const auto add = [&](double value, int decimals) {
        cells.push_back(measured(value, group.height, decimals));
      };
      add(group.height.mean, 2);
      add(group.height.p95, 2);
      add(group.height.max, 2);
      add(group.clearance.p95, 2);
      add(group.speed.mean, 1);
      add(group.speed.p95, 1);
      add(group.speed.max, 1);
      for (const double energy : {group.total.mean, group.total.p95, group.total.max}) {
        cells.push_back(group.total.count == 0 ? "-" : significant(energy / 1000.0));
      }
      cells.push_back(group.total.mean > 0.0 ? percent(group.rotational.mean / group.total.mean)
                                             : "-");
      add(group.rotation_rate.p95 / kTurn, 2);
      table.row(std::move(cells));
    }
  }
  return table.html();
}

std::string barrier_charts(const Comparison& comparison, std::size_t line) {
  std::vector<const Crossing*> first(comparison.rows.size(), nullptr);
  bool any = false;
  for (const CrossingRow& crossing : comparison.crossings) {
    if (!crossing.counted || crossing.barrier != line) continue;
    first[crossing.row] = crossing.crossing;
    any = true;
  }
  if (!any) return paragraph("No run crossed this barrier.");
  const auto chart = [&](const std::string& title, const std::string& label, auto value) {
    return figure(cumulative_chart({title, label},
                                   series_of(comparison, GroupKind::kGarcia,
                                             [&](std::size_t row) -> std::optional<double> {
                                               if (first[row] == nullptr) return std::nullopt;
                                               return value(*first[row]);
                                             }),
                                   true));
  };
  return "<div class=\"charts\">\n" +
         chart("Share of crossings above this energy", "total kinetic energy, kJ",
               [](const Crossing& c) {
                 return (c.translational_energy + c.rotational_energy) / 1000.0;
               }) +
         chart("Share of crossings above this height", "height of the centre above ground, m",
               [](const Crossing& c) { return c.height; }) +
         "</div>\n";
}

}  // namespace

std::string barrier_section(const Comparison& comparison) {
  if (comparison.lines.empty()) return {};
  std::string html = paragraph(
      "First forward crossing of each run. Probability is runs with a crossing over runs started, "
      "with Wilson's 95 % interval. Height is of the centre of mass, clearance of the lowest point "
      "of the block, both above the ground under it. Energy is translational plus rotational.");
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    const BarrierLine& barrier = comparison.lines[line];
    html += "<h3>" + escaped(barrier.name) + "</h3>\n<p class=\"note\">from (" +
            fixed(barrier.from.x(), 2) + ", " + fixed(barrier.from.y(), 2) + ") to (" +
            fixed(barrier.to.x(), 2) + ", " + fixed(barrier.to.y(), 2) + ") m</p>\n";
    html += barrier_table(comparison, line) + barrier_charts(comparison, line);
  }
  return section("Barriers", html);
}

namespace {

/// The run with the largest of something, in words.
template <class Value>
std::vector<std::string> extreme(const Comparison& comparison, const std::string& what,
                                 const std::string& unit, Value value_of) {
  const RunRow* worst = nullptr;
  double largest = -INFINITY;
  std::vector<double> values;
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    const double value = value_of(row);
    if (!std::isfinite(value)) continue;
    values.push_back(value);
    if (value > largest) {
      largest = value;
      worst = &row;
    }
  }
  if (worst == nullptr) return {what, "-", "-", "-", "-"};
  const Summary summary = summarise(values);
  const std::string run =
      (several_files(comparison) ? "file " + std::to_string(worst->file + 1) + ", run " : "run ") +
      std::to_string(worst->record->run) + ", block " + worst->block->id;
  return {what + unit, run, significant(summary.mean), significant(summary.p95),
          significant(largest)};
}

std::string lost_runs(const Comparison& comparison) {
  constexpr std::size_t kMostListed = 200;
  HtmlTable table({"run", "block", "ended as", "what happened"}, 4);
  std::size_t count = 0;
  for (const RunRow& row : comparison.rows) {
    const ReleaseResult& result = row.record->result;
    if (result.stop_reason == StopReason::kRest && !result.below_ground) continue;
    if (++count > kMostListed) continue;
    std::string story = result.message;
    if (story.empty()) {
      story = "at (" + fixed(row.stop.x(), 2) + ", " + fixed(row.stop.y(), 2) + ", " +
              fixed(row.stop.z(), 2) + ") m after " + fixed(result.duration, 1) + " s";
    }
    const std::string file =
        several_files(comparison) ? std::to_string(row.file + 1) + ": " : std::string();
    table.row({file + std::to_string(row.record->run), row.block->id,
               name_of(result.stop_reason) + (result.below_ground ? ", below ground" : ""), story});
  }
  if (count == 0) return paragraph("Every run came to rest on the terrain.");
  std::string html = "<h3>Runs that did not come to rest on the terrain</h3>\n" + table.html();
  if (count > kMostListed) {
    html += paragraph("The first " + std::to_string(kMostListed) + " of " + std::to_string(count) +
                      "; the others are in runs.csv.");
  }
  return html;
}

}  // namespace

std::string quality_section(const Comparison& comparison) {
  HtmlTable table({"measure", "worst run", "mean", "p95", "largest"}, 2);
  table.row(extreme(comparison, "energy not accounted for, share of the dissipated", "",
                    [](const RunRow& row) { return row.record->result.energy.error; }));
  table.row(extreme(comparison, "largest penetration", ", mm",
                    [](const RunRow& row) { return row.record->result.max_penetration * 1000.0; }));
  table.row(extreme(comparison, "largest penetration, share of S", "", [](const RunRow& row) {
    return row.record->result.max_penetration / row.block->axes.S;
  }));
  table.row(extreme(comparison, "penetration at the end", ", mm", [](const RunRow& row) {
    return row.record->result.settled_penetration * 1000.0;
  }));
  table.row(extreme(comparison, "simulated time", ", s",
                    [](const RunRow& row) { return row.record->result.duration; }));
  std::size_t below = 0;
  for (const RunRow& row : comparison.rows) below += row.record->result.below_ground;
  const StopCounts& stops = comparison.deposits.front().stops;
  return section(
      "Quality of the runs",
      paragraph("At rest " + std::to_string(stops.rest) + ", left the terrain " +
                std::to_string(stops.left_terrain) + ", still moving at max_time " +
                std::to_string(stops.max_time) + ", error " + std::to_string(stops.error) +
                "; below ground " + std::to_string(below) + ".") +
          table.html() + lost_runs(comparison));
}

std::string provenance_section(const Comparison& comparison) {
  std::string html;
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    html += "<h3>" +
            escaped("File " + std::to_string(file + 1) + ": " + results.file.filename().string()) +
            "</h3>\n";
    html +=
        paragraph(std::to_string(results.runs.size()) + " of " +
                  std::to_string(results.planned_runs) + " planned runs, clast " +
                  results.program_version + ". k_n " + significant(results.stiffness.normal, 6) +
                  " N/m, k_t " + significant(results.stiffness.tangential, 6) + " N/m, k_r " +
                  significant(results.stiffness.rolling, 6) + " N m/rad, time step " +
                  significant(results.stiffness.time_step, 6) + " s.");
    HtmlTable zones(
        {"ground zone", "e_n\xC2\xB2", "friction \xC2\xB5", "rolling friction \xC2\xB5_R"}, 1);
    for (std::size_t zone = 0; zone < results.ground.size(); ++zone) {
      const GroundParameters& ground = results.ground[zone];
      zones.row({zone < results.zone_names.size() ? results.zone_names[zone] : std::to_string(zone),
                 significant(ground.energy_restitution), significant(ground.friction),
                 significant(ground.rolling_friction)});
    }
    html += zones.html();
    html += "<p>Campaign SHA-256 <code>" + escaped(results.campaign_sha256) +
            "</code></p>\n<ul class=\"note\">\n";
    for (const std::string& input : results.inputs) {
      html += "<li><code>" + escaped(input) + "</code></li>\n";
    }
    html += "</ul>\n<details><summary>Campaign file</summary><pre>" +
            escaped(results.campaign_text) + "</pre></details>\n";
  }
  return section("What was run", html) + "<footer>Made by clast " + escaped(version()) +
         ". Every figure here is in runs.csv, barriers.csv, crossings.csv and deposits.csv beside "
         "this page; map layers are in stops.gpkg.</footer>\n";
}

}  // namespace clast
