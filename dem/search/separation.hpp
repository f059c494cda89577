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
struct Way {
  double across = 0.0;  ///< along the axis, up or down
  double along = 0.0;   ///< perpendicular to it
  double whole = 0.0;

  Way operator+(const Way& more) const {
    return {across + more.across, along + more.along, whole + more.whole};
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(across, along, whole);
  }
};

/// Not measured again before both ways, each times its number, add up to `until`.
struct Asleep {
  double per_across = 0.0, per_along = 0.0;  ///< 1/m
  double until = -1.0;

  /// What is left of 1; not above 0 when due.
  double left(const Way& way) const {
    return until - per_across * way.across - per_along * way.along;
  }
  bool due(const Way& way) const { return !(left(way) > 0.0); }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(per_across, per_along, until);
  }
};

/// What keeps one or many apart from here on: |w.axis|/d and |w x axis|/d, the largest of each.
struct Separation {
  double per_across = 0.0, per_along = 0.0;  ///< 1/m

  void include(const Separation& other) {
    per_across = std::max(per_across, other.per_across);
    per_along = std::max(per_along, other.per_along);
  }
  double sum() const { return per_across + per_along; }
  Asleep asleep(const Way& way) const {
    return {per_across, per_along, 1.0 + per_across * way.across + per_along * way.along};
  }
};

/// Until the first of many that sleep may be due.
class FirstDue {
 public:
  explicit FirstDue(const Way& way) : way_(way) {}
  void include(const Asleep& one) {
    const double left = one.left(way_);
    due_ = due_ || !(left > 0.0);
    if (due_) return;
    // Most of many are bounded by those before, which takes no division.
    Separation& all = separation_;
    if (one.per_across > all.per_across * left) all.per_across = one.per_across / left;
    if (one.per_along > all.per_along * left) all.per_along = one.per_along / left;
  }
  Asleep asleep() const { return due_ ? Asleep() : separation_.asleep(way_); }

 private:
  const Way& way_;
  Separation separation_;
  bool due_ = false;
};

}  // namespace clast::dem_detail
