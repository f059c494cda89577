#pragma once
/// Sentences that begin with a word made elsewhere.
#include <cctype>
#include <string>

namespace clast::report_detail {

/// With its first letter, if that is one of ASCII, as a capital.
inline std::string capitalized(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace clast::report_detail
