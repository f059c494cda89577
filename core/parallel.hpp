#pragma once
/// Parallel loops with results that do not depend on the number of threads.
#include <cstddef>
#include <functional>
#include <memory>

namespace clast {

/// Calls `body(i)` for every i in [0, count) on up to `threads` threads (0: one per core).
///
/// Items are handed out in order, one at a time. `body` must write only what belongs to item i.
/// If items throw, the exception of the smallest such i is rethrown once all threads stopped; no
/// new item is started after the first exception.
void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& body);

/// Returns `threads`, or the number of cores if it is 0.
unsigned resolve_thread_count(unsigned threads);

/// Pool of waiting threads, for loops too short for starting threads. One loop at a time.
class ThreadPool {
 public:
  /// Starts the threads.
  /// @param threads  including the calling thread; 0: one per core
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();

  /// Runs a loop like `parallel_for`, with `chunk` consecutive items per assignment.
  void run(std::size_t count, std::size_t chunk, const std::function<void(std::size_t)>& body);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
