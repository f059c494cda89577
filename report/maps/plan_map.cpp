#include "report/maps/plan_map.hpp"

#include "report/html/html_page.hpp"
#include "report/maps/svg_map.hpp"
#include "study/campaign/barrier_line.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

using namespace report_detail;

std::string plan_map(const CampaignResults& header) {
  // The map of a comparison in which every point has one run that has not moved.
  Comparison plan;
  plan.results.push_back(header);
  CampaignResults& results = plan.results.front();
  for (std::uint32_t point = 0; point < results.release_points.size(); ++point) {
    RunRecord run;
    run.point = point;
    run.start.position = run.result.final_state.position = results.release_points[point];
    results.runs.push_back(run);
  }
  for (const RunRecord& run : results.runs) {
    RunRow row;
    row.record = &run;
    row.block = &results.blocks.front();
    row.start = row.stop = results.frame.map(run.start.position);
    plan.rows.push_back(row);
  }
  const Vec2 origin = results.frame.origin.head<2>();
  for (const Barrier& barrier : results.barriers) {
    using Counts = BarrierLine::Counts;
    const Counts counts = is_ring(barrier.through)                        ? Counts::kEntries
                          : barrier.counted == CountedCrossings::kForward ? Counts::kForward
                                                                          : Counts::kEither;
    plan.lines.push_back({barrier.name, barrier.through, {0}, counts});
    for (Vec2& point : plan.lines.back().through) point += origin;
  }
  return svg_file(svg_map(plan));
}

}  // namespace clast
