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
  std::vector<std::string> ids;  ///< in this order; all blocks if empty and `scheme` is empty
  std::string scheme;            ///< "garcia", "sneed-folk", "zingg"
  std::string shape_class;
};

/// Scaling of the blocks; shape and density are kept.
struct BlockScale {
  enum class Kind { kNone, kMass, kVolume, kEqualMass };
  Kind kind = Kind::kNone;
  double value =
      0.0;  ///< kg or m^3; unused for equal mass, which is the mean mass of the selected blocks
};

/// Random sampling of the selected blocks by class, each scaled to a drawn mass. Persistent blocks
/// are sampled anew for each realisation.
struct BlockSampling {
  std::size_t count = 0;         ///< number of blocks in each realisation
  std::optional<double> volume;  ///< total volume in place of `count`, m^3
  std::uint64_t seed = 1;
  std::string scheme = "garcia";
  std::vector<std::pair<std::string, double>>
      shares;  ///< class fractions, sum 1; empty: those of the selection
  /// Class fractions that replace those of the selection; the other classes keep their proportions.
  std::map<std::string, double> set_shares = {};
  std::optional<Distribution> mass;  ///< kg; empty: the mass of the library block
};

/// Blocks of a campaign and their sizes.
struct BlockSelection {
  std::filesystem::path library;
  BlockFilter filter;
  BlockScale scale;
  std::optional<BlockSampling> draw;
  /// Series of varied bodies that replaces the selected blocks; its library and ids are those
  /// above.
  std::optional<SeriesRequest> vary;
  bool any_size = false;  ///< accept blocks outside the usual sizes, or large for the terrain
};

/// Ground parameters of a zone, each a value or a distribution. Block groups state only the
/// parameters that differ.
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
  std::string name;  ///< empty if there is only one set
  BlockFilter filter;
  std::map<std::string, GroundDistributions> ground;  ///< by zone, all parameters present
};

/// Ensemble of draws of the uncertain parameters.
struct Ensemble {
  enum class Design {
    kRandom,  ///< independent random draws
    kSobol,   ///< quasi-random Sobol sequence
  };
  std::uint32_t members = 1;
  std::uint64_t seed = 1;
  Design design = Design::kRandom;
  /// Posterior draws, one per member; parameters that they lack keep the campaign's values.
  std::optional<PosteriorDraws> posterior;
};

/// Release points, orientations and initial velocities. Points are centres of mass in map
/// coordinates, z up.
struct ReleaseSet {
  std::string name;  ///< empty where there is only one
  std::vector<Vec3> points;
  std::string orientation_source;  ///< as written: "grid-45", "random" or a file
  std::vector<Quat>
      orientations;  ///< world_from_source, or world_from_body if `in_principal_frame`
  bool in_principal_frame = false;  ///< true if `orientations` refer to the principal frame
  /// If true, each block and point has independent random orientations, as many as `orientations`.
  bool fresh_orientations = false;
  std::uint64_t orientation_seed = 1;
  std::optional<double> drop_height;     ///< m; if given, points are plan positions
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> files;  ///< point and orientation files that were read
};

/// Release of several blocks at once: from their positions in the library's frame, or from a heap
/// without overlaps. Its name is that of its ReleaseSet.
struct MultiBlockRelease {
  bool in_place = false;
  double raised = 0.0;  ///< above the positions in the library, m
  /// Outline in map coordinates: of the heap, or of the block centres if several releases are in
  /// place.
  std::vector<Vec2> polygon;
  std::optional<double> thickness;  ///< maximum height of the heap above the ground, m
  /// Fraction of the blocks of a realisation. If `count` is empty too, the remaining blocks are
  /// divided by polygon area.
  std::optional<double> share;
  std::optional<std::uint32_t> count;  ///< of blocks in each realisation
  double release_time = 0.0;           ///< blocks are fixed until then, since the first release, s
  bool settle = false;  ///< let the blocks settle behind confining walls at the polygon's sides
                        ///< before the release
  double settle_time = 20.0;  ///< time limit for settling, s
  /// Interval between the removals of the confining walls at the release, s; 0: all at once.
  double face_interval = 0.0;
};

/// Settings of persistent blocks: in each realisation, blocks are released one after the other,
/// each when the previous ones are at rest, or as multi-block releases.
struct PersistentBlocksPlan {
  std::uint32_t realisations = 1;
  std::vector<MultiBlockRelease>
      masses;  ///< multi-block releases, one per ReleaseSet; empty: one block after the other
  bool random_order =
      true;  ///< random release order in each realisation; false: the selected order
  std::vector<std::string> cleared_zones;  ///< zones in which blocks at rest are removed
  GroundParameters between_blocks;         ///< contact parameters between two blocks

  /// Returns the time of the last release or wall removal since the first release, s; 0 without
  /// multi-block releases.
  double last_release_time() const;
  /// Returns the longest settling time limit, s; 0 if no release settles.
  double settling_time() const;
};

/// Campaign that was read and checked. Paths are resolved against the folder of the campaign file;
/// ${CLAST_DATA} is replaced by that environment variable (default ../shared/data).
struct Campaign {
  std::filesystem::path file;
  std::string sha256;
  std::string text;  ///< contents of the file, byte for byte
  BlockSelection blocks;
  TerrainOptions terrain;
  double terrain_radius = 0.0;  ///< m
  /// Distance from the terrain border below which release points cause a warning, m.
  std::optional<double> border_distance;
  std::map<std::string, GroundDistributions> ground;  ///< complete
  std::vector<BlockGroup> groups;                     ///< each block is in at most one
  Ensemble ensemble;
  /// Release sets with distinct names, at least one. The sets of multi-block releases have no
  /// points.
  std::vector<ReleaseSet> releases;
  std::optional<PersistentBlocksPlan> stay;  ///< empty: each run has the terrain to itself
  ContactWeighting weights = ContactWeighting::kPatch;
  StiffnessOptions
      stiffness;  ///< including the contact law; empty members are chosen automatically
  std::vector<Barrier> barriers;  ///< in map coordinates
  double max_time = 60.0;         ///< s
  double rest_energy = 2e-4;      ///< J/kg
  double rest_duration = 0.5;     ///< s
  double gravity = 9.81;          ///< m/s^2
  std::optional<Vec2> downslope;
  double trajectory_interval = 0.1;  ///< s; 0: no trajectories are stored
};

/// Reads and checks a campaign file.
/// @throws InputError  if a key is unknown, missing, of the wrong type or out of range (file, line,
///                     key, value and expectation are named), or if a file that it names cannot be
///                     read
Campaign read_campaign(const std::filesystem::path& file);
/// Parses a campaign from text.
/// @param file  resolves relative paths and names the campaign in messages; need not exist
/// @throws InputError  as `read_campaign`
Campaign parse_campaign(const std::string& text, const std::filesystem::path& file);

/// Returns the 4^3 rotations qz(c) qy(b) qx(a) with a, b, c in 0, 45, 90, 135 degrees; c varies
/// fastest.
std::vector<Quat> orientations_in_45_degree_grid();

}  // namespace clast
