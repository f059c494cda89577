#pragma once
/// Conversion of keyword arguments to option structs.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace clast::python_detail {

/// Keyword arguments of a Python call. None counts as not given.
class Keywords {
 public:
  explicit Keywords(const pybind11::dict& given);

  /// Returns true if the argument is given, and marks it as used.
  bool has(const char* name);
  /// Sets an option field if the argument is given.
  /// @throws TypeError  if the argument has a wrong type; names the argument
  template <class T>
  void read(const char* name, T& field) {
    if (has(name)) field = cast<T>(name);
  }
  template <class T>
  void read(const char* name, std::optional<T>& field) {
    if (has(name)) field = cast<T>(name);
  }
  /// Returns the texts of an argument, which is a text, a path or a list of these.
  std::vector<std::string> read_texts(const char* name);
  /// Checks that all given arguments were used.
  /// @throws TypeError  if an argument was not used; names it
  void check_all_used() const;

  pybind11::object given_object(const char* name) const { return given_[name]; }

 private:
  template <class T>
  T cast(const char* name) const {
    try {
      return pybind11::cast<T>(given_[name]);
    } catch (const pybind11::cast_error&) {
      refuse(name);
    }
  }
  [[noreturn]] void refuse(const char* name) const;

  pybind11::dict given_;
  std::vector<std::string> taken_;
};

/// Converts a Python text, a path or a list of these to texts.
std::vector<std::string> parse_texts(const pybind11::handle& object, const char* name);

}  // namespace clast::python_detail
