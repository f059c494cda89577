#include "reconstruct/photos/stereo_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace {

constexpr double kDegrees = 180.0 / kPi;

struct Partner {
  std::size_t photo;
  double angle;
  Vec3 step;  ///< from one camera to the other, unit
};

}  // namespace

void PairOptions::check() const {
  if (!(least_angle > 0.0 && least_angle <= best_angle && best_angle <= largest_angle &&
        largest_angle < 0.5 * kPi)) {
    throw InputError("angles between photos must be 0 < least <= best <= largest < 90 degrees");
  }
  if (partners < 1) {
    throw InputError("partners = " + std::to_string(partners) + "; must be 1 or more");
  }
}

std::vector<StereoPair> stereo_pairs(const PhotoModel& model, const PhotoRegion& region,
                                     const std::vector<std::size_t>& left_out,
                                     const PairOptions& options) {
  options.check();
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < model.photos.size(); ++i) {
    if (std::binary_search(left_out.begin(), left_out.end(), i)) continue;
    const Lens& lens = model.lenses[model.photos[i].lens];
    const std::optional<Vec2> seen = seen_at(model, i, region.centre);
    const bool inside = seen && seen->x() > 0.0 && seen->y() > 0.0 && seen->x() < lens.width &&
                        seen->y() < lens.height;
    // From inside the ball there is no picture of the block.
    if (inside && (model.photos[i].centre() - region.centre).norm() > 1.2 * region.radius) {
      usable.push_back(i);
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> chosen;
  std::vector<double> nearest;
  for (const std::size_t i : usable) {
    std::vector<Partner> partners;
    double smallest = kPi;
    for (const std::size_t j : usable) {
      if (j == i) continue;
      const double angle = angle_between(model, region, i, j);
      if (angle >= options.least_angle) smallest = std::min(smallest, angle);
      if (angle < options.least_angle || angle > options.largest_angle) continue;
      partners.push_back(
          {j, angle, (model.photos[j].centre() - model.photos[i].centre()).normalized()});
    }
    if (smallest < kPi) nearest.push_back(smallest);
    std::sort(partners.begin(), partners.end(), [&](const Partner& a, const Partner& b) {
      const double off_a = std::abs(std::log(a.angle / options.best_angle));
      const double off_b = std::abs(std::log(b.angle / options.best_angle));
      return off_a < off_b || (off_a == off_b && a.photo < b.photo);
    });
    std::vector<Vec3> taken;
    for (const bool other_side : {true, false}) {
      for (const Partner& partner : partners) {
        if (taken.size() >= options.partners) break;
        const bool same_side = std::any_of(taken.begin(), taken.end(), [&](const Vec3& step) {
          return step.dot(partner.step) > 0.0;
        });
        const std::pair<std::size_t, std::size_t> pair = std::minmax(i, partner.photo);
        if (other_side && same_side) continue;
        if (std::any_of(taken.begin(), taken.end(),
                        [&](const Vec3& step) { return step == partner.step; })) {
          continue;
        }
        taken.push_back(partner.step);
        chosen.insert(pair);
      }
    }
  }
  if (chosen.size() < options.fewest_pairs) {
    std::string apart;
    if (!nearest.empty()) {
      std::sort(nearest.begin(), nearest.end());
      apart = ": neighbours are " + with_digits(nearest[nearest.size() / 2] * kDegrees, 2) +
              " degrees apart";
    }
    throw InputError("only " + std::to_string(chosen.size()) + " pairs among " +
                     std::to_string(usable.size()) +
                     " photos that show the block are close enough to compare" + apart +
                     ". Take one photo every 10-15 degrees all round the block");
  }
  std::vector<StereoPair> pairs;
  for (const auto& [i, j] : chosen) pairs.push_back({i, j, angle_between(model, region, i, j)});
  return pairs;
}

}  // namespace clast
