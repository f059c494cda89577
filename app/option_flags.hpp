#pragma once
/// Translation of library messages to command-line options.
#include <string>
#include <string_view>

namespace clast {

/// Replaces option fields in backticks by their command-line options: "`any_size`" becomes
/// "--any-size". Other fields only lose their backticks.
std::string replace_keys_by_flags(std::string_view text);

/// Formats a message for the terminal: options replaced, non-printable characters escaped.
std::string format_for_terminal(std::string_view text);

}  // namespace clast
