#pragma once
/// Particle: a block as another engine takes it.
#include <array>
#include <string>
#include <vector>

#include "library/block.hpp"
#include "particles/shape_errors.hpp"

namespace clast {

/// Shape that replaces a block.
enum class ParticleShape {
  kSpheres,     ///< overlapping spheres
  kParts,       ///< convex parts that fill the block without gap and overlap
  kPolyhedron,  ///< convex hull
};

/// Returns the name of a shape in options: "spheres", "parts" or "polyhedron".
std::string particle_shape_name(ParticleShape shape);
/// Finds a shape by name.
/// @throws InputError  if there is none
ParticleShape find_particle_shape(const std::string& name);

/// Returns a name for the files of a block that every engine accepts: its id with letters, digits
/// and underscores, and "b" before a digit at the start.
std::string particle_name(const std::string& id);

/// Block as another engine takes it, in its principal frame about its true centre of mass. Mass and
/// inertia tensor are those of the true body.
struct Particle {
  std::string id;    ///< of the block
  std::string name;  ///< letters, digits and underscores; unique in an export
  ParticleShape shape = ParticleShape::kSpheres;
  std::vector<Ball> balls;          ///< of kSpheres
  std::vector<TriangleMesh> parts;  ///< closed convex meshes of kParts, one of kPolyhedron
  ShapeErrors errors;
  double added_volume = 0.0;  ///< of parts or hull beyond the body, relative to its volume
  MassProperties shape_mass;  ///< of the exported shape at the density of the block

  double density = 0.0, volume = 0.0, mass = 0.0;  ///< true: kg/m^3, m^3, kg
  Vec3 moments = Vec3::Zero();                     ///< true principal moments, kg m^2, ascending
  Vec3 lengths = Vec3::Zero();                     ///< L, I, S of the true smallest box, m
  Vec3 shape_lengths = Vec3::Zero();               ///< of the exported shape, m
  Pose source_from_body;                           ///< frame of the scan from principal frame
};

/// Masses of spheres whose sum, centre and, with `rest`, inertia tensor are those of a particle.
/// Engines that add up spheres then get the true values.
struct SphereMasses {
  std::vector<double> masses;  ///< kg; may be negative
  Mat3 rest = Mat3::Zero();    ///< inertia tensor to add to the first sphere, kg m^2
};

/// Computes the masses nearest to those in proportion to the cubes of the radii. Inertia tensors of
/// the spheres themselves are taken as zero but for that of the first, `rest`.
SphereMasses sphere_masses(const Particle& particle);

}  // namespace clast
