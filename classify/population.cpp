#include "classify/population.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/number_text.hpp"

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

// Below this probability a difference is called one.
constexpr double kSignificant = 0.05;

/// Values of an index over the blocks that have it.
template <class Index>
std::vector<double> values_of(std::span<const Axes> blocks, const Index& index) {
  std::vector<double> values;
  for (const Axes& axes : blocks) {
    if (const std::optional<double> value = index(axes)) values.push_back(*value);
  }
  return values;
}

std::optional<double> s_over_l(const Axes& axes) { return axes.S / axes.L; }

TestResult kolmogorov_smirnov_of(std::vector<double> a, std::vector<double> b) {
  return a.empty() || b.empty() ? TestResult{} : kolmogorov_smirnov(std::move(a), std::move(b));
}

}  // namespace

std::vector<ClassShare> class_shares(std::span<const Axes> blocks, const std::string& scheme,
                                     const SchemeOptions& options, std::span<const double> masses) {
  const std::vector<std::string>& names = class_names(scheme);
  std::vector<std::size_t> counts(names.size(), 0);
  std::vector<double> mass_of(names.size(), 0.0);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto found =
        std::find(names.begin(), names.end(), shape_class(scheme, blocks[i], options));
    const auto place = static_cast<std::size_t>(found - names.begin());
    ++counts[place];
    if (!masses.empty()) mass_of[place] += masses[i];
  }
  const double total = std::accumulate(mass_of.begin(), mass_of.end(), 0.0);
  std::vector<ClassShare> shares;
  for (std::size_t i = 0; i < names.size(); ++i) {
    ClassShare share;
    share.name = names[i];
    share.count = counts[i];
    if (blocks.empty()) {
      share.high = 1.0;  // nothing is known
    } else {
      set_interval(share, blocks.size());
    }
    if (total > 0.0) share.mass_share = mass_of[i] / total;
    shares.push_back(share);
  }
  return shares;
}

double c40(std::span<const Axes> blocks) {
  const auto slabs = std::count_if(blocks.begin(), blocks.end(), [](const Axes& axes) {
    return axes.S / axes.L <= 0.4 + 1e-12;  // decimals on the limit are on it
  });
  return static_cast<double>(slabs) / static_cast<double>(blocks.size());
}

PopulationComparison compared(std::span<const Axes> a, std::span<const Axes> b,
                              const std::string& scheme, const SchemeOptions& options) {
  const auto differ = [&](const auto& index) {
    return kolmogorov_smirnov_of(values_of(a, index), values_of(b, index));
  };
  const auto counts = [&](std::span<const Axes> blocks) {
    std::vector<std::size_t> row;
    for (const ClassShare& share : class_shares(blocks, scheme, options))
      row.push_back(share.count);
    return row;
  };
  return {differ(elongation_s_c), differ(s_over_l), differ(disc_rod_index),
          chi_squared(counts(a), counts(b))};
}

std::string in_words(const std::string& what, const TestResult& result) {
  const bool classes = result.degrees > 0;
  std::string text =
      what + (result.p_value < kSignificant ? " differ (" : " can't be told apart (");
  text += classes ? "chi-squared " + with_digits(result.statistic, 3) + " with " +
                        std::to_string(result.degrees) + " degrees of freedom"
                  : "Kolmogorov-Smirnov D = " + with_digits(result.statistic, 3);
  text += result.p_value < 1e-4 ? ", p < 0.0001" : ", p = " + with_digits(result.p_value, 2);
  if (result.small_counts) text += "; some classes hold too few blocks for an exact p";
  return text + ")";
}

}  // namespace clast
