#pragma once
/// Progress and cancellation of long jobs.
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

namespace clast {

struct ProgressUpdate {
  std::size_t done = 0;         ///< out of `total` runs, scans, ...
  std::size_t total = 0;        ///< 0 if unknown
  std::size_t done_before = 0;  ///< of those done, in an earlier session
  std::string activity = {};    ///< current activity, such as "fitting B017"
  bool is_slow = false;  ///< takes minutes, as COLMAP does, and is shown on a line of its own
};

/// Called by a job at intervals, from one thread at a time. Its exceptions end the job; finished
/// work is kept.
using ProgressCallback = std::function<void(const ProgressUpdate&)>;

/// Exception by which a `ProgressCallback` ends a job. It is not an `Error`, so that batches do not
/// treat it as the failure of one item.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace clast
