#pragma once
/// Validators of command-line option values.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>

#include "core/number_range.hpp"

namespace clast {

/// Makes an option validator that accepts the numbers of a range.
CLI::Validator number_in_range(const NumberRange& range);
/// Makes an option validator that accepts decimal integers from `low` to `high`.
CLI::Validator integer_in_range(std::uint64_t low = 0, std::uint64_t high = UINT64_MAX);

/// Runs a check of option values and reports its errors as misuse.
/// @throws CLI::ValidationError  if `check` throws InputError
void check_usage(const std::function<void()>& check);

}  // namespace clast
