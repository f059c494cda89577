#pragma once
/// Check of the nesting depth of a TOML text before parsing.
#include <string>
#include <string_view>

namespace clast {

/// Checks that lists, tables and dotted keys are not nested deeper than clast needs. Parsers need
/// stack for each level, and 50,000 dots in a key would crash the program.
/// @param name  of the file, for messages
/// @throws InputError  naming file, line and the allowed depth
void check_toml_depth(std::string_view text, const std::string& name);

}  // namespace clast
