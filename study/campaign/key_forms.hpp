#pragma once
/// Values of keys, for tables of them.
#include <utility>

#include "study/campaign/key_table.hpp"

namespace clast::study_detail {

using Kind = ValueForm::Kind;

inline ValueForm text() { return {}; }
inline ValueForm words(std::vector<std::string> all) { return {.words = std::move(all)}; }
inline ValueForm fitting(std::string pattern) { return {.pattern = std::move(pattern)}; }
inline ValueForm flag() { return {.kind = Kind::kFlag}; }
inline ValueForm count(std::uint64_t least, std::uint64_t most) {
  return {.kind = Kind::kCount, .least = least, .most = most};
}
inline ValueForm seed() { return count(0, INT64_MAX); }
inline ValueForm number(const NumberRange& range) {
  return {.kind = Kind::kNumber, .range = range};
}
inline ValueForm list(ValueForm item, std::uint64_t least, std::uint64_t most = INT64_MAX) {
  return {.kind = Kind::kList, .least = least, .most = most, .items = {std::move(item)}};
}
inline ValueForm table(std::vector<TableKey> keys) {
  return {.kind = Kind::kTable, .keys = std::move(keys)};
}
inline ValueForm named(ValueForm item) {
  return {.kind = Kind::kNamed, .items = {std::move(item)}};
}
inline ValueForm either(std::vector<ValueForm> forms) {
  return {.kind = Kind::kEither, .items = std::move(forms)};
}
/// A value or a list of such.
inline ValueForm one_or_more(const ValueForm& form, std::uint64_t most = INT64_MAX) {
  return either({form, list(form, 1, most)});
}
inline ValueForm texts() { return one_or_more(text()); }
/// On a map, with or without its height.
ValueForm point();
/// A number, or the law by which it is drawn, as `read_uncertain` takes it.
ValueForm uncertain(const NumberRange& range);

/// The form of a value whose unit its key states; a range that has one keeps it.
ValueForm with_unit(ValueForm form, const char* unit);
/// A value that may not be missing.
/// @param expected  what it must be, for the refusal of a table without it
inline ValueForm required(std::string expected, ValueForm form) {
  form.required = std::move(expected);
  return form;
}

}  // namespace clast::study_detail
