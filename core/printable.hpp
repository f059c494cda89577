#pragma once
/// Text from files on its way to a terminal.
#include <string>
#include <string_view>

namespace clast {

/// `text` on one line, with everything escaped that is not a visible UTF-8 character: control
/// characters ("\u001b", "\n"), characters that turn the direction of what follows or end a line
/// ("\u202e"), and bytes that are no UTF-8 ("\xff"). Names out of files could otherwise clear a
/// screen, hide text or forge a line of a message. A backslash stays as it is.
std::string escape_nonprintable(std::string_view text);

}  // namespace clast
