#pragma once
/// Tables as they are printed.
#include <string>
#include <vector>

namespace clast {

/// Columns under headings, as wide as their longest entry. The first column is text, on the left;
/// others are on the right when they hold numbers. What cells hold is made `printable`.
struct TextTable {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;

  std::string text() const;
};

}  // namespace clast
