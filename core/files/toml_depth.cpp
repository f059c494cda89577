#include "core/files/toml_depth.hpp"

#include <algorithm>
#include <cstddef>

#include "core/error.hpp"

namespace clast {
namespace {

// A campaign needs six.
constexpr std::size_t kDeepest = 32;

/// The position after the string that begins at `at`; the end of the line where it is never closed,
/// which the parser refuses.
std::size_t behind_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool escapes = quote == '"';
  const std::string three(3, quote);
  const bool several_lines = text.substr(at, 3) == three;
  at += several_lines ? 3 : 1;
  while (at < text.size()) {
    if (several_lines && text.substr(at, 3) == three) {
      at += 3;
      // Up to two quotes before the last three belong to the text.
      for (int i = 0; i < 2 && at < text.size() && text[at] == quote; ++i) ++at;
      return at;
    }
    if (!several_lines && (text[at] == quote || text[at] == '\n')) return at + 1;
    at += escapes && text[at] == '\\' ? 2 : 1;
  }
  return text.size();
}

}  // namespace

void check_toml_depth(std::string_view text, const std::string& name) {
  std::size_t brackets = 0, dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = behind_string(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '[' || c == '{') ++brackets;
    if ((c == ']' || c == '}') && brackets > 0) --brackets;
    dots = c == '.' ? dots + 1 : c == '=' || c == ',' || c == '\n' ? 0 : dots;
    if (brackets > kDeepest || dots >= kDeepest) {
      const auto lines =
          std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      throw InputError(
          name + ":" + std::to_string(lines + 1) +
          (dots >= kDeepest ? ": a key of more than " : ": lists or tables in more than ") +
          std::to_string(kDeepest) + (dots >= kDeepest ? " parts" : " others") +
          "; no valid key is nested this deeply; remove it");
    }
    ++at;
  }
}

}  // namespace clast
