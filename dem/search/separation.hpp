#pragma once
/// Separation bounds of features near the ground (docs/theory.md, Contact search).
///
/// Two convex bodies at distance d have a separating plane with unit normal w. They stay separated
/// until one has moved by d along w. Displacements are accumulated along an axis (u) and
/// perpendicular to it (v). Contact is impossible while |w.axis| u + |w x axis| v < d.
#include <algorithm>

namespace clast::dem_detail {

/// Upper bounds of the accumulated displacement of all points of a block part, m.
struct Displacement {
  double axial = 0.0;       ///< along the axis, in either direction
  double transverse = 0.0;  ///< perpendicular to the axis
  double total = 0.0;

  Displacement operator+(const Displacement& more) const {
    return {axial + more.axial, transverse + more.transverse, total + more.total};
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(axial, transverse, total);
  }
};

/// Separation bound. Contact is impossible while per_axial times the axial displacement plus
/// per_transverse times the transverse displacement is below `until`.
struct SeparationBound {
  double per_axial = 0.0, per_transverse = 0.0;  ///< 1/m
  double until = -1.0;

  /// Returns the remaining margin until the bound expires; not positive if it has expired.
  double remaining(const Displacement& displacement) const {
    return until - per_axial * displacement.axial - per_transverse * displacement.transverse;
  }
  bool is_expired(const Displacement& displacement) const {
    return !(remaining(displacement) > 0.0);
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(per_axial, per_transverse, until);
  }
};

/// Coefficients of separation bounds, |w.axis|/d and |w x axis|/d, or maxima of several.
struct SeparationCoefficients {
  double per_axial = 0.0, per_transverse = 0.0;  ///< 1/m

  void include(const SeparationCoefficients& other) {
    per_axial = std::max(per_axial, other.per_axial);
    per_transverse = std::max(per_transverse, other.per_transverse);
  }
  double sum() const { return per_axial + per_transverse; }
  SeparationBound separation_bound(const Displacement& displacement) const {
    return {per_axial, per_transverse,
            1.0 + per_axial * displacement.axial + per_transverse * displacement.transverse};
  }
};

/// Earliest expiry of several separation bounds.
class EarliestExpiry {
 public:
  explicit EarliestExpiry(const Displacement& displacement) : displacement_(displacement) {}
  void include(const SeparationBound& one) {
    const double remaining = one.remaining(displacement_);
    expired_ = expired_ || !(remaining > 0.0);
    if (expired_) return;
    // Most bounds are weaker than those before them; the comparison needs no division.
    SeparationCoefficients& all = separation_;
    if (one.per_axial > all.per_axial * remaining) all.per_axial = one.per_axial / remaining;
    if (one.per_transverse > all.per_transverse * remaining)
      all.per_transverse = one.per_transverse / remaining;
  }
  SeparationBound separation_bound() const {
    return expired_ ? SeparationBound() : separation_.separation_bound(displacement_);
  }

 private:
  const Displacement& displacement_;
  SeparationCoefficients separation_;
  bool expired_ = false;
};

}  // namespace clast::dem_detail
