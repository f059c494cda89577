#include "report/text/plain_numbers.hpp"

#include <cmath>

#include "core/number_text.hpp"
#include "study/compare/ground_draws.hpp"

namespace clast::report_detail {
namespace {

std::string share_number(double share) {
  const double percent = 100.0 * share;
  const bool near_an_end = (percent > 0.0 && percent < 1.0) || (percent > 99.0 && percent < 100.0);
  return format_decimals(percent, near_an_end ? 1 : 0);
}

/// The next value up that so many decimals can say.
double raised(double value, int decimals) {
  const double steps = std::pow(10.0, decimals);
  return std::ceil(value * steps - 1e-9) / steps;
}

int decimals_of_height(double metres) { return std::abs(metres) < 0.95 ? 2 : 1; }

/// Returns the decimals of a number in joules or kilojoules.
int decimals_of_energy(double joules) { return joules >= 1e3 && joules < 1e4 ? 1 : 0; }

}  // namespace

int decimals_of_length(double length, const std::optional<Interval>& interval) {
  return significant_decimals(interval.value_or(Interval{0.0, 0.25 * std::abs(length)}), 2);
}

std::string format_length(double length, int decimals) {
  return format_decimals(length, decimals) + " m";
}

std::string format_length_interval(const Interval& interval, int decimals) {
  return format_decimals(interval.low, decimals) + " to " +
         format_decimals(interval.high, decimals) + " m";
}

std::string format_percentage(double share) { return share_number(share) + " %"; }

std::string format_percentage_interval(const Interval& interval) {
  return share_number(interval.low) + " to " + share_number(interval.high) + " %";
}

std::string format_energy(double joules) {
  const int decimals = decimals_of_energy(joules);
  if (joules >= 1e3) return format_decimals(joules / 1e3, decimals) + " kJ";
  return joules >= 10.0 ? format_decimals(joules, decimals) + " J"
                        : format_significant(joules, 2) + " J";
}

std::string format_energy_limit(double joules) {
  const double unit = joules >= 1e3 ? 1e3 : 1.0;
  return format_energy(unit * raised(joules / unit, decimals_of_energy(joules)));
}

std::string format_speed_limit(double metres_per_second) {
  return format_decimals(raised(metres_per_second, 1), 1) + " m/s";
}

std::string format_mass(double kilograms) {
  return (kilograms < 100.0 ? format_significant(kilograms, 2) : format_decimals(kilograms, 0)) +
         " kg";
}

std::string format_height(double metres) {
  return format_decimals(metres, decimals_of_height(metres)) + " m";
}

std::string format_height_limit(double metres) {
  return format_height(raised(metres, decimals_of_height(metres)));
}

bool is_ninety_percent_interval(std::size_t draws) { return draws >= kMinDrawsForPercentiles; }

std::string format_range_by_draw(const std::optional<Interval>& range,
                                 std::string (*limit)(double)) {
  return range ? limit(range->low) + " to " + limit(range->high) + kOverDrawsText : "";
}

std::string format_in_brackets(const std::string& text) {
  return text.empty() ? "" : " (" + text + ")";
}

}  // namespace clast::report_detail
