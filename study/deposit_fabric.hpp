#pragma once
/// Fabric and sorting of deposits: which way long axes point, whether blocks of a class lie
/// together, and which blocks went far. Blocks count alike; realisations are independent of each
/// other, blocks of one are not.
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/axial_statistics.hpp"
#include "core/mean_intervals.hpp"
#include "study/lying_blocks.hpp"

namespace clast {

/// The mean over realisations of what a realisation has on average.
struct RealisationMean {
  Summary summary;                   ///< of the realisations
  std::optional<Interval> interval;  ///< 95 %, as `mean_interval`
};

/// Blocks of a file that lie in the deposits: all, of a class, or of a third of the sizes.
struct FabricGroup {
  std::uint32_t file = 0;
  std::string name;  ///< "all", "class compact", "sneed-folk VE", "smallest third"
  std::size_t blocks = 0;
  std::size_t realisations = 0;  ///< that have any
  RealisationMean along;         ///< m, as `LyingBlock`
  RealisationMean ahead;
  RealisationMean aside;  ///< m, to either side
  RealisationMean height;
  RealisationMean relative_height;
  AxialMean trend;  ///< of the long axes, from downslope to the right
  /// p of even trends with blocks taken as independent; none below two realisations.
  std::optional<double> rayleigh;
  std::optional<double> rayleigh_realisations;  ///< ... realisations independent; none below two
  double plunge = NAN;                          ///< mean, rad
  Vec3 eigenvalues = Vec3::Constant(NAN);       ///< of the mean of a a', descending; their sum is 1
  std::vector<double> trends;                   ///< of each block
};

/// Whether the nearest neighbour of a block is of its class more often than by chance.
struct NeighbourTest {
  std::uint32_t file = 0;
  std::string scheme;             ///< "garcia" or "sneed-folk"
  std::size_t blocks = 0;         ///< in realisations with two or more
  std::size_t realisations = 0;   ///< with two or more blocks
  double share = NAN;             ///< of blocks whose nearest neighbour has the same class
  double expected = NAN;          ///< where classes are dealt to the places at random
  std::optional<double> p_value;  ///< of a share so far from that, either way; none below two
                                  ///< realisations
};

/// A class of each block, and the block whose class it is set against.
struct PairedClasses {
  std::vector<std::uint32_t> classes;
  std::vector<std::size_t> partners;  ///< of the same stratum
  std::vector<std::uint32_t> strata;  ///< classes are exchanged within these
};
/// Shares and p of the test; classes are exchanged within strata, up to 9,999 times.
/// p = (1 + as far from the expected share)/(1 + exchanges).
/// @return file and scheme empty, share not a number without blocks
/// @cite phipson2010
NeighbourTest same_class_test(const PairedClasses& pairs, std::uint64_t seed);

/// Rank correlation of a property of blocks with their place, within realisations.
struct SortingTrend {
  std::uint32_t file = 0;
  std::string property;  ///< "volume", "I/L" or "S/L"
  std::string place;     ///< "runout", "ahead", "aside" or "relative height"
  RealisationMean rank_correlation;
  std::optional<double> p_value;  ///< of none on average: Student's t over realisations
};

struct DepositFabric {
  std::vector<FabricGroup> groups;        ///< by file
  std::vector<NeighbourTest> neighbours;  ///< by file; schemes of which two classes occur
  std::vector<SortingTrend> sorting;      ///< by file; none where all blocks have the same property
};
DepositFabric deposit_fabric(const Comparison& comparison);

}  // namespace clast
