#pragma once
/// Correction of a clump to volume, centre and second moments of a body.
#include <vector>

#include "massprops/moments.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast::particles_detail {

/// Corrects a union of balls in one step: maps the centres affinely so that the second moments
/// approach those of the body up to a factor, moves the centre of mass, and adds the same length to
/// all radii until the volume is that of the body to 1e-5. The map is left out if it does not bring
/// the second moments nearer.
/// @param body  moments about the origin of the balls
/// @param smallest_radius  to which smaller radii are raised
void correct_moments(std::vector<Ball>& balls, const massprops_detail::SolidMoments& body,
                     double smallest_radius);

}  // namespace clast::particles_detail
