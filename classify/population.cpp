#include "classify/population.hpp"

#include <algorithm>
#include <cmath>

namespace clast {
namespace {

// Standard normal deviate that 2.5 % exceed.
constexpr double kDeviate = 1.959963984540054;

void set_interval(ClassShare& share, std::size_t total) {
  const double n = static_cast<double>(total);
  const double p = static_cast<double>(share.count) / n;
  const double z2 = kDeviate * kDeviate;
  const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = kDeviate / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  share.share = p;
  // At 0 and all the interval reaches the end exactly; rounding must not leave it short.
  share.low = share.count == 0 ? 0.0 : std::max(0.0, middle - half);
  share.high = share.count == total ? 1.0 : std::min(1.0, middle + half);
}

}  // namespace

std::vector<ClassShare> class_shares(std::span<const Axes> blocks, const std::string& scheme) {
  std::vector<ClassShare> shares;
  for (const std::string& name : class_names(scheme)) {
    ClassShare share;
    share.name = name;
    for (const Axes& axes : blocks) share.count += shape_class(scheme, axes) == name;
    if (blocks.empty()) {
      share.high = 1.0;  // nothing is known
    } else {
      set_interval(share, blocks.size());
    }
    shares.push_back(share);
  }
  return shares;
}

}  // namespace clast
