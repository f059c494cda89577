#pragma once
/// Separation bounds: limits of the displacement of block features before contact (docs/theory.md,
/// Contact search).
///
/// Two convex bodies at distance d have a separating plane with unit normal w. They stay separated
/// until one has moved by d along w. Displacements are accumulated along an axis (u) and
/// perpendicular to it (v). Contact is impossible while |w.axis| u + |w x axis| v < d.
#include <algorithm>

namespace clast::dem_detail {

/// Upper bounds of the accumulated displacement of any point of a block part, m.
struct AccumulatedDisplacement {
  double axial = 0.0;       ///< displacement along the axis, in either direction
  double transverse = 0.0;  ///< displacement perpendicular to the axis
  double total = 0.0;

  AccumulatedDisplacement operator+(const AccumulatedDisplacement& more) const {
    return {axial + more.axial, transverse + more.transverse, total + more.total};
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(axial, transverse, total);
  }
};

/// Separation bound. Contact is impossible while `axial_coefficient` times axial displacement plus
/// `transverse_coefficient` times transverse displacement is below `until`. Otherwise, the bound
/// has expired.
struct SeparationBound {
  double axial_coefficient = 0.0, transverse_coefficient = 0.0;  ///< 1/m
  double until = -1.0;

  /// Returns the difference between `until` and the weighted displacement; not positive if the
  /// bound has expired.
  double remaining(const AccumulatedDisplacement& displacement) const {
    return until - axial_coefficient * displacement.axial -
           transverse_coefficient * displacement.transverse;
  }
  bool is_expired(const AccumulatedDisplacement& displacement) const {
    return !(remaining(displacement) > 0.0);
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(axial_coefficient, transverse_coefficient, until);
  }
};

/// Coefficients of a separation bound for axial and transverse displacement. They are the
/// components of the separating normal divided by the distance, or maxima over several bounds.
struct SeparationCoefficients {
  double axial_coefficient = 0.0, transverse_coefficient = 0.0;  ///< 1/m

  void include(const SeparationCoefficients& other) {
    axial_coefficient = std::max(axial_coefficient, other.axial_coefficient);
    transverse_coefficient = std::max(transverse_coefficient, other.transverse_coefficient);
  }
  /// Includes the coefficients of a separating normal, m apart. Most distances are too large to
  /// count; the comparison needs no division.
  /// @param axial, transverse  components of the unit normal
  /// @param distance  positive, m
  void include_distance(double axial, double transverse, double distance) {
    if (axial > axial_coefficient * distance) axial_coefficient = axial / distance;
    if (transverse > transverse_coefficient * distance)
      transverse_coefficient = transverse / distance;
  }
  SeparationBound separation_bound(const AccumulatedDisplacement& displacement) const {
    return {axial_coefficient, transverse_coefficient,
            1.0 + axial_coefficient * displacement.axial +
                transverse_coefficient * displacement.transverse};
  }
};

/// Combines separation bounds into one, which expires at the latest when the first of them expires.
class EarliestBoundExpiry {
 public:
  explicit EarliestBoundExpiry(const AccumulatedDisplacement& displacement)
      : displacement_(displacement) {}
  void include(const SeparationBound& one) {
    const double remaining = one.remaining(displacement_);
    expired_ = expired_ || !(remaining > 0.0);
    if (expired_) return;
    separation_.include_distance(one.axial_coefficient, one.transverse_coefficient, remaining);
  }
  SeparationBound separation_bound() const {
    return expired_ ? SeparationBound() : separation_.separation_bound(displacement_);
  }

 private:
  const AccumulatedDisplacement& displacement_;
  SeparationCoefficients separation_;
  bool expired_ = false;
};

}  // namespace clast::dem_detail
