#pragma once
/// A body whose edges are rounded until it has a roundness.
#include <functional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast::library_detail {

struct RoundedBody {
  SpheroPolyhedron body;
  double radius_share = 0.0;  ///< radius over S
  double roundness = 0.0;     ///< that was measured
};

/// The radius is found by false position (Illinois) on the roundness that is measured, between the
/// largest radius and the first of a falling row whose body is less round than asked for, which
/// leaves out small radii but none at all: they take longest to measure.
/// @param rounded      the body with a radius of this share of S
/// @param edge_length  of the mesh that roundness is measured on, m
/// @throws GeometryError  a target out of reach, or missed by more than `kRoundnessTolerance`; with
///                        the nearest
RoundedBody find_body_of_roundness(const std::function<SpheroPolyhedron(double)>& rounded, double target,
                              double edge_length);

}  // namespace clast::library_detail
