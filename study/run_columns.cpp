#include "study/run_columns.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "classify/form.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

/// Orders by number where there is one, then by text.
using Value = std::pair<double, std::string>;

Value number(double value) { return {value, with_digits(value, 6)}; }
Value count(std::uint64_t value) { return {static_cast<double>(value), std::to_string(value)}; }
Value text(const std::string& value) { return {0.0, value.empty() ? "none" : value}; }

struct Column {
  const char* name;
  Value (*value)(const CampaignResults&, const RunRow&);
};

const GroundSet* ground_set(const CampaignResults& results, const RunRow& row) {
  const std::uint32_t set = row.record->ground_set;
  return set < results.ground_sets.size() ? &results.ground_sets[set] : nullptr;
}

const std::vector<Column>& columns() {
  using Results = CampaignResults;
  static const std::vector<Column> all = {
      {"block", [](const Results&, const RunRow& r) { return text(r.block->id); }},
      {"library_block",
       [](const Results&, const RunRow& r) { return text(r.block->library_block()); }},
      {"block_group", [](const Results&, const RunRow& r) { return text(r.block->group); }},
      {"class", [](const Results&, const RunRow& r) { return text(r.block->sneed_folk); }},
      {"shape", [](const Results&, const RunRow& r) { return text(r.block->garcia); }},
      {"zingg", [](const Results&, const RunRow& r) { return text(r.block->zingg); }},
      {"mass_kg", [](const Results&, const RunRow& r) { return number(r.block->mass); }},
      {"volume_m3", [](const Results&, const RunRow& r) { return number(r.block->volume); }},
      {"scale", [](const Results&, const RunRow& r) { return number(r.block->scale); }},
      {"s_c",
       [](const Results&, const RunRow& r) { return number(elongation_s_c(r.block->axes)); }},
      {"L_m", [](const Results&, const RunRow& r) { return number(r.block->axes.L); }},
      {"I_m", [](const Results&, const RunRow& r) { return number(r.block->axes.I); }},
      {"S_m", [](const Results&, const RunRow& r) { return number(r.block->axes.S); }},
      {"file", [](const Results&, const RunRow& r) { return count(r.file + 1); }},
      {"point", [](const Results&, const RunRow& r) { return count(r.record->point); }},
      {"orientation", [](const Results&, const RunRow& r) { return count(r.record->orientation); }},
      {"release_set",
       [](const Results& results, const RunRow& r) {
         return text(release_set_of(results, r.record->point));
       }},
      {"ground_set", [](const Results&, const RunRow& r) { return count(r.record->ground_set); }},
      {"ensemble_member",
       [](const Results& results, const RunRow& r) {
         const GroundSet* set = ground_set(results, r);
         return count(set ? set->member : 0);
       }},
      {"stop_reason",
       [](const Results&, const RunRow& r) { return text(name_of(r.record->result.stop_reason)); }},
      {"max_speed_m_s",
       [](const Results&, const RunRow& r) { return number(r.record->result.max_speed); }},
      {"impacts", [](const Results&, const RunRow& r) { return count(r.record->result.impacts); }},
      {"longest_flight_m",
       [](const Results&, const RunRow& r) { return number(r.record->contacts.longest_flight); }}};
  return all;
}

const Column& column_named(const std::string& name) {
  for (const Column& column : columns()) {
    if (name == column.name) return column;
  }
  std::string list;
  for (const Column& column : columns())
    list += (list.empty() ? "" : ", ") + std::string(column.name);
  throw InputError("runs have no column \"" + name + "\" to be grouped by; there are " + list);
}

// The quarter of the sorted values that a number lies in: its bounds, in words.
Value quarter(const std::vector<double>& sorted, double value) {
  std::vector<double> bounds;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) bounds.push_back(quantile(sorted, share));
  std::size_t part = 0;
  while (part < 3 && value > bounds[part + 1]) ++part;
  return {static_cast<double>(part),
          with_digits(bounds[part], 4) + " to " + with_digits(bounds[part + 1], 4)};
}

}  // namespace

std::vector<std::string> run_columns() {
  std::vector<std::string> names;
  for (const Column& column : columns()) names.emplace_back(column.name);
  return names;
}

void append_column_groups(Comparison& comparison, const std::string& name) {
  const Column& column = column_named(name);
  std::vector<Value> values;
  for (const RunRow& row : comparison.rows) {
    values.push_back(column.value(comparison.results[row.file], row));
  }
  const std::set<Value> distinct(values.begin(), values.end());
  // Texts have the number 0.
  const bool numbers = distinct.begin()->first != distinct.rbegin()->first;
  if (numbers && distinct.size() > kMostValues) {
    std::vector<double> sorted;
    for (const Value& value : values) sorted.push_back(value.first);
    std::sort(sorted.begin(), sorted.end());
    for (Value& value : values) value = quarter(sorted, value.first);
  }
  std::map<Value, std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < values.size(); ++i) rows[values[i]].push_back(i);
  for (auto& [value, members] : rows) {
    comparison.groups.push_back({name + " " + value.second, GroupKind::kColumn, value.second, name,
                                 std::nullopt, std::move(members)});
  }
}

}  // namespace clast
