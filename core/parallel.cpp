#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace clast {
namespace {

/// A waiting thread gives way this often before it goes to sleep: waking it takes longer than the
/// serial work between two loops of a time step.
constexpr int kYields = 64;

void wait_while(const std::atomic<std::uint32_t>& value, std::uint32_t old) {
  for (int i = 0; i < kYields; ++i) {
    if (value.load() != old) return;
    std::this_thread::yield();
  }
  value.wait(old);
}

}  // namespace

unsigned resolve_thread_count(unsigned threads) {
  return threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
}

struct ThreadPool::Impl {
  // The loop in progress.
  const std::function<void(std::size_t)>* body = nullptr;
  std::size_t count = 0;
  std::size_t chunk = 1;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex failure_mutex;
  std::size_t failed_item = 0;
  std::exception_ptr failure;

  std::atomic<std::uint32_t> loop{0};  ///< number of the loop; changes to start one, or to end all
  std::atomic<bool> open{false};       ///< there is a loop to help with
  std::atomic<std::uint32_t> active{0};  ///< helpers that may be looking at it
  bool ending = false;
  std::vector<std::jthread> helpers;

  void work() {
    while (!failed) {
      const std::size_t first = next.fetch_add(chunk);
      if (first >= count) return;
      for (std::size_t item = first; item < std::min(first + chunk, count); ++item) {
        try {
          (*body)(item);
        } catch (...) {
          const std::lock_guard lock(failure_mutex);
          failed = true;
          if (item < failed_item) {
            failed_item = item;
            failure = std::current_exception();
          }
          return;
        }
      }
    }
  }

  void help() {
    for (std::uint32_t done = 0;;) {
      wait_while(loop, done);
      done = loop;
      if (ending) return;
      // Who wakes too late to help is not waited for.
      ++active;
      if (open) work();
      if (--active == 0) active.notify_one();
    }
  }
};

ThreadPool::ThreadPool(unsigned threads) : impl_(std::make_unique<Impl>()) {
  for (unsigned i = 1; i < resolve_thread_count(threads); ++i) {
    impl_->helpers.emplace_back([this] { impl_->help(); });
  }
}

ThreadPool::~ThreadPool() {
  impl_->ending = true;
  ++impl_->loop;
  impl_->loop.notify_all();
}

void ThreadPool::run(std::size_t count, std::size_t chunk,
                     const std::function<void(std::size_t)>& body) {
  impl_->body = &body;
  impl_->count = count;
  impl_->chunk = std::max<std::size_t>(chunk, 1);
  impl_->next = 0;
  impl_->failed = false;
  impl_->failed_item = count;
  impl_->failure = nullptr;
  const bool alone = impl_->helpers.empty() || count <= impl_->chunk;
  if (!alone) {
    impl_->open = true;
    ++impl_->loop;
    impl_->loop.notify_all();
  }
  impl_->work();
  if (!alone) {
    impl_->open = false;
    while (const std::uint32_t left = impl_->active.load()) wait_while(impl_->active, left);
  }
  if (impl_->failure) std::rethrow_exception(std::exchange(impl_->failure, nullptr));
}

void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& body) {
  const std::size_t workers =
      std::clamp<std::size_t>(resolve_thread_count(threads), 1, std::max<std::size_t>(count, 1));
  ThreadPool(static_cast<unsigned>(workers)).run(count, 1, body);
}

}  // namespace clast
