#pragma once
/// A body stretched until its smallest box has the sides that are wanted, in ratio.
#include "shapes/oriented_box.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Ratios of the sides L >= I >= S of a box: the form of a body, without its size.
struct BoxRatios {
  double i_l = 1.0;  ///< I/L
  double s_l = 1.0;  ///< S/L

  /// @throws InputError  not 0 < S/L <= I/L <= 1; names the field and its value
  void check() const;
};

BoxRatios box_ratios(const OrientedBox& box);

/// The larger relative difference of I/L and of S/L from those of the target.
double ratio_difference(const BoxRatios& ratios, const BoxRatios& target);

/// What `stretch_to_ratios` found.
struct StretchedBody {
  SpheroPolyhedron body;
  Vec3 stretch = Vec3::Ones();    ///< principal stretches of the core, descending; product 1
  double ratio_difference = 0.0;  ///< `ratio_difference` that is left
};

/// The body whose core is stretched so that its smallest box has the ratios of `target`, nearly at
/// the core's volume. The radius keeps its share of S. A body that has these ratios is returned as
/// it is, to the bit; no core crosses itself that did not before.
///
/// The box of a stretched body is in general not the stretched box: its axes turn. So the map that
/// gives the box its target is applied to the body, the smallest box is found anew, and so on. Each
/// such map keeps the volume and takes the box to a box around the new body, so that the volume of
/// the smallest box never grows, and the ratios converge (docs/theory.md). The maps together are a
/// stretch and a turn; only the stretch is applied.
/// @throws InputError     as `BoxRatios::check`
/// @throws GeometryError  a ball or a capsule, which has no core to stretch; a flat core
StretchedBody stretch_to_ratios(const SpheroPolyhedron& body, const BoxRatios& target);

}  // namespace clast
