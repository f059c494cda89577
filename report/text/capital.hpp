#pragma once
/// Capitalisation of sentences.
#include <cctype>
#include <string>

namespace clast::report_detail {

/// Returns the text with its first ASCII letter in upper case.
inline std::string capitalized(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace clast::report_detail
