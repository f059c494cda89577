#pragma once
/// Formats of the TOML values that keys of campaign files accept.
#include <utility>

#include "study/campaign/key_table.hpp"

namespace clast::study_detail {

using Kind = ValueFormat::Kind;

inline ValueFormat text_format() { return {}; }
inline ValueFormat word_format(std::vector<std::string> all) { return {.words = std::move(all)}; }
inline ValueFormat pattern_format(std::string pattern) { return {.pattern = std::move(pattern)}; }
inline ValueFormat flag_format() { return {.kind = Kind::kFlag}; }
inline ValueFormat count_format(std::uint64_t minimum, std::uint64_t maximum) {
  return {.kind = Kind::kCount, .minimum = minimum, .maximum = maximum};
}
inline ValueFormat seed_format() { return count_format(0, INT64_MAX); }
inline ValueFormat number_format(const NumberRange& range) {
  return {.kind = Kind::kNumber, .range = range};
}
inline ValueFormat list_format(ValueFormat item, std::uint64_t minimum,
                               std::uint64_t maximum = INT64_MAX) {
  return {.kind = Kind::kList, .minimum = minimum, .maximum = maximum, .items = {std::move(item)}};
}
inline ValueFormat table_format(std::vector<TableKey> keys) {
  return {.kind = Kind::kTable, .keys = std::move(keys)};
}
inline ValueFormat named_table_format(ValueFormat item) {
  return {.kind = Kind::kNamed, .items = {std::move(item)}};
}
inline ValueFormat alternative_formats(std::vector<ValueFormat> forms) {
  return {.kind = Kind::kEither, .items = std::move(forms)};
}
/// Returns the format of a TOML value that is a single value or a list of such values.
inline ValueFormat one_or_more_format(const ValueFormat& form, std::uint64_t maximum = INT64_MAX) {
  return alternative_formats({form, list_format(form, 1, maximum)});
}
inline ValueFormat texts_format() { return one_or_more_format(text_format()); }
/// Returns the format of a TOML value that is a point in map coordinates, with or without height.
ValueFormat point_format();
/// Returns the format of a TOML value that is a number or a probability distribution.
ValueFormat uncertain_number_format(const NumberRange& range);

/// Sets the unit of a format, unless its range has a unit.
ValueFormat with_unit(ValueFormat form, const char* unit);
/// Marks the format of a key as required.
/// @param expected  description of the value in the message if it is missing
inline ValueFormat required_format(std::string expected, ValueFormat form) {
  form.required = std::move(expected);
  return form;
}

}  // namespace clast::study_detail
