#pragma once
/// Results file of a campaign (HDF5). Schema: docs/formats.md.
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "dem/simulation/energy_sample.hpp"
#include "dem/simulation/release.hpp"
#include "shapes/sphero_polyhedron.hpp"
#include "study/campaign/barrier.hpp"
#include "study/results/impact.hpp"
#include "terrain/terrain.hpp"

namespace clast {

/// Stored results of one run. Positions are in the local frame of the terrain, m.
struct RunRecord {
  std::uint32_t run = 0;          ///< index of the run
  std::uint32_t block = 0;        ///< index into CampaignHeader::blocks
  std::uint32_t point = 0;        ///< index of the release point
  std::uint32_t orientation = 0;  ///< index of the orientation in its release set
  std::uint32_t ground_set = 0;   ///< index into CampaignHeader::ground_sets
  RigidState start;
  /// Stiffness and time step, chosen for this run or given in the campaign.
  ContactStiffness stiffness;
  /// Settled depth: overlap of the block at rest, m. NaN in old results.
  double settled_depth = 0.0;
  double impact_depth = 0.0;
  ReleaseResult result;
  ContactStatistics contacts;
};

/// Properties of a block of a campaign, as used in comparisons.
struct BlockSummary {
  std::string id;
  double mass = 0.0;   ///< kg
  Axes axes;           ///< side lengths of the smallest box, m
  std::string garcia;  ///< Garcia class: "compact" or "elongated"
  std::string sneed_folk;
  std::string zingg;
  std::string library_id = {};  ///< id of the library block; if empty, equal to `id`
  std::string group = {};       ///< name of the block group; empty if in no group
  double scale = 1.0;           ///< scale of lengths relative to the library block
  double volume = 0.0;          ///< m^3
  std::uint32_t shape = 0;      ///< index into CampaignHeader::shapes
  Vec3 moments = Vec3::Zero();  ///< principal moments of inertia, kg m^2
  /// Id of the block from which it was varied; empty if it was not varied.
  std::string parent = {};
  std::string variation = {};  ///< variation, such as "stretch to 0.8, 0.5"

  const std::string& library_block() const { return library_id.empty() ? id : library_id; }
};

/// Additional results of a run whose block stays on the terrain.
struct PersistentBlockRecord {
  std::uint32_t run = 0;
  double released_at = 0.0;   ///< release time since the first release of the realisation, s
  double raise_height = 0.0;  ///< height by which the start was raised above the planned start, m
  double later_displacement = 0.0;  ///< displacement by later blocks after the block stopped, m
  std::uint32_t blocks_hit = 0;     ///< number of other blocks that it touched before it stopped
  /// Time from the first release to its removal from a cleared zone, s; NaN if not removed.
  double removed_at = std::numeric_limits<double>::quiet_NaN();
};

/// Energies of all persistent blocks of a realisation at one time.
struct EnergyRecord {
  std::uint32_t run = 0;  ///< first run of the realisation
  EnergySample energy;    ///< energies and time since the first release

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, energy);
  }
};

/// Settings of blocks that stay on the terrain. Runs are ordered by realisation, then by release.
struct PersistentBlocksSettings {
  std::uint32_t blocks_per_realisation = 1;  ///< number of blocks per realisation
  GroundParameters between_blocks;
  bool at_once = false;  ///< true if all blocks are released at once; false if one after the other
};

/// Ground parameters of one block group in one ensemble member.
struct GroundParameterSet {
  std::string group;         ///< name of the block group; empty for blocks in no group
  std::uint32_t member = 0;  ///< index of the ensemble member, from 0
  std::vector<GroundParameters> zones;
};

/// Trajectory of one run: states at equal intervals of time.
struct Trajectory {
  std::vector<double> time;        ///< s
  std::vector<RigidState> states;  ///< states in the local frame
};

struct StoredRun {
  RunRecord record;
  std::vector<Crossing> crossings;
  std::vector<Impact> impacts;
  /// Record of a persistent block; empty for single-block runs.
  std::vector<PersistentBlockRecord> persistent_block_records;
  /// Energies of the realisation; empty except for its first run.
  std::vector<EnergyRecord> energies;
  Trajectory trajectory;
};

/// Data shared by all runs of a campaign.
struct CampaignHeader {
  std::filesystem::path file;
  std::string campaign_text;
  std::string campaign_sha256;
  std::vector<std::string> inputs;  ///< library, terrain and release files, each as "path sha256"
  std::string program_version;
  /// Digest of the simulated physics (`physics_digest`); empty if unknown or from another engine.
  std::string physics_digest = {};
  /// Name of another engine that computed the runs, such as "rockable". Empty for clast. Results of
  /// other engines have no contact data.
  std::string engine = {};
  std::vector<BlockSummary> blocks;
  std::vector<Barrier> barriers;            ///< local frame
  std::vector<Vec3> release_points;         ///< release points in the local frame
  std::vector<std::string> release_sets;    ///< names of the release sets
  std::vector<std::uint32_t> set_of_point;  ///< index of the release set of each release point
  std::vector<SpheroPolyhedron> shapes;     ///< shapes of the library blocks, body frame, unscaled
  std::vector<std::string> zone_names;
  /// Ground parameters by zone; central values of uncertain parameters.
  std::vector<GroundParameters> ground;
  std::vector<GroundParameterSet> ground_sets;
  ContactLaw law;
  ContactWeighting weighting = ContactWeighting::kPatch;
  std::vector<std::string> warnings;
  MapFrame frame;
  std::optional<Vec2> downslope;  ///< direction given in the campaign, unit vector
  Terrain terrain;                ///< surface used for the simulation
  /// Empty if each run simulated a single block.
  std::optional<PersistentBlocksSettings> persistent_blocks;
  std::uint32_t planned_runs = 0;

  /// True if contact data (penetration, impacts, dissipation) are available.
  bool has_contacts() const { return engine.empty(); }
  /// Returns the number of blocks that are simulated together; 1 if each run simulates one block.
  std::uint32_t runs_per_realisation() const {
    return persistent_blocks ? persistent_blocks->blocks_per_realisation : 1;
  }
};

/// Contents of a results file without its trajectories.
struct CampaignResults : CampaignHeader {
  std::vector<RunRecord> runs;      ///< runs, in ascending order of their indices
  std::vector<Crossing> crossings;  ///< barrier crossings, ordered by run, then time
  std::vector<Impact> impacts;      ///< ordered by run, then time
  /// Records of persistent blocks, ordered by run.
  std::vector<PersistentBlockRecord> persistent_block_records;
  /// Energies of realisations, ordered by realisation, then time.
  std::vector<EnergyRecord> energies;

  /// Returns the record of a persistent block; null if there is none.
  const PersistentBlockRecord* find_persistent_block(std::uint32_t run) const;
};

/// Reads a results file.
/// @throws InputError  if the file is missing, not a results file, damaged, or of a newer schema
CampaignResults read_results(const std::filesystem::path& path);

/// Reads single trajectories of a results file. Not thread-safe.
class TrajectoryFile {
 public:
  /// Opens a results file.
  /// @throws InputError  if `read_results` would throw
  explicit TrajectoryFile(const std::filesystem::path& path);
  ~TrajectoryFile();
  TrajectoryFile(TrajectoryFile&&) noexcept;

  /// Returns the number of stored states of a run. It is 0 if no trajectory was stored.
  std::size_t frame_count(std::uint32_t run) const;
  /// Reads one trajectory.
  /// @throws InputError  if the run does not exist or no trajectories were stored
  Trajectory read(std::uint32_t run) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};
/// Reads one trajectory of a results file.
/// @throws InputError  if the file cannot be read, the run does not exist, or has no trajectory
Trajectory read_trajectory(const std::filesystem::path& path, std::uint32_t run);

/// Merges the results of all shards of a campaign into one results file.
/// @throws InputError  if a part cannot be read, parts differ in campaign, inputs or version, or
///                     runs are missing or repeated
void merge_results(const std::vector<std::filesystem::path>& parts,
                   const std::filesystem::path& target);

/// Checks that a results file can be written to `target`.
/// @param replace  true if existing results may be replaced
/// @throws InputError  if the target cannot be written, is a file of another kind, or has results
///                     that must be kept
void check_results_target(const std::filesystem::path& target, bool replace);

/// True if `target` holds the finished results of a campaign.
/// @param runs  number of runs of the finished file
/// @throws InputError  if the file has results of another campaign, other inputs or another version
bool has_finished_results(const std::filesystem::path& target, const CampaignHeader& header,
                          std::size_t runs);

/// Returns the path of the journal, which stores runs until all are finished: target + ".part".
std::filesystem::path results_journal_path(const std::filesystem::path& target);

/// Writer of a results file. Runs are first written to a journal, so that none is lost if the
/// program is killed. The results file is written at the end. The target is locked during the
/// lifetime of the writer (core/files/file_lock.hpp).
class ResultsWriter {
 public:
  /// Starts a new journal, which replaces that of an interrupted campaign.
  /// @param runs  number of runs of the complete file
  /// @throws InputError  if `check_results_target` throws, another program writes to the target, or
  ///                     the disk has too little space for that many runs
  static ResultsWriter create(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs = 0);
  /// Resumes the journal of an interrupted campaign. An incomplete last run is dropped.
  /// @throws InputError  if the journal is missing, damaged, or of another campaign (by digest of
  ///                     campaign and inputs), or if `create` would throw
  static ResultsWriter resume(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs = 0);
  ~ResultsWriter();
  ResultsWriter(ResultsWriter&&) noexcept;

  /// Returns the indices of the runs in the journal, ascending.
  const std::vector<std::uint32_t>& completed_runs() const;
  /// Appends a run to the journal. Runs may be added in any order.
  void add(const StoredRun& run);
  /// Writes the results file and deletes the journal.
  void finish();

 private:
  struct Impl;
  explicit ResultsWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
