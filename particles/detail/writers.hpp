#pragma once
/// Writers of the files of each engine.
#include <vector>

#include "particles/engines.hpp"

namespace clast::particles_detail {

std::vector<ParticleFile> write_yade(const Particle& particle);
std::vector<ParticleFile> write_lammps(const Particle& particle);
std::vector<ParticleFile> write_liggghts(const Particle& particle);
std::vector<ParticleFile> write_pfc(const Particle& particle);
std::vector<ParticleFile> write_edem(const Particle& particle);
std::vector<ParticleFile> write_kratos(const Particle& particle);
std::vector<ParticleFile> write_chrono(const Particle& particle);
std::vector<ParticleFile> write_dem_engine(const Particle& particle);
std::vector<ParticleFile> write_mjcf(const Particle& particle);
std::vector<ParticleFile> write_urdf(const Particle& particle);
std::vector<ParticleFile> write_ramms(const Particle& particle);

/// Formats a number with fifteen significant digits.
std::string number_text(double value);
/// Formats the components of a vector, separated by `separator`.
std::string vector_text(const Vec3& vector, const char* separator = " ");
/// Formats a convex part as Wavefront OBJ.
std::string obj_text(const TriangleMesh& part, const std::string& name);
/// Returns the largest distance of the surface from the centre of mass, m.
double bounding_radius(const Particle& particle);

/// Formats id, density and errors in one line: "block B017, 2650 kg/m3, 94 spheres; volume ...".
std::string particle_comment(const Particle& particle);

}  // namespace clast::particles_detail
