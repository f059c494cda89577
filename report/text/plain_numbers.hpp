#pragma once
/// Numbers as sentences have them: with no more digits than are known.
#include <optional>
#include <string>

#include "core/statistics/statistics.hpp"

namespace clast::report_detail {

/// Decimals that a length shall have: few where its interval is wide, else by its size.
int decimals_of_length(double length, const std::optional<Interval>& interval = {});
/// "13 m".
std::string format_length(double length, int decimals);
/// "10 to 17 m".
std::string format_length_interval(const Interval& interval, int decimals);

/// "34 %"; a decimal where it is near none or all.
std::string format_percentage(double share);
/// "28 to 41 %".
std::string format_percentage_interval(const Interval& interval);

/// "43 kJ", "850 J".
std::string format_energy(double joules);
/// What values stay below, in the same digits, never rounded down: 33.4 kJ is "34 kJ".
std::string format_energy_limit(double joules);
std::string format_height_limit(double metres);
/// "10.2 m/s".
std::string format_speed_limit(double metres_per_second);
/// "542 kg", "8.4 kg".
std::string format_mass(double kilograms);
/// "1.0 m", "0.35 m".
std::string format_height(double metres);

/// After a range over the draws of uncertain ground.
inline constexpr const char* kByDraw = " over draws of the ground parameters";
/// True where a range over so many draws is that of nine draws of ten.
bool is_ninety_percent_interval(std::size_t draws);
/// "86 kJ to 153 kJ over draws of the ground parameters"; empty without a range.
std::string range_by_draw(const std::optional<Interval>& range, std::string (*limit)(double));
/// " (86 kJ to 153 kJ)"; empty for an empty text.
std::string format_in_brackets(const std::string& text);

}  // namespace clast::report_detail
