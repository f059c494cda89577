// The step of `auto` is short enough: half of it stops blocks at the same places. Single runs are
// chaotic (a stop moves by metres either way), so the shift is that of means, and the mean over
// more releases than the bar requires show that it is not met by luck.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/tested_slope.hpp"

namespace clast {
namespace {

TEST(TimeStep, HalfOfItMovesTheMeanStopByLessThanTheStandardErrorOf64Releases) {
  constexpr int kReleases = 256, kOfTheBar = 64;
  const RigidBody body = tested_rock(5);
  const TerrainSurface terrain = ground(tested_slope(120));
  const ReleaseSettings whole = tested_settings(body);
  ReleaseSettings half = whole;
  half.stiffness.time_step *= 0.5;
  half.stiffness.max_time_step *= 0.5;
  double sum = 0.0, squares = 0.0, shift = 0.0, shift_of_64 = 0.0;
  for (int i = 0; i < kReleases; ++i) {
    const auto stop = [&](const ReleaseSettings& settings) {
      const ReleaseResult result = simulate_release(
          terrain, kTestedZones, body, tested_start(static_cast<std::uint64_t>(i)), settings);
      EXPECT_EQ(result.stop_reason, StopReason::kRest);
      return result.final_state.position.x();
    };
    const double with_whole = stop(whole);
    const double with_half = stop(half);
    sum += with_whole;
    squares += with_whole * with_whole;
    shift += with_half - with_whole;
    if (i + 1 == kOfTheBar) shift_of_64 = shift / kOfTheBar;
  }
  const double mean = sum / kReleases;
  const double deviation = std::sqrt(squares / kReleases - mean * mean);
  const double standard_error = deviation / std::sqrt(kOfTheBar);
  RecordProperty("shift_of_64_m", std::to_string(shift_of_64));
  RecordProperty("shift_m", std::to_string(shift / kReleases));
  RecordProperty("standard_error_m", std::to_string(standard_error));
  EXPECT_LT(std::abs(shift_of_64), standard_error);
  EXPECT_LT(std::abs(shift / kReleases), standard_error);
}

}  // namespace
}  // namespace clast
