#include "particles/detail/clump_problem.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace clast::particles_detail {

namespace {

// All lengths are relative to L.
constexpr std::size_t kSurfaceSamples = 6000, kDenseSamples = 25000, kInteriorSamples = 1500,
                      kCandidates = 2000;
constexpr double kFieldSpacing = 0.008;
constexpr double kMargin = 0.15;  ///< of the distance field around the body
constexpr int kShrinkingSteps = 40;
constexpr double kShrinkingTolerance = 1e-4;
constexpr double kWidestGrowth = 0.3;  ///< growth of balls that covers any body by few balls
constexpr double kGrowthPrecision = 0.04;
constexpr double kGrowthFactor = 1.2;  ///< of the bracket around a guess

Bounds enlarged(Bounds box, double margin) {
  box.low.array() -= margin;
  box.high.array() += margin;
  return box;
}

std::vector<Vec3> lattice_inside(const BodySurface& body, double volume) {
  const double step = std::cbrt(volume / static_cast<double>(kInteriorSamples));
  const Bounds& box = body.box();
  std::vector<Vec3> points;
  std::uint32_t hint = 0;
  for (double z = box.low.z() + 0.5 * step; z < box.high.z(); z += step) {
    for (double y = box.low.y() + 0.5 * step; y < box.high.y(); y += step) {
      for (double x = box.low.x() + 0.5 * step; x < box.high.x(); x += step) {
        const Vec3 point(x, y, z);
        const BodySurface::Closest found = body.closest(point, hint);
        hint = found.triangle;
        if (found.distance < 0.0) points.push_back(point);
      }
    }
  }
  return points;
}

std::vector<TangentBall> tangent_balls(const std::vector<Vec3>& contacts, const BodySurface& body) {
  std::vector<TangentBall> balls;
  for (const Vec3& contact : contacts) {
    const Ball ball = shrink_tangent_ball(body, contact, body.closest(contact).outward, 0.5);
    if (ball.radius > 0.0) balls.push_back({ball, contact});
  }
  return balls;
}

/// Which samples each candidate covers, one bit for each.
class Cover {
 public:
  Cover(const ClumpProblem& problem, double growth) {
    const std::size_t samples = problem.surface.size() + problem.interior.size();
    words_ = (samples + 63) / 64;
    open_.assign(words_, 0);
    for (std::size_t s = 0; s < samples; ++s) open_[s / 64] |= std::uint64_t{1} << (s % 64);
    bits_.assign(problem.balls.size() * words_, 0);
    for (std::size_t b = 0; b < problem.balls.size(); ++b) {
      const Ball& ball = problem.balls[b].ball;
      const double reach = ball.radius + 2.0 * growth, squared = reach * reach;
      std::size_t s = 0;
      for (const std::vector<Vec3>* points : {&problem.surface, &problem.interior}) {
        for (const Vec3& point : *points) {
          const bool covered = (point - ball.centre).squaredNorm() <= squared;
          bits_[b * words_ + s / 64] |= std::uint64_t{covered} << (s % 64);
          ++s;
        }
      }
    }
  }

  /// Takes the ball that covers most open samples until all are covered or `count` are taken.
  /// @return indices of the balls
  std::vector<std::size_t> take(std::size_t count) {
    std::vector<std::size_t> gains(bits_.size() / words_, std::numeric_limits<std::size_t>::max());
    std::vector<std::size_t> taken;
    while (taken.size() < count) {
      std::size_t best = 0, best_gain = 0;
      for (std::size_t b = 0; b < gains.size(); ++b) {
        if (gains[b] <= best_gain) continue;  // gains only fall
        gains[b] = gain(b);
        if (gains[b] > best_gain) best = b, best_gain = gains[b];
      }
      if (best_gain == 0) return taken;
      taken.push_back(best);
      for (std::size_t w = 0; w < words_; ++w) open_[w] &= ~bits_[best * words_ + w];
    }
    return taken;
  }

  bool is_complete() const {
    return std::all_of(open_.begin(), open_.end(), [](std::uint64_t word) { return word == 0; });
  }

 private:
  std::size_t gain(std::size_t b) const {
    std::size_t sum = 0;
    for (std::size_t w = 0; w < words_; ++w) {
      sum += static_cast<std::size_t>(std::popcount(open_[w] & bits_[b * words_ + w]));
    }
    return sum;
  }

  std::size_t words_;
  std::vector<std::uint64_t> open_, bits_;
};

std::vector<Ball> grown_balls(const ClumpProblem& problem, const std::vector<std::size_t>& chosen,
                              double growth) {
  std::vector<Ball> balls;
  for (const std::size_t b : chosen) {
    const Ball& ball = problem.balls[b].ball;
    balls.push_back({ball.centre, ball.radius + growth});
  }
  return balls;
}

}  // namespace

ClumpProblem::ClumpProblem(TriangleMesh solid, double radius,
                           const massprops_detail::SolidMoments& unit_moments)
    : body(std::move(solid), radius),
      moments(unit_moments),
      field(body, enlarged(body.box(), kMargin), kFieldSpacing),
      surface(body.sample(kSurfaceSamples)),
      dense(body.sample(kDenseSamples)),
      interior(lattice_inside(body, moments.volume)) {
  std::vector<Vec3> contacts;
  for (std::size_t i = 0; i < surface.size(); i += kSurfaceSamples / kCandidates) {
    contacts.push_back(surface[i]);
  }
  balls = tangent_balls(contacts, body);
  for (const Vec3& corner : body.corners(kDenseSamples)) dense.push_back(corner);
}

Ball shrink_tangent_ball(const BodySurface& body, const Vec3& contact, const Vec3& normal,
                         double largest) {
  double radius = largest;
  std::uint32_t hint = 0;
  for (int step = 0; step < kShrinkingSteps; ++step) {
    const Vec3 centre = contact - radius * normal;
    const BodySurface::Closest found = body.closest(centre, hint);
    hint = found.triangle;
    if (std::abs(found.distance) >= radius * (1.0 - kShrinkingTolerance)) break;
    const Vec3 chord = contact - found.foot(centre);
    const double depth = normal.dot(chord);
    if (!(depth > 0.0)) break;
    radius =
        std::min(radius * (1.0 - 0.5 * kShrinkingTolerance), chord.squaredNorm() / (2.0 * depth));
  }
  return {contact - radius * normal, radius};
}

std::vector<Ball> cover_greedily(const ClumpProblem& problem, std::size_t count, double guess) {
  double low = 0.0, high = kWidestGrowth;
  std::vector<std::size_t> best = Cover(problem, high).take(count);
  double growth = std::min(guess, 0.5 * high);
  while (high - low > kGrowthPrecision * high) {
    Cover cover(problem, growth);
    std::vector<std::size_t> taken = cover.take(count);
    if (cover.is_complete()) {
      high = growth;
      best = std::move(taken);
    } else {
      low = growth;
    }
    // The bracket is first widened around the guess, then halved.
    growth = 0.5 * (low + high);
    if (low == 0.0) growth = std::max(growth, high / kGrowthFactor);
    if (high == kWidestGrowth) growth = std::min(growth, low * kGrowthFactor);
  }
  return grown_balls(problem, best, high);
}

std::vector<Ball> cover_completely(const ClumpProblem& problem, double growth) {
  return grown_balls(problem, Cover(problem, growth).take(problem.balls.size()), growth);
}

}  // namespace clast::particles_detail
