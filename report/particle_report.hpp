#pragma once
/// Pages of an export of particles.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "particles/particle_export.hpp"

namespace clast {

/// Pages of an export of particles: one page per block, written while the export runs, and a table
/// of all particles.
class ParticleReport : public ParticleExportObserver {
 public:
  /// Opens the folder of the pages.
  /// @param options  of the export; `replace` also holds for the pages
  /// @throws InputError  if the folder cannot be created or written, or if it holds pages of an
  ///                     export with other options and `replace` is false
  ParticleReport(std::filesystem::path folder, const ParticleExportOptions& options);

  /// True if the page of the block exists and has this key.
  bool is_finished(const Block& block, const std::string& key) const override;
  void on_particles_made(const Block& block, const std::vector<Particle>& particles,
                         const std::string& key) override;

  /// Writes the table of the particles in the manifest of an export, with links to their pages.
  /// @param blocks  exported blocks
  /// @param failures  messages about blocks that were not exported
  /// @return path of the page
  /// @throws InputError  if the manifest cannot be read or the page cannot be written
  std::filesystem::path finish(const std::filesystem::path& export_folder,
                               std::span<const Block* const> blocks,
                               const std::vector<std::string>& failures) const;

 private:
  std::filesystem::path page_of(const std::string& id) const;
  void write_page(const std::filesystem::path& path, const std::string& page) const;

  std::filesystem::path folder_;
  ParticleExportOptions options_;
};

}  // namespace clast
