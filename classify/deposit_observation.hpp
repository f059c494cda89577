#pragma once
/// Observation of a block in the scan of a deposit, in which it is partly hidden.
#include <cstddef>

#include "classify/form.hpp"

namespace clast {

struct DepositObservation {
  Axes lower_axes, upper_axes;  ///< limits of the two-sided 90 % intervals of L, I and S, m
  double volume = 0.0;          ///< m^3
  double lower_volume = 0.0, upper_volume = 0.0;  ///< limits of the two-sided 90 % interval, m^3
  Vec3 long_axis = Vec3::UnitX();                 ///< direction of L, unit, z up
  std::size_t points = 0;                         ///< number of its points
  double spacing = 0.0;                           ///< spacing of the points, m
  double visible_fraction = 1.0;                  ///< observed area over the area of the body
  double confidence = 1.0;    ///< probability that the outline is that of one block
  double plan_area = 0.0;     ///< area of the body in plan, m^2
  double exposed_area = 0.0;  ///< part of `plan_area` that no other found block covers, m^2
};

}  // namespace clast
