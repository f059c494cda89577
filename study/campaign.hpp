#pragma once
/// What a campaign file asks for.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dem/release.hpp"
#include "dem/stiffness.hpp"
#include "study/barrier.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

/// Blocks by id, by class, or all.
struct BlockSelection {
  std::filesystem::path library;
  std::vector<std::string> ids;  ///< in this order; empty and no scheme: all
  std::string scheme;            ///< "garcia", "sneed-folk", "zingg"
  std::string shape_class;
};

/// Where and how blocks start. Points are of the centre of mass, in map coordinates, z up.
struct ReleasePlan {
  std::vector<Vec3> points;
  std::string orientation_source;  ///< as written: "grid-45", "random", or a file
  std::vector<Quat>
      orientations;  ///< world_from_source, or world_from_body for the principal frame
  bool in_principal_frame = false;       ///< what `orientations` turn
  std::optional<double> drop_height;     ///< m: then points are plan positions
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> files;  ///< point and orientation files that were read
};

/// A campaign, read and checked. Paths are resolved against the campaign file's folder, with
/// ${CLAST_DATA} replaced by the environment variable of that name (default ../shared/data).
struct Campaign {
  std::filesystem::path file;
  std::string sha256;
  std::string text;  ///< the file, byte for byte
  BlockSelection blocks;
  TerrainOptions terrain;
  double terrain_radius = 0.0;            ///< m
  std::optional<double> border_distance;  ///< release points nearer to the border are warned of, m
  std::map<std::string, GroundParameters> ground;
  ReleasePlan release;
  ContactWeights weights = ContactWeights::kPatch;
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
/// line,
///                     key, value and what was expected; or a file it names that can't be read
Campaign read_campaign(const std::filesystem::path& file);

/// The 4^3 rotations by 45 degrees: qz(c) qy(b) qx(a), a, b, c in 0, 45, 90, 135 degrees, c
/// fastest.
std::vector<Quat> grid_45_orientations();

}  // namespace clast
