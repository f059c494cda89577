#pragma once
/// Numbers in sentences, with significant digits only.
#include <optional>
#include <string>

#include "core/statistics/statistics.hpp"

namespace clast::report_detail {

/// Returns the decimals of a length: by the width of its interval, otherwise by its size.
int decimals_of_length(double length, const std::optional<Interval>& interval = {});
/// Formats a length: "13 m".
std::string format_length(double length, int decimals);
/// Formats an interval of lengths: "10 to 17 m".
std::string format_length_interval(const Interval& interval, int decimals);

/// Formats a fraction as "34 %", with a decimal near 0 and 100 %.
std::string format_percentage(double share);
/// Formats an interval of fractions: "28 to 41 %".
std::string format_percentage_interval(const Interval& interval);

/// Formats an energy: "43 kJ", "850 J".
std::string format_energy(double joules);
/// Formats an upper limit, never rounded down: 33.4 kJ is "34 kJ".
std::string format_energy_limit(double joules);
std::string format_height_limit(double metres);
/// Formats an upper limit of a speed: "10.2 m/s".
std::string format_speed_limit(double metres_per_second);
/// Formats a mass: "542 kg", "8.4 kg".
std::string format_mass(double kilograms);
/// Formats a height: "1.0 m", "0.35 m".
std::string format_height(double metres);

/// Text after ranges over ground draws.
inline constexpr const char* kByDraw = " over draws of the ground parameters";
/// True if a range over so many draws is a 90 % interval.
bool is_ninety_percent_interval(std::size_t draws);
/// Formats a range over ground draws: "86 kJ to 153 kJ over draws of the ground parameters"; empty
/// without a range.
std::string format_range_by_draw(const std::optional<Interval>& range,
                                 std::string (*limit)(double));
/// Formats a text in parentheses with a leading space; empty for an empty text.
std::string format_in_brackets(const std::string& text);

}  // namespace clast::report_detail
