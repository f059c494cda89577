#pragma once
/// Text tables for terminals.
#include <string>
#include <vector>

namespace clast {

/// Text table with columns as wide as their longest entry. The first column is left-aligned text;
/// other columns are right-aligned if they contain numbers. Non-printable characters are escaped.
struct TextTable {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;

  std::string text() const;
};

}  // namespace clast
