#pragma once
/// Tables of a comparison as the text of their files.
#include <string>

#include "report/tables/comparison_tables.hpp"

namespace clast {

inline std::string table_csv(const Comparison& comparison, const std::string& name) {
  return find_report_table(comparison_tables(), name).csv(comparison);
}

}  // namespace clast
