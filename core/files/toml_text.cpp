#include "core/files/toml_text.hpp"

#include <toml++/toml.h>

#include <sstream>

namespace clast {

std::string format_toml_string(const std::string& text) {
  const toml::value<std::string> value(text);
  std::ostringstream quoted;
  quoted << toml::toml_formatter(value, toml::format_flags::none);
  return quoted.str();
}

std::string format_toml_key(const std::string& name) {
  const bool bare =
      !name.empty() && name.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyz"
                           "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos;
  return bare ? name : format_toml_string(name);
}

}  // namespace clast
