#pragma once
/// Boxes as bodies.
#include "dem/motion/rigid_body.hpp"

namespace clast {

/// A box about the origin, its sides along the axes.
/// @param sides   of the core, m
/// @param radius  that the core is rounded with, m; 0: sharp
/// @param mass    kg, taken to fill the core evenly
RigidBody make_box_body(const Vec3& sides, double radius, double mass);

}  // namespace clast
