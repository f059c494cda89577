#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "report/charts/palette.hpp"
#include "report/charts/rose_diagram.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/capital.hpp"
#include "report/text/subject_words.hpp"

namespace clast::report_detail {
namespace {

constexpr double kFabricLevel = 0.05;    ///< of tests
constexpr double kAlong = 30.0;          ///< deg from downslope: up to this is along it
constexpr double kAcross = 60.0;         ///< ... and from this on across it
constexpr std::size_t kFewestAxes = 10;  ///< of a rose, and of a statement
constexpr const char* kNoChance = "; one realisation does not show whether this is chance";

std::string group_colour(const FabricGroup& group) {
  const std::string prefix = "class ";
  return group.name.starts_with(prefix) ? class_colour(group.name.substr(prefix.size()))
                                        : class_colour("");
}

/// @param all  of the file: a class that has all blocks has no rose of its own
bool has_rose(const FabricGroup& group, const FabricGroup& all) {
  if (group.blocks < kFewestAxes) return false;
  return group.name == "all" || (group.name.starts_with("class ") && group.blocks < all.blocks);
}

std::string prefix_of(const Comparison& comparison, std::uint32_t file) {
  return several_files(comparison) ? file_name(comparison, file) + ": " : "";
}

/// "lie across the slope (axial mean 78 deg to the right of downslope, resultant 0.31)".
std::string orientation_in_words(const FabricGroup& all) {
  const double degrees = kDegreesPerRadian * all.trend.direction;
  const std::optional<double> p =
      all.rayleigh_realisations ? all.rayleigh_realisations : all.rayleigh;
  const std::string figures =
      "axial mean " + fixed(std::abs(degrees), 0) + "\xC2\xB0 to the " +
      (degrees < 0.0 ? "left" : "right") + " of downslope, resultant " +
      fixed(all.trend.resultant, 2) +
      (p ? ", p " + with_digits(*p, 2) +
               (all.rayleigh_realisations ? "" : " with blocks taken as independent")
         : std::string());
  if (!p) return "have " + figures + kNoChance;
  if (!(*p < kFabricLevel)) return "have no direction beyond chance (" + figures + ")";
  return (std::abs(degrees) <= kAlong    ? "lie along the slope ("
          : std::abs(degrees) >= kAcross ? "lie across the slope ("
                                         : "lie obliquely to the slope (") +
         figures + ")";
}

std::string neighbours_in_words(const NeighbourTest& test) {
  const std::string figures = percent(test.share, 0) + " of nearest neighbours against " +
                              percent(test.expected, 0) + " by chance" +
                              (test.p_value ? ", p " + with_digits(*test.p_value, 2) : "");
  if (!test.p_value) return "Blocks of a class: " + figures + kNoChance + ".";
  if (!(*test.p_value < kFabricLevel)) {
    return "Blocks of a class lie neither together nor apart beyond chance (" + figures + ").";
  }
  return std::string("Blocks of a class lie ") +
         (test.share > test.expected ? "together" : "apart") + " (" + figures + ").";
}

std::string sorting_in_words(const SortingTrend& size) {
  const RealisationMean& mean = size.rank_correlation;
  const std::string figures =
      "rank correlation of volume and runout " + fixed(mean.summary.mean, 2) +
      (mean.interval
           ? " (" + fixed(mean.interval->low, 2) + " to " + fixed(mean.interval->high, 2) + ")"
           : std::string()) +
      ", " + counted(mean.summary.count, "realisation");
  if (!size.p_value) return "Size and runout: " + figures + "; an interval takes two that differ.";
  if (!(*size.p_value < kFabricLevel))
    return "Runout does not go with size beyond chance (" + figures + ").";
  return std::string(mean.summary.mean > 0.0 ? "Larger" : "Smaller") + " blocks go farther (" +
         figures + ").";
}

std::string words_of(const Comparison& comparison, const DepositFabric& fabric) {
  std::string html;
  for (const FabricGroup& group : fabric.groups) {
    if (group.name != "all") continue;
    std::string words =
        group.blocks < kFewestAxes ? "" : "Long axes " + orientation_in_words(group) + ". ";
    for (const NeighbourTest& test : fabric.neighbours) {
      if (test.file == group.file && test.scheme == "garcia") {
        words += neighbours_in_words(test) + " ";
      }
    }
    for (const SortingTrend& trend : fabric.sorting) {
      if (trend.file == group.file && trend.property == "volume" && trend.place == "runout") {
        words += sorting_in_words(trend);
      }
    }
    if (!words.empty()) html += paragraph(capital(prefix_of(comparison, group.file) + words));
  }
  return html;
}

std::string roses_of(const Comparison& comparison, const DepositFabric& fabric) {
  std::string roses;
  const FabricGroup* all = nullptr;
  for (const FabricGroup& group : fabric.groups) {
    if (group.name == "all") all = &group;
    if (!has_rose(group, *all)) continue;
    const std::string of_file =
        several_files(comparison) ? "file " + std::to_string(group.file + 1) + ": " : "";
    roses += figure(rose_diagram(of_file + group.name + " (" + std::to_string(group.blocks) + ")",
                                 group_colour(group), group.trends, group.trend));
  }
  if (roses.empty()) return "";
  return "<div class=\"charts by-three roses\">\n" + roses + "</div>\n" +
         paragraph(
             "Directions of the long axes in plan, downslope up; areas are as the numbers "
             "of blocks. The dashed circle is where all sectors would end if directions were "
             "even, the line is the axial mean, as long as the resultant.");
}

std::string mean_cell(const RealisationMean& mean, int decimals) {
  if (mean.summary.count == 0) return "-";
  const std::string value = fixed(mean.summary.mean, decimals);
  if (!mean.interval) return value;
  return value + " (" + fixed(mean.interval->low, decimals) + " to " +
         fixed(mean.interval->high, decimals) + ")";
}

std::string fabric_table(const Comparison& comparison, const DepositFabric& fabric) {
  HtmlTable table({"group", "blocks", "along, m", "ahead, m", "aside, m", "height, m",
                   "relative height", "trend, \xC2\xB0", "resultant", "p, blocks",
                   "p, realisations", "plunge, \xC2\xB0", "eigenvalues"},
                  1);
  for (const FabricGroup& group : fabric.groups) {
    const Vec3& values = group.eigenvalues;
    table.row({prefix_of(comparison, group.file) + group.name, std::to_string(group.blocks),
               mean_cell(group.along, 2), mean_cell(group.ahead, 2), mean_cell(group.aside, 2),
               mean_cell(group.height, 2), mean_cell(group.relative_height, 2),
               fixed(kDegreesPerRadian * group.trend.direction, 0), fixed(group.trend.resultant, 2),
               group.rayleigh ? with_digits(*group.rayleigh, 2) : "-",
               group.rayleigh_realisations ? with_digits(*group.rayleigh_realisations, 2) : "-",
               fixed(kDegreesPerRadian * group.plunge, 0),
               fixed(values[0], 2) + ", " + fixed(values[1], 2) + ", " + fixed(values[2], 2)});
  }
  return table.html();
}

std::string sorting_tables(const Comparison& comparison, const DepositFabric& fabric) {
  HtmlTable neighbours(
      {"classes", "blocks", "nearest neighbour of the same class", "by chance", "p"}, 1);
  for (const NeighbourTest& test : fabric.neighbours) {
    neighbours.row({prefix_of(comparison, test.file) + test.scheme, std::to_string(test.blocks),
                    percent(test.share), percent(test.expected),
                    test.p_value ? with_digits(*test.p_value, 2) : "-"});
  }
  HtmlTable sorting({"property", "place", "realisations", "rank correlation", "p"}, 2);
  for (const SortingTrend& trend : fabric.sorting) {
    sorting.row({prefix_of(comparison, trend.file) + trend.property, trend.place,
                 std::to_string(trend.rank_correlation.summary.count),
                 mean_cell(trend.rank_correlation, 2),
                 trend.p_value ? with_digits(*trend.p_value, 2) : "-"});
  }
  return (fabric.neighbours.empty() ? "" : neighbours.html()) +
         (fabric.sorting.empty() ? "" : sorting.html());
}

}  // namespace

std::string fabric_section(const Comparison& comparison, const DepositFabric& fabric) {
  if (fabric.groups.empty()) return "";
  return section(
      "Fabric and sorting",
      words_of(comparison, fabric) + roses_of(comparison, fabric) +
          folded("Figures of fabric and sorting",
                 paragraph(
                     "Means over realisations with 95 % interval. Along is from the highest start, "
                     "ahead from the centre of mass of the deposit, both along downslope; aside is "
                     "to either side of the line along downslope through the centre of the starts. "
                     "Relative height is that of the block's centre over the thickness of the "
                     "deposit there: 0.5 of a block alone, less below others, more upon them. "
                     "Where L is near I, which axis is the long one is chance. p is of even "
                     "directions, with blocks or with realisations taken as independent.") +
                     fabric_table(comparison, fabric) + sorting_tables(comparison, fabric)));
}

}  // namespace clast::report_detail
