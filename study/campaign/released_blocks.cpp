#include "study/campaign/released_blocks.hpp"

#include <utility>

#include "core/files/digest.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"

namespace clast {
namespace {

std::string names_of(const std::vector<std::filesystem::path>& files) {
  std::string names;
  for (const std::filesystem::path& file : files) {
    names += (names.empty() ? "" : ", ") + file.string();
  }
  return names;
}

/// Digest of the digests of all files.
std::string digest_of(const BeforeAfterTerrains& terrains, const ReleasedMassOptions& options) {
  std::string digests;
  for (const auto& files : {terrains.before, terrains.after}) {
    for (const std::filesystem::path& file : files) digests += sha256_of_file(file);
  }
  if (options.polygon) digests += sha256_of_file(*options.polygon);
  return sha256(digests);
}

}  // namespace

ReleasedMass read_released_mass(const BeforeAfterTerrains& terrains,
                                const ReleasedMassOptions& options) {
  options.check();
  const Terrain before = read_terrain({.surface = terrains.before, .up = terrains.up});
  const Terrain after = read_terrain({.surface = terrains.after, .up = terrains.up});
  return find_released_mass(before, after, options);
}

RockMassBlocks cut_released_mass(const ReleasedMass& mass, const BeforeAfterTerrains& terrains,
                                 const ReleasedMassOptions& options,
                                 const RockMassOptions& cutting) {
  const BlockSource source{
      to_utf8(names_of(terrains.before) + " less " + names_of(terrains.after)),
      digest_of(terrains, options),
      "min_thickness_m=" + format_significant(options.min_thickness, 6) +
          " bodies=" + options.bodies +
          (options.resolution ? " resolution_m=" + format_significant(*options.resolution, 6)
                              : "") +
          (options.polygon ? " polygon=" + to_utf8(options.polygon->filename().string()) : ""),
      ""};
  std::vector<TriangleMesh> masses;
  for (const ReleasedBody& body : mass.bodies) masses.push_back(body.mesh);
  return cut_rock_masses(masses, source, cutting);
}

TriangleMesh make_released_mass_mesh(const ReleasedMass& mass) {
  TriangleMesh mesh;
  for (const ReleasedBody& body : mass.bodies) mesh = merged(std::move(mesh), body.mesh);
  return mesh;
}

}  // namespace clast
