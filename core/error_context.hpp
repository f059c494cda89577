#pragma once
/// Errors that name what was being worked on.
#include <string>
#include <utility>

#include "core/error.hpp"

namespace clast {

/// Calls `f` and returns its result. An error of the family that it throws gets `rewrite(message)`
/// as its message and keeps its kind.
template <class Rewrite, class F>
decltype(auto) with_rewritten_error(Rewrite&& rewrite, F&& f) {
  try {
    return std::forward<F>(f)();
  } catch (const GeometryError& error) {
    throw GeometryError(rewrite(std::string(error.what())));
  } catch (const SimulationError& error) {
    throw SimulationError(rewrite(std::string(error.what())));
  } catch (const InputError& error) {
    throw InputError(rewrite(std::string(error.what())));
  }
}

/// Calls `f` and returns its result. The message of an error that it throws gets `name` in front,
/// "block B01: ...".
template <class F>
decltype(auto) with_error_context(const std::string& name, F&& f) {
  return with_rewritten_error([&](const std::string& message) { return name + ": " + message; },
                              std::forward<F>(f));
}

/// As `with_error_context`; a message that names the file already stays as it is.
template <class F>
decltype(auto) with_file_context(const std::string& path, F&& f) {
  return with_rewritten_error(
      [&](const std::string& message) {
        return message.find(path) == std::string::npos ? path + ": " + message : message;
      },
      std::forward<F>(f));
}

}  // namespace clast
