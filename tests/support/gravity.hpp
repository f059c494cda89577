#pragma once

namespace clast {

/// Gravitational acceleration of the tests, m/s^2.
inline constexpr double kTestGravity = 9.81;

}  // namespace clast
