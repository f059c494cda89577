#include "study/simulate/team_work.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "core/parallel.hpp"

namespace clast {
namespace {

// The first thread of the process that leads waits for what others hand in. MPI can't sleep until
// something comes without burning a core, so it looks this often.
constexpr std::chrono::microseconds kLookAround(500);

}  // namespace

void distribute_work(ProcessTeam& team, const std::vector<std::uint32_t>& items, unsigned threads,
                     const std::function<void(std::uint32_t item)>& here,
                     const std::function<void(const std::string& done)>& accept) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::mutex failure_mutex;
  std::exception_ptr failure;
  const auto guarded = [&](const std::function<void()>& action) {
    try {
      action();
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      stop = true;
    }
  };
  const auto take = [&]() -> std::optional<std::size_t> {
    if (stop) return std::nullopt;
    const std::size_t item = next++;
    return item < items.size() ? std::optional<std::size_t>(items[item]) : std::nullopt;
  };
  team.begin_dependent_section();
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < threads; ++i) {
    workers.emplace_back([&] {
      while (const std::optional<std::size_t> item = take()) {
        guarded([&] { here(static_cast<std::uint32_t>(*item)); });
      }
    });
  }
  for (std::size_t waiting = std::size_t{team.size() - 1} * threads; waiting > 0;) {
    const std::optional<ProcessTeam::TeamMessage> delivery = team.receive_message();
    if (!delivery) {
      std::this_thread::sleep_for(kLookAround);
      continue;
    }
    if (!delivery->done.empty()) guarded([&] { accept(delivery->done); });
    const std::optional<std::size_t> item = take();
    team.send_item(delivery->from, item);
    if (!item) --waiting;
  }
  workers.clear();
  team.end_dependent_section();
  if (failure) std::rethrow_exception(failure);
}

void process_received_work(ProcessTeam& team, unsigned threads,
                           const std::function<std::string(std::uint32_t item)>& compute) {
  std::mutex one_at_a_time;
  team.begin_dependent_section();
  parallel_for(threads, threads, [&](std::size_t) {
    std::string done;
    while (true) {
      std::optional<std::size_t> item;
      {
        const std::lock_guard lock(one_at_a_time);
        item = team.exchange_item(done);
      }
      if (!item) return;
      done = compute(static_cast<std::uint32_t>(*item));
    }
  });
  team.end_dependent_section();
}

}  // namespace clast
