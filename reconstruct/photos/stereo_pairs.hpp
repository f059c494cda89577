#pragma once
/// Selection of stereo pairs.
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "core/fields.hpp"
#include "reconstruct/photos/photo_region.hpp"

namespace clast {

/// Pair of photos that show the same side of a block.
struct StereoPair {
  std::size_t first = 0, second = 0;  ///< photo indices, first < second
  double angle = 0.0;                 ///< angle between the viewing directions at the block, rad
};

/// Selection criteria of stereo pairs. The photos must be far enough apart to give depth, and near
/// enough to look alike. Angles in rad.
struct StereoPairOptions {
  double min_angle = 6.0 * kRadiansPerDegree;
  double preferred_angle = 15.0 * kRadiansPerDegree;
  double max_angle = 32.0 * kRadiansPerDegree;
  std::size_t partners = 2;  ///< number of partners per photo
  /// Minimum number of pairs that cover the block.
  std::size_t min_pairs = 6;

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const StereoPairOptions& options, Visit&& visit) {
  const auto& [min_angle, preferred_angle, max_angle, partners, min_pairs] = options;
  visit("least_angle", min_angle);
  visit("best_angle", preferred_angle);
  visit("largest_angle", max_angle);
  visit("partners", partners);
  visit("fewest_pairs", min_pairs);
}

/// Chooses stereo partners for each photo that shows the centre of the region. They have angles
/// nearest to the best angle, on both sides if possible. Pairs are in the order of the photos.
/// @param excluded  ascending indices of photos that are not used, such as blurred ones
/// @throws InputError  if there are too few pairs; states how far the photos are apart
std::vector<StereoPair> choose_stereo_pairs(const PhotoModel& model, const PhotoRegion& region,
                                            const std::vector<std::size_t>& excluded = {},
                                            const StereoPairOptions& options = {});

}  // namespace clast
