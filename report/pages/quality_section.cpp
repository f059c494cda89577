#include "report/pages/report_sections.hpp"

#include <cmath>

#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"

namespace clast::report_detail {
namespace {

/// The run with the largest of something, in words.
template <class Value>
std::vector<std::string> extreme(const Comparison& comparison, const std::string& what,
                                 const std::string& unit, Value value_of) {
  const RunRow* worst = nullptr;
  double largest = -INFINITY;
  std::vector<double> values;
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    const double value = value_of(row);
    if (!std::isfinite(value)) continue;
    values.push_back(value);
    if (value > largest) {
      largest = value;
      worst = &row;
    }
  }
  if (worst == nullptr) return {what + unit, "not known", "-", "-", "-"};
  const SampleSummary summary = summarise_sample(values);
  const std::string run =
      (has_several_files(comparison) ? "file " + std::to_string(worst->file + 1) + ", run "
                                     : "run ") +
      std::to_string(worst->record->run) + ", block " + worst->block->id;
  return {what + unit, run, format_significant_digits(summary.mean),
          format_significant_digits(summary.p95), format_significant_digits(largest)};
}

std::string lost_runs(const Comparison& comparison) {
  constexpr std::size_t kMaxListed = 200;
  HtmlTable table({"run", "block", "ended as", "what happened"}, 4);
  std::size_t count = 0;
  for (const RunRow& row : comparison.rows) {
    const ReleaseResult& result = row.record->result;
    if (result.stop_reason == StopReason::kRest && !result.below_ground) continue;
    if (++count > kMaxListed) continue;
    std::string story = result.message;
    if (story.empty()) {
      story = "at (" + format_fixed(row.stop.x(), 2) + ", " + format_fixed(row.stop.y(), 2) + ", " +
              format_fixed(row.stop.z(), 2) + ") m after " + format_fixed(result.duration, 1) +
              " s";
    }
    const std::string file =
        has_several_files(comparison) ? std::to_string(row.file + 1) + ": " : std::string();
    table.row({file + std::to_string(row.record->run), row.block->id,
               name_of(result.stop_reason) + (result.below_ground ? ", below ground" : ""), story});
  }
  if (count == 0) return format_paragraph("Every run came to rest on the terrain.");
  std::string html = table.html();
  if (count > kMaxListed) {
    html += format_paragraph("The first " + std::to_string(kMaxListed) + " of " +
                             std::to_string(count) + "; the others are in runs.csv.");
  }
  return format_folded_section(format_count(count, "run") + " did not come to rest on the terrain",
                               html);
}

}  // namespace

std::string format_quality_section(const Comparison& comparison) {
  HtmlTable table({"measure", "worst run", "mean", "p95", "largest"}, 2);
  table.row(extreme(comparison, "error of the energy balance, fraction of the dissipated energy",
                    "", [](const RunRow& row) { return row.record->result.energy.error; }));
  table.row(extreme(
      comparison,
      "energy gained or lost when contacts or weights change, fraction of the dissipated energy",
      "", [](const RunRow& row) {
        return reassigned_energy_fraction(row.record->result.energy).value_or(NAN);
      }));
  table.row(extreme(comparison, "largest penetration", ", mm",
                    [](const RunRow& row) { return row.record->result.max_penetration * 1000.0; }));
  table.row(extreme(comparison, "largest penetration, fraction of S", "", [](const RunRow& row) {
    return row.record->result.max_penetration / row.block->axes.S;
  }));
  table.row(extreme(comparison, "penetration at the end", ", mm", [](const RunRow& row) {
    return row.record->result.settled_penetration * 1000.0;
  }));
  table.row(extreme(comparison, "simulated time", ", s",
                    [](const RunRow& row) { return row.record->result.duration; }));
  std::size_t below = 0;
  for (const RunRow& row : comparison.rows) below += row.record->result.below_ground;
  const StopCounts& stops = comparison.deposits.front().stops;
  std::string without;
  for (const CampaignResults& results : comparison.results) {
    if (results.has_contacts()) continue;
    without =
        format_paragraph("Runs computed by " + results.engine +
                         " do not report energy balance and penetration; the statistics below "
                         "do not include them.");
  }
  return format_section(
      "Quality of the runs",
      format_paragraph("At rest " + std::to_string(stops.rest) + ", left the terrain " +
                       std::to_string(stops.left_terrain) + ", still moving at max_time " +
                       std::to_string(stops.max_time) + ", error " + std::to_string(stops.error) +
                       "; below ground " + std::to_string(below) + ".") +
          without + format_folded_section("Energy balance, penetration and time", table.html()) +
          lost_runs(comparison));
}

}  // namespace clast::report_detail
