#pragma once
/// Keyword arguments on their way into the options of a library.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace clast::python_detail {

/// The keyword arguments of one call. Those that are None were not given.
class Keywords {
 public:
  explicit Keywords(const pybind11::dict& given);

  /// Whether it is given; it counts as taken then.
  bool has(const char* name);
  /// Sets the field where the argument is given.
  /// @throws TypeError  it is of another type; the message names it
  template <class T>
  void take(const char* name, T& field) {
    if (has(name)) field = cast<T>(name);
  }
  template <class T>
  void take(const char* name, std::optional<T>& field) {
    if (has(name)) field = cast<T>(name);
  }
  /// A text, a path, or several of them.
  std::vector<std::string> texts(const char* name);
  /// Not taken by anything above: none; the Python side gives what this side takes.
  /// @throws TypeError  naming one that is left
  void done() const;

  pybind11::object object(const char* name) const { return given_[name]; }

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

/// A text or a path, or several, as texts.
std::vector<std::string> parse_texts(const pybind11::handle& object, const char* name);

}  // namespace clast::python_detail
