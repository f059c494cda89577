#pragma once
/// Overlap of a contact over a time step, and the resulting normal force.
#include <algorithm>
#include <cmath>

namespace clast {

/// Overlap of a contact over a time step, as a quadratic function of time. It is negative without
/// contact.
struct OverlapPath {
  double duration = 0.0;         ///< s
  double initial_overlap = 0.0;  ///< overlap at the start, m
  double final_overlap = 0.0;    ///< overlap at the end, m
  /// Rate of the overlap at the start, m/s; positive if the overlap grows.
  double initial_rate = 0.0;

  double quadratic_coefficient() const {
    return duration > 0.0
               ? (final_overlap - initial_overlap - initial_rate * duration) / (duration * duration)
               : 0.0;
  }
  double overlap_at(double time) const {
    return initial_overlap + time * (initial_rate + time * quadratic_coefficient());
  }
  double rate_at(double time) const { return initial_rate + 2.0 * time * quadratic_coefficient(); }
  /// Returns the time of the largest or smallest overlap inside the step, s; the end of the step if
  /// there is none.
  double reversal_time() const {
    const double end_rate_times_duration =
        2.0 * (final_overlap - initial_overlap) - initial_rate * duration;
    if (!(initial_rate * end_rate_times_duration < 0.0)) return duration;
    return std::min(-0.5 * initial_rate / quadratic_coefficient(), duration);
  }
  /// Returns the time of zero overlap between two times, s. The overlap must be monotonic between
  /// them and change its sign.
  double zero_crossing(double from, double to) const {
    const double b = quadratic_coefficient();
    const double root =
        std::sqrt(std::max(0.0, initial_rate * initial_rate - 4.0 * b * initial_overlap));
    const double q = -0.5 * (initial_rate + (initial_rate >= 0.0 ? root : -root));
    const double one = q != 0.0 ? initial_overlap / q : from;
    const double other = b != 0.0 ? q / b : one;
    const double middle = 0.5 * (from + to);
    const double nearer = std::abs(one - middle) <= std::abs(other - middle) ? one : other;
    return std::clamp(nearer, from, to);
  }
};

/// Normal force and residual indentation of a contact at the start of a step.
struct NormalForceState {
  double force = 0.0;  ///< at the end of the previous step, N, not negative
  /// Part of the overlap that remains without load, m; only for plastic laws.
  double residual_indentation = 0.0;
};

/// Normal force, work and correction impulse of a contact over a step, per unit of contact weight.
///
/// If a contact begins, reverses or ends inside a step, velocity Verlet integration has a
/// first-order error. `impulse` and `moment` compensate it (docs/theory.md); otherwise they are
/// zero.
struct NormalForceResponse {
  double force = 0.0;                 ///< force at the end of the step, N, never negative
  double work = 0.0;                  ///< work taken from the bodies over the step, J
  double impulse = 0.0;               ///< correction of the momentum, N s
  double moment = 0.0;                ///< correction of the position times mass, N s^2
  double residual_indentation = 0.0;  ///< m; only for plastic laws
};

/// Integrals of the normal force of a contact over a step, summed over intervals.
class ForcePathIntegral {
 public:
  ForcePathIntegral(const OverlapPath& path, double first_force)
      : path_(path), first_force_(first_force) {}

  /// Adds a time interval in which `force(time)` is at most quadratic. Uses two Gauss points.
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
  NormalForceResponse response(double force) const {
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
