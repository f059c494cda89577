#pragma once
/// Values of command-line options that are more than a number or a name.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>

#include "core/number_range.hpp"

namespace clast {

/// Accepts the numbers of a range.
CLI::Validator within(const NumberRange& range);
/// Accepts whole numbers from `low` to `high`, in digits alone.
CLI::Validator whole_number(std::uint64_t low = 0, std::uint64_t high = UINT64_MAX);

/// Runs `check` of options that came from the command line: what it refuses is a misuse.
/// @throws CLI::ValidationError  in place of InputError
void check_usage(const std::function<void()>& check);

}  // namespace clast
