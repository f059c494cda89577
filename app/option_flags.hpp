#pragma once
/// Messages of the libraries in the words of the command line.
#include <string>
#include <string_view>

namespace clast {

/// `text` with the fields of options that it names between backticks as the options of this
/// program: "`any_size`" becomes "--any-size". A field without an option loses its backticks alone.
std::string replace_keys_by_flags(std::string_view text);

/// A message on its way to the terminal: `replace_keys_by_flags`, then `printable`.
std::string shown(std::string_view text);

}  // namespace clast
