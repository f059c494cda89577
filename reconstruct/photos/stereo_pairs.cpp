#include "reconstruct/photos/stereo_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace {

struct Partner {
  std::size_t photo;
  double angle;
  Vec3 step;  ///< from one camera to the other, unit
};

/// Photos that show the middle of the region from outside of it.
std::vector<std::size_t> usable_photos(const PhotoModel& model, const PhotoRegion& region,
                                       const std::vector<std::size_t>& excluded) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < model.photos.size(); ++i) {
    if (std::binary_search(excluded.begin(), excluded.end(), i)) continue;
    const CameraIntrinsics& lens = model.lenses[model.photos[i].lens];
    const std::optional<Vec2> projection = project_into_photo(model, i, region.centre);
    const bool inside = projection && projection->x() > 0.0 && projection->y() > 0.0 &&
                        projection->x() < lens.width && projection->y() < lens.height;
    // Cameras inside the ball do not show the block.
    if (inside && (model.photos[i].centre() - region.centre).norm() > 1.2 * region.radius) {
      usable.push_back(i);
    }
  }
  return usable;
}

/// Photos with which a photo may be compared.
struct Candidates {
  std::vector<Partner> partners;  ///< those whose angle is nearest to the best come first
  double smallest = kPi;          ///< angle to another photo, of those above the least; pi: to none
};

Candidates candidates(const PhotoModel& model, const PhotoRegion& region,
                      const std::vector<std::size_t>& usable, std::size_t photo,
                      const StereoPairOptions& options) {
  Candidates result;
  for (const std::size_t j : usable) {
    if (j == photo) continue;
    const double angle = viewing_angle(model, region, photo, j);
    if (angle >= options.min_angle) result.smallest = std::min(result.smallest, angle);
    if (angle < options.min_angle || angle > options.max_angle) continue;
    result.partners.push_back(
        {j, angle, (model.photos[j].centre() - model.photos[photo].centre()).normalized()});
  }
  std::sort(result.partners.begin(), result.partners.end(),
            [&](const Partner& a, const Partner& b) {
              const double off_a = std::abs(std::log(a.angle / options.preferred_angle));
              const double off_b = std::abs(std::log(b.angle / options.preferred_angle));
              return off_a < off_b || (off_a == off_b && a.photo < b.photo);
            });
  return result;
}

/// The best partners, on different sides of the photo first.
std::vector<std::size_t> choose_partners(const std::vector<Partner>& partners, std::size_t most) {
  std::vector<std::size_t> photos;
  std::vector<Vec3> taken;
  for (const bool other_side : {true, false}) {
    for (const Partner& partner : partners) {
      if (taken.size() >= most) break;
      const bool same_side = std::any_of(taken.begin(), taken.end(), [&](const Vec3& step) {
        return step.dot(partner.step) > 0.0;
      });
      if (other_side && same_side) continue;
      if (std::find(taken.begin(), taken.end(), partner.step) != taken.end()) continue;
      taken.push_back(partner.step);
      photos.push_back(partner.photo);
    }
  }
  return photos;
}

/// @param nearest  smallest angle of each photo to another
[[noreturn]] void refuse_few_pairs(std::size_t pairs, std::size_t photos,
                                   std::vector<double> nearest) {
  std::string apart;
  if (!nearest.empty()) {
    std::sort(nearest.begin(), nearest.end());
    apart = ": neighbours are " +
            format_significant(nearest[nearest.size() / 2] * kDegreesPerRadian, 2) +
            " degrees apart";
  }
  throw InputError("only " + std::to_string(pairs) + " pairs among " + std::to_string(photos) +
                   " photos that show the block are close enough to compare" + apart +
                   ". Take one photo every 10-15 degrees all round the block");
}

}  // namespace

void StereoPairOptions::check() const {
  if (!(min_angle > 0.0 && min_angle <= preferred_angle && preferred_angle <= max_angle &&
        max_angle < 0.5 * kPi)) {
    throw InputError("angles between photos must be 0 < least <= best <= largest < 90 degrees");
  }
  if (partners < 1) {
    throw InputError("partners = " + std::to_string(partners) + "; must be 1 or more");
  }
}

std::vector<StereoPair> choose_stereo_pairs(const PhotoModel& model, const PhotoRegion& region,
                                            const std::vector<std::size_t>& excluded,
                                            const StereoPairOptions& options) {
  options.check();
  const std::vector<std::size_t> usable = usable_photos(model, region, excluded);
  std::set<std::pair<std::size_t, std::size_t>> chosen;
  std::vector<double> nearest;
  for (const std::size_t i : usable) {
    const Candidates of_photo = candidates(model, region, usable, i, options);
    if (of_photo.smallest < kPi) nearest.push_back(of_photo.smallest);
    for (const std::size_t j : choose_partners(of_photo.partners, options.partners)) {
      chosen.insert(std::minmax(i, j));
    }
  }
  if (chosen.size() < options.min_pairs) {
    refuse_few_pairs(chosen.size(), usable.size(), nearest);
  }
  std::vector<StereoPair> pairs;
  for (const auto& [i, j] : chosen) pairs.push_back({i, j, viewing_angle(model, region, i, j)});
  return pairs;
}

}  // namespace clast
