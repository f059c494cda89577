#pragma once
/// The overlap of a contact over one time step, and the response of a law to it.
#include <algorithm>
#include <cmath>

namespace clast {

/// Overlap as a parabola in time, as the position in a velocity Verlet step is. Negative: not
/// touching.
struct OverlapPath {
  double duration = 0.0;  ///< s
  double before = 0.0;    ///< overlap at the beginning, m
  double after = 0.0;     ///< at the end, m
  double rate = 0.0;      ///< at the beginning, m/s; positive: getting deeper

  double quadratic_coefficient() const {
    return duration > 0.0 ? (after - before - rate * duration) / (duration * duration) : 0.0;
  }
  double overlap_at(double time) const {
    return before + time * (rate + time * quadratic_coefficient());
  }
  double rate_at(double time) const { return rate + 2.0 * time * quadratic_coefficient(); }
  /// When the overlap turns from growing to shrinking or back; the end when it does not.
  double reversal_time() const {
    const double end_rate_times_duration = 2.0 * (after - before) - rate * duration;
    if (!(rate * end_rate_times_duration < 0.0)) return duration;
    return std::min(-0.5 * rate / quadratic_coefficient(), duration);
  }
  /// When the overlap is zero, between two times of a monotonic piece that straddles it.
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

/// What a law knows of a contact when a step begins.
struct NormalState {
  double force = 0.0;  ///< N
  double residual_indentation =
      0.0;  ///< part of the overlap that stays, m; only under a law that keeps one
};

/// The response of a law to a path, per unit of weight.
///
/// A Verlet step takes the force at its beginning as constant for the position, and the mean of the
/// forces at both ends for the velocity. Where a law starts, reverses or ends inside the step that
/// is wrong to first order; `impulse` and `moment` are what is missing then (docs/theory.md), else
/// zero.
struct NormalResponse {
  double force = 0.0;    ///< at the end, N, never negative
  double work = 0.0;     ///< taken from the bodies along the path, J
  double impulse = 0.0;  ///< integral of the force, less the mean of both ends times the step, N s
  double moment = 0.0;   ///< integral of force times time left, less that of the first force, N s^2
  double residual_indentation = 0.0;  ///< at the end, m
};

/// Integrals of a force along a path, piece by piece.
class PathIntegral {
 public:
  PathIntegral(const OverlapPath& path, double first_force)
      : path_(path), first_force_(first_force) {}

  /// Adds a piece on which `force(time)` is at most quadratic: two Gauss points are exact.
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
  /// The response when the path ends with this force.
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
