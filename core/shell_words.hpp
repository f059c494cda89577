#pragma once
/// Formatting of shell commands in messages.
#include <string>
#include <vector>

namespace clast {

/// Joins words to a command that can be pasted into a POSIX shell, quoted if necessary. Control
/// characters are escaped as in $'\x1b', so that a terminal prints them.
std::string format_shell_command(const std::vector<std::string>& words);

}  // namespace clast
