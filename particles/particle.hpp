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

/// Computes positive masses of the spheres of a particle whose sum is its mass, with centre of mass
/// and principal axes of the particle, kg. Engines that add up spheres as if they did not overlap
/// then find the right frame. The masses are as nearly proportional to the cubes of the radii as
/// possible. With fewer than eight spheres, small differences may remain.
std::vector<double> balanced_masses(const Particle& particle);

}  // namespace clast
