#pragma once
/// Which runs of a comparison have a stored trajectory, and the trajectories.
#include <optional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/results/results.hpp"

namespace clast::report_detail {

/// The runs whose motion is stored. Files are open as long as this lives.
struct DrawnRuns {
  std::vector<std::size_t> rows;                     ///< of the comparison
  std::size_t frames = 0;                            ///< of all of them together
  std::vector<std::optional<TrajectoryFile>> files;  ///< one for each results file; none: gone

  Trajectory trajectory(const RunRow& row) const { return files[row.file]->read(row.record->run); }
};

/// @throws InputError  a results file can't be read any more
DrawnRuns select_drawn_runs(const Comparison& comparison);

}  // namespace clast::report_detail
