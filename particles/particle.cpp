#include "particles/particle.hpp"

#include <Eigen/QR>
#include <cctype>
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

SphereMasses sphere_masses(const Particle& particle) {
  const std::vector<Ball>& balls = particle.balls;
  std::vector<double> weights;
  double sum = 0.0;
  for (const Ball& ball : balls) {
    weights.push_back(ball.radius * ball.radius * ball.radius);
    sum += weights.back();
  }
  // Masses m_i = w_i (1 + k . (1, x_i)) with the least relative change that keep mass and centre.
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d wrong = Eigen::Vector4d(particle.mass, 0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    weights[i] *= particle.mass / sum;
    Eigen::Vector4d row;
    row << 1.0, balls[i].centre / particle.lengths[0];
    matrix += weights[i] * row * row.transpose();
    wrong -= weights[i] * row;
  }
  const Eigen::Vector4d change = matrix.completeOrthogonalDecomposition().solve(wrong);
  SphereMasses result;
  result.rest = particle.moments.asDiagonal();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3& x = balls[i].centre;
    const double mass =
        weights[i] * (1.0 + change[0] + change.tail<3>().dot(x) / particle.lengths[0]);
    result.masses.push_back(mass);
    result.rest -= mass * (x.squaredNorm() * Mat3::Identity() - x * x.transpose());
  }
  return result;
}

}  // namespace clast
