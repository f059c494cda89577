#pragma once
/// How deep a TOML text nests, found before a parser follows it.
#include <string>
#include <string_view>

namespace clast {

/// Refuses a text whose lists and tables lie deeper in each other than anything clast reads, or
/// whose keys have more parts: a parser, and whoever walks over its result, needs stack for each
/// level, and 50,000 dots in a key would end the program.
/// @param name  of the file, for messages
/// @throws InputError  file, line and the depth that is allowed
void check_toml_depth(std::string_view text, const std::string& name);

}  // namespace clast
