#include "dem/surface/local_ground.hpp"

#include <algorithm>
#include <cmath>

#include "dem/surface/trim.hpp"

namespace clast::dem_detail {

LocalFaces::Face make_local_face(const SurfaceFeatures& features, std::uint32_t index) {
  const SurfaceFace& face = features.faces[index];
  const Vec3& a = features.vertices[face.vertices[0]];
  const Vec3& b = features.vertices[face.vertices[1]];
  const Vec3& c = features.vertices[face.vertices[2]];
  const Vec3 middle = (a + b + c) / 3.0;
  const double radius = std::sqrt(std::max(
      {(a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm()}));
  return {face.normal, face.normal.dot(a), middle, radius, index};
}

bool is_at_border(const SurfaceFeatures& features, std::uint32_t face) {
  const std::array<std::uint32_t, 3>& edges = features.faces[face].edges;
  return std::any_of(edges.begin(), edges.end(), [&](std::uint32_t edge) {
    return features.edges[edge].kind == EdgeKind::kBorder;
  });
}

FacePrism make_face_prism(const SurfaceFeatures& features, std::uint32_t index) {
  const SurfaceFace& face = features.faces[index];
  const Vec3& normal = face.normal;
  FacePrism prism{{normal.x(), normal.y(), normal.z()},
                  normal.dot(features.vertices[face.vertices[0]]),
                  {},
                  {}};
  if (is_at_border(features, index)) return prism;
  for (std::size_t k = 0; k < 3; ++k) {
    const SurfaceEdge& edge = features.edges[face.edges[k]];
    const Vec3 inward =
        inward_direction(face, edge.direction, edge.forward[edge.faces[0] == index ? 0 : 1]);
    std::copy_n(inward.data(), 3, prism.inward[k]);
    prism.inward_offset[k] = inward.dot(features.vertices[edge.vertices[0]]);
  }
  return prism;
}

void LocalGround::collect_near(const IndexedSurface& ground, const Vec3& centre, double reach) {
  const SurfaceFeatures& features = ground.features;
  faces.clear();
  prisms.clear();
  edges.clear();
  pointed_vertices.clear();
  Bounds box;
  box.include(centre);
  for (const std::uint32_t f : ground.find_faces_near(box, reach)) {
    const Face found = make_local_face(features, f);
    if ((centre - found.centre).norm() > reach + found.radius) continue;
    faces.push_back(found);
    prisms.push_back(make_face_prism(features, f));
    const SurfaceFace& face = features.faces[f];
    for (int k = 0; k < 3; ++k) {
      if (features.edges[face.edges[k]].is_convex()) edges.push_back(face.edges[k]);
      if (features.is_pointed_vertex[face.vertices[k]])
        pointed_vertices.push_back(face.vertices[k]);
    }
  }
  const auto each_once = [](std::vector<std::uint32_t>& indices) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  };
  each_once(edges);
  each_once(pointed_vertices);
  shrink_capacity(faces, prisms, edges, pointed_vertices);
  fit_bounding_plane(features);
}

void LocalFaces::collect_near(const SurfaceFeatures& features, const LocalFaces& from,
                              const Vec3& centre, double reach) {
  faces.clear();
  prisms.clear();
  for (std::size_t i = 0; i < from.faces.size(); ++i) {
    const FacePrism& prism = from.prisms[i];
    const double near = reach + from.faces[i].radius;
    if ((centre - from.faces[i].centre).squaredNorm() > near * near ||
        std::abs(prism.height(centre)) > reach || prism.distance_beside(centre) > reach) {
      continue;
    }
    faces.push_back(from.faces[i]);
    prisms.push_back(prism);
  }
  shrink_capacity(faces, prisms);
  fit_bounding_plane(features);
}

void LocalFaces::fit_bounding_plane(const SurfaceFeatures& features) {
  Vec3 sum = Vec3::Zero();
  for (const Face& face : faces) sum += face.normal;
  const double length = sum.norm();
  plane.normal = length > 0.0 ? Vec3(sum / length) : Vec3(Vec3::UnitZ());
  plane.offset = -1e300;
  for (const Face& face : faces) {
    for (const std::uint32_t v : features.faces[face.face].vertices) {
      plane.offset = std::max(plane.offset, plane.normal.dot(features.vertices[v]));
    }
  }
}

LocalFaces::NearestFace LocalFaces::nearest(const SurfaceFeatures& features, const Vec3& query,
                                            double limit, double beyond,
                                            std::uint32_t guess) const {
  return find_nearest_face(faces, features, query, limit, beyond, guess);
}

LocalFaces::NearestFace find_nearest_face(std::span<const LocalFaces::Face> faces,
                                          const SurfaceFeatures& features, const Vec3& query,
                                          double limit, double beyond, std::uint32_t guess) {
  LocalFaces::NearestFace found;
  found.nearest.distance = 1e300;
  found.second = limit;
  const auto measure = [&](std::uint32_t i) {
    const LocalFaces::Face& face = faces[i];
    const double best = std::abs(found.nearest.distance);
    const double distinguished = std::min(best, limit) + beyond;
    if (std::abs(face.normal.dot(query) - face.offset) > distinguished) return;
    const double near = distinguished + face.radius;
    if ((query - face.centre).squaredNorm() > near * near) return;
    const NearestPoint candidate = project_onto_face(features, face.face, query);
    const double distance = std::abs(candidate.distance);
    // Ties go to the smaller face index, so that the order of visits does not matter.
    const bool nearer =
        distance < best || (distance == best && candidate.face < found.nearest.face);
    found.second = std::min(found.second, nearer ? best : distance);
    if (nearer) {
      found.nearest = candidate;
      found.entry = i;
    }
  };
  if (guess < faces.size()) measure(guess);
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    if (i != guess) measure(i);
  }
  found.second = std::min(found.second, std::abs(found.nearest.distance) + beyond);
  if (found.nearest.face != kNoFeature) determine_query_side(features, query, found.nearest);
  return found;
}

}  // namespace clast::dem_detail
