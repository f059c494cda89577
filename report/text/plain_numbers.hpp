#pragma once
/// Formatting of numbers in sentences, with significant digits only.
#include <optional>
#include <string>

#include "core/statistics/statistics.hpp"

namespace clast::report_detail {

/// Returns the number of decimals with which a length is printed, from the width of its interval or
/// from the length.
int decimals_of_length(double length, const std::optional<Interval>& interval = {});
/// Formats a length as "13 m".
std::string format_length(double length, int decimals);
/// Formats an interval of lengths as "10 to 17 m".
std::string format_length_interval(const Interval& interval, int decimals);

/// Formats a fraction as "34 %". Near 0 and 100 %, it has one decimal.
std::string format_percentage(double share);
/// Formats an interval of fractions as "28 to 41 %".
std::string format_percentage_interval(const Interval& interval);

/// Formats an energy as "43 kJ" or "850 J".
std::string format_energy(double joules);
/// Formats an upper limit of an energy, rounded up: 33.4 kJ gives "34 kJ".
std::string format_energy_limit(double joules);
std::string format_height_limit(double metres);
/// Formats an upper limit of a speed as "10.2 m/s".
std::string format_speed_limit(double metres_per_second);
/// Formats a mass as "542 kg" or "8.4 kg".
std::string format_mass(double kilograms);
/// Formats a height as "1.0 m" or "0.35 m".
std::string format_height(double metres);

/// Text that follows ranges over draws of the ground parameters.
inline constexpr const char* kOverDrawsText = " over draws of the ground parameters";
/// True if a range over `draws` draws of the ground parameters is a 90 % interval rather than
/// minimum and maximum.
bool is_ninety_percent_interval(std::size_t draws);
/// Formats a range over draws of the ground parameters. Empty if there is no range.
std::string format_range_by_draw(const std::optional<Interval>& range,
                                 std::string (*limit)(double));
/// Formats a text in parentheses with a leading space. Empty if the text is empty.
std::string format_in_brackets(const std::string& text);

}  // namespace clast::report_detail
