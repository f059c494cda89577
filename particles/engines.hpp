#pragma once
/// Engines that take particles, and the files that each loads.
#include <string>
#include <vector>

#include "particles/particle.hpp"

namespace clast {

/// Text file of an export.
struct ParticleFile {
  std::string name;  ///< relative to the folder of the export
  std::string text;
};

/// Engine that takes particles. The documentation of the formats is made from these rows.
struct ParticleEngine {
  std::string name;                   ///< as in an option: "yade"
  std::string program;                ///< as its authors write it
  std::vector<ParticleShape> shapes;  ///< the first is the default
  std::string files;                  ///< names of the files of a body; code is between tildes
  /// Quantities that the files carry (mass, centre, inertia tensor), and what the engine computes.
  std::string mass;
  std::string loading;  ///< call or command that loads the files; code is between tildes
  std::vector<ParticleFile> (*write)(const Particle& particle);
};

/// Returns all engines in the order of the documentation.
const std::vector<ParticleEngine>& particle_engines();
/// Returns the names of all engines.
std::vector<std::string> particle_engine_names();
/// Finds an engine by name.
/// @throws InputError  if there is none; the message lists all names
const ParticleEngine& find_particle_engine(const std::string& name);

/// Formats a table of the engines and a list of what their files carry in Markdown, as the
/// documentation has them.
std::string particle_engine_table();

}  // namespace clast
