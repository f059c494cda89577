#include "particles/detail/sphere_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace clast::particles_detail {

namespace {

/// Relative change of radii that separates coinciding spheres: large against rounding (2e-16), and
/// without effect on any result.
constexpr double kSeparation = 1e-11;
/// Conjugate golden ratio: its multiples modulo 1 are all different and evenly spread.
constexpr double kGoldenRatio = 0.6180339887498949;
/// Longest part of an arc, rad: the quadrature below is then exact to 1e-16.
constexpr double kArcPart = kPi / 4.0;

/// Nodes and weights of Gauss and Legendre with eight points, positive half.
constexpr std::array<std::array<double, 2>, 4> kGauss = {
    {{0.1834346424956498, 0.3626837833783620},
     {0.5255324099163290, 0.3137066458778873},
     {0.7966664774136267, 0.2223810344533745},
     {0.9602898564975363, 0.1012285362903763}}};

/// Circle in which another sphere meets the unit sphere; points with n . axis > height are covered.
struct Circle {
  Vec3 axis, across, along;  ///< right-handed: across, along, axis
  double height = 0.0, radius = 0.0;

  Vec3 point(double angle) const {
    return height * axis + radius * (std::cos(angle) * across + std::sin(angle) * along);
  }
};

struct Interval {
  double begin, end;
};

/// Integrals over the exposed patch of a unit sphere.
struct PatchIntegrals {
  double solid_angle = 0.0;
  Vec3 first = Vec3::Zero();   ///< of n
  Mat3 second = Mat3::Zero();  ///< of n n^T
  Mat3 third = Mat3::Zero();   ///< of n n^T (n . c), with the centre c of the ball
};

/// Signed area of the spherical triangle of unit vectors (Van Oosterom & Strackee 1983).
double triangle_solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

std::vector<Ball> separated(std::span<const Ball> balls, const Vec3& origin) {
  std::vector<Ball> result;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double turn = static_cast<double>(i + 1) * kGoldenRatio;
    const double change = kSeparation * (2.0 * (turn - std::floor(turn)) - 1.0);
    result.push_back({balls[i].centre - origin, balls[i].radius * (1.0 + change)});
  }
  return result;
}

/// Circles of the other spheres on sphere `i`. `hidden` if another ball contains it.
struct CirclesOnSphere {
  std::vector<Circle> circles;
  bool hidden = false;
};

CirclesOnSphere circles_on(std::span<const Ball> balls, std::size_t i) {
  CirclesOnSphere result;
  const double radius = balls[i].radius;
  for (std::size_t j = 0; j < balls.size(); ++j) {
    if (j == i) continue;
    const double other = balls[j].radius, reach = radius + other;
    const Vec3 offset = balls[j].centre - balls[i].centre;
    const double squared = offset.squaredNorm();
    if (squared >= reach * reach) continue;
    const double distance = std::sqrt(squared);
    if (distance + radius <= other) {
      result.hidden = true;
      return result;
    }
    if (distance + other <= radius) continue;
    Circle circle;
    circle.axis = offset / distance;
    circle.height = std::clamp(
        (squared + (radius - other) * (radius + other)) / (2.0 * distance * radius), -1.0, 1.0);
    circle.radius = std::sqrt((1.0 - circle.height) * (1.0 + circle.height));
    circle.across = circle.axis.unitOrthogonal();
    circle.along = circle.axis.cross(circle.across);
    result.circles.push_back(circle);
  }
  return result;
}

/// Parts of circle `j` outside the caps of the others, as ranges of its angle.
std::vector<Interval> exposed_arcs(const std::vector<Circle>& circles, std::size_t j) {
  const Circle& circle = circles[j];
  std::vector<Interval> covered;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    if (k == j) continue;
    const Circle& cap = circles[k];
    const double a = circle.radius * circle.across.dot(cap.axis);
    const double b = circle.radius * circle.along.dot(cap.axis);
    const double bound = cap.height - circle.height * circle.axis.dot(cap.axis);
    const double reach = std::hypot(a, b);
    if (bound >= reach) continue;
    if (bound <= -reach) return {};
    const double middle = std::atan2(b, a), half = std::acos(bound / reach);
    double begin = middle - half;
    if (begin < 0.0) begin += 2.0 * kPi;
    const double end = begin + 2.0 * half;
    covered.push_back({begin, std::min(end, 2.0 * kPi)});
    if (end > 2.0 * kPi) covered.push_back({0.0, end - 2.0 * kPi});
  }
  std::sort(covered.begin(), covered.end(), [](const Interval& x, const Interval& y) {
    return x.begin < y.begin || (x.begin == y.begin && x.end < y.end);
  });
  std::vector<Interval> exposed;
  double reached = 0.0;
  for (const Interval& interval : covered) {
    if (interval.begin > reached) exposed.push_back({reached, interval.begin});
    reached = std::max(reached, interval.end);
  }
  if (reached < 2.0 * kPi) exposed.push_back({reached, 2.0 * kPi});
  return exposed;
}

/// Adds the line integrals along a part of a circle of at most `kArcPart`.
void add_line_integrals(const Circle& circle, const Interval& part, const Vec3& centre,
                        PatchIntegrals& sum) {
  const double middle = 0.5 * (part.begin + part.end), half = 0.5 * (part.end - part.begin);
  const double h = circle.height, ac = circle.axis.dot(centre);
  const Vec3& axis = circle.axis;
  const Mat3 axis_centre = axis * centre.transpose();
  const Mat3 traces = ac * Mat3::Identity() + axis_centre + axis_centre.transpose();
  for (const auto& [node, weight] : kGauss) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 n = circle.point(middle + side * half * node);
      const double w = weight * half, nc = n.dot(centre);
      const Mat3 nn = n * n.transpose(), an = axis * n.transpose(), cn = centre * n.transpose();
      const Mat3 mixed = an + an.transpose();
      const Mat3 third_traces = nc * Mat3::Identity() + cn + cn.transpose();
      sum.first += w * (axis - h * n);
      sum.second += w * (mixed - 2.0 * h * nn);
      sum.third += w * (nc * mixed + ac * nn - 0.4 * h * third_traces - 0.2 * traces -
                        3.0 * h * (nc * nn - 0.2 * third_traces));
    }
  }
}

PatchIntegrals integrate_patch(const std::vector<Circle>& circles, const Vec3& centre) {
  PatchIntegrals line, result;
  if (circles.empty()) {
    result.solid_angle = 4.0 * kPi;
  } else {
    // The areas of the arcs are counted from the point opposite to the middle of the largest cap,
    // which is covered.
    const auto widest =
        std::min_element(circles.begin(), circles.end(),
                         [](const Circle& a, const Circle& b) { return a.height < b.height; });
    const Vec3 start = -widest->axis;
    for (std::size_t j = 0; j < circles.size(); ++j) {
      const Circle& circle = circles[j];
      for (const Interval& arc : exposed_arcs(circles, j)) {
        const double parts = std::ceil((arc.end - arc.begin) / kArcPart);
        const double step = (arc.end - arc.begin) / parts;
        for (double p = 0.0; p < parts; ++p) {
          const Interval part = {arc.begin + p * step, arc.begin + (p + 1.0) * step};
          const Vec3 from = circle.point(part.begin), to = circle.point(part.end);
          result.solid_angle -= triangle_solid_angle(start, from, to) +
                                (1.0 - circle.height) * step -
                                triangle_solid_angle(circle.axis, from, to);
          add_line_integrals(circle, part, centre, line);
        }
      }
    }
  }
  result.first = -line.first / 2.0;
  result.second = result.solid_angle / 3.0 * Mat3::Identity() - line.second / 6.0;
  const Mat3 mc = result.first * centre.transpose();
  result.third = -line.third / 12.0 +
                 0.2 * (result.first.dot(centre) * Mat3::Identity() + mc + mc.transpose());
  return result;
}

/// Adds the contribution of a patch: the fluxes of x/3, x (x . n)/4 and x x^T (x . n)/5.
void add_fluxes(const Ball& ball, const PatchIntegrals& patch,
                massprops_detail::SolidMoments& sum) {
  const double r = ball.radius, area = r * r;
  const Vec3& c = ball.centre;
  const double first_c = patch.first.dot(c);
  const Vec3 second_c = patch.second * c;
  sum.volume += area / 3.0 * (first_c + r * patch.solid_angle);
  sum.first +=
      area / 4.0 * (c * (first_c + r * patch.solid_angle) + r * (second_c + r * patch.first));
  const Mat3 cross = c * (second_c + r * patch.first).transpose();
  sum.second += area / 5.0 *
                ((first_c + r * patch.solid_angle) * c * c.transpose() +
                 r * (cross + cross.transpose()) + r * r * (patch.third + r * patch.second));
}

}  // namespace

BallUnionIntegrals integrate_ball_union(std::span<const Ball> balls, const Vec3& origin) {
  const std::vector<Ball> local = separated(balls, origin);
  BallUnionIntegrals result;
  for (std::size_t i = 0; i < local.size(); ++i) {
    const CirclesOnSphere on = circles_on(local, i);
    if (on.hidden) {
      result.areas.push_back(0.0);
      continue;
    }
    const PatchIntegrals patch = integrate_patch(on.circles, local[i].centre);
    result.areas.push_back(local[i].radius * local[i].radius * patch.solid_angle);
    add_fluxes(local[i], patch, result.moments);
  }
  return result;
}

}  // namespace clast::particles_detail
