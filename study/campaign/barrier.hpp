#pragma once
/// Virtual barriers: vertical planes at which the passages of blocks are counted and measured.
#include <string>
#include <vector>

#include "dem/simulation/release.hpp"

namespace clast {

/// Direction in which crossings of a barrier are counted. Not used for rings, which have entries
/// and exits.
enum class CountedDirection { kEither, kForward };

/// Parses "either" or "forward".
/// @throws InputError  if the name is unknown
CountedDirection parse_counted_direction(const std::string& name);
std::string name_of(CountedDirection crossings);

/// Virtual barrier: vertical planes through the segments of a line in plan. A forward crossing is
/// from left to right, looking along the line. A line that ends at its first point is a ring, with
/// entries and exits.
struct Barrier {
  std::string name;
  std::vector<Vec2> vertices;  ///< points of the line, local frame, m
  CountedDirection counted = CountedDirection::kEither;
};

/// Crossing of a barrier by the centre of mass of a block.
struct Crossing {
  std::uint32_t run = 0;
  std::uint32_t barrier = 0;  ///< index into the campaign's barriers
  bool forward = true;
  double time = 0.0;                     ///< time of the crossing, s
  Vec3 position = Vec3::Zero();          ///< position of the centre of mass, m
  Vec3 velocity = Vec3::Zero();          ///< velocity of the centre of mass, m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< angular velocity, rad/s
  double height = 0.0;                   ///< height of the centre of mass above the ground, m
  double clearance = 0.0;                ///< height of the lowest surface point above the ground, m
  double translational_energy = 0.0;     ///< kinetic energy of the translation, J
  double rotational_energy = 0.0;        ///< kinetic energy of the rotation, J

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, barrier, forward, time, position, velocity, angular_velocity, height, clearance,
          translational_energy, rotational_energy);
  }
};

/// Finds the crossings of a barrier by the centre of mass of a block during a step, in order of
/// time. There is at most one crossing per segment. Times are exact in free flight, and accurate to
/// 1e-9 s otherwise. Crossings outside the surveyed ground are omitted. The caller sets `run` and
/// `barrier`.
std::vector<Crossing> find_crossings(const Barrier& barrier, const RigidBody& body,
                                     const MotionStep& step, const TerrainSurface& terrain,
                                     double gravity);

}  // namespace clast
