#pragma once
/// Alpha wrapping: closed surfaces around triangle soups.
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Computes the alpha wrap of a triangle soup. It is a closed, oriented 2-manifold without
/// self-intersections that encloses the soup.
/// @param soup  non-degenerate triangles; they may intersect, overlap and leave gaps
/// @param alpha  size of the smallest cavity that the wrap enters, m, positive
/// @param offset  distance of the wrap from the soup, m, positive
/// @cite portaneri2022
TriangleMesh alpha_wrap(const TriangleMesh& soup, double alpha, double offset);

}  // namespace clast
