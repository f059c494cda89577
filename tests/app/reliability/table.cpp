#include "tests/app/reliability/table.hpp"

#include <array>
#include <cstdio>

namespace clast::reliability {

namespace {

struct Row {
  std::string kind, level;
  std::array<std::size_t, 4> outcomes = {};
  std::size_t cases = 0, misses = 0, bounded = 0;
  double width = 0.0;  ///< summed

  void add(const Verdict& verdict) {
    ++cases;
    ++outcomes[static_cast<std::size_t>(verdict.outcome)];
    misses += verdict.missed.empty() ? 0 : 1;
    if (verdict.outcome != Outcome::kBracketed || !verdict.width) return;
    ++bounded;
    width += *verdict.width;
  }

  std::string text(bool levels) const {
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, " %zu | %zu | %zu | %zu | %zu | ", cases, outcomes[0],
                  outcomes[1], outcomes[2], outcomes[3]);
    std::string mean = "-";
    if (bounded > 0) {
      char share[40];
      std::snprintf(share, sizeof share, "%.1f %%", 100.0 * width / static_cast<double>(bounded));
      mean = share;
    }
    return "| " + kind + " |" + (levels ? " " + level + " |" : "") + numbers + mean + " | " +
           std::to_string(misses) + " |\n";
  }
};

}  // namespace

std::string markdown_table(const std::vector<Judged>& judged, bool levels) {
  std::string text =
      std::string("| kind |") + (levels ? " amount |" : "") +
      " cases | right | bracketed | refused | wrong | mean width | ranges that miss |\n"
      "|---|" +
      (levels ? "---|" : "") + "---|---|---|---|---|---|---|\n";
  std::vector<Row> rows;
  Row all{.kind = "all", .level = ""};
  for (const Judged& one : judged) {
    const std::string& level = levels ? one.level : "";
    if (rows.empty() || rows.back().kind != one.kind || rows.back().level != level) {
      rows.push_back({.kind = one.kind, .level = level});
    }
    rows.back().add(one.verdict);
    all.add(one.verdict);
  }
  for (const Row& row : rows) text += row.text(levels);
  return text + all.text(levels);
}

}  // namespace clast::reliability
