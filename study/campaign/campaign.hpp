#pragma once
/// What a campaign file asks for.
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
#include "study/campaign/posterior_draws.hpp"
#include "study/campaign/uncertain.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

/// Blocks by id, by class, or all.
struct BlockFilter {
  std::vector<std::string> ids;  ///< in this order; empty and no scheme: all
  std::string scheme;            ///< "garcia", "sneed-folk", "zingg"
  std::string shape_class;
};

/// To what size blocks are brought; shape and density stay.
struct BlockScale {
  enum class Kind { kNone, kMass, kVolume, kEqualMass };
  Kind kind = Kind::kNone;
  double value = 0.0;  ///< kg or m^3; equal mass: the mean mass of the selected blocks
};

/// Blocks drawn from those selected: so many of each class, each scaled to a drawn mass; where
/// blocks stay, anew for each realisation.
struct BlockSampling {
  std::size_t count = 0;         ///< 0: as many as have `volume` on average
  std::optional<double> volume;  ///< of all of them together, in place of `count`, m^3
  std::uint64_t seed = 1;
  std::string scheme = "garcia";
  std::vector<std::pair<std::string, double>> shares;  ///< of classes, sum 1; empty: as they are
  /// In place of those of these classes; the others divide what is left as they did before.
  std::map<std::string, double> set_shares = {};
  std::optional<Distribution> mass;  ///< kg; none: the block's own
};

/// Which blocks run, and how large.
struct BlockSelection {
  std::filesystem::path library;
  BlockFilter filter;
  BlockScale scale;
  std::optional<BlockSampling> draw;
  /// Bodies that are made of the selected blocks and run in their place; its library and blocks are
  /// those above.
  std::optional<SeriesRequest> vary;
  bool any_size = false;  ///< take blocks beyond the usual sizes, or large for the terrain
};

/// Ground parameters of a zone as the campaign gives them; in a block group only what differs.
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

/// Blocks to which the ground behaves differently.
struct BlockGroup {
  std::string name;
  BlockFilter filter;
  std::map<std::string, GroundDistributions> ground;  ///< by zone
};

/// How often the uncertain parameters are drawn.
struct Ensemble {
  enum class Design {
    kRandom,  ///< each member by chance
    kSobol,   ///< together they fill the space of the parameters evenly
  };
  std::uint32_t members = 1;
  std::uint64_t seed = 1;
  Design design = Design::kRandom;
  /// Each member has the ground of one of its draws; parameters that it does not have are as the
  /// campaign says.
  std::optional<PosteriorDraws> posterior;
};

/// Where and how blocks start. Points are of the centre of mass, in map coordinates, z up.
struct ReleaseSet {
  std::string name;  ///< empty where there is only one
  std::vector<Vec3> points;
  std::string orientation_source;  ///< as written: "grid-45", "random", or a file
  std::vector<Quat>
      orientations;  ///< world_from_source, or world_from_body for the principal frame
  bool in_principal_frame = false;  ///< what `orientations` turn
  /// Other random orientations for every block and point, as many as `orientations` has.
  bool fresh_orientations = false;
  std::uint64_t orientation_seed = 1;
  std::optional<double> drop_height;     ///< m: then points are plan positions
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> files;  ///< point and orientation files that were read
};

/// A rock mass whose blocks are released at once, from where they lie in the frame of their
/// library, or out of a heap put together without overlap. Its name is that of its ReleaseSet.
struct MultiBlockRelease {
  bool in_place = false;
  double raised = 0.0;  ///< above their places in the library, m
  /// In map coordinates: that the heap lies in; of blocks in place, where there are several masses,
  /// that their centres lie in.
  std::vector<Vec2> polygon;
  std::optional<double> thickness;  ///< most height of the heap above the ground, m
  /// Of the blocks of a realisation; none, and no count: by area of the polygon, of what is left.
  std::optional<double> share;
  std::optional<std::uint32_t> count;  ///< of blocks in each realisation
  double release_time = 0.0;           ///< held until then, since the first release, s
  bool settle = false;                 ///< behind faces on the sides of the polygon, at first
  double settle_time = 20.0;           ///< that the blocks must rest after, s
  /// The faces are removed at the release, one after the other at this interval, s; 0: together.
  double face_interval = 0.0;
};

/// Blocks that stay where they stop: in each realisation they are released one after the other,
/// each when those before it have come to rest, or as rock masses.
struct PersistentBlocksPlan {
  std::uint32_t realisations = 1;
  std::vector<MultiBlockRelease> masses;  ///< none: one after the other; else one to each ReleaseSet
  bool random_order = true;      ///< of the blocks, drawn for each realisation; else as selected
  std::vector<std::string> cleared_zones;  ///< blocks that come to rest there are removed
  GroundParameters between_blocks;         ///< what two blocks do to each other

  /// Of the masses, since the first, s; 0 without. Faces that are removed one by one count.
  double last_release_time() const;
  /// That the blocks of masses that settle must rest after, s; 0: none settles.
  double settling_time() const;
};

/// A campaign, read and checked. Paths are resolved against the campaign file's folder, with
/// ${CLAST_DATA} replaced by the environment variable of that name (default ../shared/data).
struct Campaign {
  std::filesystem::path file;
  std::string sha256;
  std::string text;  ///< the file, byte for byte
  BlockSelection blocks;
  TerrainOptions terrain;
  double terrain_radius = 0.0;  ///< m
  /// Release points nearer to the border are warned of, m.
  std::optional<double> border_distance;
  std::map<std::string, GroundDistributions> ground;  ///< complete
  std::vector<BlockGroup> groups;             ///< a block is in one at most
  Ensemble ensemble;
  /// One at least; names differ. Those of masses have no points.
  std::vector<ReleaseSet> releases;
  std::optional<PersistentBlocksPlan> stay;  ///< none: every run has the terrain to itself
  ContactWeighting weights = ContactWeighting::kPatch;
  StiffnessOptions stiffness;     ///< with the contact law; all else empty: auto
  std::vector<Barrier> barriers;  ///< in map coordinates
  double max_time = 60.0;         ///< s
  double rest_energy = 2e-4;      ///< J/kg
  double rest_duration = 0.5;     ///< s
  double gravity = 9.81;          ///< m/s^2
  std::optional<Vec2> downslope;
  double trajectory_interval = 0.1;  ///< s; 0 stores no trajectories
};

/// @throws InputError  a key that is unknown, missing, of the wrong type or out of range: file,
///                     line, key, value and what was expected; or a file it names that can't be
///                     read
Campaign read_campaign(const std::filesystem::path& file);
/// Reads a campaign from text that a program made or changed.
/// @param file  paths in the text are relative to the folder of this file, and messages name it; it
///              need not exist
/// @throws InputError  as `read_campaign`
Campaign parse_campaign(const std::string& text, const std::filesystem::path& file);

/// The 4^3 rotations by 45 degrees: qz(c) qy(b) qx(a), a, b, c in 0, 45, 90, 135 degrees, c
/// fastest.
std::vector<Quat> orientations_in_45_degree_grid();

}  // namespace clast
