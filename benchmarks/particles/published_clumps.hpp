#pragma once
/// Published methods that replace a body by spheres, written from the papers for comparison.
#include <cstdint>
#include <vector>

#include "mesh/triangle_tree.hpp"
#include "particles/particle_body.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast {

/// Inscribed balls on stations along the longest side of the body: at each, the largest ball with
/// its centre in the plane of the station.
/// @cite favier1999
std::vector<Ball> favier_clump(const ParticleBody& body, const TriangleTree& tree,
                               std::size_t count);

/// Balls inside the body that touch its surface at random points which no ball covers yet.
/// @param smallest_radius  balls below it are left out, m
/// @param covering  points of the surface within this distance of a ball are covered, m
/// @cite ferellec2010
std::vector<Ball> ferellec_mcdowell_clump(const ParticleBody& body, const TriangleTree& tree,
                                          double smallest_radius, double covering,
                                          std::uint64_t seed);

/// Balls as in the other overload, with the smallest covering distance that `count` balls allow.
std::vector<Ball> ferellec_mcdowell_clump(const ParticleBody& body, const TriangleTree& tree,
                                          double smallest_radius, std::size_t count,
                                          std::uint64_t seed);

/// Largest balls of the Euclidean distance transform, one after the other. Each ball, shrunk by
/// `overlap`, is removed from the body before the next one.
/// @cite angelidakis2021
std::vector<Ball> euclidean_distance_clump(const ParticleBody& body, const TriangleTree& tree,
                                           std::size_t count, double overlap);

}  // namespace clast
