#pragma once
/// Names and text as TOML files have them.
#include <string>

namespace clast {

/// A TOML string in double quotes.
std::string format_toml_string(const std::string& text);

/// A TOML key: as it is where TOML allows that, else in double quotes.
std::string format_toml_key(const std::string& name);

}  // namespace clast
