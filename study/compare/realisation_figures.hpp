#pragma once
/// The figures of what blocks that stay leave behind, over the realisations of each file, and how
/// far the files differ. Realisations are independent of each other, so a figure has as many values
/// as there are realisations with a deposit.
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/mean_intervals.hpp"
#include "study/compare/realisation_deposits.hpp"

namespace clast {

/// A figure of a realisation.
struct RealisationFigure {
  std::string name;  ///< with its unit: "toe_distance_m"
  std::string unit;  ///< "m"; empty for counts and shares
  std::string words;
  int decimals = 2;                                        ///< that are worth printing
  std::function<double(const RealisationDeposit&)> value;  ///< not finite: there is none
  Interval possible = {-INFINITY, INFINITY};
};
/// Blocks at rest, volume, centre of mass, crest to toe, area, bulk volume, thickness.
const std::vector<RealisationFigure>& realisation_figures();

/// A figure over the realisations of a file.
struct FigureOfFile {
  std::uint32_t file = 0;  ///< index into Comparison::results
  std::size_t figure = 0;  ///< index into `realisation_figures`
  Summary summary;         ///< its count is that of realisations with the figure
  double least = NAN;
  std::optional<Interval> interval;  ///< 95 %, of the mean; as `mean_interval`
};

/// A figure of one file less that of another.
struct FigureDifference {
  FigureOfFile first;
  FigureOfFile second;
  std::optional<MeanDifference> welch;  ///< as `welch_difference`
  double p_holm = 1.0;                  ///< of `welch`, corrected for all that are tested
  std::size_t tests = 0;                ///< that it is corrected for

  double difference() const { return first.summary.mean - second.summary.mean; }
};

/// What a difference between files means.
enum class Distinction {
  kDistinguished,     ///< the interval excludes zero, the corrected p is below 5 %
  kOneOfMany,         ///< the interval excludes zero, but one of so many does that by chance
  kNotDistinguished,  ///< the interval holds zero
  kUnknown,           ///< there is no interval
};
Distinction distinction_of(const FigureDifference& difference);

struct FiguresOfFiles {
  std::vector<FigureOfFile> files;  ///< by file, then figure; figures without a value left out
  /// Of each pair of files, in the order of figures; none with more than `kMostGroups` files.
  std::vector<FigureDifference> differences;
};
FiguresOfFiles figures_of_files(const std::vector<RealisationDeposit>& realisations);

/// "travel angle: file 1 31.2 deg, file 2 28.4 deg; 2.8 deg more (1.1 to 4.5 deg), from 4 and 4
/// realisations", and whether that can be chance.
std::string in_words(const FigureDifference& difference);

/// "2.8 deg more (1.1 to 4.5 deg)": the first against the second.
std::string gap_in_words(const FigureDifference& difference);

}  // namespace clast
