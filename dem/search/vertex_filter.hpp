#pragma once
/// Vertex filter: compares all vertices of a block part with the ground faces near it, four
/// vertices at a time. It proves that most vertices touch nothing, or one face only; the others
/// need an exact test. The results are the same to the last bit with every instruction set.
#include <cstddef>
#include <cstdint>

#include "dem/surface/block_parts.hpp"
#include "dem/surface/local_ground.hpp"

namespace clast::dem_detail {

/// Instructions that the filter uses.
enum class InstructionSet { kPortable, kAvx2 };
/// Returns the widest of these instruction sets that the processor has.
InstructionSet widest_instruction_set();

struct VertexFilterSettings {
  /// Rotation matrix from the body frame to the frame of the ground, by columns.
  const double* rotation;
  const double* position;  ///< origin of the body in the frame of the ground, m
  double reach;            ///< distance of an outside vertex below which it is in contact, m
  double max_depth;        ///< upper bound of the depth of all vertices inside the ground, m
};

/// Four vertices with the results of the filter.
struct FilteredVertices {
  /// The vertex is outside the ground and not in contact.
  static constexpr std::int64_t kClear = 0;
  /// The vertex is in contact with `face` only or inside the ground, with `face` as the nearest.
  static constexpr std::int64_t kOneFace = 1;
  /// The vertex needs an exact test; `face` is probably the nearest.
  static constexpr std::int64_t kUnknown = 2;

  bool all_clear() const { return (result[0] | result[1] | result[2] | result[3]) == kClear; }

  VertexGroup placed;  ///< vertices in the frame of the ground
  std::int64_t result[4];
  std::int64_t face[4];        ///< index into the list of faces
  double squared_distance[4];  ///< square of the distance from the faces, m^2, or a smaller value
};

/// Transforms vertices to the frame of the ground and classifies them.
///
/// The distance of a vertex from a face is at least that from the infinite prism under and over it
/// combined with its height over the plane. It is exactly the height if the vertex is in the prism.
/// @param groups  vertices in the body frame; `wanted_groups` are the indices of those to compare
/// @param faces  list of faces
/// @param close_faces  indices into `faces`: all that may touch a vertex or be nearest to a vertex
///                     inside the ground
/// @param filtered  results, one entry per wanted group
void filter_vertices(const VertexFilterSettings& settings, const VertexGroup* groups,
                     const std::uint32_t* wanted_groups, std::size_t group_count,
                     const FacePrism* faces, const std::uint32_t* close_faces,
                     std::size_t close_face_count, FilteredVertices* filtered,
                     InstructionSet instructions = widest_instruction_set());

/// Clearances of vertices outside the ground from one face.
struct PrismClearance {
  std::uint32_t face;  ///< index into the list of faces
  /// Displacement before contact, per height over the plane; 0 for a face at a border, which only
  /// its plane may separate from vertices.
  double displacement_per_height;
  /// Least height over the plane minus the reach, m, of the vertices that the plane separates best
  /// from the face; 1e300 without such vertices.
  double over_plane = 0.0;
  /// Least distance from the face minus the reach, m, of all other vertices.
  double from_face = 0.0;
};
/// Measures the clearances of filtered vertices from faces.
/// @param reach  distance of an outside vertex below which it is in contact, m
/// @param clearances  their faces and displacements are read, their clearances are written
void measure_prism_clearances(const FacePrism* faces, double reach,
                              const FilteredVertices* vertices, std::size_t group_count,
                              PrismClearance* clearances, std::size_t clearance_count,
                              InstructionSet instructions = widest_instruction_set());

}  // namespace clast::dem_detail
