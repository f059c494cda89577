#pragma once
/// Parallel loops whose result can't depend on the number of threads.
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

/// The number of threads that `threads` stands for: itself, or one per core when 0.
unsigned resolve_thread_count(unsigned threads);

/// Threads that wait for the next loop: for loops so short that starting threads would cost more
/// than it saves. One loop at a time.
class ThreadPool {
 public:
  /// @param threads  counts the caller, who works too; 0: one per core
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();

  /// Like `parallel_for`, with `chunk` neighbouring items handed out at a time.
  void run(std::size_t count, std::size_t chunk, const std::function<void(std::size_t)>& body);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
