#pragma once
/// Virtual barriers: vertical planes at which the passages of blocks are counted and measured.
#include <string>
#include <vector>

#include "dem/simulation/release.hpp"

namespace clast {

/// Direction in which crossings of a barrier line are counted; not used for rings. Only the first
/// counted crossing of a run is used.
enum class CountedDirection { kEither, kForward };

/// Parses "either" or "forward".
/// @throws InputError  if the name is unknown
CountedDirection parse_counted_direction(const std::string& name);
std::string name_of(CountedDirection crossings);

/// Barrier: vertical planes through the segments of a line in plan. A forward crossing is from left
/// to right of the line, looking from first to last point. A line that ends at its first point is a
/// ring, with entries and exits. Exits of a counter-clockwise ring are forward crossings.
struct Barrier {
  std::string name;
  std::vector<Vec2> vertices;  ///< local frame, m; satisfies `check_barrier_line`
  CountedDirection counted = CountedDirection::kEither;
};

/// Crossing of a barrier by a centre of mass.
struct Crossing {
  std::uint32_t run = 0;
  std::uint32_t barrier = 0;  ///< index into the campaign's barriers
  bool forward = true;
  double time = 0.0;                     ///< s
  Vec3 position = Vec3::Zero();          ///< of the centre of mass, m
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
  double height = 0.0;                   ///< height of the centre of mass above the ground, m
  double clearance = 0.0;                ///< height of the lowest surface point above the ground, m
  double translational_energy = 0.0;     ///< J
  double rotational_energy = 0.0;        ///< J

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, barrier, forward, time, position, velocity, angular_velocity, height, clearance,
          translational_energy, rotational_energy);
  }
};

/// Finds the crossings of a barrier by the centre of mass during a step, in order of time, at most
/// one per segment. Times are exact in free flight, and accurate to 1e-9 s otherwise. A centre
/// exactly on a plane is treated as right of it. Entries and exits of a ring alternate, also if the
/// path touches a vertex. There are no crossings outside surveyed ground. If only the lowest
/// surface point is outside, the clearance refers to the ground below the centre. The caller sets
/// `run` and `barrier`.
std::vector<Crossing> find_crossings(const Barrier& barrier, const RigidBody& body,
                                     const MotionStep& step, const TerrainSurface& terrain,
                                     double gravity);

}  // namespace clast
