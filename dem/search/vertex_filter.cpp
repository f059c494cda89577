#include "dem/search/vertex_filter.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#define CLAST_HAS_AVX2_FUNCTIONS
#endif

namespace clast::dem_detail {
namespace {

/// Distances that differ by less are not distinguished, m. Larger than the rounding errors of
/// coordinates up to 100 km.
constexpr double kDistanceRounding = 1e-9;
/// The same for squared distances, m^2, in addition to their fraction of 1e-9.
constexpr double kSquareRounding = 1e-12, kSquareFraction = 1.0 + 1e-9;
constexpr double kFar = 1e300;

// The loops are written once, with the vector types of the compiler, and compiled for each
// instruction set and its number of lanes: the compiler would take a wider vector apart into
// numbers. They call no function: the linker could keep a copy of it with instructions that another
// processor does not have.

/// Two numbers, which every 64-bit processor computes with at once.
struct TwoLanes {
  static constexpr int kCount = 2;
  using Lanes = double __attribute__((vector_size(16)));
  using Mask = std::int64_t __attribute__((vector_size(16)));
};
struct FourLanes {
  static constexpr int kCount = 4;
  using Lanes = double __attribute__((vector_size(32)));
  using Mask = std::int64_t __attribute__((vector_size(32)));
};

// Attributes of all functions here, which must become part of their callers.
#define CLAST_VECTOR_BODY static inline __attribute__((always_inline)) void

template <class Lanes>
CLAST_VECTOR_BODY load(Lanes& lanes, const double* from) {
  __builtin_memcpy(&lanes, from, sizeof lanes);
}
template <class Lanes>
CLAST_VECTOR_BODY store(double* to, const Lanes& lanes) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

/// Height of points over the plane of a face, and distance of their feet from its border, positive
/// inside.
template <class Lanes>
CLAST_VECTOR_BODY project(const FacePrism& face, const Lanes& x, const Lanes& y, const Lanes& z,
                          Lanes& height, Lanes& inside) {
  height = face.normal[0] * x + face.normal[1] * y + face.normal[2] * z - face.offset;
  inside =
      face.inward[0][0] * x + face.inward[0][1] * y + face.inward[0][2] * z - face.inward_offset[0];
  for (int k = 1; k < 3; ++k) {
    const Lanes one = face.inward[k][0] * x + face.inward[k][1] * y + face.inward[k][2] * z -
                      face.inward_offset[k];
    inside = one < inside ? one : inside;
  }
}

template <class Type>
CLAST_VECTOR_BODY filter_in_lanes(const VertexFilterSettings& settings, const VertexGroup* groups,
                                  const std::uint32_t* wanted_groups, std::size_t group_count,
                                  const FacePrism* faces, const std::uint32_t* close_faces,
                                  std::size_t close_face_count, FilteredVertices* filtered) {
  using Lanes = typename Type::Lanes;
  using LaneMask = typename Type::Mask;
  const double* r = settings.rotation;
  const double* at = settings.position;
  const Lanes zero = {};
  const LaneMask no_mask = {};
  const double clear = settings.reach + kDistanceRounding;
  const double clear_squared = clear * clear, reach_squared = settings.reach * settings.reach;
  const double depth = settings.max_depth + kDistanceRounding;
  const double depth_squared = depth * depth;
  for (std::size_t g = 0; g < group_count; ++g) {
    for (int lane = 0; lane < 4; lane += Type::kCount) {
      Lanes a, b, c;
      const VertexGroup& group = groups[wanted_groups[g]];
      load(a, group.x + lane);
      load(b, group.y + lane);
      load(c, group.z + lane);
      const Lanes x = at[0] + (r[0] * a + r[3] * b + r[6] * c);
      const Lanes y = at[1] + (r[1] * a + r[4] * b + r[7] * c);
      const Lanes z = at[2] + (r[2] * a + r[5] * b + r[8] * c);
      store(filtered[g].placed.x + lane, x);
      store(filtered[g].placed.y + lane, y);
      store(filtered[g].placed.z + lane, z);

      // Squared distance bounds: of the nearest face, of all other faces, of the nearest face with
      // the vertex below its plane, and of the nearest with the vertex over it, which is exact.
      Lanes nearest = zero + kFar, others = nearest, below = nearest, over = nearest;
      Lanes height_of_nearest = zero, inside_of_nearest = zero;
      LaneMask nearest_face = {};
      for (std::size_t f = 0; f < close_face_count; ++f) {
        Lanes height, inside;
        project(faces[close_faces[f]], x, y, z, height, inside);
        const Lanes beside = inside < zero ? inside : zero;
        const Lanes squared = height * height + beside * beside;
        const LaneMask nearer = squared < nearest;
        const Lanes second = nearer ? nearest : squared;
        others = second < others ? second : others;
        nearest = nearer ? squared : nearest;
        height_of_nearest = nearer ? height : height_of_nearest;
        inside_of_nearest = nearer ? inside : inside_of_nearest;
        const LaneMask index = no_mask + static_cast<std::int64_t>(close_faces[f]);
        nearest_face = nearer ? index : nearest_face;
        const Lanes squared_below = height < zero ? squared : zero + kFar;
        below = squared_below < below ? squared_below : below;
        const LaneMask is_over = (height >= zero) & (inside > zero + kDistanceRounding);
        const Lanes squared_over = is_over ? squared : zero + kFar;
        over = squared_over < over ? squared_over : over;
      }
      // A face over the vertex would have to be the nearest for the vertex to be inside the ground.
      const LaneMask outside =
          (below > depth_squared) | (below > over * kSquareFraction + kSquareRounding);
      const LaneMask is_clear = outside & (nearest > clear_squared);
      const LaneMask within = inside_of_nearest > zero + kDistanceRounding;
      const LaneMask one_inside =
          (height_of_nearest < zero) & (others > nearest * kSquareFraction + kSquareRounding);
      const LaneMask one_outside = (height_of_nearest >= zero) & outside &
                                   (nearest < reach_squared) & (others > clear_squared);
      const LaneMask one_face = within & (one_inside | one_outside);
      const LaneMask touching =
          one_face ? no_mask + FilteredVertices::kOneFace : no_mask + FilteredVertices::kUnknown;
      const LaneMask result = is_clear ? no_mask + FilteredVertices::kClear : touching;
      __builtin_memcpy(filtered[g].result + lane, &result, sizeof result);
      __builtin_memcpy(filtered[g].face + lane, &nearest_face, sizeof nearest_face);
      store(filtered[g].squared_distance + lane, nearest);
    }
  }
}

template <class Type>
CLAST_VECTOR_BODY measure_in_lanes(const FacePrism* faces, double reach,
                                   const FilteredVertices* vertices, std::size_t group_count,
                                   PrismClearance* clearances, std::size_t clearance_count) {
  using Lanes = typename Type::Lanes;
  using LaneMask = typename Type::Mask;
  const Lanes zero = {};
  for (std::size_t i = 0; i < clearance_count; ++i) {
    PrismClearance& clearance = clearances[i];
    const FacePrism& face = faces[clearance.face];
    const double displacement_per_height = clearance.displacement_per_height;
    const double penalty = displacement_per_height > 0.0 ? reach : kFar;
    Lanes over_plane = zero + kFar, from_face = over_plane;
    for (std::size_t g = 0; g < group_count; ++g) {
      for (int lane = 0; lane < 4; lane += Type::kCount) {
        Lanes x, y, z, height, inside;
        load(x, vertices[g].placed.x + lane);
        load(y, vertices[g].placed.y + lane);
        load(z, vertices[g].placed.z + lane);
        project(face, x, y, z, height, inside);
        const Lanes magnitude = height < zero ? -height : height;
        const Lanes distance = (-inside > magnitude ? -inside : magnitude) - penalty;
        const Lanes over = height - reach;
        const LaneMask by_plane = over * displacement_per_height >= distance;
        const Lanes over_or_far = by_plane ? over : zero + kFar;
        const Lanes distance_or_far = by_plane ? zero + kFar : distance;
        over_plane = over_or_far < over_plane ? over_or_far : over_plane;
        from_face = distance_or_far < from_face ? distance_or_far : from_face;
      }
    }
    clearance.over_plane = clearance.from_face = kFar;
    for (int lane = 0; lane < Type::kCount; ++lane) {
      clearance.over_plane =
          over_plane[lane] < clearance.over_plane ? over_plane[lane] : clearance.over_plane;
      clearance.from_face =
          from_face[lane] < clearance.from_face ? from_face[lane] : clearance.from_face;
    }
  }
}

#undef CLAST_VECTOR_BODY

#ifdef CLAST_HAS_AVX2_FUNCTIONS
__attribute__((target("avx2"))) void filter_with_avx2(
    const VertexFilterSettings& settings, const VertexGroup* groups,
    const std::uint32_t* wanted_groups, std::size_t group_count, const FacePrism* faces,
    const std::uint32_t* close_faces, std::size_t close_face_count, FilteredVertices* filtered) {
  filter_in_lanes<FourLanes>(settings, groups, wanted_groups, group_count, faces, close_faces,
                             close_face_count, filtered);
}
__attribute__((target("avx2"))) void measure_with_avx2(const FacePrism* faces, double reach,
                                                       const FilteredVertices* vertices,
                                                       std::size_t group_count,
                                                       PrismClearance* clearances,
                                                       std::size_t clearance_count) {
  measure_in_lanes<FourLanes>(faces, reach, vertices, group_count, clearances, clearance_count);
}
#endif

}  // namespace

InstructionSet widest_instruction_set() {
#ifdef CLAST_HAS_AVX2_FUNCTIONS
  static const InstructionSet widest =
      __builtin_cpu_supports("avx2") ? InstructionSet::kAvx2 : InstructionSet::kPortable;
  return widest;
#else
  return InstructionSet::kPortable;
#endif
}

void filter_vertices(const VertexFilterSettings& settings, const VertexGroup* groups,
                     const std::uint32_t* wanted_groups, std::size_t group_count,
                     const FacePrism* faces, const std::uint32_t* close_faces,
                     std::size_t close_face_count, FilteredVertices* filtered,
                     InstructionSet instructions) {
#ifdef CLAST_HAS_AVX2_FUNCTIONS
  if (instructions == InstructionSet::kAvx2)
    return filter_with_avx2(settings, groups, wanted_groups, group_count, faces, close_faces,
                            close_face_count, filtered);
#endif
  filter_in_lanes<TwoLanes>(settings, groups, wanted_groups, group_count, faces, close_faces,
                            close_face_count, filtered);
}

void measure_prism_clearances(const FacePrism* faces, double reach,
                              const FilteredVertices* vertices, std::size_t group_count,
                              PrismClearance* clearances, std::size_t clearance_count,
                              InstructionSet instructions) {
#ifdef CLAST_HAS_AVX2_FUNCTIONS
  if (instructions == InstructionSet::kAvx2)
    return measure_with_avx2(faces, reach, vertices, group_count, clearances, clearance_count);
#endif
  measure_in_lanes<TwoLanes>(faces, reach, vertices, group_count, clearances, clearance_count);
}

}  // namespace clast::dem_detail
