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

/// One stored run. Positions are in the local frame of the terrain, m.
struct RunRecord {
  std::uint32_t run = 0;          ///< index of the run
  std::uint32_t block = 0;        ///< index into CampaignHeader::blocks
  std::uint32_t point = 0;        ///< index of the release point
  std::uint32_t orientation = 0;  ///< index of the orientation in its release set
  std::uint32_t ground_set = 0;   ///< index into CampaignHeader::ground_sets
  RigidState start;
  ContactStiffness
      stiffness;  ///< stiffness and time step, chosen for this run or given in the campaign
  /// Settled depth and impact depth, m. The settled depth is m g/(k_n e_n^2) or m g/k_n, depending
  /// on the contact law. The impact depth is that at the largest speed that the start allows. NaN
  /// in results of schema 3 and older.
  double settled_depth = 0.0;
  double impact_depth = 0.0;
  ReleaseResult result;
  ContactStatistics contacts;
};

/// Properties of a block that are used in comparisons.
struct BlockSummary {
  std::string id;
  double mass = 0.0;   ///< kg
  Axes axes;           ///< m
  std::string garcia;  ///< "compact" or "elongated"
  std::string sneed_folk;
  std::string zingg;
  std::string library_id = {};  ///< id of the library block; if empty, it is `id`
  std::string group = {};       ///< empty: blocks in no group
  double scale = 1.0;           ///< scale of lengths relative to the library block
  double volume = 0.0;          ///< m^3
  std::uint32_t shape = 0;      ///< index into CampaignHeader::shapes
  Vec3 moments = Vec3::Zero();  ///< principal moments of inertia, kg m^2
  std::string parent = {};      ///< block from which it was varied; empty if it was not varied
  std::string variation = {};   ///< variation, such as "stretch to 0.8, 0.5"

  const std::string& library_block() const { return library_id.empty() ? id : library_id; }
};

/// Additional record of a run with a persistent block.
struct PersistentBlockRecord {
  std::uint32_t run = 0;
  double released_at = 0.0;   ///< release time since the first release of the realisation, s
  double raise_height = 0.0;  ///< height by which the start was raised above the planned start, m
  double later_displacement = 0.0;  ///< displacement by later blocks after the block stopped, m
  std::uint32_t blocks_hit = 0;     ///< number of other blocks that it touched before it stopped
  /// Time of its removal from a cleared zone, since the first release, s; otherwise NaN.
  double removed_at = std::numeric_limits<double>::quiet_NaN();
};

/// Total energy of the persistent blocks of a realisation at one time.
struct EnergyRecord {
  std::uint32_t run = 0;  ///< first run of the realisation
  EnergySample energy;    ///< energies; the time is that since the first release

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, energy);
  }
};

/// Settings of persistent blocks. Runs are ordered by realisation, then by release.
struct PersistentBlocksSettings {
  std::uint32_t blocks_per_realisation = 1;  ///< number of blocks per realisation
  GroundParameters between_blocks;
  bool at_once = false;  ///< true for multi-block releases, false for one block after the other
};

/// Ground parameters of one block group in one ensemble member.
struct GroundParameterSet {
  std::string group;         ///< empty: blocks in no group
  std::uint32_t member = 0;  ///< from 0
  std::vector<GroundParameters> zones;
};

/// Trajectory of one run: states at the interval requested by the campaign.
struct Trajectory {
  std::vector<double> time;        ///< s
  std::vector<RigidState> states;  ///< local frame
};

struct StoredRun {
  RunRecord record;
  std::vector<Crossing> crossings;
  std::vector<Impact> impacts;
  std::vector<PersistentBlockRecord>
      persistent_block_records;  ///< one entry for a persistent block, otherwise empty
  std::vector<EnergyRecord>
      energies;  ///< energies of the realisation if it is its first run, otherwise empty
  Trajectory trajectory;
};

/// Data shared by all runs of a campaign.
struct CampaignHeader {
  std::filesystem::path file;
  std::string campaign_text;
  std::string campaign_sha256;
  std::vector<std::string> inputs;  ///< "path sha256" of library, terrain and release files
  std::string program_version;
  /// Physics digest of the program; empty if unknown or from another engine.
  std::string physics_digest = {};
  /// Name of another engine that computed the runs, such as "rockable". Empty for clast. Results of
  /// other engines have no contact data.
  std::string engine = {};
  std::vector<BlockSummary> blocks;
  std::vector<Barrier> barriers;     ///< local frame
  std::vector<Vec3> release_points;  ///< local frame; z is that of the first orientation
  std::vector<std::string>
      release_sets;  ///< names of the release sets; "" for a single unnamed set
  std::vector<std::uint32_t> set_of_point;  ///< index into `release_sets`
  std::vector<SpheroPolyhedron> shapes;     ///< shapes of the library blocks, body frame, unscaled
  std::vector<std::string> zone_names;
  std::vector<GroundParameters>
      ground;  ///< parameters by zone for blocks in no group; medians of uncertain parameters
  std::vector<GroundParameterSet> ground_sets;
  ContactLaw law;
  ContactWeighting weighting = ContactWeighting::kPatch;
  std::vector<std::string> warnings;
  MapFrame frame;
  std::optional<Vec2> downslope;  ///< direction given in the campaign, unit vector
  Terrain terrain;                ///< surface used for the simulation
  std::optional<PersistentBlocksSettings>
      persistent_blocks;  ///< empty if each run simulated a single block
  std::uint32_t planned_runs = 0;

  /// True if contact data (penetration, impacts, dissipation) are available.
  bool has_contacts() const { return engine.empty(); }
  /// Returns the number of runs of a realisation; 1 without persistent blocks.
  std::uint32_t runs_per_realisation() const {
    return persistent_blocks ? persistent_blocks->blocks_per_realisation : 1;
  }
};

/// Contents of a results file without its trajectories.
struct CampaignResults : CampaignHeader {
  std::vector<RunRecord> runs;                                  ///< ordered by run
  std::vector<Crossing> crossings;                              ///< ordered by run, then time
  std::vector<Impact> impacts;                                  ///< ordered by run, then time
  std::vector<PersistentBlockRecord> persistent_block_records;  ///< ordered by run
  /// Ordered by realisation, then time. Empty in results of older versions.
  std::vector<EnergyRecord> energies;

  /// Returns the record of a persistent block; null if there is none.
  const PersistentBlockRecord* find_persistent_block(std::uint32_t run) const;
};

/// Reads a results file.
/// @throws InputError  if it is missing, not a results file, damaged, or of a newer schema
CampaignResults read_results(const std::filesystem::path& path);

/// Reads single trajectories of a results file. Not thread-safe.
class TrajectoryFile {
 public:
  /// Opens the file.
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

/// Merges the results of all shards of a campaign. The datasets are those that a single process
/// would have written. The order of the parts has no influence.
/// @throws InputError  if a part cannot be read, parts differ in campaign, inputs or version, a run
///                     is in two parts, or runs are missing; names the missing shards
void merge_results(const std::vector<std::filesystem::path>& parts,
                   const std::filesystem::path& target);

/// Checks that results can be written to `target`. Called before the runs.
/// @param replace  true: existing results may be replaced
/// @throws InputError  if the target is a folder, a device, a circular link, write-protected, in a
///                     folder without write permission, a non-empty file of another kind, or
///                     results that must be kept
void check_results_target(const std::filesystem::path& target, bool replace);

/// True if `target` holds the finished results of this campaign.
/// @param runs  number of runs of the finished file
/// @throws InputError  if it has results of another campaign, other inputs or another version
bool has_finished_results(const std::filesystem::path& target, const CampaignHeader& header,
                          std::size_t runs);

/// Returns the path of the journal, target + ".part". The journal stores runs until all are
/// finished. It is not an HDF5 file.
std::filesystem::path results_journal_path(const std::filesystem::path& target);

/// Writer of a results file. Runs are first written to a journal, so that none is lost if the
/// program is killed. The results file is written at the end. The target is locked during the
/// lifetime of the writer (core/files/file_lock.hpp).
class ResultsWriter {
 public:
  /// Starts a new journal, in place of that of an interrupted campaign. Creates missing folders.
  /// @param runs  number of runs of the complete file
  /// @throws InputError  if `check_results_target` throws, another program writes to the target, or
  ///                     the disk has too little space for that many runs
  static ResultsWriter create(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs = 0);
  /// Resumes the journal of `target`. An incomplete last run is dropped.
  /// @throws InputError  if the journal is missing, damaged, or of another campaign (by digest of
  ///                     campaign and inputs), or if `create` would throw
  static ResultsWriter resume(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs = 0);
  ~ResultsWriter();
  ResultsWriter(ResultsWriter&&) noexcept;

  /// Returns the indices of the runs in the journal, ascending.
  const std::vector<std::uint32_t>& completed_runs() const;
  /// Appends a run and flushes the journal. Runs may be added in any order.
  void add(const StoredRun& run);
  /// Writes the target with the runs in ascending order, and deletes the journal.
  void finish();

 private:
  struct Impl;
  explicit ResultsWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
