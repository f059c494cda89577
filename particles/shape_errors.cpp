#include "particles/shape_errors.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "particles/ball_union.hpp"
#include "particles/detail/surface_distance.hpp"

namespace clast {

void ShapeErrors::check() const {
  const auto check_one = [](const char* name, double value) {
    if (value > 0.0 && value < 1.0) return;
    throw InputError(std::string("`error` ") + name + " = " + format_significant(value, 6) +
                     ": must be above 0 and below 1, such as 0.02 for 2 %");
  };
  check_one("volume", volume);
  check_one("inertia", inertia);
  check_one("surface", surface);
}

std::string format_shape_errors(const ShapeErrors& errors) {
  return "volume " + format_percent(errors.volume, 2) + ", inertia " +
         format_percent(errors.inertia, 2) + ", surface " + format_percent(errors.surface, 2);
}

ShapeErrors compare_mass_properties(const MassProperties& shape, const MassProperties& body) {
  const Mat3 own = shape.inertia / shape.mass, true_one = body.inertia / body.mass;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(true_one, Eigen::EigenvaluesOnly);
  ShapeErrors errors;
  errors.volume = std::abs(shape.volume / body.volume - 1.0);
  errors.inertia = (own - true_one).cwiseAbs().maxCoeff() / solver.eigenvalues()[0];
  return errors;
}

ShapeErrors measure_clump_errors(const ParticleBody& body, std::span<const Ball> balls) {
  ShapeErrors errors = compare_mass_properties(ball_union_mass_properties(balls, 1.0), body.mass);
  const particles_detail::BodySurface surface(body.mesh, body.radius);
  const std::vector<Vec3> samples =
      particles_detail::sample_body(surface, particles_detail::kFineSpacing * body.length);
  errors.surface = particles_detail::measure_surface_distance(
                       surface, samples, balls, particles_detail::kFineSpacing * body.length)
                       .value /
                   body.length;
  return errors;
}

}  // namespace clast
