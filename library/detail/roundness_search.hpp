#pragma once
/// Search of a body with a given roundness.
#include <functional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast::library_detail {

struct RoundedBody {
  SpheroPolyhedron body;
  double radius_share = 0.0;  ///< radius over S
  double roundness = 0.0;     ///< measured value
};

/// Finds the radius by regula falsi (Illinois) on the measured roundness, between the largest
/// radius and the first of a descending sequence with a smaller roundness, which avoids small radii
/// that take longest to measure.
/// @param rounded  returns the body for a ratio of radius to S
/// @param edge_length  of the roundness mesh, m
/// @throws GeometryError  if the target is out of reach or missed by more than
///                        `kRoundnessTolerance`; states the nearest value
RoundedBody find_body_of_roundness(const std::function<SpheroPolyhedron(double)>& rounded,
                                   double target, double edge_length);

}  // namespace clast::library_detail
