#pragma once
/// Commands in messages, as they can be pasted into a shell.
#include <string>
#include <vector>

namespace clast {

/// The words with blanks between them; each is quoted where a POSIX shell would take it apart or
/// for something else. Control characters are escaped as in $'\x1b', so that a terminal prints
/// them.
std::string format_shell_command(const std::vector<std::string>& words);

}  // namespace clast
