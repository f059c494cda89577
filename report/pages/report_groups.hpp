#pragma once
/// Selection, names and curve styles of the groups in a report.
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "report/charts/palette.hpp"
#include "report/charts/series.hpp"
#include "study/compare/comparison.hpp"

namespace clast::report_detail {

bool has_several_files(const Comparison& comparison);
/// Returns the indices of the groups of one kind. If there are several files, these are the groups
/// of single files; otherwise, those over all files.
std::vector<std::size_t> select_groups_of_kind(const Comparison& comparison, RunGroupKind kind);
/// Returns the name of a group without its kind, such as "compact" for "class compact".
std::string short_group_name(const RunGroup& group);

/// Formats mean and standard deviation; "-" for an empty sample.
std::string format_mean_and_deviation(const SampleSummary& summary, int decimals,
                                      double unit = 1.0);
/// Formats a value of a sample summary; "-" for an empty sample.
std::string format_summary_value(double value, const SampleSummary& summary, int decimals);

/// Appends an item to a list such as "runout; largest speed".
void append_list_item(std::string& list, const std::string& item);
/// Formats a list as a paragraph with a bold head. Empty if the list is empty.
std::string format_headed_list(const std::string& head, const std::string& list);

/// Returns the class of a group with a single block; empty for several blocks.
std::string block_class_of_group(const Comparison& comparison, const RunGroup& group);

/// Chooses colour and dash pattern of the curve of a group. Classes differ in colour, blocks in
/// dash pattern or shade.
/// @param classes_before  classes of the previously drawn groups
std::pair<std::string, std::string> choose_curve_style(
    const Comparison& comparison, const RunGroup& group,
    const std::vector<std::string>& classes_before);

template <class Value>
std::vector<ChartSeries> make_value_series(const Comparison& comparison, RunGroupKind kind,
                                           Value value_of) {
  std::vector<ChartSeries> series;
  std::vector<std::string> classes;
  for (const std::size_t g : select_groups_of_kind(comparison, kind)) {
    const RunGroup& group = comparison.groups[g];
    ChartSeries one;
    one.name = short_group_name(group);
    std::tie(one.colour, one.dash) = choose_curve_style(comparison, group, classes);
    classes.push_back(block_class_of_group(comparison, group));
    for (const std::size_t row : group.rows) {
      const std::optional<double> value = value_of(row);
      if (value) one.values.push_back(*value);
    }
    series.push_back(std::move(one));
  }
  return series;
}

}  // namespace clast::report_detail
