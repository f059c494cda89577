#pragma once
/// What is said when something is refused.
#include <gtest/gtest.h>

#include <concepts>
#include <string>

#include "core/error.hpp"

namespace clast {

/// The message of the `Expected` that `action` throws; empty when it throws nothing. Anything else
/// it throws fails the test.
template <class Expected = InputError, std::invocable Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const Expected& error) {
    return error.what();
  }
  return {};
}

/// Whether `part` occurs in `text`; says the text, a page at most, when it does not.
inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "\"" << text.substr(0, 2000) << "\" does not contain \"" << part << "\"";
}

}  // namespace clast
