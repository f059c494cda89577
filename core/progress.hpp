#pragma once
/// How a long job says how far it is, and how it is stopped.
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

namespace clast {

/// How far a job is.
struct ProgressUpdate {
  std::size_t done = 0;         ///< of `total` runs, scans, ...
  std::size_t total = 0;        ///< 0: not known
  std::size_t done_before = 0;  ///< of those done, in an earlier session
  std::string activity = {};    ///< that is being done now, such as "fitting B017"
  bool is_slow = false;         ///< minutes, as COLMAP does: worth a line of its own
};

/// Called by a job now and then, from one thread at a time. What it throws ends the job; whatever
/// was finished by then is kept.
using ProgressCallback = std::function<void(const ProgressUpdate&)>;

/// For a `ProgressCallback` to throw that wants the job to end. No `Error`: a batch that goes on
/// after what is wrong with one item does not go on after this.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace clast
