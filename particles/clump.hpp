#pragma once
/// Clumps: overlapping balls that replace a body to stated errors.
#include <cstdint>
#include <optional>
#include <vector>

#include "particles/particle_body.hpp"
#include "particles/shape_errors.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast {

struct ClumpOptions {
  ShapeErrors error = {.volume = 0.01, .inertia = 0.02, .surface = 0.02};  ///< largest errors
  /// Number of balls. If given, `error` is not used, and the errors are as small as they get.
  std::optional<std::size_t> balls = {};
  std::size_t max_balls = 400;  ///< largest number of balls for the error
  /// Smallest radius relative to L. It sets the time step of an engine.
  double smallest_sphere = 0.02;
  std::uint64_t seed = 1;  ///< of the random directions of the fit

  void check() const;  ///< throws InputError naming the field and its value
};

/// Balls that replace a body, largest first.
struct Clump {
  std::vector<Ball> balls;  ///< in the frame of the body, m
  ShapeErrors errors;       ///< of the union of the balls
};

/// Fits balls to a body: the fewest that were found for `error`, or as many as `balls` asks for.
///
/// A greedy cover by grown tangent balls is the start of a joint descent on all centres and radii.
/// Its loss is a function of the distances between both surfaces. An affine map of the centres and
/// a common change of the radii give the union the volume, centre and second moments of the body
/// (docs/theory/particles.md). The result depends on the body and the options only.
/// @throws InputError  if an option is invalid
/// @throws GeometryError  if `error` is not reached with `max_balls`; the message states the
///                        errors reached
Clump fit_clump(const ParticleBody& body, const ClumpOptions& options = {});

/// Fits a clump for each of several surface errors to one body, largest error first.
/// @param surface_errors  replace `error.surface`; the other limits change in proportion
std::vector<Clump> fit_clump_levels(const ParticleBody& body, const ClumpOptions& options,
                                    const std::vector<double>& surface_errors);

}  // namespace clast
