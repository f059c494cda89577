#pragma once
/// Check of the nesting depth of a TOML text before parsing.
#include <string>
#include <string_view>

namespace clast {

/// Checks that lists, tables and dotted keys are not nested too deep. The parser needs stack for
/// each level, so that a key with 50,000 dots would crash the program.
/// @param name  name of the file, for messages
/// @throws InputError  if the nesting is too deep; the message gives file, line and allowed depth
void check_toml_depth(std::string_view text, const std::string& name);

}  // namespace clast
