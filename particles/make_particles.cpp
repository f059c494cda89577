#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/unscaled.hpp"
#include "particles/ball_union.hpp"
#include "particles/detail/ball_contacts.hpp"
#include "particles/particle_export.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/outer_surface.hpp"

namespace clast {

namespace {

constexpr std::size_t kDefaultParts = 32;
/// Points on each sphere for the smallest box of a clump: its sides are right to 1e-3.
constexpr std::size_t kBoxPoints = 1000;

/// "_s0_02" for a surface error of 0.02.
std::string level_suffix(double surface) {
  std::string suffix = "_s" + format_significant(surface, 6);
  std::replace(suffix.begin(), suffix.end(), '.', '_');
  return suffix;
}

Particle common_part(const Block& block) {
  Particle particle;
  particle.id = block.id;
  particle.name = particle_name(block.id);
  particle.density = block.density;
  particle.volume = block.mass.volume;
  particle.mass = block.mass.mass;
  particle.moments = block.principal.moments;
  particle.lengths = block.box.lengths;
  particle.source_from_body = block.source_from_body();
  return particle;
}

Vec3 clump_lengths(const std::vector<Ball>& balls) {
  std::vector<Vec3> points;
  for (const Ball& ball : balls) {
    for (std::size_t k = 0; k < kBoxPoints; ++k) {
      points.push_back(ball.centre +
                       ball.radius * particles_detail::spiral_direction(k, kBoxPoints));
    }
  }
  return smallest_box(convex_hull(points).vertices).lengths;
}

Particle with_spheres(Particle particle, Clump clump) {
  particle.shape = ParticleShape::kSpheres;
  particle.balls = std::move(clump.balls);
  particle.errors = clump.errors;
  particle.shape_mass = ball_union_mass_properties(particle.balls, particle.density);
  particle.shape_lengths = clump_lengths(particle.balls);
  return particle;
}

Particle with_parts(Particle particle, ParticleShape shape, const ParticleBody& body,
                    ConvexParts parts) {
  particle.shape = shape;
  particle.parts = std::move(parts.parts);
  particle.added_volume = parts.added_volume;
  particle.errors = measure_part_errors(body, particle.parts);
  particle.shape_mass = convex_part_mass_properties(particle.parts, particle.density);
  std::vector<Vec3> points;
  for (const TriangleMesh& part : particle.parts) {
    points.insert(points.end(), part.vertices.begin(), part.vertices.end());
  }
  particle.shape_lengths = smallest_box(points).lengths;
  return particle;
}

/// Body for convex shapes: the simplified scan has fewer faces than its rounded body.
ParticleBody faceted_body(const Block& block) {
  if (block.from_core) return make_particle_body(block, outer_surface_mesh(block.body));
  return make_particle_body(block, block.surface);
}

Particle hull_particle(const Block& block, const ParticleExportOptions& options) {
  const ParticleBody body = faceted_body(block);
  TriangleMesh hull = convex_hull(body.mesh.vertices);
  const double added = signed_volume(hull) / signed_volume(body.mesh) - 1.0;
  Particle particle =
      with_parts(common_part(block), ParticleShape::kPolyhedron, body, {{std::move(hull)}, added});
  if (!options.hull && !particle.errors.is_within(options.clump.error)) {
    throw GeometryError("block " + block.id + " is concave, and " +
                        find_particle_engine(options.engine).program +
                        " takes a convex polyhedron: its hull has errors of " +
                        format_shape_errors(particle.errors) + ", more than those asked for (" +
                        format_shape_errors(options.clump.error) +
                        "). Accept the hull with `hull`, or allow larger errors");
  }
  return particle;
}

Particle part_particle(const Block& block, const ParticleExportOptions& options) {
  const ParticleBody body = faceted_body(block);
  const std::size_t most = options.max_parts.value_or(kDefaultParts);
  ConvexParts parts =
      split_into_convex_parts(body.mesh, {.added_volume = options.clump.error.volume,
                                          .max_parts = most,
                                          .max_vertices = options.max_part_vertices});
  return with_parts(common_part(block), ParticleShape::kParts, body, std::move(parts));
}

}  // namespace

std::vector<Particle> make_particles(const Block& block, const ParticleExportOptions& options) {
  options.check();
  if (is_unscaled(block)) {
    throw InputError("block " + block.id +
                     " is unscaled, and particles are in metres: " + explain_unscaled_block());
  }
  switch (options.chosen_shape()) {
    case ParticleShape::kPolyhedron:
      return {hull_particle(block, options)};
    case ParticleShape::kParts:
      return {part_particle(block, options)};
    case ParticleShape::kSpheres:
      break;
  }
  const ParticleBody body = make_particle_body(block);
  std::vector<Particle> particles;
  try {
    if (options.levels.empty()) {
      particles.push_back(with_spheres(common_part(block), fit_clump(body, options.clump)));
      return particles;
    }
    std::vector<Clump> clumps = fit_clump_levels(body, options.clump, options.levels);
    for (std::size_t i = 0; i < clumps.size(); ++i) {
      particles.push_back(with_spheres(common_part(block), std::move(clumps[i])));
      particles.back().name += level_suffix(options.levels[i]);
    }
  } catch (const GeometryError& error) {
    throw GeometryError("block " + block.id + ": " + error.what());
  }
  return particles;
}

}  // namespace clast
