#pragma once
/// The HDF5 file of a campaign's results. Schema: docs/formats.md.
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

/// One run as it is stored. Positions are in the terrain's local frame.
struct RunRecord {
  std::uint32_t run = 0;          ///< number in the campaign
  std::uint32_t block = 0;        ///< index into CampaignHeader::blocks
  std::uint32_t point = 0;        ///< index of the release point
  std::uint32_t orientation = 0;  ///< index of the orientation in its release set
  std::uint32_t ground_set = 0;   ///< index into CampaignHeader::draw_ground_sets
  RigidState start;
  ContactStiffness stiffness;  ///< and time step, chosen for this run or given
  /// Of the block at rest, m g/(k_n e_n^2) or m g/k_n by law, and of an impact at the fastest speed
  /// that its start allows, m; not a number in results of schema 3 and older.
  double rest_depth = 0.0;
  double impact_depth = 0.0;
  ReleaseResult result;
  ContactStatistics contacts;
};

/// What the comparison needs to know of a block.
struct BlockSummary {
  std::string id;
  double mass = 0.0;   ///< kg
  Axes axes;           ///< m
  std::string garcia;  ///< compact or elongated
  std::string sneed_folk;
  std::string zingg;
  std::string library_id = {};  ///< of the library block it was made from; empty: `id`
  std::string group = {};       ///< block group; empty: none
  double scale = 1.0;           ///< of lengths, against the library block
  double volume = 0.0;          ///< m^3
  std::uint32_t shape = 0;      ///< index into CampaignHeader::shapes
  Vec3 moments = Vec3::Zero();  ///< principal, kg m^2
  std::string parent = {};      ///< block that it was varied from; empty: none
  std::string variation = {};   ///< "stretch to 0.8, 0.5"

  const std::string& library_block() const { return library_id.empty() ? id : library_id; }
};

/// What else is kept of a run whose block stayed among others.
struct PersistentBlockRecord {
  std::uint32_t run = 0;
  double released_at = 0.0;      ///< since the first block of the realisation was released, s
  double raised = 0.0;           ///< above the start that was planned, m
  double later_displacement = 0.0;      ///< by later blocks, from where it had stopped, m
  std::uint32_t blocks_hit = 0;  ///< other blocks that it touched during its own release
  /// When it was removed out of a cleared zone, as `released_at`; NaN: it stayed.
  double removed_at = std::numeric_limits<double>::quiet_NaN();
};

/// The energy of all blocks of a realisation of blocks that stay, at one instant.
struct EnergyRecord {
  std::uint32_t run = 0;  ///< the first of the realisation
  EnergySample energy;    ///< its time counts from the first release

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, energy);
  }
};

/// Realisations of blocks that stay: runs are in order of realisations, then of release.
struct PersistentBlocksSettings {
  std::uint32_t blocks_each = 1;  ///< in each realisation
  GroundParameters between_blocks;
  bool at_once = false;  ///< released together, as a mass; else one after the other
};

/// Ground parameters that some of the runs have: of one block group in one member of the ensemble.
struct GroundParameterSet {
  std::string group;         ///< empty: blocks in no group
  std::uint32_t member = 0;  ///< from 0
  std::vector<GroundParameters> zones;
};

/// The state of one run over time, at the asked interval.
struct Trajectory {
  std::vector<double> time;        ///< s
  std::vector<RigidState> states;  ///< local frame
};

/// Everything that is stored of one run.
struct StoredRun {
  RunRecord record;
  std::vector<Crossing> crossings;
  std::vector<Impact> impacts;
  std::vector<PersistentBlockRecord> stays;       ///< one where blocks stay, else none
  std::vector<EnergyRecord> energies;  ///< of its realisation, if it is the first run of one
  Trajectory trajectory;
};

/// What all runs of a campaign share: in a results file, and of a campaign before it runs.
struct CampaignHeader {
  std::filesystem::path file;
  std::string campaign_text;
  std::string campaign_sha256;
  std::vector<std::string> inputs;  ///< "path sha256" of library, terrain and release files
  std::string program_version;
  /// Of the program that computed the runs; empty: not known, or another engine did.
  std::string physics_digest = {};
  /// That computed the runs where it was not clast, "rockable": what needs contacts is not known.
  std::string engine = {};
  std::vector<BlockSummary> blocks;
  std::vector<Barrier> barriers;            ///< local frame
  std::vector<Vec3> release_points;         ///< local frame; z as started for the first orientation
  std::vector<std::string> release_sets;    ///< names; one without a name when there is one
  std::vector<std::uint32_t> set_of_point;  ///< index into `release_sets`
  std::vector<SpheroPolyhedron> shapes;     ///< of library blocks, body frame, unscaled
  std::vector<std::string> zone_names;
  std::vector<GroundParameters> ground;  ///< by zone, without groups; uncertain ones in the middle
  std::vector<GroundParameterSet> ground_sets;
  ContactLaw law;
  ContactWeighting weights = ContactWeighting::kPatch;
  std::vector<std::string> warnings;
  MapFrame frame;
  std::optional<Vec2> downslope;    ///< as asked for
  Terrain terrain;                  ///< the surface that was used, for maps
  std::optional<PersistentBlocksSettings> stay;  ///< none: every run had the terrain to itself
  std::uint32_t planned_runs = 0;

  /// Whether the runs tell of contacts: penetration, impacts, dissipation.
  bool has_contacts() const { return engine.empty(); }
  /// Runs that are computed together: those of a realisation, or one.
  std::uint32_t runs_per_realisation() const { return stay ? stay->blocks_each : 1; }
};

/// A results file, read whole except for the trajectories.
struct CampaignResults : CampaignHeader {
  std::vector<RunRecord> runs;      ///< in run order
  std::vector<Crossing> crossings;  ///< in run order, then time
  std::vector<Impact> impacts;      ///< in run order, then time
  std::vector<PersistentBlockRecord> stays;    ///< in run order
  /// In order of realisation, then time; none in results of older programs.
  std::vector<EnergyRecord> energies;

  /// What is kept of a run whose block stayed among others; null: none.
  const PersistentBlockRecord* find_persistent_block(std::uint32_t run) const;
};

/// @throws InputError  missing, not clast results, damaged, or of a newer schema
CampaignResults read_results(const std::filesystem::path& path);

/// The trajectories of a results file, read one by one. One thread at a time.
class TrajectoryFile {
 public:
  /// @throws InputError  as `read_results`
  explicit TrajectoryFile(const std::filesystem::path& path);
  ~TrajectoryFile();
  TrajectoryFile(TrajectoryFile&&) noexcept;

  /// How many states are stored of a run; 0 for none.
  std::size_t frames(std::uint32_t run) const;
  /// @throws InputError  no such run, or trajectories were not stored
  Trajectory read(std::uint32_t run) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};
/// One trajectory.
/// @throws InputError  as `TrajectoryFile`
Trajectory read_trajectory(const std::filesystem::path& path, std::uint32_t run);

/// Joins parts of one campaign, which `clast simulate --shard` wrote, to the file that one process
/// would have written, with the same datasets. Any order of parts.
/// @throws InputError  a part can't be read; parts of different campaigns, inputs or versions; a
///                     run in two parts; runs that are in none, with the shard that they belong to
void merge_results(const std::vector<std::filesystem::path>& parts,
                   const std::filesystem::path& target);

/// Checks that results could be written to `target`, before the runs.
/// @param replace  results that are there; false: they are kept
/// @throws InputError  a folder, a device, a link in a circle, write-protected, in a folder that
///                     can't be written to, a file that is not empty and holds no results, or one
///                     that is to be kept
void check_results_target(const std::filesystem::path& target, bool replace);

/// Are the results of this campaign in `target` already, finished?
/// @param runs  that will be in the file
/// @throws InputError  it holds other results: of another campaign, other inputs or another version
bool is_finished(const std::filesystem::path& target, const CampaignHeader& header,
                 std::size_t runs);

/// Where runs are kept until all are done: target + ".part", a journal, not HDF5.
std::filesystem::path journal_path(const std::filesystem::path& target);

/// Keeps results run by run, so that a kill costs no run that was added, and writes the file when
/// all are done. Until then it holds the lock on the target (core/files/file_lock.hpp).
class ResultsWriter {
 public:
  /// Starts anew, in place of what an interrupted campaign left. Makes missing parent folders.
  /// @param runs  that will be in the file
  /// @throws InputError  as `check_results_target`; another program is writing to the target; or
  ///                     the disk is too full for the header and as many runs
  static ResultsWriter create(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs = 0);
  /// Goes on with `journal_path(target)`; half a run that a kill left is dropped.
  /// @throws InputError  it is missing, damaged, or of another campaign (by hash of campaign and
  ///                     inputs); or as `create`
  static ResultsWriter resume(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs = 0);
  ~ResultsWriter();
  ResultsWriter(ResultsWriter&&) noexcept;

  /// Runs that are in the file already, sorted.
  const std::vector<std::uint32_t>& runs_with_trajectory() const;
  /// Adds one run and flushes. Order does not matter.
  void add(const StoredRun& run);
  /// Writes the target, whole, with runs in order of their number; the journal goes.
  void finish();

 private:
  struct Impl;
  explicit ResultsWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
