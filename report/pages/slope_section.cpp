#include <cmath>

#include "dem/terrain_surface.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"

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

std::vector<std::string> counts_of(const Bins& bins) {
  std::vector<std::string> notes;
  for (const ProfileBin* bin : bins) notes.push_back(std::to_string(bin->runs) + " runs");
  return notes;
}

/// Mean, 95th percentile and largest of a quantity of every class.
std::string against_distance(const Comparison& comparison, const std::vector<ProfileBin>& bins,
                             std::optional<std::uint32_t> file, const ChartAxes& axes,
                             Summary ProfileBin::*quantity, double unit) {
  std::vector<Trace> traces;
  for (const std::size_t g : groups_of(comparison, GroupKind::kGarcia)) {
    const Group& group = comparison.groups[g];
    if (group.file != file) continue;
    const Bins along = bins_of_group(bins, g);
    const auto add = [&](const char* name, const char* dash, double Summary::*value, bool shown) {
      Trace trace{
          group.key + ", " + name, class_colour(group.key), dash, Trace::Kind::kLine, {}, {}};
      for (const ProfileBin* bin : along) {
        const Summary& summary = bin->*quantity;
        trace.x.push_back(0.5 * (bin->from + bin->to));
        trace.y.push_back(summary.count > 0 ? summary.*value * unit : NAN);
      }
      trace.notes = counts_of(along);
      trace.shown = shown;
      traces.push_back(std::move(trace));
    };
    add("95 % below", "", &Summary::p95, true);
    add("mean", "6 3", &Summary::mean, true);
    add("largest", "2 2", &Summary::max, false);
  }
  return plotly_chart(axes, traces);
}

/// The ground under the mean path of a group, and how high its blocks pass over it.
std::string cut_along_the_mean_path(const Comparison& comparison,
                                    const std::vector<ProfileBin>& bins, std::size_t group,
                                    const std::string& title) {
  const CampaignResults& results = comparison.results[comparison.groups[group].file.value_or(0)];
  const TerrainSurface surface = terrain_surface(results.terrain);
  const double highest = bounds(results.terrain.surface).high.z();
  Trace ground{"ground", "#7a6245", {}, Trace::Kind::kLine, {}, {}};
  Trace most{"95 % of the runs pass below", "#0072B2", {}, Trace::Kind::kLine, {}, {}};
  Trace all{"highest passage", "#0072B2", "2 2", Trace::Kind::kLine, {}, {}};
  const Bins along = bins_of_group(bins, group);
  for (const ProfileBin* bin : along) {
    const Vec2 place = bin->place - results.frame.origin.head<2>();
    const double z =
        surface.height(place.x(), place.y(), highest).value_or(NAN) + results.frame.origin.z();
    for (Trace* trace : {&ground, &most, &all}) trace->x.push_back(0.5 * (bin->from + bin->to));
    ground.y.push_back(z);
    most.y.push_back(bin->height.count > 0 ? z + bin->height.p95 : NAN);
    all.y.push_back(bin->height.count > 0 ? z + bin->height.max : NAN);
  }
  most.filled = true;
  most.notes = all.notes = counts_of(along);
  ChartAxes axes{title, "distance along downslope, m", "elevation, m"};
  axes.equal_scales = true;
  return plotly_chart(axes, {ground, most, all});
}

/// Groups of which each has a path of its own: one for each file, or for each release set of one.
std::vector<std::size_t> groups_with_a_path(const Comparison& comparison) {
  std::vector<std::size_t> found;
  for (const std::size_t g : groups_of(comparison, GroupKind::kAll)) {
    const CampaignResults& results = comparison.results[comparison.groups[g].file.value_or(0)];
    if (results.release_sets.size() < 2) found.push_back(g);
  }
  if (several_files(comparison)) return found;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    if (comparison.groups[g].column == "release_set") found.push_back(g);
  }
  return found;
}

}  // namespace

std::string slope_section(const Comparison& comparison, const std::vector<ProfileBin>& bins) {
  const std::string title = "Along the slope";
  if (bins.empty()) {
    return section(title, paragraph("The results hold no trajectories: set [run] "
                                    "trajectory_interval_s above zero to see energies and passing "
                                    "heights against distance."));
  }
  std::string charts = "<div class=\"charts\">\n";
  for (const std::size_t all : groups_of(comparison, GroupKind::kAll)) {
    const std::optional<std::uint32_t> file = comparison.groups[all].file;
    const std::string where = file ? ", file " + std::to_string(*file + 1) : std::string();
    const std::string distance = "distance along downslope, m";
    charts += against_distance(comparison, bins, file,
                               {"Energy against distance" + where, distance, "energy, kJ"},
                               &ProfileBin::energy, 1e-3);
    charts += against_distance(
        comparison, bins, file,
        {"Passing height against distance" + where, distance, "height above ground, m"},
        &ProfileBin::height, 1.0);
    charts += against_distance(comparison, bins, file,
                               {"Speed against distance" + where, distance, "speed, m/s"},
                               &ProfileBin::speed, 1.0);
  }
  for (const std::size_t group : groups_with_a_path(comparison)) {
    const std::string name = short_name(comparison.groups[group]);
    charts +=
        cut_along_the_mean_path(comparison, bins, group, "The ground along the mean path: " + name);
  }
  return section(title,
                 paragraph("Largest value of each run that comes so far, by distance. The section "
                           "follows the mean path.") +
                     charts + "</div>\n");
}

}  // namespace clast::report_detail
