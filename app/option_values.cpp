#include "app/option_values.hpp"

#include <charconv>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

CLI::Validator number_in_range(const NumberRange& range) {
  return {[range](const std::string& text) {
            const std::optional<double> number = parse_number(text);
            if (number && range.contains(*number)) return std::string();
            return "\"" + text + "\" is not a number " + range.describe();
          },
          ""};
}

CLI::Validator integer_in_range(std::uint64_t low, std::uint64_t high) {
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

void check_usage(const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    throw CLI::ValidationError(error.what());
  }
}

}  // namespace clast
