#include "report/scene/stored_runs.hpp"

#include <filesystem>

namespace clast::report_detail {

RunsWithTrajectories find_runs_with_trajectories(const Comparison& comparison) {
  RunsWithTrajectories stored;
  for (const CampaignResults& results : comparison.results) {
    std::error_code code;
    stored.files.emplace_back();
    if (std::filesystem::exists(results.file, code)) stored.files.back().emplace(results.file);
  }
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    const RunRow& row = comparison.rows[i];
    if (!stored.files[row.file]) continue;
    const std::size_t frames = stored.files[row.file]->frame_count(row.record->run);
    if (frames == 0) continue;
    stored.rows.push_back(i);
    stored.frames += frames;
  }
  return stored;
}

}  // namespace clast::report_detail
