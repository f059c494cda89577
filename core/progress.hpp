#pragma once
/// Progress and cancellation of long jobs.
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

namespace clast {

struct ProgressUpdate {
  std::size_t done = 0;         ///< number of finished runs, scans, ...
  std::size_t total = 0;        ///< total number; 0 if unknown
  std::size_t done_before = 0;  ///< part of `done` from an earlier session
  std::string activity = {};    ///< current activity, such as "fitting B017"
  bool is_slow = false;  ///< true if the activity takes minutes; it is shown on a line of its own
};

/// Function that a job calls at intervals, from one thread at a time. If it throws, the job ends;
/// finished work is kept.
using ProgressCallback = std::function<void(const ProgressUpdate&)>;

/// Exception that a `ProgressCallback` throws to end a job. It is not derived from `Error`, so that
/// a batch does not treat it as the failure of one item.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace clast
