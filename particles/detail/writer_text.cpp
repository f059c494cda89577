#include <algorithm>

#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/version.hpp"
#include "particles/detail/writers.hpp"

namespace clast::particles_detail {

std::string number_text(double value) { return format_significant(value, 15); }

std::string vector_text(const Vec3& vector, const char* separator) {
  return number_text(vector.x()) + separator + number_text(vector.y()) + separator +
         number_text(vector.z());
}

std::string obj_text(const TriangleMesh& part, const std::string& name) {
  std::string text = "o " + name + "\n";
  for (const Vec3& vertex : part.vertices) text += "v " + vector_text(vertex) + "\n";
  for (const auto& [a, b, c] : part.triangles) {
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
            std::to_string(c + 1) + "\n";
  }
  return text;
}

double bounding_radius(const Particle& particle) {
  double radius = 0.0;
  for (const Ball& ball : particle.balls) {
    radius = std::max(radius, ball.centre.norm() + ball.radius);
  }
  for (const TriangleMesh& part : particle.parts) {
    for (const Vec3& vertex : part.vertices) radius = std::max(radius, vertex.norm());
  }
  return radius;
}

std::string particle_comment(const Particle& particle) {
  const std::string count =
      particle.shape == ParticleShape::kSpheres ? format_count(particle.balls.size(), "sphere")
      : particle.shape == ParticleShape::kParts ? format_count(particle.parts.size(), "convex part")
                                                : "convex hull";
  return "block " + escape_nonprintable(particle.id) + ", " +
         format_significant(particle.density, 6) + " kg/m3, " + count +
         "; errors: " + format_shape_errors(particle.errors) + "; metres, principal frame; clast " +
         version();
}

}  // namespace clast::particles_detail
