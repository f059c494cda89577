#pragma once
/// Values of command-line options that are more than a number or a name.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "core/number_range.hpp"

namespace clast {

/// "a, b,c" as {"a", "b", "c"}; empty items are dropped.
std::vector<std::string> split_list(const std::string& text);

/// Metres per unit: m, cm, mm, um, km, in, ft, or a factor in `kLengthUnit`.
/// @throws CLI::ValidationError  anything else
double length_unit(const std::string& text);

/// Two points of a scan, in its own coordinates, and how far apart they are.
struct MeasuredLength {
  std::array<Vec3, 2> points;
  double unit;  ///< metres per unit of the scan
};

/// From "x,y,z;x,y,z;metres". Commas, semicolons and blanks may stand for each other.
/// @throws CLI::ValidationError  not seven numbers, points that are one, or a length not positive
MeasuredLength measured_length(const std::string& text);

/// "L,I,S" in metres, in any order.
/// @throws CLI::ValidationError  not three numbers in `kBlockLength`
Axes axes_from(const std::string& text);

/// Accepts "y" and "z".
CLI::Validator up_axis();
/// Accepts the numbers of a range.
CLI::Validator within(const NumberRange& range);
/// Accepts whole numbers from `low` to `high`, in digits alone.
CLI::Validator whole_number(std::uint64_t low = 0, std::uint64_t high = UINT64_MAX);
/// Accepts finite numbers from `low` to `high`.
CLI::Validator number_between(double low, double high);

/// Runs `check` of options that came from the command line: what it refuses is a misuse.
/// @throws CLI::ValidationError  in place of InputError
void check_usage(const std::function<void()>& check);

}  // namespace clast
