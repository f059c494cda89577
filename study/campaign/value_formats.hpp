#pragma once
/// Constructors of value formats for key declarations.
#include <utility>

#include "study/campaign/key_table.hpp"

namespace clast::study_detail {

using Kind = ValueFormat::Kind;

inline ValueFormat text() { return {}; }
inline ValueFormat words(std::vector<std::string> all) { return {.words = std::move(all)}; }
inline ValueFormat fitting(std::string pattern) { return {.pattern = std::move(pattern)}; }
inline ValueFormat flag() { return {.kind = Kind::kFlag}; }
inline ValueFormat count(std::uint64_t least, std::uint64_t most) {
  return {.kind = Kind::kCount, .least = least, .most = most};
}
inline ValueFormat seed() { return count(0, INT64_MAX); }
inline ValueFormat number(const NumberRange& range) {
  return {.kind = Kind::kNumber, .range = range};
}
inline ValueFormat list(ValueFormat item, std::uint64_t least, std::uint64_t most = INT64_MAX) {
  return {.kind = Kind::kList, .least = least, .most = most, .items = {std::move(item)}};
}
inline ValueFormat table(std::vector<TableKey> keys) {
  return {.kind = Kind::kTable, .keys = std::move(keys)};
}
inline ValueFormat named(ValueFormat item) {
  return {.kind = Kind::kNamed, .items = {std::move(item)}};
}
inline ValueFormat either(std::vector<ValueFormat> forms) {
  return {.kind = Kind::kEither, .items = std::move(forms)};
}
/// Format of a single value or a list of such values.
inline ValueFormat one_or_more(const ValueFormat& form, std::uint64_t most = INT64_MAX) {
  return either({form, list(form, 1, most)});
}
inline ValueFormat texts() { return one_or_more(text()); }
/// Format of a map point, with or without height.
ValueFormat point();
/// Format of a number or distribution that `read_distribution` accepts.
ValueFormat uncertain(const NumberRange& range);

/// Sets the unit of a format. A range that has a unit keeps it.
ValueFormat with_unit(ValueFormat form, const char* unit);
/// Marks a format as required.
/// @param expected  description of the value for the message if it is missing
inline ValueFormat required(std::string expected, ValueFormat form) {
  form.required = std::move(expected);
  return form;
}

}  // namespace clast::study_detail
