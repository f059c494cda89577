#pragma once
/// Overlap of a contact over a time step, and the response of a law.
#include <algorithm>
#include <cmath>

namespace clast {

/// Overlap over a step as a parabola in time, like the position in a velocity Verlet step. It is
/// negative without contact.
struct OverlapPath {
  double duration = 0.0;  ///< s
  double before = 0.0;    ///< at the start, m
  double after = 0.0;     ///< at the end, m
  double rate = 0.0;      ///< at the start, m/s; positive if the overlap grows

  double quadratic_coefficient() const {
    return duration > 0.0 ? (after - before - rate * duration) / (duration * duration) : 0.0;
  }
  double overlap_at(double time) const {
    return before + time * (rate + time * quadratic_coefficient());
  }
  double rate_at(double time) const { return rate + 2.0 * time * quadratic_coefficient(); }
  /// Returns the time of largest or smallest overlap, s; the end of the step if it has none inside.
  double reversal_time() const {
    const double end_rate_times_duration = 2.0 * (after - before) - rate * duration;
    if (!(rate * end_rate_times_duration < 0.0)) return duration;
    return std::min(-0.5 * rate / quadratic_coefficient(), duration);
  }
  /// Returns the time of zero overlap, s. It must lie between the times, with monotonic overlap.
  double zero_crossing(double from, double to) const {
    const double b = quadratic_coefficient();
    const double root = std::sqrt(std::max(0.0, rate * rate - 4.0 * b * before));
    const double q = -0.5 * (rate + (rate >= 0.0 ? root : -root));
    const double one = q != 0.0 ? before / q : from;
    const double other = b != 0.0 ? q / b : one;
    const double middle = 0.5 * (from + to);
    const double nearer = std::abs(one - middle) <= std::abs(other - middle) ? one : other;
    return std::clamp(nearer, from, to);
  }
};

/// State of a contact at the start of a step, as passed to a law.
struct NormalState {
  double force = 0.0;  ///< at the end of the previous step, N, not negative
  double residual_indentation =
      0.0;  ///< part of the overlap that remains without load, m; only for plastic laws
};

/// Response of a law to a path, per unit weight.
///
/// A Verlet step uses the initial force for the position, and the mean of initial and final force
/// for the velocity. If a contact begins, reverses or ends inside the step, this has a first-order
/// error. `impulse` and `moment` compensate it (docs/theory.md); otherwise they are zero.
struct NormalResponse {
  double force = 0.0;    ///< at the end of the step, N, never negative
  double work = 0.0;     ///< taken from the bodies along the path, J
  double impulse = 0.0;  ///< integral of the force, minus (initial + final force)/2 times step, N s
  double moment =
      0.0;  ///< integral of force times remaining time, minus the same for the initial force, N s^2
  double residual_indentation = 0.0;  ///< m; only for plastic laws
};

/// Piecewise integrals of a force along a path.
class PathIntegral {
 public:
  PathIntegral(const OverlapPath& path, double first_force)
      : path_(path), first_force_(first_force) {}

  /// Adds a piece of the path on which `force(time)` is at most quadratic. Uses two Gauss points.
  template <class Force>
  void add_interval(double from, double to, const Force& force) {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    for (const double node : {-0.5773502691896257, 0.5773502691896257}) {
      const double time = middle + node * half;
      const double weighted_force = half * force(time);
      impulse_ += weighted_force;
      moment_ += weighted_force * (path_.duration - time);
      work_ += weighted_force * path_.rate_at(time);
    }
  }
  NormalResponse response(double force) const {
    const double step = path_.duration;
    return {force, work_, impulse_ - 0.5 * step * (first_force_ + force),
            moment_ - 0.5 * step * step * first_force_};
  }

 private:
  const OverlapPath& path_;
  double first_force_;
  double impulse_ = 0.0, moment_ = 0.0, work_ = 0.0;
};

}  // namespace clast
