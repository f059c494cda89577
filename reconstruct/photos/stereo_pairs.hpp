#pragma once
/// Which photos are compared with which.
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "core/fields.hpp"
#include "reconstruct/photos/photo_region.hpp"

namespace clast {

/// Two photos of the same side of a block.
struct StereoPair {
  std::size_t first = 0, second = 0;  ///< numbers of photos, first < second
  double angle = 0.0;                 ///< between them at the block, rad
};

/// Neighbours: far enough apart to give a depth, near enough to look alike. Angles in rad.
struct StereoPairOptions {
  double least_angle = 6.0 * kRadiansPerDegree;
  double best_angle = 15.0 * kRadiansPerDegree;
  double largest_angle = 32.0 * kRadiansPerDegree;
  std::size_t partners = 2;  ///< that each photo looks for
  /// Pairs that see a side of the block: below, no side is known safely.
  std::size_t fewest_pairs = 6;

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const StereoPairOptions& options, Visit&& visit) {
  const auto& [least_angle, best_angle, largest_angle, partners, fewest_pairs] = options;
  visit("least_angle", least_angle);
  visit("best_angle", best_angle);
  visit("largest_angle", largest_angle);
  visit("partners", partners);
  visit("fewest_pairs", fewest_pairs);
}

/// For each photo that shows the middle of the region, the partners nearest to the best angle, on
/// both sides of it where there are some. In order of photos.
/// @param excluded  photos not to use, by number (blurred ones), ascending
/// @throws InputError  too few pairs: says how far the photos are apart
std::vector<StereoPair> stereo_pairs(const PhotoModel& model, const PhotoRegion& region,
                                     const std::vector<std::size_t>& excluded = {},
                                     const StereoPairOptions& options = {});

}  // namespace clast
