#include "shapes/box_stretch.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {
namespace {

/// A gap of rounding: the body has these ratios already.
constexpr double kSameRatios = 1e-9;
constexpr double kGoodEnough = 1e-4;  ///< a fiftieth of what is promised
constexpr int kStretchRounds = 400;
/// First iteration from which three of four steps are eight times as long: if several boxes are
/// nearly the smallest, the ratios hardly change for hundreds of steps. Steps of any length keep
/// the volume of the box, so that the smallest box never grows.
constexpr int kFirstLongStep = 8;
constexpr double kLongStep = 8.0;
constexpr double kMaxFactor = 1.1;  ///< of one side, to the power of a long step
/// Fraction of L below which S is undefined.
constexpr double kNoThickness = 1e-9;

/// Sides of the target box with a core of radius `share` S inside, S = s_l.
Vec3 core_sides(const BoxRatios& target, double share) {
  const double rim = 2.0 * share * target.s_l;
  return {1.0 - rim, target.i_l - rim, target.s_l - rim};
}

/// The stretch in a map without its turn: the root of A^T A.
Mat3 stretch_in(const Mat3& map) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(map.transpose() * map);
  return eigen.operatorSqrt();
}

/// Box around the corners of a hull after a map, with the radius `share` times its S.
struct MappedBox {
  OrientedBox box;
  double radius = 0.0;
};

MappedBox mapped_box(const std::vector<Vec3>& corners, const Mat3& map, double share,
                     double radius) {
  std::vector<Vec3> mapped;
  mapped.reserve(corners.size());
  for (const Vec3& corner : corners) mapped.emplace_back(map * corner);
  MappedBox result{smallest_box(mapped, radius), radius};
  // S of the core stays along these axes while the radius goes to its share.
  const double thickness = result.box.lengths[2] - 2.0 * radius;
  result.radius = share * thickness / (1.0 - 2.0 * share);
  result.box.lengths += Vec3::Constant(2.0 * (result.radius - radius));
  return result;
}

}  // namespace

void BoxRatios::check() const {
  if (!(i_l > 0.0 && i_l <= 1.0)) {
    throw InputError("I/L = " + format_significant(i_l, 6) + ": must be above 0 and at most 1");
  }
  if (!(s_l > 0.0 && s_l <= i_l)) {
    throw InputError("S/L = " + format_significant(s_l, 6) + ": must be above 0 and at most I/L, " +
                     format_significant(i_l, 6));
  }
}

BoxRatios box_ratios(const OrientedBox& box) {
  return {box.lengths[1] / box.lengths[0], box.lengths[2] / box.lengths[0]};
}

double max_ratio_difference(const BoxRatios& ratios, const BoxRatios& target) {
  return std::max(std::abs(ratios.i_l / target.i_l - 1.0), std::abs(ratios.s_l / target.s_l - 1.0));
}

StretchedBody stretch_to_ratios(const SpheroPolyhedron& body, const BoxRatios& target) {
  target.check();
  if (body.faces.empty()) throw GeometryError("a ball or a capsule has no core to stretch");
  const OrientedBox before = smallest_box(body);
  const double gap = max_ratio_difference(box_ratios(before), target);
  if (gap <= kSameRatios) return {body, Vec3::Ones(), gap};
  if (before.lengths[2] - 2.0 * body.radius <= kNoThickness * before.lengths[0]) {
    throw GeometryError("the core is flat, so stretching can't change its S");
  }
  const double share = body.radius / before.lengths[2];
  const Vec3 wanted = core_sides(target, share);
  std::vector<Vec3> corners = extreme_points(body.vertices);
  for (Vec3& corner : corners) corner -= before.centre;

  Mat3 map = Mat3::Identity(), best_map = map;
  MappedBox found{before, body.radius};
  StretchedBody result{body, Vec3::Ones(), gap};
  for (int round = 0; round < kStretchRounds && result.max_ratio_difference > kGoodEnough;
       ++round) {
    const Vec3 sides = found.box.lengths - Vec3::Constant(2.0 * found.radius);
    Vec3 factors = wanted.cwiseQuotient(sides);
    factors /= std::cbrt(factors.prod());
    if (round >= kFirstLongStep && round % 4 != 3) {
      factors = factors.cwiseMin(kMaxFactor).cwiseMax(1.0 / kMaxFactor);
      factors = factors.array().pow(kLongStep).matrix();
      factors /= std::cbrt(factors.prod());
    }
    map = found.box.axes * factors.asDiagonal() * found.box.axes.transpose() * map;
    found = mapped_box(corners, map, share, found.radius);
    const double left = max_ratio_difference(box_ratios(found.box), target);
    if (left >= result.max_ratio_difference) continue;
    result.max_ratio_difference = left;
    result.body.radius = found.radius;
    best_map = map;
  }
  const Mat3 stretch = stretch_in(best_map);
  for (Vec3& vertex : result.body.vertices) {
    vertex = before.centre + stretch * (vertex - before.centre);
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(stretch, Eigen::EigenvaluesOnly);
  result.principal_stretches = eigen.eigenvalues().reverse();
  result.max_ratio_difference = max_ratio_difference(box_ratios(smallest_box(result.body)), target);
  return result;
}

}  // namespace clast
