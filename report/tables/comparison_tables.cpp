#include "report/tables/comparison_tables.hpp"

#include "report/tables/comparison_columns.hpp"

namespace clast {

using namespace report_detail;

const std::vector<ComparisonTable>& comparison_tables() {
  static const std::vector<ComparisonTable> all = [] {
    std::vector<ComparisonTable> tables;
    for (const auto& part : {make_run_tables(), make_group_tables(), make_effect_tables(),
                             make_crossing_tables(), make_deposit_tables(), make_energy_tables()}) {
      tables.insert(tables.end(), part.begin(), part.end());
    }
    return tables;
  }();
  return all;
}

}  // namespace clast
