#include "report/tables/comparison_tables.hpp"

#include "report/tables/comparison_columns.hpp"

namespace clast {

using namespace report_detail;

const std::vector<ComparisonTable>& comparison_tables() {
  static const std::vector<ComparisonTable> all = [] {
    std::vector<ComparisonTable> tables;
    for (const auto& part : {run_tables(), group_tables(), effect_tables(), passage_tables(),
                             deposit_tables(), energy_tables()}) {
      tables.insert(tables.end(), part.begin(), part.end());
    }
    return tables;
  }();
  return all;
}

}  // namespace clast
