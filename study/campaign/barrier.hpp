#pragma once
/// Virtual barriers: vertical planes at which passing blocks are counted and measured.
#include <string>
#include <vector>

#include "dem/simulation/release.hpp"

namespace clast {

/// Crossing direction that counts at a barrier line (not a ring). A run counts once, at its first
/// counted crossing.
enum class CountedDirection { kEither, kForward };

/// Parses "either" or "forward".
/// @throws InputError  if the name is unknown
CountedDirection parse_counted_direction(const std::string& name);
std::string name_of(CountedDirection crossings);

/// Barrier: vertical planes over the segments of a line in plan. Forward is from left to right of
/// the line in its own direction. A line that ends at its first point is a ring with entries and
/// exits; a counter-clockwise ring is left in the forward direction.
struct Barrier {
  std::string name;
  std::vector<Vec2> through;  ///< local frame, m; satisfies `check_barrier_line`
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
  double height = 0.0;                   ///< of the centre of mass above the ground, m
  double clearance = 0.0;                ///< of the lowest surface point above the ground, m
  double translational_energy = 0.0;     ///< J
  double rotational_energy = 0.0;        ///< J

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, barrier, forward, time, position, velocity, angular_velocity, height, clearance,
          translational_energy, rotational_energy);
  }
};

/// Finds the crossings of a barrier during a step, in order of time, at most one per segment. Times
/// are exact in free flight, otherwise to 1e-9 s. A centre exactly on a plane counts as right of
/// it; an inner point of the line belongs to the segment that starts there. Entries and exits of a
/// ring alternate, also if a path grazes a vertex. There are no crossings outside surveyed ground;
/// if only the lowest surface point is outside, its clearance refers to the ground below the
/// centre. The caller sets `run` and `barrier`.
std::vector<Crossing> find_crossings(const Barrier& barrier, const RigidBody& body,
                                     const MotionStep& step, const TerrainSurface& terrain,
                                     double gravity);

}  // namespace clast
