#pragma once
/// Text tables for terminals.
#include <string>
#include <vector>

namespace clast {

/// Table that is formatted as text. A column is as wide as its longest entry. The first column is
/// left-aligned; other columns are right-aligned if they contain numbers. Non-printable characters
/// are escaped.
struct TextTable {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;

  std::string text() const;
};

}  // namespace clast
