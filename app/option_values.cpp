#include "app/option_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>

#include "app/text_table.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/block_ranges.hpp"

namespace clast {

namespace {

/// The whole of `text` as a finite number, or NaN.
double number_from(const std::string& text) {
  const std::optional<double> value = number_in(text);
  return value && std::isfinite(*value) ? *value : std::nan("");
}

}  // namespace

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> items;
  std::istringstream stream(text);
  for (std::string item; std::getline(stream, item, ',');) {
    const std::size_t begin = item.find_first_not_of(" \t");
    if (begin == std::string::npos) continue;
    items.push_back(item.substr(begin, item.find_last_not_of(" \t") - begin + 1));
  }
  return items;
}

double length_unit(const std::string& text) {
  static const std::map<std::string, double> units = {{"m", 1.0},    {"cm", 0.01},   {"mm", 0.001},
                                                      {"um", 1e-6},  {"km", 1000.0}, {"in", 0.0254},
                                                      {"ft", 0.3048}};
  const auto unit = units.find(text);
  if (unit != units.end()) return unit->second;
  const double factor = number_from(text);
  if (kLengthUnit.holds(factor)) return factor;
  throw CLI::ValidationError("--units", "\"" + text +
                                            "\" is no unit; expected m, cm, mm, um, km, in, ft or "
                                            "the metres in one unit, a number " +
                                            kLengthUnit.words());
}

MeasuredLength measured_length(const std::string& text) {
  std::string commas = text;
  for (const char other : {';', ' '}) std::replace(commas.begin(), commas.end(), other, ',');
  std::vector<double> numbers;
  for (const std::string& item : split_list(commas)) numbers.push_back(number_from(item));
  const auto refuse = [&](const std::string& what) {
    throw CLI::ValidationError(
        "--scale-length", "\"" + text + "\" " + what +
                              "; expected two points of the scan and the metres between them (" +
                              kBlockLength.words() + "), such as \"0.2,1.1,0;3.9,1.3,0.4;0.52\"");
  };
  if (numbers.size() != 7) refuse("has " + counted(numbers.size(), "number") + " and not seven");
  for (const double number : numbers) {
    if (!std::isfinite(number)) refuse("holds what is no number");
  }
  const Vec3 a(numbers[0], numbers[1], numbers[2]), b(numbers[3], numbers[4], numbers[5]);
  if (!kBlockLength.holds(numbers[6])) refuse("gives a length that is not " + kBlockLength.words());
  if (a == b) refuse("gives the same point twice");
  const double unit = numbers[6] / (b - a).norm();
  if (!kLengthUnit.holds(unit)) {
    refuse("makes a unit of the scan " + with_digits(unit, 6) + " m long, and it must be " +
           kLengthUnit.words());
  }
  return {{a, b}, unit};
}

Axes axes_from(const std::string& text) {
  const std::vector<std::string> items = split_list(text);
  std::vector<double> lengths;
  for (const std::string& item : items) {
    if (kBlockLength.holds(number_from(item))) lengths.push_back(number_from(item));
  }
  if (items.size() == 3 && lengths.size() == 3) {
    return Axes::sorted(lengths[0], lengths[1], lengths[2]);
  }
  throw CLI::ValidationError("--taped", "\"" + text + "\" is not three lengths " +
                                            kBlockLength.words() + ", such as 0.65,0.53,0.38");
}

CLI::Validator up_axis() { return CLI::IsMember({"y", "z"}); }

CLI::Validator within(const NumberRange& range) {
  return {[range](const std::string& text) {
            if (range.holds(number_from(text))) return std::string();
            return "\"" + text + "\" is not a number " + range.words();
          },
          ""};
}

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  return {[low, high](const std::string& text) {
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && stop == end && value >= low && value <= high) {
              return std::string();
            }
            return "\"" + text + "\" is not a whole number from " + std::to_string(low) + " to " +
                   std::to_string(high);
          },
          ""};
}

CLI::Validator number_between(double low, double high) {
  return {[low, high](const std::string& text) {
            const double value = number_from(text);
            if (value >= low && value <= high) return std::string();
            return "\"" + text + "\" is not a number from " + with_digits(low, 6) + " to " +
                   with_digits(high, 6);
          },
          ""};
}

void check_usage(const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    throw CLI::ValidationError(error.what());
  }
}

}  // namespace clast
