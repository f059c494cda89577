#pragma once
/// Tables and numbers as they are printed.
#include <string>
#include <vector>

namespace clast {

/// `value` with so many significant digits, without an exponent where it stays readable.
std::string rounded(double value, int digits = 4);
/// With so many digits after the point.
std::string with_decimals(double value, int decimals);

/// Columns under headings, as wide as their longest entry. The first column is text, on the left;
/// others are on the right when they hold numbers. What cells hold is made `printable`.
struct TextTable {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;

  std::string text() const;
};

}  // namespace clast
