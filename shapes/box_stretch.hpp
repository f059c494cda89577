#pragma once
/// Stretching of bodies to given side ratios of their smallest box.
#include "shapes/oriented_box.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Side ratios of a box with L >= I >= S.
struct BoxRatios {
  double i_l = 1.0;  ///< I/L
  double s_l = 1.0;  ///< S/L

  /// Checks the ratios.
  /// @throws InputError  unless 0 < S/L <= I/L <= 1; names field and value
  void check() const;
};

BoxRatios box_ratios(const OrientedBox& box);

/// Returns the larger relative difference of I/L and S/L from the target.
double ratio_difference(const BoxRatios& ratios,
                        const BoxRatios& target);  ///< remaining `ratio_difference`

struct StretchedBody {
  SpheroPolyhedron body;
  Vec3 stretch = Vec3::Ones();    ///< principal stretches of the core, descending; product 1
  double ratio_difference = 0.0;  ///< `ratio_difference` that is left
};

/// Stretches the core so that the smallest box has the ratios of `target`, nearly at constant core
/// volume. The ratio of radius to S is kept. A body with these ratios is returned unchanged, and no
/// new self-intersections arise.
///
/// The smallest box of a stretched body is generally not the stretched box, because its axes
/// rotate. Therefore the map that gives the box its target ratios is applied and the smallest box
/// computed again, until convergence: each map keeps the volume and gives a box around the new
/// body, so that the volume of the smallest box never grows (docs/theory.md). Only the stretch of
/// the combined map is applied.
/// @throws InputError  as `BoxRatios::check`
/// @throws GeometryError  for balls, capsules and flat cores
StretchedBody stretch_to_ratios(const SpheroPolyhedron& body, const BoxRatios& target);

}  // namespace clast
