#pragma once
/// Virtual barriers: vertical planes in which passing blocks are counted and measured.
#include <string>
#include <vector>

#include "dem/simulation/release.hpp"

namespace clast {

/// Which crossings count at a line that is no ring; a run counts once, at its first one.
enum class CountedDirection { kEither, kForward };

/// By name, "either" or "forward".
/// @throws InputError  unknown name; the message lists both
CountedDirection parse_counted_direction(const std::string& name);
std::string name_of(CountedDirection crossings);

/// Vertical planes over the segments of a line on the map. Forward is from the left of the line, as
/// it runs, to its right. A line that ends at its first point is a ring, which is entered and left:
/// one that runs counter-clockwise is left forward.
struct Barrier {
  std::string name;
  std::vector<Vec2> through;  ///< local frame, m; as `check_barrier_line` wants it
  CountedDirection counted = CountedDirection::kEither;
};

/// One passage of a centre of mass through a barrier.
struct Crossing {
  std::uint32_t run = 0;
  std::uint32_t barrier = 0;  ///< index into the campaign's barriers
  bool forward = true;
  double time = 0.0;                     ///< s
  Vec3 position = Vec3::Zero();          ///< of the centre, m
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
  double height = 0.0;                   ///< of the centre above the ground under it, m
  double clearance = 0.0;                ///< of the lowest skin point above the ground under it, m
  double translational_energy = 0.0;     ///< J
  double rotational_energy = 0.0;        ///< J

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(run, barrier, forward, time, position, velocity, angular_velocity, height, clearance,
          translational_energy, rotational_energy);
  }
};

/// The crossings of `step` through the barrier in order of time, one at most through each segment:
/// exact time in flight, to 1e-9 s otherwise. A centre exactly on a plane counts as right of it,
/// and an inner point of the line belongs to the segment that begins there. Of a ring, entries and
/// exits alternate, also where a path grazes a corner. None where the centre
/// is not over surveyed ground; where only the lowest skin point is not, its clearance is taken to
/// the ground under the centre. `run` and `barrier` of the results are left to the caller.
std::vector<Crossing> find_crossings(const Barrier& barrier, const RigidBody& body,
                                     const MotionStep& step, const TerrainSurface& terrain,
                                     double gravity);

}  // namespace clast
