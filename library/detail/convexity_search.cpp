#include "library/detail/convexity_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/block_variation.hpp"
#include "massprops/sphero.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/hull_interpolation.hpp"

namespace clast::library_detail {
namespace {

/// Tolerance within which a target is reached.
constexpr double kSameConvexity = 1e-6;
constexpr double kConvexityTolerance = 2e-4;
constexpr double kVolumeAccuracy = 1e-4;
constexpr int kSteps = 30;

/// Convexities of the bodies of a blend.
class BlendConvexity {
 public:
  BlendConvexity(const HullInterpolation& blend, const SpheroPolyhedron& hull)
      : blend_(blend),
        radius_(hull.radius),
        hull_volume_(sphero_mass_properties(hull, 1.0).volume) {}

  SpheroPolyhedron body(double part, std::size_t edge_flips) const {
    return make_sphero_polyhedron(blend_.interpolate(part, edge_flips), radius_);
  }
  double at(double part, std::size_t edge_flips) const {
    return sphero_mass_properties(body(part, edge_flips), 1.0, kVolumeAccuracy).volume /
           hull_volume_;
  }

 private:
  const HullInterpolation& blend_;
  double radius_, hull_volume_;
};

/// The fewest turned edges with which the target can be reached.
std::size_t fewest_turns(const BlendConvexity& convexity, std::size_t all, double target) {
  if (convexity.at(1.0, 0) >= target) return 0;
  std::size_t below = 0, enough = all;
  while (enough - below > 1) {
    const std::size_t middle = below + (enough - below) / 2;
    (convexity.at(1.0, middle) >= target ? enough : below) = middle;
  }
  return enough;
}

HullInterpolation blend_of(const SpheroPolyhedron& body, double target) {
  try {
    return HullInterpolation(core_mesh(body));
  } catch (const GeometryError& error) {
    throw GeometryError("a convexity of " + format_significant(target, 4) +
                        " can't be reached: " + error.what() +
                        "; the nearest are its own convexity and 1, that of its hull");
  }
}

}  // namespace

SpheroPolyhedron find_body_with_convexity(const SpheroPolyhedron& body, double initial_convexity,
                                          double target) {
  if (std::abs(target - initial_convexity) <= kSameConvexity) return body;
  if (!(target <= 1.0 && target > initial_convexity)) {
    throw GeometryError("a convexity of " + format_significant(target, 4) +
                        " can't be reached: filling hollows gives values from its own " +
                        format_significant(initial_convexity, 4) + " to 1");
  }
  const SpheroPolyhedron hull = make_sphero_polyhedron(convex_hull(body.vertices), body.radius);
  if (target > 1.0 - kSameConvexity) return hull;
  const HullInterpolation blend = blend_of(body, target);
  const BlendConvexity convexity(blend, hull);
  const std::size_t edge_flips = fewest_turns(convexity, blend.edge_flips(), target);
  // False position with halving (Illinois), since the volume is close to a cubic in the part.
  double low = 0.0, high = 1.0;
  double below = (edge_flips == 0 ? initial_convexity : convexity.at(0.0, edge_flips)) - target;
  double above = convexity.at(1.0, edge_flips) - target;
  if (below > 0.0 || above < 0.0) {
    return std::abs(above) <= kVariationTolerance * target ? convexity.body(1.0, edge_flips) : hull;
  }
  double part = 1.0;
  int side = 0;  // which bound moved last
  for (int step = 0; step < kSteps; ++step) {
    part = above > below ? low - below * (high - low) / (above - below) : 0.5 * (low + high);
    const double gap = convexity.at(part, edge_flips) - target;
    if (std::abs(gap) <= kConvexityTolerance * target) break;
    if (gap > 0.0) {
      high = part;
      above = gap;
      if (side == 1) below *= 0.5;
      side = 1;
    } else {
      low = part;
      below = gap;
      if (side == -1) above *= 0.5;
      side = -1;
    }
  }
  return convexity.body(part, edge_flips);
}

}  // namespace clast::library_detail
