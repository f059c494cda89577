#pragma once
/// What scanning and its software do to the surface of a rock.
#include <cstdint>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// How much of each damage. Lengths are shares of the diagonal D of the rock.
struct Damage {
  double ground_height = 0.02;  ///< triangles wholly lower than this share of the height are lost
  std::size_t holes = 15;
  double hole_radius = 0.04;     ///< of the largest
  double jitter = 1e-7;          ///< triangles don't share vertices; each is moved by up to this
  double flipped = 0.05;         ///< share of triangles that face the other way
  std::size_t duplicates = 100;  ///< triangles stored twice, half of them facing the other way
  std::size_t fins = 100;        ///< triangles that stand on an edge
  double spikes = 0.001;         ///< share of vertices
  double spike_height = 0.06;
  std::size_t sheets = 4;  ///< patches stored again a little outside
  double sheet_radius = 0.05;
  double sheet_gap = 0.004;
  std::size_t islands = 20;  ///< scraps beside the rock, open and closed
  std::size_t bubbles = 2;   ///< closed shells inside

  /// 1: the numbers above; 0.5: half of each damage; 2: twice as much.
  static Damage of_intensity(double factor);
};

struct DamagedRock {
  TriangleMesh mesh;
  double largest_hole = 0.0;  ///< radius of the largest hole about the middle of its border, m
  double lost_share = 0.0;    ///< of the area that is gone
};

/// A damaged copy of `rock`, the same for the same seed.
/// @param rock  closed, outward, triangles small against D
DamagedRock damaged(const TriangleMesh& rock, const Damage& damage, std::uint64_t seed);

}  // namespace clast
