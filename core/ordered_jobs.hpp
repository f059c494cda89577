#pragma once
/// Parallel jobs with results consumed in order.
#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>

#include "core/parallel.hpp"

namespace clast {

/// Calls `produce(i)` for every i in [0, count) on up to `threads` threads (0: one per core). Calls
/// `consume(i, result)` with each result, in order of i and one at a time. At most four results per
/// thread are buffered. If either function throws, no new job starts and the exception is rethrown.
template <class Make, class Take>
void run_ordered_jobs(std::size_t count, unsigned threads, const Make& produce,
                      const Take& consume) {
  constexpr std::size_t kAhead = 4;
  const std::size_t ahead = kAhead * resolve_thread_count(threads);
  std::mutex mutex;
  std::condition_variable taken;
  std::map<std::size_t, decltype(produce(std::size_t{}))> waiting;
  std::size_t next = 0;
  bool stopped = false;
  parallel_for(count, threads, [&](std::size_t i) {
    try {
      {
        std::unique_lock lock(mutex);
        taken.wait(lock, [&] { return stopped || i < next + ahead; });
        if (stopped) return;
      }
      auto result = produce(i);
      const std::lock_guard lock(mutex);
      waiting.emplace(i, std::move(result));
      // If a result cannot be consumed, no thread may consume it again, or the next one.
      for (auto first = waiting.find(next); !stopped && first != waiting.end();
           first = waiting.find(next)) {
        stopped = true;
        consume(next, first->second);
        stopped = false;
        waiting.erase(first);
        ++next;
      }
      taken.notify_all();
    } catch (...) {
      const std::lock_guard lock(mutex);
      stopped = true;
      taken.notify_all();
      throw;
    }
  });
}

}  // namespace clast
