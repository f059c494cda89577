#pragma once
/// One kind of damage at a time, as scanners and their software leave it. Lengths in the units of
/// the mesh; `Random` makes each the same for the same seed.
#include <cstddef>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

// What is lost.

/// Each triangle is lost with the probability `share`.
TriangleMesh without_faces(TriangleMesh mesh, double share, Random& random);
/// Each vertex is lost with the probability `share`, and with it the triangles around it.
TriangleMesh without_vertices(TriangleMesh mesh, double share, Random& random);
/// Triangles whose centres lie in one of `count` balls about points of the surface are lost; their
/// radii are half of `radius` to all of it.
TriangleMesh without_clumps(TriangleMesh mesh, std::size_t count, double radius, Random& random);
/// What lies beyond a plane across `direction` is lost: `share` of the extent along it. Triangles
/// are cut, so that the rim lies in the plane.
TriangleMesh cut_off(const TriangleMesh& mesh, const Vec3& direction, double share);
/// Triangles whose normals lie within `angle` of `direction` are lost: a side that no scan faced.
TriangleMesh without_side(TriangleMesh mesh, const Vec3& direction, double angle);

// What is there twice, or should not be there.

/// Triangles in random number and order are stored again, half of them facing the other way.
TriangleMesh with_duplicates(TriangleMesh mesh, double share, Random& random);
/// Each triangle faces the other way with the probability `share`.
TriangleMesh with_flipped_faces(TriangleMesh mesh, double share, Random& random);
/// Every triangle with vertices of its own, each moved by up to `gap`.
TriangleMesh as_soup(const TriangleMesh& mesh, double gap, Random& random);
/// The mesh and what of it lies within `radius` of a point of its surface once more, scaled about
/// the middle of its box by `factor` and moved by `shift`. An infinite radius doubles all of it.
TriangleMesh with_copy(const TriangleMesh& mesh, double factor, const Vec3& shift, double radius,
                       Random& random);
/// Two halves that overlap in a band of `band`, one of them moved by `shift`.
TriangleMesh in_two_halves(const TriangleMesh& mesh, const Vec3& direction, double band,
                           const Vec3& shift);
/// Balls of up to `radius` that touch nothing: beside the mesh, where every other one is half a
/// ball, or inside of it, where every other one faces inwards.
TriangleMesh with_islands(TriangleMesh mesh, std::size_t count, double radius, Random& random);
TriangleMesh with_bubbles(TriangleMesh mesh, std::size_t count, double radius, Random& random);
/// Balls of `radius` whose centres are points of the surface.
TriangleMesh with_crossing_balls(TriangleMesh mesh, std::size_t count, double radius,
                                 Random& random);

// What is moved.

/// So many vertices stand out by 0.5 to 1 of `height`, one of five stands in.
TriangleMesh with_spikes(TriangleMesh mesh, std::size_t count, double height, Random& random);

enum class Jitter {
  kAllWays,       ///< in any direction, by up to the amplitude
  kAlongNormals,  ///< outward or inward, by up to the amplitude
  kOutward,       ///< outward, by up to the amplitude
  kOneSidedNoise  ///< one of three vertices outward, by |N(0, amplitude)|
};
TriangleMesh jittered(TriangleMesh mesh, Jitter jitter, double amplitude, Random& random);

}  // namespace clast
