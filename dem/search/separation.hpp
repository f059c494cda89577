#pragma once
/// How long things near the ground stay apart from it (docs/theory.md, Contact search).
///
/// Two convex things d apart have a plane with unit normal w between them, and stay apart until one
/// has moved d along w. Its way is summed along an axis and perpendicular to it, u and v; that
/// takes at least |w.axis| u + |w x axis| v = d.
#include <algorithm>

namespace clast::dem_detail {

/// How far a part of a block has moved against its ground, summed from visit to visit, m: bounds
/// for all of its points.
struct Displacement {
  double axial = 0.0;  ///< along the axis, up or down
  double transverse = 0.0;   ///< perpendicular to it
  double total = 0.0;

  Displacement operator+(const Displacement& more) const {
    return {axial + more.axial, transverse + more.transverse, total + more.total};
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(axial, transverse, total);
  }
};

/// Not measured again before both ways, each times its number, add up to `until`.
struct SeparationBound {
  double per_axial = 0.0, per_transverse = 0.0;  ///< 1/m
  double until = -1.0;

  /// What is left of 1; not above 0 when due.
  double remaining(const Displacement& displacement) const {
    return until - per_axial * displacement.axial - per_transverse * displacement.transverse;
  }
  bool is_expired(const Displacement& displacement) const { return !(remaining(displacement) > 0.0); }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(per_axial, per_transverse, until);
  }
};

/// What keeps one or many apart from here on: |w.axis|/d and |w x axis|/d, the largest of each.
struct SeparationRates {
  double per_axial = 0.0, per_transverse = 0.0;  ///< 1/m

  void include(const SeparationRates& other) {
    per_axial = std::max(per_axial, other.per_axial);
    per_transverse = std::max(per_transverse, other.per_transverse);
  }
  double sum() const { return per_axial + per_transverse; }
  SeparationBound separation_bound(const Displacement& displacement) const {
    return {per_axial, per_transverse, 1.0 + per_axial * displacement.axial + per_transverse * displacement.transverse};
  }
};

/// Until the first of many that sleep may be due.
class EarliestExpiry {
 public:
  explicit EarliestExpiry(const Displacement& displacement) : displacement_(displacement) {}
  void include(const SeparationBound& one) {
    const double remaining = one.remaining(displacement_);
    expired_ = expired_ || !(remaining > 0.0);
    if (expired_) return;
    // Most of many are bounded by those before, which takes no division.
    SeparationRates& all = separation_;
    if (one.per_axial > all.per_axial * remaining) all.per_axial = one.per_axial / remaining;
    if (one.per_transverse > all.per_transverse * remaining) all.per_transverse = one.per_transverse / remaining;
  }
  SeparationBound separation_bound() const { return expired_ ? SeparationBound() : separation_.separation_bound(displacement_); }

 private:
  const Displacement& displacement_;
  SeparationRates separation_;
  bool expired_ = false;
};

}  // namespace clast::dem_detail
