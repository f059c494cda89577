#pragma once
/// Parallel loops with results that do not depend on the number of threads.
#include <cstddef>
#include <functional>
#include <memory>

namespace clast {

/// Calls `body(i)` for every i in [0, count) on up to `threads` threads (0: one per core).
///
/// Items are started in order, one at a time. `body(i)` must write only data of item i. No new item
/// starts after an exception. When all threads have stopped, that with the smallest i is rethrown.
void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& body);

/// Returns `threads`, or the number of cores if it is 0.
unsigned resolve_thread_count(unsigned threads);

/// Pool of waiting threads, for loops too short to start threads. Runs one loop at a time.
class ThreadPool {
 public:
  /// Starts the threads.
  /// @param threads  number of threads including the calling one; 0: one per core
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();

  /// Runs a loop like `parallel_for`. A thread takes `chunk` consecutive items at a time.
  void run(std::size_t count, std::size_t chunk, const std::function<void(std::size_t)>& body);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
