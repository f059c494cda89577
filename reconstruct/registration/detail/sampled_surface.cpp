#include "reconstruct/registration/detail/sampled_surface.hpp"

#include <numeric>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/registration/detail/even_subset.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kFewPoints = 80, kSparsePoints = 300;

}  // namespace

SampledSurface::SampledSurface(OrientedSurface observed)
    : surface(std::move(observed)),
      grid(surface),
      few(choose_even_subset(surface.points, kFewPoints)),
      sparse(choose_even_subset(surface.points, kSparsePoints)),
      all(surface.size()) {
  std::iota(all.begin(), all.end(), 0u);
  Bounds box;
  for (const Vec3& p : surface.points) box.include(p);
  diagonal = box.diagonal();
}

}  // namespace clast::reconstruct_detail
