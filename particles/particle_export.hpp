#pragma once
/// Export of blocks as particles of other engines.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/table.hpp"
#include "core/progress.hpp"
#include "particles/clump.hpp"
#include "particles/convex_parts.hpp"
#include "particles/engines.hpp"

namespace clast {

struct ParticleExportOptions {
  std::string engine;                         ///< name of a `ParticleEngine`
  std::optional<ParticleShape> shape = {};    ///< default: the first one of the engine
  ClumpOptions clump = {};                    ///< errors and spheres; `error` holds for all shapes
  std::vector<double> levels = {};            ///< surface errors; each block is written at each
  std::optional<std::size_t> max_parts = {};  ///< default: 32 convex parts
  std::optional<std::size_t> max_part_vertices = {};  ///< of each convex part; default: no limit
  bool hull = false;     ///< true: concave blocks are written as hulls, also beyond `error`
  bool replace = false;  ///< if false, files of other exports in the folder are an error
  unsigned threads = 0;  ///< number of threads, 0: one per core; does not affect the files

  ParticleShape chosen_shape() const;
  void check() const;  ///< throws InputError naming the field and its value
};

/// Makes the particles of a block: one, or one for each level.
/// @throws InputError  if the block is unscaled
/// @throws GeometryError  if an error is not reached, or the block is concave and the shape is a
///                        polyhedron without `hull`; the message states what was reached
std::vector<Particle> make_particles(const Block& block, const ParticleExportOptions& options);

/// File name of the manifest in the folder of an export.
inline constexpr const char* kParticleManifest = "particles.json";

/// Row of the manifest.
struct ParticleRecord {
  Particle particle;
  std::vector<std::string> files;
};

/// Returns the columns of the manifest, which is written as particles.csv and particles.json.
const TableColumns<ParticleRecord>& particle_columns();

struct ParticleExport {
  std::size_t written = 0;  ///< blocks written
  std::size_t kept = 0;     ///< blocks whose files an earlier export with the same options wrote
  std::vector<std::string> failures;  ///< one message for each block that is left out
};

/// Formats the options that affect the particles as "key=value" separated by blanks.
std::string format_particle_options(const ParticleExportOptions& options);

/// Observer of an export, such as its pages. `key` is a digest of all that the particles of a block
/// depend on: the block, the options and the version of the program.
class ParticleExportObserver {
 public:
  virtual ~ParticleExportObserver() = default;

  /// Called for a block whose files an earlier export wrote. They are kept if the result is true;
  /// otherwise the particles are made again.
  virtual bool is_finished(const Block& /*block*/, const std::string& /*key*/) const {
    return true;
  }
  /// Called with new particles of a block on the thread that made them; calls may be concurrent.
  /// The block fails if an `Error` is thrown.
  virtual void on_particles_made(const Block& /*block*/, const std::vector<Particle>& /*particles*/,
                                 const std::string& /*key*/) {}
};

/// Writes the files of all blocks and the manifest to a folder. Blocks are computed on several
/// threads. An interrupted export keeps the finished blocks in the manifest, and the same call
/// computes the others only.
/// @param observer  may be null
/// @throws InputError  if an option is invalid, there is no block, or the folder holds an export
///                     with other options and `replace` is false
ParticleExport export_particles(const std::vector<const Block*>& blocks,
                                const std::filesystem::path& folder,
                                const ParticleExportOptions& options,
                                const ProgressCallback& progress = {},
                                ParticleExportObserver* observer = nullptr);

}  // namespace clast
