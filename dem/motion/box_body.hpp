#pragma once
/// Box-shaped bodies.
#include "dem/motion/rigid_body.hpp"

namespace clast {

/// Makes a box about the origin with sides along the axes.
/// @param sides  side lengths of the core, m
/// @param radius  radius of the rounding, m; if 0, edges are sharp
/// @param mass  mass, kg, uniformly distributed in the core
RigidBody make_box_body(const Vec3& sides, double radius, double mass);

}  // namespace clast
