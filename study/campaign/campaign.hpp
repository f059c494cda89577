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

/// Selection of blocks of a library: by id, by shape class, or all.
struct BlockFilter {
  /// Ids of the selected blocks, in this order; if empty, blocks are selected by class.
  std::vector<std::string> ids;
  /// Classification scheme of `shape_class`; if empty, all blocks are selected.
  std::string scheme;
  std::string shape_class;
};

/// Scaling of blocks to a mass or volume, at constant shape and density.
struct BlockScaling {
  enum class Kind { kNone, kMass, kVolume, kEqualMass };
  Kind kind = Kind::kNone;
  /// Mass, kg, or volume, m^3; unused for kEqualMass, where all blocks get the mean mass.
  double value = 0.0;
};

/// Random sampling of blocks from the selected library blocks, by shape class. Each sampled block
/// is scaled to a random mass.
struct BlockSampling {
  std::size_t count = 0;         ///< number of blocks in each realisation
  std::optional<double> volume;  ///< total volume of the blocks, m^3; replaces `count`
  std::uint64_t seed = 1;
  std::string scheme = "garcia";
  /// Fraction of each class, with sum 1; if empty, the fractions of the selected blocks.
  std::vector<std::pair<std::string, double>> shares;
  /// Fractions of single classes that replace those of the selected blocks. The other classes keep
  /// their proportions.
  std::map<std::string, double> set_shares = {};
  std::optional<Distribution> mass;  ///< mass of a block, kg; if empty, that of the library block
};

/// Blocks of a campaign and their sizes.
struct BlockSelection {
  std::filesystem::path library;
  BlockFilter filter;
  BlockScaling scale;
  std::optional<BlockSampling> draw;
  /// Series of varied bodies that replaces the selected blocks.
  std::optional<VariationSeriesRequest> vary;
  bool any_size = false;  ///< true if blocks of unusual size are accepted
};

/// Ground parameters of a zone, each a fixed value or a probability distribution. Empty parameters
/// are not stated.
struct GroundDistributions {
  std::optional<Distribution> energy_restitution;
  std::optional<Distribution> friction;
  std::optional<Distribution> rolling_friction;
  std::optional<Distribution> rolling_length;  ///< rounding radius of the terrain surface, m
  std::optional<Distribution> friction_min;
  std::optional<Distribution> slip_growth;  ///< 1/m
  std::optional<Distribution> slip_memory;  ///< s
  std::optional<Distribution> scar_drag;
  std::optional<Distribution> soil_density;  ///< kg/m^3
  std::optional<Distribution> soil_memory;   ///< m
};

/// Group of blocks with ground parameters of their own.
struct BlockGroup {
  std::string name;  ///< name of the group
  BlockFilter filter;
  /// Parameters that replace those of a zone for blocks of this group, by zone name.
  std::map<std::string, GroundDistributions> ground;
};

/// Ensemble: members with independent draws of the uncertain parameters.
struct Ensemble {
  enum class Design {
    kRandom,  ///< independent random draws
    kSobol,   ///< quasi-random Sobol sequence
  };
  std::uint32_t members = 1;
  std::uint64_t seed = 1;
  Design design = Design::kRandom;
  /// Posterior draws of a calibration, one of which is used by each member.
  std::optional<PosteriorDraws> posterior;
};

/// Release set: release points, orientations and initial velocities of blocks.
struct ReleaseSet {
  std::string name;  ///< empty if there is only one set
  std::vector<Vec3> points;
  /// Origin of the orientations in the campaign: "grid-45", "random" or a file.
  std::string orientation_source;
  /// Rotations of the blocks; from their principal frame if `in_principal_frame`, otherwise from
  /// the frame of the library.
  std::vector<Quat> orientations;
  /// True if `orientations` refer to the principal frames of the blocks.
  bool in_principal_frame = false;
  /// True if other random orientations are drawn for each block and release point.
  bool fresh_orientations = false;
  std::uint64_t orientation_seed = 1;
  /// Height of the release points above the ground, m; replaces their z.
  std::optional<double> drop_height;
  Vec3 velocity = Vec3::Zero();          ///< initial velocity, m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< initial angular velocity, rad/s
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> files;  ///< point and orientation files that were read
};

/// Simultaneous release of several blocks. They start at their positions in the library, or in a
/// heap without overlaps.
struct MultiBlockRelease {
  bool in_place = false;
  double height_offset = 0.0;  ///< height of the start above the positions in the library, m
  /// Outline of the heap in map coordinates, m. For blocks at their library positions, it contains
  /// their centres.
  std::vector<Vec2> polygon;
  std::optional<double> thickness;  ///< maximum height of the heap above the ground, m
  /// Fraction of the blocks of a realisation. If `count` is empty too, it is proportional to the
  /// area of the outline.
  std::optional<double> share;
  std::optional<std::uint32_t> count;  ///< number of blocks in each realisation
  double release_time = 0.0;           ///< time of the release after the first release, s
  bool settle = false;  ///< true if the blocks settle behind confining walls before the release
  double settle_time = 20.0;  ///< time limit for settling, s
  /// Interval between the removals of the confining walls, s; if 0, all are removed at once.
  double face_interval = 0.0;
};

/// Settings of persistent blocks, which stay on the terrain and may collide. They are released one
/// after the other, or several at once.
struct PersistentBlocksPlan {
  std::uint32_t realisations = 1;
  /// Simultaneous releases; if empty, one block is released after the other.
  std::vector<MultiBlockRelease> masses;
  /// True if the release order is random; false if it is that of the selection.
  bool random_order = true;
  std::vector<std::string> cleared_zones;  ///< zones in which blocks at rest are removed
  GroundParameters between_blocks;         ///< contact parameters between two blocks

  /// Returns the time from the first to the last release or wall removal, s; 0 for blocks released
  /// one after the other.
  double last_release_time() const;
  /// Returns the longest time limit for settling, s; 0 if no blocks settle.
  double settling_time() const;
};

/// Contents of a campaign file, read and checked.
struct Campaign {
  std::filesystem::path file;
  std::string sha256;
  std::string text;  ///< contents of the file, byte for byte
  BlockSelection blocks;
  TerrainOptions terrain;
  double terrain_radius = 0.0;  ///< m
  /// Minimum distance of release points from the terrain border, m. Smaller distances cause a
  /// warning.
  std::optional<double> border_distance;
  std::map<std::string, GroundDistributions> ground;  ///< ground parameters by zone name, complete
  /// Groups with ground parameters of their own; each block is in at most one.
  std::vector<BlockGroup> groups;
  Ensemble ensemble;
  /// Release sets with distinct names, at least one.
  std::vector<ReleaseSet> releases;
  /// Empty if each run simulates a single block.
  std::optional<PersistentBlocksPlan> persistent_blocks;
  ContactWeighting weighting = ContactWeighting::kPatch;
  StiffnessOptions stiffness;  ///< contact law and stiffness; empty values are chosen automatically
  std::vector<Barrier> barriers;  ///< in map coordinates
  double max_time = 60.0;         ///< time limit of a run, s
  double rest_energy = 2e-4;      ///< largest kinetic energy per mass of a block at rest, J/kg
  double rest_duration = 0.5;     ///< time for which a block at rest must be below `rest_energy`, s
  double gravity = 9.81;          ///< m/s^2
  std::optional<Vec2> downslope;
  /// Interval of stored states, s; if 0, no trajectories are stored.
  double trajectory_interval = 0.1;
};

/// Reads and checks a campaign file.
/// @throws InputError  if a key or value is invalid, or if a file cannot be read; names file, line,
///                     key, value and expectation
Campaign read_campaign(const std::filesystem::path& file);
/// Parses a campaign from text.
/// @param file  path to which relative paths refer, used in messages; need not exist
/// @throws InputError  if `read_campaign` would throw
Campaign parse_campaign(const std::string& text, const std::filesystem::path& file);

/// Returns the 64 orientations of a grid: combined rotations about the axes x, y and z by 0, 45, 90
/// or 135 degrees each.
std::vector<Quat> orientations_in_45_degree_grid();

}  // namespace clast
