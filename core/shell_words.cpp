#include "core/shell_words.hpp"

#include <algorithm>
#include <string_view>

namespace clast {
namespace {

bool is_control(char character) {
  const auto byte = static_cast<unsigned char>(character);
  return byte < 0x20 || byte == 0x7f;
}

/// Characters that no shell takes for anything but themselves, wherever they stand.
bool is_plain(char character) {
  const auto byte = static_cast<unsigned char>(character);
  const bool letter = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
  const bool digit = byte >= '0' && byte <= '9';
  return letter || digit || byte >= 0x80 ||
         std::string_view("%+,-./:=@_").find(character) != std::string_view::npos;
}

std::string quoted_word(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  const bool escaped = std::any_of(word.begin(), word.end(), is_control);
  std::string text = escaped ? "$'" : "'";
  for (const char character : word) {
    constexpr const char* kHex = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(character);
    if (is_control(character)) {
      text += std::string("\\x") + kHex[byte >> 4] + kHex[byte & 15];
    } else if (character == '\'') {
      text += escaped ? "\\'" : "'\\''";
    } else if (character == '\\' && escaped) {
      text += "\\\\";
    } else {
      text += character;
    }
  }
  return text + "'";
}

}  // namespace

std::string format_shell_command(const std::vector<std::string>& words) {
  std::string command;
  for (const std::string& word : words) command += (command.empty() ? "" : " ") + quoted_word(word);
  return command;
}

}  // namespace clast
