#include "dem/contact/elastoplastic_law.hpp"

namespace clast {
namespace {

/// A force this close to a line of the law, relative to itself, is on it (the correction of events
/// shifts the block by less).
constexpr double kOnLine = 1e-5;

/// When the overlap is at `level`, between two times of a monotonic piece that straddles it.
double time_at(const OverlapPath& path, double level, double from, double to) {
  return OverlapPath{path.duration, path.before - level, path.after - level, path.rate}
      .zero_between(from, to);
}

/// The law followed along monotonic pieces of a path.
class Follower {
 public:
  Follower(const ElastoplasticLaw& law, const OverlapPath& path, const NormalState& past)
      : law_(law), path_(path), integral_(path, past.force), force_(past.force), dent_(past.dent) {}

  void follow(double from, double to) {
    if (!(to > from)) return;
    const double first = path_.at(from), last = path_.at(to);
    last > first ? grow(from, to, first, last) : shrink(from, to, first, last);
  }

  NormalResponse response() const {
    NormalResponse response = integral_.ending_with(force_);
    response.dent = dent_;
    return response;
  }

 private:
  void grow(double from, double to, double first, double last) {
    if (!(force_ > 0.0)) {  // through the dent, or the air, to where it touches
      const double touch = std::max(dent_, 0.0);
      if (last <= touch) return;
      if (first < touch) {
        from = time_at(path_, touch, from, to);
        first = touch;
      }
    }
    const double yield = law_.loading;
    if (force_ < yield * first * (1.0 - kOnLine) && law_.reloading > yield) {
      // To where the rising force meets the line of first loading.
      const double meet = (law_.reloading * first - force_) / (law_.reloading - yield);
      const double until = meet < last ? time_at(path_, meet, from, to) : to;
      press(from, until, first, std::min(meet, last), law_.reloading);
      from = until;
      first = std::min(meet, last);
    }
    if (last > first) press(from, to, first, last, yield);
    dent_ = std::max(dent_, last - force_ / law_.unloading);
  }

  /// From the force at `first`, by a stiffness.
  void press(double from, double to, double first, double last, double stiffness) {
    const double base = force_;
    integral_.add(from, to,
                  [&](double time) { return base + stiffness * (path_.at(time) - first); });
    force_ = base + stiffness * (last - first);
  }

  void shrink(double from, double to, double first, double last) {
    if (first > dent_ && force_ > 0.0) {
      const double until = last < dent_ ? time_at(path_, dent_, from, to) : to;
      integral_.add(from, until,
                    [&](double time) { return law_.unloading * (path_.at(time) - dent_); });
    }
    force_ = force_ > 0.0 ? law_.unloading * std::max(0.0, last - dent_) : 0.0;
  }

  const ElastoplasticLaw& law_;
  const OverlapPath& path_;
  PathIntegral integral_;
  double force_, dent_;
};

}  // namespace

ElastoplasticLaw ElastoplasticLaw::on_ground(double stiffness, const GroundParameters& ground) {
  const double unloading = stiffness / ground.energy_restitution;
  const double reloading = ground.energy_restitution < 1.0 ? kReloading * unloading : unloading;
  return {stiffness, unloading, reloading};
}

NormalResponse ElastoplasticLaw::integrate(const OverlapPath& path, const NormalState& past,
                                           double /*effective_mass*/) const {
  const double force = past.force, dent = past.dent;
  const double deeper = path.after - path.before;
  const auto smooth = [&](double end, double new_dent) {
    return NormalResponse{end, 0.5 * (force + end) * deeper, 0.0, 0.0, new_dent};
  };
  const double turn = path.turn();
  if (turn == path.duration) {  // mostly all of the step is on one line
    const bool growing = path.rate > 0.0 || (path.rate == 0.0 && path.bend() > 0.0);
    if (growing && force > 0.0) {
      const bool yields = force >= loading * path.before * (1.0 - kOnLine);
      const double end = force + (yields ? loading : reloading) * deeper;
      if (yields || end <= loading * path.after) {
        return smooth(end, std::max(dent, path.after - end / unloading));
      }
    } else if (!growing && path.after >= dent && force > 0.0) {
      const double start = unloading * (path.before - dent);
      if (std::abs(force - start) <= kOnLine * force) {
        return smooth(unloading * (path.after - dent), dent);
      }
    }
  }
  Follower follower(*this, path, past);
  follower.follow(0.0, turn);
  follower.follow(turn, path.duration);
  return follower.response();
}

}  // namespace clast
