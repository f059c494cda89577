#pragma once
/// Which groups a report shows, what they are called, and what its sections share.
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
/// Groups of one kind: per file when there are several files, so that sites do not mix.
std::vector<std::size_t> select_groups(const Comparison& comparison, GroupKind kind);
/// The name without what the table's heading says already.
std::string short_group_name(const Group& group);

/// Mean and standard deviation as text; "-" for an empty sample.
std::string format_mean_and_deviation(const Summary& summary, int decimals, double unit = 1.0);
/// `value` of a summary; "-" for an empty sample.
std::string measured(double value, const Summary& summary, int decimals);

/// Adds to a list of items, "runout; largest speed".
void append_item(std::string& list, const std::string& item);
/// A line with its head in bold; empty for an empty list.
std::string format_headed_list(const std::string& head, const std::string& list);

/// Class of the block that all runs of a group are of; empty where they are of several.
std::string block_class_of_group(const Comparison& comparison, const Group& group);

/// Colour and dash of the curve of a group: a block has the colour of its class, and a dash or
/// shade of its own. Together they repeat after twelve blocks of a class.
/// @param classes_before  of the groups drawn before it
std::pair<std::string, std::string> choose_curve_style(const Comparison& comparison, const Group& group,
                                                const std::vector<std::string>& classes_before);

/// One curve per group.
template <class Value>
std::vector<Series> make_value_series(const Comparison& comparison, GroupKind kind, Value value_of) {
  std::vector<Series> series;
  std::vector<std::string> classes;
  for (const std::size_t g : select_groups(comparison, kind)) {
    const Group& group = comparison.groups[g];
    Series one;
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
