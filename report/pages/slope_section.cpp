#include <cmath>

#include "dem/surface/terrain_surface.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/plain_numbers.hpp"

namespace clast::report_detail {
namespace {

using Bins = std::vector<const ProfileBin*>;

Bins bins_of_group(const std::vector<ProfileBin>& bins, std::size_t group) {
  Bins found;
  for (const ProfileBin& bin : bins) {
    if (bin.group == group) found.push_back(&bin);
  }
  return found;
}

std::vector<std::string> bin_counts(const Bins& bins) {
  std::vector<std::string> notes;
  for (const ProfileBin* bin : bins) notes.push_back(std::to_string(bin->runs) + " runs");
  return notes;
}

/// Barriers on the axis of distance: where half of their counted crossings lie before.
std::vector<LabelledLine> barrier_places(const Comparison& comparison,
                                         std::optional<std::uint32_t> file) {
  std::vector<LabelledLine> places;
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    std::vector<double> distances;
    for (const BarrierCrossing& crossing : comparison.crossings) {
      const RunRow& row = comparison.rows[crossing.row];
      if (!crossing.counted || crossing.barrier != line || (file && row.file != *file)) continue;
      const Vec3 way = crossing.crossing->position - row.record->start.position;
      distances.push_back(comparison.downslope.dot(way.head<2>()));
    }
    if (distances.empty()) continue;
    places.push_back({summarise_sample(distances).median, comparison.lines[line].name});
  }
  return places;
}

/// Draws the fraction of the runs of each class that reach a distance.
std::string share_against_distance(const Comparison& comparison,
                                   const std::vector<ProfileBin>& bins,
                                   std::optional<std::uint32_t> file, const ChartAxes& axes) {
  std::vector<ChartTrace> traces;
  for (const std::size_t g : select_groups_of_kind(comparison, RunGroupKind::kGarcia)) {
    const RunGroup& group = comparison.groups[g];
    if (group.file != file) continue;
    ChartTrace trace{group.key, class_colour(group.key), {}, ChartTrace::Kind::kSteps, {}, {}};
    const Bins along = bins_of_group(bins, g);
    for (const ProfileBin* bin : along) {
      trace.x.push_back(bin->from);
      trace.y.push_back(static_cast<double>(bin->runs) / static_cast<double>(group.rows.size()));
    }
    trace.notes = bin_counts(along);
    traces.push_back(std::move(trace));
  }
  return draw_plotly_chart(axes, traces);
}

/// Values at a barrier at every distance, over all runs of a group.
std::string barrier_table(const Comparison& comparison, const std::vector<ProfileBin>& bins,
                          std::size_t group) {
  HtmlTable table({"distance, m", "runs that reach it", "fraction", "energy p95, kJ",
                   "energy max, kJ", "height p95, m", "height max, m", "speed p95, m/s"},
                  1);
  const auto runs = static_cast<double>(comparison.groups[group].rows.size());
  for (const ProfileBin* bin : bins_of_group(bins, group)) {
    table.row({format_significant(bin->from, 4) + " to " + format_significant(bin->to, 4),
               std::to_string(bin->runs), format_percent(static_cast<double>(bin->runs) / runs, 0),
               format_significant_digits(bin->energy.p95 / 1000.0),
               format_significant_digits(bin->energy.max / 1000.0),
               format_summary_value(bin->height.p95, bin->height, 2),
               format_summary_value(bin->height.max, bin->height, 2),
               format_summary_value(bin->speed.p95, bin->speed, 1)});
  }
  return table.html();
}

/// "Where at least half of the 192 runs arrive, the energy is lowest 16 to 18 m from the release:
/// ..."
std::string least_demand(const Comparison& comparison, const std::vector<ProfileBin>& bins,
                         std::size_t group) {
  const std::size_t runs = comparison.groups[group].rows.size();
  const ProfileBin* place = find_least_energy_bin(bins, group, runs);
  if (place == nullptr || runs < kMinPassages) return {};
  return "Where at least half of the " + std::to_string(runs) +
         " runs arrive, the energy is lowest " + format_significant(place->from, 4) + " to " +
         format_significant(place->to, 4) + " m from the release: for 95 % of the " +
         std::to_string(place->runs) + " runs there, it is below " +
         format_energy_limit(place->energy.p95) + ", and the centre of mass is below " +
         format_height_limit(place->height.p95) + ". ";
}

/// Mean, 95th percentile and largest of a quantity of every class.
std::string against_distance(const Comparison& comparison, const std::vector<ProfileBin>& bins,
                             std::optional<std::uint32_t> file, const ChartAxes& axes,
                             SampleSummary ProfileBin::*quantity, double unit) {
  std::vector<ChartTrace> traces;
  for (const std::size_t g : select_groups_of_kind(comparison, RunGroupKind::kGarcia)) {
    const RunGroup& group = comparison.groups[g];
    if (group.file != file) continue;
    const Bins along = bins_of_group(bins, g);
    const auto add = [&](const char* name, const char* dash, double SampleSummary::*value,
                         bool shown) {
      ChartTrace trace{
          group.key + ", " + name, class_colour(group.key), dash, ChartTrace::Kind::kLine, {}, {}};
      for (const ProfileBin* bin : along) {
        const SampleSummary& summary = bin->*quantity;
        trace.x.push_back(0.5 * (bin->from + bin->to));
        trace.y.push_back(summary.count > 0 ? summary.*value * unit : NAN);
      }
      trace.notes = bin_counts(along);
      trace.shown = shown;
      traces.push_back(std::move(trace));
    };
    add("95 % below", "", &SampleSummary::p95, true);
    add("mean", "6 3", &SampleSummary::mean, true);
    add("largest", "2 2", &SampleSummary::max, false);
  }
  return draw_plotly_chart(axes, traces);
}

/// The ground under the mean path of a group, and how high its blocks pass over it.
std::string cut_along_the_mean_path(const Comparison& comparison,
                                    const std::vector<ProfileBin>& bins, std::size_t group,
                                    const std::string& title) {
  const CampaignResults& results = comparison.results[comparison.groups[group].file.value_or(0)];
  const TerrainSurface surface = make_terrain_surface(results.terrain);
  const double highest = bounds(results.terrain.surface).high.z();
  ChartTrace ground{"ground", "#7a6245", {}, ChartTrace::Kind::kLine, {}, {}};
  ChartTrace maximum{
      "height that 95 % of the runs pass below", "#0072B2", {}, ChartTrace::Kind::kLine, {}, {}};
  ChartTrace all{"highest passage", "#0072B2", "2 2", ChartTrace::Kind::kLine, {}, {}};
  const Bins along = bins_of_group(bins, group);
  for (const ProfileBin* bin : along) {
    const Vec2 place = bin->position - results.frame.origin.head<2>();
    const double z =
        surface.height_at(place.x(), place.y(), highest).value_or(NAN) + results.frame.origin.z();
    for (ChartTrace* trace : {&ground, &maximum, &all})
      trace->x.push_back(0.5 * (bin->from + bin->to));
    ground.y.push_back(z);
    maximum.y.push_back(bin->height.count > 0 ? z + bin->height.p95 : NAN);
    all.y.push_back(bin->height.count > 0 ? z + bin->height.max : NAN);
  }
  maximum.filled = true;
  maximum.notes = all.notes = bin_counts(along);
  ChartAxes axes{title, "distance along downslope, m", "elevation, m"};
  axes.equal_scales = true;
  return draw_plotly_chart(axes, {ground, maximum, all});
}

/// Groups of which each has a path of its own: one for each file, or for each release set of one.
std::vector<std::size_t> groups_with_a_path(const Comparison& comparison) {
  std::vector<std::size_t> found;
  for (const std::size_t g : select_groups_of_kind(comparison, RunGroupKind::kAll)) {
    const CampaignResults& results = comparison.results[comparison.groups[g].file.value_or(0)];
    if (results.release_sets.size() < 2) found.push_back(g);
  }
  if (has_several_files(comparison)) return found;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    if (comparison.groups[g].column == "release_set") found.push_back(g);
  }
  return found;
}

}  // namespace

std::string format_slope_section(const Comparison& comparison,
                                 const std::vector<ProfileBin>& bins) {
  const std::string title = "Along the slope";
  if (bins.empty()) {
    return format_section(
        title,
        format_paragraph("The results contain no trajectories; set [run] trajectory_interval_s "
                         "above zero to see energies and passing heights against distance."));
  }
  std::string words, charts, tables;
  for (const std::size_t all : select_groups_of_kind(comparison, RunGroupKind::kAll)) {
    const std::optional<std::uint32_t> file = comparison.groups[all].file;
    const std::string where = file ? ", file " + std::to_string(*file + 1) : std::string();
    const auto axes = [&](const std::string& what, const std::string& label) {
      ChartAxes chart{what + where, "distance along downslope, m", label};
      chart.places = barrier_places(comparison, file);
      return chart;
    };
    const std::string minimum = least_demand(comparison, bins, all);
    if (!minimum.empty())
      words += (file ? short_group_name(comparison.groups[all]) + ": " : "") + minimum;
    ChartAxes share = axes("Runs that reach a distance", "fraction of runs");
    share.y_in_percent = true;
    charts += share_against_distance(comparison, bins, file, share);
    charts +=
        against_distance(comparison, bins, file, axes("Energy against distance", "energy, kJ"),
                         &ProfileBin::energy, 1e-3);
    charts += against_distance(comparison, bins, file,
                               axes("Passing height against distance", "height, m"),
                               &ProfileBin::height, 1.0);
    charts += against_distance(comparison, bins, file, axes("Speed against distance", "speed, m/s"),
                               &ProfileBin::speed, 1.0);
    tables += format_folded_section("Values at a barrier at every distance" + where,
                                    barrier_table(comparison, bins, all));
  }
  for (const std::size_t group : groups_with_a_path(comparison)) {
    const std::string name = short_group_name(comparison.groups[group]);
    charts +=
        cut_along_the_mean_path(comparison, bins, group, "The ground along the mean path: " + name);
  }
  const std::string width = format_significant(bins.front().to - bins.front().from, 3);
  return format_section(
      title, format_paragraph(words + "In every " + width +
                              " m of distance, the largest value of each run is used. Distances "
                              "are measured from the release point, and heights are those of the "
                              "centre of mass. The section follows the mean path.") +
                 "<div class=\"charts by-three\">\n" + charts + "</div>\n" + tables);
}

}  // namespace clast::report_detail
