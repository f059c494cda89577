#include "library/detail/roundness_search.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/block_measures.hpp"
#include "library/block_variation.hpp"
#include "library/variation_ranges.hpp"

namespace clast::library_detail {
namespace {

constexpr double kRoundnessTolerance = 3e-3;  ///< relative
constexpr int kRounds = 10;
/// Shares of S that are tried to get below a target, after the largest.
constexpr std::array<double, 4> kFallingFractions = {0.2, 0.1, 0.05, 0.0};

[[noreturn]] void refuse_target(double target, const std::string& why, double nearest) {
  throw GeometryError("a roundness of " + format_significant(target, 4) +
                      " can't be reached: " + why + format_significant(nearest, 4));
}

bool good(const RoundnessSearchResult& one, double target, double tolerance) {
  return std::abs(one.roundness / target - 1.0) <= tolerance;
}

/// An end that stays twice running counts half, so that both ends close in. @cite dowell1971
RoundnessSearchResult between(const std::function<RoundnessSearchResult(double)>& at,
                              RoundnessSearchResult low, RoundnessSearchResult high,
                              double target) {
  double below = low.roundness - target, above = high.roundness - target;
  bool moved_low = false, moved_high = false;
  RoundnessSearchResult best = -below < above ? low : high;
  for (int round = 0; round < kRounds && !good(best, target, kRoundnessTolerance); ++round) {
    RoundnessSearchResult next =
        at((low.radius_fraction * above - high.radius_fraction * below) / (above - below));
    const double gap = next.roundness - target;
    if (std::abs(gap) < std::abs(best.roundness - target)) best = next;
    if (gap < 0.0) {
      low = std::move(next);
      below = gap;
      if (std::exchange(moved_low, true)) above *= 0.5;
      moved_high = false;
    } else {
      high = std::move(next);
      above = gap;
      if (std::exchange(moved_high, true)) below *= 0.5;
      moved_low = false;
    }
  }
  return best;
}

}  // namespace

RoundnessSearchResult find_body_with_roundness(
    const std::function<SpheroPolyhedron(double)>& rounded, double target, double edge_length) {
  const auto at = [&](double share) {
    RoundnessSearchResult one{rounded(share), share, 0.0};
    one.roundness = body_roundness(one.body, edge_length).value;
    return one;
  };
  RoundnessSearchResult high = at(kVariedRadiusFractionRange.high);
  if (good(high, target, kRoundnessTolerance)) return high;
  if (high.roundness < target) {
    refuse_target(target,
                  "the largest radius, " + format_significant(kVariedRadiusFractionRange.high, 2) +
                      " of S, gives ",
                  high.roundness);
  }
  for (const double share : kFallingFractions) {
    RoundnessSearchResult low = at(share);
    if (good(low, target, kRoundnessTolerance)) return low;
    if (low.roundness > target) {
      high = std::move(low);
      continue;
    }
    RoundnessSearchResult found = between(at, std::move(low), std::move(high), target);
    if (good(found, target, kRoundnessTolerance)) return found;
    refuse_target(target, "the measured roundness is discontinuous there; the nearest value is ",
                  found.roundness);
  }
  refuse_target(target, "with sharp edges it is ", high.roundness);
}

}  // namespace clast::library_detail
