#pragma once
/// Shares of shape classes in a population of blocks, and how it differs from another.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/schemes.hpp"
#include "classify/statistics.hpp"

namespace clast {

/// One class of a population. Shares are in [0, 1].
struct ClassShare {
  std::string name;
  std::size_t count = 0;
  double share = 0.0;
  double low = 0.0;  ///< Wilson interval, 95 %
  double high = 0.0;
  std::optional<double> mass_share;  ///< only where every block has a mass
};

/// Counts and shares of every class of the scheme, also of empty ones.
/// @param masses  kg, of every block in order, or empty
/// @cite wilson1927
std::vector<ClassShare> class_shares(std::span<const Axes> blocks, const std::string& scheme,
                                     const SchemeOptions& options = {},
                                     std::span<const double> masses = {});

/// Share of blocks with S/L <= 0.4. @cite benn1993
double c40(std::span<const Axes> blocks);

/// Of two populations, both with a block.
struct PopulationComparison {
  TestResult s_c, s_l, disc_rod_index;  ///< Kolmogorov-Smirnov
  TestResult classes;                   ///< chi-squared on the scheme's classes
};
PopulationComparison compared(std::span<const Axes> a, std::span<const Axes> b,
                              const std::string& scheme, const SchemeOptions& options = {});

/// A sentence to quote: "s_c differs (Kolmogorov-Smirnov D = 0.31, p = 0.002)".
std::string in_words(const std::string& what, const TestResult& result);

}  // namespace clast
