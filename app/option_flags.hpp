#pragma once
/// Translation of library messages to command-line options.
#include <string>
#include <string_view>

namespace clast {

/// Replaces names of option fields in backticks by command-line options: "`any_size`" becomes
/// "--any-size". The backticks of other names are removed.
std::string replace_keys_by_flags(std::string_view text);

/// Formats a message for the terminal: names of option fields are replaced by options, and
/// non-printable characters are escaped.
std::string format_for_terminal(std::string_view text);

}  // namespace clast
