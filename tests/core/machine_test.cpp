#include "core/machine.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace clast {
namespace {

TEST(Machine, AThreadThatSleepsUsesNoProcessorTime) {
  const double begin = thread_processor_time();
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_LT(thread_processor_time() - begin, 0.1);
}

TEST(Machine, AThreadThatComputesUsesProcessorTimeAndOthersDoNotCount) {
  const double begin = thread_processor_time();
  std::thread([] {
    const double others_begin = thread_processor_time();
    while (thread_processor_time() < others_begin + 0.2) continue;
  }).join();
  EXPECT_LT(thread_processor_time() - begin, 0.1);
}

}  // namespace
}  // namespace clast
