#pragma once
/// Errors of a simpler shape that replaces a body.
#include <span>
#include <string>

#include "massprops/mass_properties.hpp"
#include "particles/particle_body.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast {

/// Relative errors of a shape against the body that it replaces.
struct ShapeErrors {
  double volume = 0.0;  ///< |V' - V| / V
  double inertia =
      0.0;  ///< largest |I'_ij - I_ij| at equal mass, over the smallest principal moment
  double surface = 0.0;  ///< Hausdorff distance of the surfaces over L

  bool is_within(const ShapeErrors& limits) const {
    return volume <= limits.volume && inertia <= limits.inertia && surface <= limits.surface;
  }
  void check() const;  ///< throws InputError unless all are positive and below 1
};

/// Formats errors: "volume 0.1 %, inertia 0.4 %, surface 1.9 %".
std::string format_shape_errors(const ShapeErrors& errors);

/// Compares volume and inertia tensor of a shape with the true ones. `surface` is left 0.
/// @param shape  homogeneous, in the frame of the body, any density
ShapeErrors compare_mass_properties(const MassProperties& shape, const MassProperties& body);

/// Measures the errors of a union of balls. Volume and inertia are exact. The surface distance is
/// the largest of two sets of samples: points of the body at about 0.5 % of L and its vertices,
/// from the surface of the union; and exposed points of the spheres at about 0.5 % of L, of the
/// circles where two spheres meet and the corners where three do, from the body.
ShapeErrors measure_clump_errors(const ParticleBody& body, std::span<const Ball> balls);

}  // namespace clast
