#include "reconstruct/detail/unseen_bounds.hpp"

#include <algorithm>
#include <vector>

#include "reconstruct/detail/enclosed_space.hpp"
#include "reconstruct/detail/flank_planes.hpp"

namespace clast::detail {

namespace {

/// Largest upper volume against what is closed by films: a third of the block may be unseen where
/// the flanks alone bound it, half of it where a floor does. Beyond, planes of the flanks meet so
/// far from what was seen that a small error of theirs moves the bound by tenths of the volume.
constexpr double kMostByFlanks = 1.5, kMostOnFloor = 2.0;
constexpr double kLeastLeft = 0.5;  ///< of the volume, by a film that is dented
/// The planes are moved out by so much more of their slack where sides are bounded: a corner that
/// stands out is seen in them and hardly in the volume.
constexpr double kSideSlack = 0.5;
constexpr double kFarthest = 10.0;  ///< from the middle, against the film there

struct Middle {
  Vec3 place = Vec3::Zero();
  double volume = 0.0;
};

Middle middle_of(const TriangleMesh& closed) {
  const Vec3 origin = closed.vertices[0];
  Middle middle;
  for (const auto& [a, b, c] : closed.triangles) {
    const Vec3 p = closed.vertices[a] - origin, q = closed.vertices[b] - origin,
               r = closed.vertices[c] - origin;
    const double tetrahedron = p.dot(q.cross(r)) / 6.0;
    middle.volume += tetrahedron;
    middle.place += tetrahedron * (p + q + r) / 4.0;
  }
  middle.place = origin + middle.place / middle.volume;
  return middle;
}

double film_area(const TriangleMesh& mesh, std::size_t first) {
  double doubled = 0.0;
  for (std::size_t t = first; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    doubled += (q - p).cross(r - p).norm();
  }
  return 0.5 * doubled;
}

}  // namespace

UnseenBounds unseen_bounds(const TriangleMesh& closed, const UnseenParts& parts) {
  const Middle middle = middle_of(closed);
  const FlankPlanes flanks = flank_planes(closed, parts.first, parts.rims);
  UnseenBounds bounds;
  bounds.lower_volume = std::max(middle.volume - flanks.slack * film_area(closed, parts.first),
                                 kLeastLeft * middle.volume);
  const auto behind = [&](double further) {
    std::vector<Plane> planes = flanks.planes;
    for (Plane& plane : planes) plane.distance += further;
    if (parts.floor) planes.push_back({-parts.floor->normal, -parts.floor->distance});
    return enclosed_space(closed, parts.first, middle.place, planes, kFarthest);
  };
  const std::optional<EnclosedSpace> space = behind(0.0);
  const double most = parts.floor ? kMostOnFloor : kMostByFlanks;
  if (!space || middle.volume + space->volume > most * middle.volume) return bounds;
  bounds.upper_volume = middle.volume + space->volume;
  const std::optional<EnclosedSpace> wider = behind(kSideSlack * flanks.slack);
  if (!wider) return bounds;
  std::vector<Vec3> seen;
  for (std::size_t t = 0; t < parts.first; ++t) {
    for (const std::uint32_t v : closed.triangles[t]) seen.push_back(closed.vertices[v]);
  }
  std::vector<Vec3> possible = seen;
  possible.insert(possible.end(), wider->places.begin(), wider->places.end());
  bounds.sides = box_ranges(seen, possible);
  return bounds;
}

}  // namespace clast::detail
