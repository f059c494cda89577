#pragma once
/// Numbers as sentences have them: with no more digits than are known.
#include <optional>
#include <string>

#include "core/statistics/statistics.hpp"

namespace clast::report_detail {

/// Decimals that a length shall have: few where its interval is wide, else by its size.
int decimals_of_length(double length, const std::optional<Interval>& interval = {});
/// "13 m".
std::string length_in_words(double length, int decimals);
/// "10 to 17 m".
std::string lengths_in_words(const Interval& interval, int decimals);

/// "34 %"; a decimal where it is near none or all.
std::string share_in_words(double share);
/// "28 to 41 %".
std::string shares_in_words(const Interval& interval);

/// "43 kJ", "850 J".
std::string energy_in_words(double joules);
/// What values stay below, in the same digits, never rounded down: 33.4 kJ is "34 kJ".
std::string energy_limit(double joules);
std::string height_limit(double metres);
/// "10.2 m/s".
std::string speed_limit(double metres_per_second);
/// "542 kg", "8.4 kg".
std::string mass_in_words(double kilograms);
/// "1.0 m", "0.35 m".
std::string height_in_words(double metres);

/// After a range over the draws of uncertain ground.
inline constexpr const char* kByDraw = " over draws of the ground parameters";
/// True where a range over so many draws is that of nine draws of ten.
bool nine_of_ten(std::size_t draws);
/// "86 kJ to 153 kJ over draws of the ground parameters"; empty without a range.
std::string range_by_draw(const std::optional<Interval>& range, std::string (*limit)(double));
/// " (86 kJ to 153 kJ)"; empty for an empty text.
std::string in_brackets(const std::string& text);

}  // namespace clast::report_detail
