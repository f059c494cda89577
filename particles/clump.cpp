#include "particles/clump.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "particles/ball_union.hpp"
#include "particles/detail/clump_descent.hpp"
#include "particles/detail/moment_correction.hpp"
#include "particles/detail/surface_distance.hpp"

namespace clast {

using namespace particles_detail;

namespace {

constexpr std::size_t kMostBalls = 2000;
/// The surface error of a usual stone is about 0.05 (20 / N)^0.65 for N balls.
constexpr double kUsualError = 0.05, kUsualCount = 20.0, kErrorExponent = 0.65;
/// Growth of the greedy cover over the surface error of the fit that starts from it.
constexpr double kUsualGrowth = 0.75;
/// The same for the first fit for an error, which has fewer balls than are needed.
constexpr double kFirstGrowth = 0.95;
/// Part of the missing balls, as the surface error predicts them, that is added at once.
constexpr double kMissingPart = 0.5;
/// The descent aims at a surface error smaller than asked for by this factor.
constexpr double kHingeMargin = 0.93;
constexpr double kStep = 0.04;  ///< part of the balls removed or added at once
constexpr double kRestart = 0.25;
constexpr int kFinalCorrections = 5;

/// Moments of a body in units of L about its centre of mass.
massprops_detail::SolidMoments unit_moments(const ParticleBody& body) {
  massprops_detail::SolidMoments moments;
  moments.volume = body.mass.volume / std::pow(body.length, 3.0);
  const Mat3 inertia =
      body.mass.inertia / body.mass.mass * moments.volume / (body.length * body.length);
  moments.second = 0.5 * inertia.trace() * Mat3::Identity() - inertia;
  return moments;
}

TriangleMesh unit_solid(const ParticleBody& body) {
  TriangleMesh mesh = body.mesh;
  for (Vec3& vertex : mesh.vertices) vertex = (vertex - body.mass.centre) / body.length;
  return mesh;
}

/// Number of balls to add at once to `count` balls with a surface error.
std::size_t missing_balls(std::size_t count, double surface, const ShapeErrors& limits) {
  const double ratio = std::pow(surface / limits.surface, 1.0 / kErrorExponent);
  return static_cast<std::size_t>(kMissingPart * static_cast<double>(count) *
                                  std::clamp(ratio - 1.0, 0.0, kRestart));
}

std::size_t step_of(std::size_t count) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(kStep * static_cast<double>(count)));
}

/// Fits of one body, in units of L about its centre of mass.
class ClumpFit {
 public:
  ClumpFit(const ParticleBody& body, const ClumpOptions& options)
      : options_(options),
        problem_(unit_solid(body), body.radius / body.length, unit_moments(body)),
        mass_(massprops_detail::to_mass_properties(problem_.moments, Vec3::Zero(), Mat3::Identity(),
                                                   1.0)),
        samples_(sample_body(problem_.body, kFineSpacing)) {}

  Clump fit_count(std::size_t count) {
    ClumpDescent descent = start(count);
    finish(descent);
    polish(descent, kHingeMargin * descent.worst_distance());
    Clump clump = {corrected(descent.balls()), {}};
    clump.errors = mass_errors(clump.balls);
    clump.errors.surface = surface_distance(clump.balls, kFineSpacing).value;
    return clump;
  }

  /// Fits the fewest balls within `limits`. The last element is within them, unless more than
  /// `max_balls` are needed.
  Clump fit_error(const ShapeErrors& limits) {
    std::vector<Ball> cover = cover_completely(problem_, kFirstGrowth * limits.surface);
    const std::size_t count = std::min(cover.size(), options_.max_balls);
    ClumpDescent descent = cover.size() > count ? start(count) : start(std::move(cover), count);
    finish(descent);
    polish(descent, kHingeMargin * limits.surface);
    Clump clump = grown(descent, judged(descent, limits), limits);
    while (clump.errors.is_within(limits) && descent.balls().size() > 1) {
      descent.remove_least_balls(step_of(descent.balls().size()));
      refit(descent, limits);
      Clump smaller = judged(descent, limits);
      if (!smaller.errors.is_within(limits)) break;
      clump = std::move(smaller);
    }
    return clump;
  }

 private:
  ClumpDescent start(std::size_t count) {
    const double error =
        kUsualError * std::pow(kUsualCount / static_cast<double>(count), kErrorExponent);
    return start(cover_greedily(problem_, count, kUsualGrowth * error), count);
  }

  /// Starts from balls that cover the body, and adds balls up to `count`.
  ClumpDescent start(std::vector<Ball> cover, std::size_t count) {
    ClumpDescent descent(problem_, std::move(cover), options_.smallest_sphere, options_.seed);
    descent.run(50, {.doublings = 1}, 6e-3, 4e-3);
    descent.move_hidden_balls();
    descent.add_balls(count - descent.balls().size());
    descent.run(50, {.doublings = 2}, 4e-3, 2e-3);
    return descent;
  }

  static void finish(ClumpDescent& descent) {
    descent.move_hidden_balls();
    descent.run(120, {.doublings = 3}, 3e-3, 1e-3);
    descent.move_hidden_balls();
    descent.run(80, {.doublings = 3}, 1.5e-3, 5e-4);
  }

  static void polish(ClumpDescent& descent, double tolerance) {
    descent.run(60, {.scale = tolerance, .hinge = true}, 8e-4, 1e-4);
  }

  static void refit(ClumpDescent& descent, const ShapeErrors& limits) {
    descent.run(60, {.doublings = 3}, 2e-3, 5e-4);
    polish(descent, kHingeMargin * limits.surface);
  }

  /// Adds balls until the limits are kept; starts anew after each `kRestart` part of them.
  Clump grown(ClumpDescent& descent, Clump clump, const ShapeErrors& limits) {
    std::size_t started = descent.balls().size();
    while (!clump.errors.is_within(limits) && descent.balls().size() < options_.max_balls) {
      const std::size_t count = descent.balls().size();
      const std::size_t next = std::min(
          count + std::max(step_of(count), missing_balls(count, clump.errors.surface, limits)),
          options_.max_balls);
      if (static_cast<double>(next) > (1.0 + kRestart) * static_cast<double>(started)) {
        descent = start(next);
        finish(descent);
        started = next;
      } else {
        descent.add_balls(next - count);
      }
      refit(descent, limits);
      clump = judged(descent, limits);
    }
    return clump;
  }

  std::vector<Ball> corrected(std::vector<Ball> balls) const {
    for (int i = 0; i < kFinalCorrections; ++i) {
      correct_moments(balls, problem_.moments, options_.smallest_sphere);
    }
    return balls;
  }

  /// Corrected balls with their errors. Spheres are sampled coarsely first. If the largest
  /// distance is too large and at a point of the body, that point is added to the dense samples.
  Clump judged(const ClumpDescent& descent, const ShapeErrors& limits) {
    Clump clump = {corrected(descent.balls()), {}};
    clump.errors = mass_errors(clump.balls);
    for (const double spacing : {kCoarseSpacing, kFineSpacing}) {
      const LargestDistance distance = surface_distance(clump.balls, spacing);
      clump.errors.surface = distance.value;
      if (clump.errors.is_within(limits)) continue;
      if (distance.is_on_body) problem_.dense.push_back(distance.place);
      break;
    }
    return clump;
  }

  ShapeErrors mass_errors(const std::vector<Ball>& balls) const {
    return compare_mass_properties(ball_union_mass_properties(balls, 1.0), mass_);
  }

  LargestDistance surface_distance(const std::vector<Ball>& balls, double spacing) const {
    return measure_surface_distance(problem_.body, samples_, balls, spacing);
  }

  const ClumpOptions& options_;
  ClumpProblem problem_;
  MassProperties mass_;
  std::vector<Vec3> samples_;  ///< of the body, finer than those of the descent
};

/// A clump in the frame of the body, largest ball first.
Clump in_body_frame(Clump clump, const ParticleBody& body) {
  for (Ball& ball : clump.balls) {
    ball = {body.mass.centre + body.length * ball.centre, body.length * ball.radius};
  }
  std::stable_sort(clump.balls.begin(), clump.balls.end(),
                   [](const Ball& a, const Ball& b) { return a.radius > b.radius; });
  return clump;
}

void check_reached(const Clump& clump, const ShapeErrors& limits, const ClumpOptions& options) {
  if (clump.errors.is_within(limits)) return;
  throw GeometryError(
      "the errors asked for (" + format_shape_errors(limits) + ") are not reached with " +
      format_count(options.max_balls, "sphere") +
      ", the most allowed by `max_spheres`; reached: " + format_shape_errors(clump.errors) +
      ". Allow more spheres, smaller ones (`smallest_sphere`) or larger errors");
}

}  // namespace

void ClumpOptions::check() const {
  error.check();
  const auto check_count = [](const char* name, std::size_t count) {
    if (count >= 1 && count <= kMostBalls) return;
    throw InputError(std::string("`") + name + "` = " + std::to_string(count) +
                     ": must be from 1 to " + std::to_string(kMostBalls));
  };
  if (balls) check_count("equal_spheres", *balls);
  check_count("max_spheres", max_balls);
  if (!(smallest_sphere >= 0.001 && smallest_sphere <= 0.2)) {
    throw InputError("`smallest_sphere` = " + format_significant(smallest_sphere, 6) +
                     ": must be from 0.001 to 0.2 of the length L");
  }
}

Clump fit_clump(const ParticleBody& body, const ClumpOptions& options) {
  options.check();
  ClumpFit fit(body, options);
  if (options.balls) return in_body_frame(fit.fit_count(*options.balls), body);
  Clump clump = fit.fit_error(options.error);
  check_reached(clump, options.error, options);
  return in_body_frame(std::move(clump), body);
}

std::vector<Clump> fit_clump_levels(const ParticleBody& body, const ClumpOptions& options,
                                    const std::vector<double>& surface_errors) {
  options.check();
  ClumpFit fit(body, options);
  std::vector<Clump> clumps;
  for (const double surface : surface_errors) {
    const double factor = surface / options.error.surface;
    const ShapeErrors limits = {std::max(1.0, factor) * options.error.volume,
                                std::max(1.0, factor) * options.error.inertia, surface};
    limits.check();
    Clump clump = fit.fit_error(limits);
    check_reached(clump, limits, options);
    clumps.push_back(in_body_frame(std::move(clump), body));
  }
  return clumps;
}

}  // namespace clast
