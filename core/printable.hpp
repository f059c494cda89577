#pragma once
/// Escaping of text from files for terminals.
#include <string>
#include <string_view>

namespace clast {

/// Escapes everything except visible UTF-8 characters: control characters ("\u001b", "\n"),
/// characters that change the text direction or end a line ("\u202e"), and invalid bytes ("\xff").
/// Otherwise names in files could clear the screen, hide text or forge messages.
std::string escape_nonprintable(std::string_view text);

}  // namespace clast
