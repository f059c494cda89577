#pragma once
/// Page of a block as another engine takes it.
#include <string>
#include <vector>

#include "particles/particle_export.hpp"

namespace clast::report_detail {

/// Makes the self-contained page of a block: for each of its particles a 3-D view of block and
/// shape with the distance between them, and a table of sides, volume, inertia and errors.
/// @param particles  of the block; several if there are several error levels
/// @param key  digest that the page states (`ParticleExportObserver`)
std::string make_particle_page(const Block& block, const std::vector<Particle>& particles,
                               const ParticleExportOptions& options, const std::string& key);

/// Formats the number of spheres or parts of particles: "1 sphere", "32 parts", "hull".
std::string format_component_count(const std::string& shape, std::size_t spheres,
                                   std::size_t parts);

/// Makes a page about particles, with the styles of images and 3-D views.
std::string make_particle_frame(const std::string& title, const std::string& body);

}  // namespace clast::report_detail
