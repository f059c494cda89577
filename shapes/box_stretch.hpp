#pragma once
/// Stretching of bodies so that their smallest box has given side ratios.
#include "shapes/oriented_box.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Side ratios of a box with sides L >= I >= S.
struct BoxRatios {
  double i_l = 1.0;  ///< I/L
  double s_l = 1.0;  ///< S/L

  /// Checks the ratios.
  /// @throws InputError  unless 0 < S/L <= I/L <= 1; the message gives field and value
  void check() const;
};

BoxRatios box_ratios(const OrientedBox& box);

/// Returns the larger of the relative differences of I/L and S/L from the target.
double max_ratio_difference(const BoxRatios& ratios, const BoxRatios& target);

struct StretchedBody {
  SpheroPolyhedron body;
  Vec3 principal_stretches =
      Vec3::Ones();  ///< principal stretches of the core, descending; product 1
  double max_ratio_difference =
      0.0;  ///< remaining relative difference of the ratios from the target
};

/// Stretches the core so that the smallest box has the ratios `target`. The volume of the core
/// hardly changes, and the ratio of radius to S is kept. A body that has these ratios is returned
/// unchanged. No new self-intersections arise.
///
/// The smallest box of a stretched body is generally not the stretched box, because its axes
/// rotate. Therefore two steps are repeated until convergence: the linear map that gives the box
/// its target ratios is applied, and the smallest box is computed again (docs/theory.md). Of the
/// combined map, the body gets only the stretch, not the rotation.
/// @throws InputError  as `BoxRatios::check`
/// @throws GeometryError  if the body is a ball or capsule or has a flat core
StretchedBody stretch_to_ratios(const SpheroPolyhedron& body, const BoxRatios& target);

}  // namespace clast
