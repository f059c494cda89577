#pragma once
/// Formatting of shell commands in messages.
#include <string>
#include <vector>

namespace clast {

/// Joins words to a command that can be pasted into a POSIX shell. Words are quoted if necessary.
/// Control characters are escaped as in $'\x1b', so that they do not act on the terminal.
std::string format_shell_command(const std::vector<std::string>& words);

}  // namespace clast
