#pragma once
/// Contents of a campaign file.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dem/contact/stiffness.hpp"
#include "dem/simulation/release.hpp"
#include "library/series_request.hpp"
#include "study/campaign/barrier.hpp"
#include "study/campaign/distribution.hpp"
#include "study/campaign/posterior_draws.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

/// Selection of library blocks: by id, by class, or all.
struct BlockFilter {
  std::vector<std::string> ids;  ///< ids of the blocks, in this order; if empty and `scheme` is
                                 ///< empty, all blocks are selected
  std::string scheme;            ///< classification scheme: "garcia", "sneed-folk" or "zingg"
  std::string shape_class;
};

/// Scaling of the blocks at constant shape and density.
struct BlockScaling {
  enum class Kind { kNone, kMass, kVolume, kEqualMass };
  Kind kind = Kind::kNone;
  double value = 0.0;  ///< mass, kg, or volume, m^3; unused for kEqualMass (mean mass)
};

/// Random sampling of the selected blocks by class. Each sampled block is scaled to a random mass.
/// Persistent blocks are sampled again for each realisation.
struct BlockSampling {
  std::size_t count = 0;         ///< number of blocks in each realisation
  std::optional<double> volume;  ///< total volume, which replaces `count`, m^3
  std::uint64_t seed = 1;
  std::string scheme = "garcia";
  std::vector<std::pair<std::string, double>>
      shares;  ///< class fractions with sum 1; if empty, those of the selection are used
  /// Class fractions that replace those of the selection. The other classes keep their proportions.
  std::map<std::string, double> set_shares = {};
  std::optional<Distribution>
      mass;  ///< mass of a block, kg; if empty, that of the library block is used
};

/// Blocks of a campaign and their sizes.
struct BlockSelection {
  std::filesystem::path library;
  BlockFilter filter;
  BlockScaling scale;
  std::optional<BlockSampling> draw;
  /// Series of bodies that replaces the selected blocks. It uses `library` and the ids of `filter`.
  std::optional<SeriesRequest> vary;
  bool any_size = false;  ///< true: blocks of unusual size, or large for the terrain, are accepted
};

/// Ground parameters of a zone. Each is a value or a distribution. A block group states only the
/// parameters that differ from those of the zone.
struct GroundDistributions {
  std::optional<Distribution> energy_restitution;
  std::optional<Distribution> friction;
  std::optional<Distribution> rolling_friction;
  std::optional<Distribution> rolling_length;  ///< m
  std::optional<Distribution> friction_min;
  std::optional<Distribution> slip_growth;  ///< 1/m
  std::optional<Distribution> slip_memory;  ///< s
  std::optional<Distribution> scar_drag;
  std::optional<Distribution> soil_density;  ///< kg/m^3
  std::optional<Distribution> soil_memory;   ///< m
};

/// Blocks with ground parameters of their own.
struct BlockGroup {
  std::string name;  ///< name of the group
  BlockFilter filter;
  std::map<std::string, GroundDistributions> ground;  ///< parameters that differ, by zone
};

/// Ensemble: the uncertain parameters are drawn for each of its members.
struct Ensemble {
  enum class Design {
    kRandom,  ///< independent random draws
    kSobol,   ///< quasi-random Sobol sequence
  };
  std::uint32_t members = 1;
  std::uint64_t seed = 1;
  Design design = Design::kRandom;
  /// Posterior draws, one per member. Other parameters keep the values of the campaign.
  std::optional<PosteriorDraws> posterior;
};

/// Release points (centres of mass, map coordinates, z up), orientations and initial velocities.
struct ReleaseSet {
  std::string name;  ///< empty if there is only one set
  std::vector<Vec3> points;
  std::string orientation_source;  ///< text in the campaign: "grid-45", "random" or a file
  std::vector<Quat>
      orientations;  ///< world_from_source, or world_from_body if `in_principal_frame`
  bool in_principal_frame = false;  ///< true if `orientations` refer to the principal frame
  /// If true, independent random orientations are drawn for each block and point. Their number is
  /// that of `orientations`.
  bool fresh_orientations = false;
  std::uint64_t orientation_seed = 1;
  std::optional<double>
      drop_height;  ///< height above the ground, m; if set, only x and y of the points are used
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> files;  ///< point and orientation files that were read
};

/// Simultaneous release of several blocks. They start at their positions in the frame of the
/// library, or in a heap without overlaps. Its name is that of its ReleaseSet.
struct MultiBlockRelease {
  bool in_place = false;
  double height_offset = 0.0;  ///< height above the positions in the library, m
  /// Outline in map coordinates, m. It is that of the heap. If several releases are in place, it
  /// contains the centres of the blocks.
  std::vector<Vec2> polygon;
  std::optional<double> thickness;  ///< maximum height of the heap above the ground, m
  /// Fraction of the blocks of a realisation; if `count` is empty too, proportional to polygon
  /// area.
  std::optional<double> share;
  std::optional<std::uint32_t> count;  ///< number of blocks in each realisation
  double release_time = 0.0;  ///< time since the first release until which the blocks are fixed, s
  bool settle = false;  ///< true: the blocks settle behind confining walls at the sides of the
                        ///< polygon before the release
  double settle_time = 20.0;  ///< time limit for settling, s
  /// Interval between removals of confining walls at the release, s. If 0, all are removed at once.
  double face_interval = 0.0;
};

/// Settings of persistent blocks, which stay on the terrain in a realisation. Blocks are released
/// one after the other, each when the previous ones are at rest, or as multi-block releases.
struct PersistentBlocksPlan {
  std::uint32_t realisations = 1;
  std::vector<MultiBlockRelease> masses;  ///< multi-block releases, one per ReleaseSet; if empty,
                                          ///< one block is released after the other
  bool random_order =
      true;  ///< true: random release order in each realisation; false: order of the selection
  std::vector<std::string> cleared_zones;  ///< zones in which blocks at rest are removed
  GroundParameters between_blocks;         ///< contact parameters between two blocks

  /// Time from the first to the last release or wall removal, s; 0 without multi-block releases.
  double last_release_time() const;
  /// Returns the longest settling time limit, s; 0 if no release settles.
  double settling_time() const;
};

/// Campaign that was read and checked. Paths are relative to the folder of the campaign file.
/// ${CLAST_DATA} is replaced by that environment variable (default ../shared/data).
struct Campaign {
  std::filesystem::path file;
  std::string sha256;
  std::string text;  ///< contents of the file, byte for byte
  BlockSelection blocks;
  TerrainOptions terrain;
  double terrain_radius = 0.0;  ///< m
  /// Minimum distance of release points from the terrain border, m. Smaller ones cause a warning.
  std::optional<double> border_distance;
  std::map<std::string, GroundDistributions> ground;  ///< parameters by zone, complete
  std::vector<BlockGroup> groups;                     ///< groups; each block is in at most one
  Ensemble ensemble;
  /// Release sets with distinct names, at least one. Those of multi-block releases have no points.
  std::vector<ReleaseSet> releases;
  std::optional<PersistentBlocksPlan>
      persistent_blocks;  ///< empty if each run simulates a single block
  ContactWeighting weighting = ContactWeighting::kPatch;
  StiffnessOptions
      stiffness;  ///< stiffness and contact law; empty members are chosen automatically
  std::vector<Barrier> barriers;  ///< in map coordinates
  double max_time = 60.0;         ///< time limit of a run, s
  double rest_energy = 2e-4;      ///< kinetic energy per mass below which a block is at rest, J/kg
  double rest_duration = 0.5;     ///< duration for which a block must be below `rest_energy`, s
  double gravity = 9.81;          ///< m/s^2
  std::optional<Vec2> downslope;
  double trajectory_interval =
      0.1;  ///< interval of stored states, s; 0: no trajectories are stored
};

/// Reads and checks a campaign file.
/// @throws InputError  if a key is unknown, missing, of the wrong type or out of range, or if a
///                     file that it names cannot be read; names file, line, key, value and
///                     expectation
Campaign read_campaign(const std::filesystem::path& file);
/// Parses a campaign from text.
/// @param file  path to which relative paths refer, used in messages; need not exist
/// @throws InputError  if `read_campaign` would throw
Campaign parse_campaign(const std::string& text, const std::filesystem::path& file);

/// Returns the 64 rotations qz(c) qy(b) qx(a) about the axes z, y and x, with a, b, c in {0, 45,
/// 90, 135} degrees; c varies fastest.
std::vector<Quat> orientations_in_45_degree_grid();

}  // namespace clast
