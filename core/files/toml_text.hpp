#pragma once
/// Formatting of TOML keys and strings.
#include <string>

namespace clast {

/// Formats a TOML string in double quotes.
std::string format_toml_string(const std::string& text);

/// Formats a TOML key, quoted if necessary.
std::string format_toml_key(const std::string& name);

}  // namespace clast
