#pragma once
/// UTF-8 text: validation and conversion.
#include <cstddef>
#include <string>
#include <string_view>

namespace clast {

/// Decoded character and its size in bytes, which is 0 if the character is invalid.
struct DecodedCharacter {
  char32_t code = 0;
  std::size_t length = 0;
};

/// Decodes the first character of a text. Its size is 0 if the first bytes are not UTF-8.
/// @cite rfc3629
DecodedCharacter decode_first_character(std::string_view text);

/// True for valid UTF-8: no stray bytes, overlong forms, surrogates or codes above U+10FFFF.
/// @cite rfc3629
bool is_utf8(std::string_view text);

/// Returns the text with A to Z in lower case; other bytes are unchanged.
std::string lower_case_ascii(std::string_view text);

/// Converts Windows-1252, a superset of printable Latin-1, to UTF-8. Its five undefined bytes
/// become Latin-1 control characters.
std::string utf8_from_latin1(std::string_view text);

/// Returns the text if it is UTF-8, otherwise converts it from Windows-1252.
std::string to_utf8(std::string_view text);

}  // namespace clast
