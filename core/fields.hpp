#pragma once
/// Named fields of option structs, listed once for printing and hashing.
///
/// Each struct has a function `visit_fields` beside it that uses a structured binding, so that a
/// field missing in the list is a compile error:
///
///     template <class Visit>
///     void visit_fields(const CloudSurfaceOptions& options, Visit&& visit) {
///       const auto& [cell, trim, fewest] = options;
///       visit("cell", cell), visit("trim", trim), visit("fewest", fewest);
///     }
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/number_text.hpp"
#include "core/types.hpp"

namespace clast {

/// Marks a field without effect on results, such as the number of threads; `format_field` omits it.
template <class T>
struct ExcludedField {
  using IsExcluded = void;
  const T& value;
};
template <class T>
ExcludedField(const T&) -> ExcludedField<T>;

template <class T>
concept HasFields = requires(const T& options) {
  visit_fields(options, [](const char*, const auto&) {});
};

/// Formats a text in quotes. Quotes inside are escaped, so that no text looks like two fields.
inline std::string format_field(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}
inline std::string format_field(const std::filesystem::path& value) {
  return format_field(value.string());
}
inline std::string format_field(const Vec3& value) {
  return format_significant(value.x(), 17) + " " + format_significant(value.y(), 17) + " " +
         format_significant(value.z(), 17);
}

template <class T>
requires std::is_arithmetic_v<T> std::string format_field(T value) {
  if constexpr (std::is_floating_point_v<T>) return format_significant(value, 17);
  return std::to_string(value);
}

template <HasFields T>
std::string format_field(const T& options);
template <class T>
std::string format_field(const std::optional<T>& value);
template <class T>
std::string format_field(const std::vector<T>& values);
template <class T, std::size_t n>
std::string format_field(const std::array<T, n>& values);

namespace core_detail {

template <class Values>
std::string comma_separated(const Values& values) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + format_field(value);
  return "[" + text + "]";
}

}  // namespace core_detail

template <class T>
std::string format_field(const std::optional<T>& value) {
  return value ? format_field(*value) : "none";
}
template <class T>
std::string format_field(const std::vector<T>& values) {
  return core_detail::comma_separated(values);
}
template <class T, std::size_t n>
std::string format_field(const std::array<T, n>& values) {
  return core_detail::comma_separated(values);
}

/// Formats all fields that affect results, including nested structs: "{unit=1, up="z", ...}".
/// Options with equal texts give equal results.
template <HasFields T>
std::string format_field(const T& options) {
  std::string text;
  const auto visit = [&]<class Value>(const char* name, const Value& value) {
    if constexpr (!requires { typename Value::IsExcluded; }) {
      text += (text.empty() ? "" : ", ") + std::string(name) + "=" + format_field(value);
    }
  };
  visit_fields(options, visit);
  return "{" + text + "}";
}

}  // namespace clast
