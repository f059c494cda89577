#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "core/ordered_jobs.hpp"

namespace clast {
namespace {

TEST(ParallelFor, VisitsEveryItemOnceForAnyThreadCount) {
  for (const unsigned threads : {1u, 2u, 8u}) {
    std::vector<int> visits(1000, 0);
    parallel_for(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(1000, 1));
  }
}

TEST(ParallelFor, RethrowsTheFailure) {
  try {
    parallel_for(100, 4, [](std::size_t i) {
      if (i == 17) throw std::runtime_error(std::to_string(i));
    });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "17");
  }
}

TEST(ParallelFor, NoItemsIsNothingToDo) {
  parallel_for(0, 2, [](std::size_t) { FAIL(); });
}

TEST(ThreadPool, RunsLoopAfterLoop) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    ThreadPool team(threads);
    std::vector<int> visits(100, 0);
    for (int loop = 0; loop < 500; ++loop) {
      team.run(visits.size(), 7, [&](std::size_t i) { ++visits[i]; });
    }
    EXPECT_EQ(visits, std::vector<int>(100, 500));
  }
}

TEST(ThreadPool, WorksOnAfterAFailure) {
  ThreadPool team(3);
  EXPECT_THROW(team.run(50, 4,
                        [](std::size_t i) {
                          if (i == 20) throw std::runtime_error("20");
                        }),
               std::runtime_error);
  std::vector<int> visits(50, 0);
  team.run(visits.size(), 4, [&](std::size_t i) { ++visits[i]; });
  EXPECT_EQ(visits, std::vector<int>(50, 1));
}

TEST(OrderedJobs, NoResultIsConsumedAfterOneThatCouldNotBe) {
  std::vector<std::size_t> consumed;
  const auto produce = [](std::size_t i) {
    // The second job ends after the first result could not be consumed.
    if (i == 1) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return i;
  };
  const auto consume = [&](std::size_t i, std::size_t) {
    consumed.push_back(i);
    throw InputError("interrupted");
  };
  EXPECT_THROW(run_ordered_jobs(4, 2, produce, consume), InputError);
  EXPECT_EQ(consumed, std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace clast
