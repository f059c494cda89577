#pragma once
/// Which answers about a damaged scan are right, and within what.
#include "tests/app/reliability/cases.hpp"

namespace clast::reliability {

inline constexpr double kPercent = 0.01;

/// The rock as it was is the one right answer.
DamagedScan of(const Body& body, TriangleMesh damaged, const Tolerance& tolerance = {});

/// Half the tolerance that damage has earned which moved the surface: what it did to volume and
/// box.
Tolerance effect(const Truth& truth, const Truth& moved);

Tolerance at_least_usual(Tolerance tolerance, double factor);

/// Bars of a cloud by its spacing and its noise, as a share of L.
Tolerance cloud_tolerance(std::size_t points, double noise);

}  // namespace clast::reliability
