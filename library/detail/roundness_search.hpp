#pragma once
/// Search of a body with a given roundness.
#include <functional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast::library_detail {

struct RoundnessSearchResult {
  SpheroPolyhedron body;
  double radius_fraction = 0.0;  ///< ratio of radius to S
  double roundness = 0.0;        ///< measured roundness
};

/// Finds the body with a given roundness, by regula falsi (Illinois) on the radius. The interval
/// begins at the largest radius. Its other end is the first of a descending sequence with a smaller
/// roundness than the target, because small radii take longest to measure.
/// @param rounded  function that returns the body for a ratio of radius to S
/// @param edge_length  edge length of the mesh on which roundness is measured, m
/// @throws GeometryError  if the target cannot be reached within `kRoundnessTolerance`; states the
///                        nearest value
RoundnessSearchResult find_body_with_roundness(
    const std::function<SpheroPolyhedron(double)>& rounded, double target, double edge_length);

}  // namespace clast::library_detail
