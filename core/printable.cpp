#include "core/printable.hpp"

#include <array>
#include <cstdio>

#include "core/utf8.hpp"

namespace clast {
namespace {

/// Control characters of Unicode and what steers the direction or the lines of a text.
bool is_unseen(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x061c || c == 0x200e || c == 0x200f ||
         (c >= 0x2028 && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069) || c == 0xfeff ||
         (c >= 0xfff9 && c <= 0xfffb);
}

std::string escape_character(char32_t c) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "\\u%04x", static_cast<unsigned>(c));
  return text.data();
}

}  // namespace

std::string escape_nonprintable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const DecodedCharacter first = decode_first_character(text);
    if (first.length == 0) {
      std::array<char, 8> byte{};
      std::snprintf(byte.data(), byte.size(), "\\x%02x", static_cast<unsigned char>(text[0]));
      result += byte.data();
      text.remove_prefix(1);
      continue;
    }
    if (is_unseen(first.code)) {
      result += escape_character(first.code);
    } else {
      result += text.substr(0, first.length);
    }
    text.remove_prefix(first.length);
  }
  return result;
}

}  // namespace clast
