#pragma once
/// Escaping of text from files for terminals.
#include <string>
#include <string_view>

namespace clast {

/// Escapes everything but visible UTF-8 characters on one line: control characters ("\u001b",
/// "\n"), characters that change the text direction or end a line ("\u202e"), and invalid bytes
/// ("\xff"). Names in files could otherwise clear a screen, hide text or forge messages.
/// Backslashes are unchanged.
std::string escape_nonprintable(std::string_view text);

}  // namespace clast
