#pragma once
/// Text that is UTF-8, and text that should be.
#include <cstddef>
#include <string>
#include <string_view>

namespace clast {

/// A character and how many bytes it takes; no bytes where there is none.
struct DecodedCharacter {
  char32_t code = 0;
  std::size_t length = 0;
};

/// The character that `text` begins with; of length 0 where its first bytes are no UTF-8.
/// @cite rfc3629
DecodedCharacter decode_first_character(std::string_view text);

/// Whether all of `text` is UTF-8: no byte out of place, no overlong form, no half of a surrogate
/// pair, nothing above U+10FFFF.
/// @cite rfc3629
bool is_utf8(std::string_view text);

/// `text` with the letters A to Z in lower case; other bytes stay as they are.
std::string lower_case_ascii(std::string_view text);

/// `text` in Windows-1252, which has Latin-1 in it, as UTF-8. Every byte is a character there: the
/// five that Windows-1252 leaves open become the control characters of Latin-1.
std::string utf8_from_latin1(std::string_view text);

/// `text` itself where it is UTF-8, else what it is as Windows-1252: for names of files and blocks
/// on their way to where only UTF-8 is allowed.
std::string to_utf8(std::string_view text);

}  // namespace clast
