#pragma once
/// Adding context to error messages.
#include <string>
#include <utility>

#include "core/error.hpp"

namespace clast {

/// Calls `f` and returns its result. If `f` throws a clast error, it is thrown again with the same
/// type and the message `rewrite(message)`.
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

/// Calls `f` and returns its result. Prefixes clast errors with `name`: "block B01: ...".
template <class F>
decltype(auto) with_error_context(const std::string& name, F&& f) {
  return with_rewritten_error([&](const std::string& message) { return name + ": " + message; },
                              std::forward<F>(f));
}

/// Like `with_error_context`, but messages that already name the file are not changed.
template <class F>
decltype(auto) with_file_context(const std::string& path, F&& f) {
  return with_rewritten_error(
      [&](const std::string& message) {
        return message.find(path) == std::string::npos ? path + ": " + message : message;
      },
      std::forward<F>(f));
}

}  // namespace clast
