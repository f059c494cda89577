#pragma once
/// Runs of a comparison with stored trajectories.
#include <optional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/results/results.hpp"

namespace clast::report_detail {

/// Runs of a comparison with stored trajectories, and their open results files.
struct RunsWithTrajectories {
  std::vector<std::size_t> rows;  ///< indices into Comparison::rows
  std::size_t frames = 0;         ///< total number of stored states
  /// Open results files; empty for files that no longer exist.
  std::vector<std::optional<TrajectoryFile>> files;

  Trajectory trajectory(const RunRow& row) const { return files[row.file]->read(row.record->run); }
};

/// Finds all runs with stored trajectories.
/// @throws InputError  if a results file can no longer be read
RunsWithTrajectories find_runs_with_trajectories(const Comparison& comparison);

}  // namespace clast::report_detail
