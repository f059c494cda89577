#include "dem/contact/elastoplastic_law.hpp"

namespace clast {
namespace {

/// Relative distance within which a force is on a line of the law; event corrections are smaller.
constexpr double kUnloadingLineTolerance = 1e-5;

/// Returns the time at which the overlap passes `level`. It must be monotonic from `from` to `to`.
double time_at(const OverlapPath& path, double level, double from, double to) {
  return OverlapPath{path.duration, path.initial_overlap - level, path.final_overlap - level,
                     path.initial_rate}
      .zero_crossing(from, to);
}

/// Applies the law along monotonic pieces of a path.
class Follower {
 public:
  Follower(const ElastoplasticLaw& law, const OverlapPath& path, const NormalForceState& state)
      : law_(law),
        path_(path),
        integral_(path, state.force),
        force_(state.force),
        residual_indentation_(state.residual_indentation) {}

  void follow(double from, double to) {
    if (!(to > from)) return;
    const double first = path_.overlap_at(from), last = path_.overlap_at(to);
    last > first ? grow(from, to, first, last) : shrink(from, to, first, last);
  }

  NormalForceResponse response() const {
    NormalForceResponse response = integral_.response(force_);
    response.residual_indentation = residual_indentation_;
    return response;
  }

 private:
  void grow(double from, double to, double first, double last) {
    if (!(force_ > 0.0)) {  // no force until the overlap reaches the indentation
      const double touch = std::max(residual_indentation_, 0.0);
      if (last <= touch) return;
      if (first < touch) {
        from = time_at(path_, touch, from, to);
        first = touch;
      }
    }
    const double yield = law_.loading_stiffness;
    if (force_ < yield * first * (1.0 - kUnloadingLineTolerance) &&
        law_.reloading_stiffness > yield) {
      // Reloads up to the overlap at which the force reaches the line of first loading.
      const double meet =
          (law_.reloading_stiffness * first - force_) / (law_.reloading_stiffness - yield);
      const double until = meet < last ? time_at(path_, meet, from, to) : to;
      press(from, until, first, std::min(meet, last), law_.reloading_stiffness);
      from = until;
      first = std::min(meet, last);
    }
    if (last > first) press(from, to, first, last, yield);
    residual_indentation_ =
        std::max(residual_indentation_, last - force_ / law_.unloading_stiffness);
  }

  /// Raises the force from its value at overlap `first`, with the given stiffness.
  void press(double from, double to, double first, double last, double stiffness) {
    const double base = force_;
    integral_.add_interval(
        from, to, [&](double time) { return base + stiffness * (path_.overlap_at(time) - first); });
    force_ = base + stiffness * (last - first);
  }

  void shrink(double from, double to, double first, double last) {
    if (first > residual_indentation_ && force_ > 0.0) {
      const double until =
          last < residual_indentation_ ? time_at(path_, residual_indentation_, from, to) : to;
      integral_.add_interval(from, until, [&](double time) {
        return law_.unloading_stiffness * (path_.overlap_at(time) - residual_indentation_);
      });
    }
    force_ =
        force_ > 0.0 ? law_.unloading_stiffness * std::max(0.0, last - residual_indentation_) : 0.0;
  }

  const ElastoplasticLaw& law_;
  const OverlapPath& path_;
  ForcePathIntegral integral_;
  double force_, residual_indentation_;
};

}  // namespace

ElastoplasticLaw ElastoplasticLaw::on_ground(double stiffness, const GroundParameters& ground) {
  const double unloading_stiffness = stiffness / ground.energy_restitution;
  const double reloading_stiffness =
      ground.energy_restitution < 1.0 ? kReloadingRatio * unloading_stiffness : unloading_stiffness;
  return {stiffness, unloading_stiffness, reloading_stiffness};
}

NormalForceResponse ElastoplasticLaw::integrate(const OverlapPath& path,
                                                const NormalForceState& state,
                                                double /*effective_mass*/) const {
  const double force = state.force, residual_indentation = state.residual_indentation;
  const double deeper = path.final_overlap - path.initial_overlap;
  const auto smooth = [&](double end, double new_dent) {
    return NormalForceResponse{end, 0.5 * (force + end) * deeper, 0.0, 0.0, new_dent};
  };
  const double reversal_time = path.reversal_time();
  if (reversal_time == path.duration) {  // mostly all of the step is on one line
    const bool growing =
        path.initial_rate > 0.0 || (path.initial_rate == 0.0 && path.quadratic_coefficient() > 0.0);
    if (growing && force > 0.0) {
      const bool yields =
          force >= loading_stiffness * path.initial_overlap * (1.0 - kUnloadingLineTolerance);
      const double end = force + (yields ? loading_stiffness : reloading_stiffness) * deeper;
      if (yields || end <= loading_stiffness * path.final_overlap) {
        return smooth(
            end, std::max(residual_indentation, path.final_overlap - end / unloading_stiffness));
      }
    } else if (!growing && path.final_overlap >= residual_indentation && force > 0.0) {
      const double start = unloading_stiffness * (path.initial_overlap - residual_indentation);
      if (std::abs(force - start) <= kUnloadingLineTolerance * force) {
        return smooth(unloading_stiffness * (path.final_overlap - residual_indentation),
                      residual_indentation);
      }
    }
  }
  Follower follower(*this, path, state);
  follower.follow(0.0, reversal_time);
  follower.follow(reversal_time, path.duration);
  return follower.response();
}

}  // namespace clast
