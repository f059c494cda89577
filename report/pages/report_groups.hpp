#pragma once
/// Which groups a report shows, what they are called, and what its sections share.
#include <optional>
#include <string>
#include <vector>

#include "report/charts/palette.hpp"
#include "report/charts/series.hpp"
#include "study/comparison.hpp"

namespace clast::report_detail {

bool several_files(const Comparison& comparison);
/// Groups of one kind: per file when there are several files, so that sites do not mix.
std::vector<std::size_t> groups_of(const Comparison& comparison, GroupKind kind);
/// The name without what the table's heading says already.
std::string short_name(const Group& group);

/// Mean and standard deviation as text; "-" for an empty sample.
std::string mean_and_std(const Summary& summary, int decimals, double unit = 1.0);
/// `value` of a summary; "-" for an empty sample.
std::string measured(double value, const Summary& summary, int decimals);

/// One curve per group. Classes keep their colours; with several files the dash distinguishes
/// files.
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

}  // namespace clast::report_detail
