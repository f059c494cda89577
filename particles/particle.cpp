#include "particles/particle.hpp"

#include <Eigen/QR>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace clast {

namespace {

const std::vector<std::pair<ParticleShape, std::string>>& shape_names() {
  static const std::vector<std::pair<ParticleShape, std::string>> kNames = {
      {ParticleShape::kSpheres, "spheres"},
      {ParticleShape::kParts, "parts"},
      {ParticleShape::kPolyhedron, "polyhedron"}};
  return kNames;
}

/// Smallest mass of a sphere over that in proportion to the cubes of the radii.
constexpr double kLeastMass = 0.02;

}  // namespace

std::string particle_shape_name(ParticleShape shape) {
  for (const auto& [known, name] : shape_names()) {
    if (known == shape) return name;
  }
  return "";
}

ParticleShape find_particle_shape(const std::string& name) {
  for (const auto& [shape, known] : shape_names()) {
    if (known == name) return shape;
  }
  throw InputError("`shape`: \"" + name + "\" is not known; expected spheres, parts or polyhedron");
}

std::string particle_name(const std::string& id) {
  std::string name;
  for (const char c : id) {
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return std::isdigit(static_cast<unsigned char>(name[0])) != 0 ? "b" + name : name;
}

std::vector<double> balanced_masses(const Particle& particle) {
  using Row = Eigen::Matrix<double, 7, 1>;
  const std::vector<Ball>& balls = particle.balls;
  std::vector<Row> rows;
  std::vector<double> masses;
  double sum = 0.0;
  for (const Ball& ball : balls) {
    const Vec3 x = ball.centre / particle.lengths[0];
    rows.emplace_back();
    rows.back() << 1.0, x, x.y() * x.z(), x.z() * x.x(), x.x() * x.y();
    masses.push_back(std::pow(ball.radius, 3.0));
    sum += masses.back();
  }
  for (double& mass : masses) mass *= particle.mass / sum;
  const std::vector<double> first = masses;
  // Masses m_i (1 + k . row_i) have the least relative change that keeps all sums. Those that
  // would fall too low are held at their limit.
  std::vector<bool> held(balls.size(), false);
  for (std::size_t pass = 0; pass < balls.size(); ++pass) {
    Eigen::Matrix<double, 7, 7> matrix = Eigen::Matrix<double, 7, 7>::Zero();
    Row wrong = particle.mass * Row::Unit(0);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      masses[i] = held[i] ? kLeastMass * first[i] : first[i];
      wrong -= masses[i] * rows[i];
      if (!held[i]) matrix += masses[i] * rows[i] * rows[i].transpose();
    }
    const Row change = matrix.completeOrthogonalDecomposition().solve(wrong);
    bool is_final = true;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (held[i]) continue;
      masses[i] *= 1.0 + change.dot(rows[i]);
      if (masses[i] >= kLeastMass * first[i]) continue;
      held[i] = true;
      is_final = false;
    }
    if (is_final) break;
  }
  return masses;
}

}  // namespace clast
