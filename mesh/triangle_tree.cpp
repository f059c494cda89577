#include "mesh/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast {

namespace {

/// Share of a mesh's coordinates below which a distance is rounding.
constexpr double kOnSurface = 1e-13;
/// Entries of the stack of a query: three for each level of a balanced tree of 2^32 triangles.
constexpr std::size_t kMaxOpen = 64;

/// Relative error of the coordinates of a point in single precision and of differences of these,
/// with a margin; and the same for a sum of three squares.
constexpr double kFloatError = 0x1p-22, kFloatSquareError = 0x1p-19;

float rounded_down(double value) {
  const auto result = static_cast<float>(value);
  return static_cast<double>(result) > value
             ? std::nextafter(result, -std::numeric_limits<float>::infinity())
             : result;
}

float rounded_up(double value) { return -rounded_down(-value); }

/// Squared distances, in single precision, of a point from four boxes. They are never too large by
/// more than `kFloatSquareError`.
class BoxDistances {
 public:
  BoxDistances(const Vec3& relative_point, double extent)
      : point_(relative_point.cast<float>()),
        slack_(static_cast<float>(kFloatError * (relative_point.cwiseAbs().maxCoeff() + extent))) {}

  using Boxes = Eigen::Array<float, 4, 3>;
  Eigen::Array4f operator()(const Boxes& low, const Boxes& high) const {
    Eigen::Array4f sum = Eigen::Array4f::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Array4f outside =
          ((low.col(axis) - point_[axis]).max(point_[axis] - high.col(axis)) - slack_).max(0.0f);
      sum += outside * outside;
    }
    return sum;
  }

 private:
  Eigen::Vector3f point_;
  float slack_;
};

struct OnTriangle {
  Vec3 point;
  int feature;
};

/// Closest point of triangle abc by the Voronoi regions of its corners and sides.
OnTriangle closest_on(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, 1};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {b, 2};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + d1 / (d1 - d3) * ab, 4};
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {c, 3};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + d2 / (d2 - d6) * ac, 6};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 5};
  }
  const double sum = va + vb + vc;
  return {a + vb / sum * ab + vc / sum * ac, 0};
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh) {
  const Bounds box = bounds(mesh);
  origin_ = 0.5 * (box.low + box.high);
  extent_ = (box.high - box.low).maxCoeff();
  order_.resize(mesh.triangles.size());
  for (std::uint32_t t = 0; t < order_.size(); ++t) order_[t] = t;
  nodes_.reserve(mesh.triangles.size() / 2 + 1);
  build(0, static_cast<std::uint32_t>(order_.size()));
  corners_.reserve(order_.size());
  for (const std::uint32_t t : order_) {
    const auto& [i, j, k] = mesh.triangles[t];
    corners_.push_back({mesh.vertices[i], mesh.vertices[j], mesh.vertices[k], t});
  }
  prepare_normals();
}

/// Builds a node over a range of `order_` and returns its index.
std::uint32_t TriangleTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto centre = [&](std::uint32_t t) {
    const TriangleMesh::Triangle& corners = mesh_.triangles[t];
    return Vec3(mesh_.vertices[corners[0]] + mesh_.vertices[corners[1]] +
                mesh_.vertices[corners[2]]);
  };
  const auto middle_of = [&](std::uint32_t from, std::uint32_t to) {
    Bounds centres;
    for (std::uint32_t i = from; i < to; ++i) centres.include(centre(order_[i]));
    Eigen::Index axis = 0;
    (centres.high - centres.low).maxCoeff(&axis);
    const std::uint32_t middle = from + (to - from) / 2;
    std::nth_element(order_.begin() + from, order_.begin() + middle, order_.begin() + to,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double ca = centre(a)[axis], cb = centre(b)[axis];
                       return ca < cb || (ca == cb && a < b);
                     });
    return middle;
  };
  std::array<std::uint32_t, 5> ends = {begin, begin, begin, begin, end};
  ends[2] = middle_of(begin, end);
  ends[1] = middle_of(begin, ends[2]);
  ends[3] = middle_of(ends[2], end);

  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  for (int child = 0; child < 4; ++child) {
    const auto k = static_cast<std::size_t>(child);
    const std::uint32_t from = ends[k], to = ends[k + 1];
    set_box(nodes_[index], child, from, to);
    const std::uint32_t content = to == from       ? kNone
                                  : to == from + 1 ? kLeaf + from
                                                   : build(from, to);
    nodes_[index].children[k] = content;
  }
  return index;
}

/// Sets one box of a node to that of a range of `order_`. No point is near the box of an empty
/// range.
void TriangleTree::set_box(Node& node, int child, std::uint32_t begin, std::uint32_t end) const {
  Bounds box;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const std::uint32_t v : mesh_.triangles[order_[i]]) box.include(mesh_.vertices[v]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    node.low(child, axis) = begin == end ? std::numeric_limits<float>::infinity()
                                         : rounded_down(box.low[axis] - origin_[axis]);
    node.high(child, axis) = begin == end ? -std::numeric_limits<float>::infinity()
                                          : rounded_up(box.high[axis] - origin_[axis]);
  }
}

void TriangleTree::prepare_normals() {
  vertex_normals_.assign(mesh_.vertices.size(), Vec3::Zero());
  for (const TriangleMesh::Triangle& t : mesh_.triangles) {
    const Vec3 normal = unit_normal(mesh_, t);
    face_normals_.push_back(normal);
    side_normals_.push_back({normal, normal, normal});
    for (std::size_t k = 0; k < 3; ++k) {
      vertex_normals_[t[k]] += corner_angle(mesh_, t, k) * normal;
    }
  }
  const auto side_of = [&](const HalfEdge& half) -> Vec3& {
    const TriangleMesh::Triangle& t = mesh_.triangles[half.triangle];
    const std::size_t k = t[0] == half.from() ? 0 : t[1] == half.from() ? 1 : 2;
    return side_normals_[half.triangle][k];
  };
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh_);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() != 2) return;
    const Vec3 sum = face_normals_[sides[0].triangle] + face_normals_[sides[1].triangle];
    side_of(sides[0]) = side_of(sides[1]) = sum;
  });
}

double TriangleTree::distance_to(std::uint32_t triangle, const Vec3& point) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  return (closest_on(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c], point).point - point)
      .norm();
}

bool TriangleTree::has_point_above(const Vec3& normal, double height, const Vec3& centre,
                                   double radius) const {
  const double relative_height = height - normal.dot(origin_);
  const BoxDistances distances(centre - origin_, extent_);
  std::array<std::uint32_t, kMaxOpen> open;
  std::size_t size = 0;
  open[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[open[--size]];
    const Eigen::Array4f squared = distances(node.low, node.high);
    for (int child = 0; child < 4; ++child) {
      const std::uint32_t content = node.children[static_cast<std::size_t>(child)];
      if (content == kNone || !(squared[child] <= radius * radius)) continue;
      const Vec3 highest = (normal.array() > 0.0)
                               .select(node.high.row(child).transpose().cast<double>(),
                                       node.low.row(child).transpose().cast<double>());
      if (!(normal.dot(highest) > relative_height)) continue;
      if (content < kLeaf) {
        open[size++] = content;
        continue;
      }
      const Corners& corners = corners_[content - kLeaf];
      const double highest_corner =
          std::max({normal.dot(corners.a), normal.dot(corners.b), normal.dot(corners.c)});
      if (!(highest_corner > height)) continue;
      const Vec3& face = face_normals_[corners.triangle];
      const double above_face = face.dot(centre - corners.a);
      const double squared_disc = radius * radius - above_face * above_face;
      if (squared_disc < 0.0) continue;
      // The ball cuts the plane of the triangle in a disc.
      const double slope = (normal - normal.dot(face) * face).norm();
      const double highest_of_disc =
          normal.dot(centre - above_face * face) + std::sqrt(squared_disc) * slope;
      if (highest_of_disc > height) return true;
    }
  }
  return false;
}

TriangleTree::Closest TriangleTree::closest_point(const Vec3& point, std::uint32_t hint) const {
  Closest best;
  float limit = 0.0f;
  const auto consider = [&](const OnTriangle& found, std::uint32_t triangle, bool first) {
    const double squared = (found.point - point).squaredNorm();
    const bool nearer = squared < best.squared_distance ||
                        (squared == best.squared_distance && triangle < best.triangle);
    if (!first && !nearer) return;
    best = {found.point, squared, triangle, found.feature};
    limit = rounded_up(squared * (1.0 + kFloatSquareError));
  };
  const auto& [a, b, c] = mesh_.triangles[hint];
  consider(closest_on(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c], point), hint, true);

  struct Visit {
    float squared_distance;
    std::uint32_t content;
  };
  const BoxDistances distances(point - origin_, extent_);
  std::array<Visit, kMaxOpen> open;
  std::size_t size = 0;
  open[size++] = {0.0f, 0};
  while (size > 0) {
    const Visit visit = open[--size];
    if (visit.squared_distance > limit) continue;
    if (visit.content >= kLeaf) {
      const Corners& corners = corners_[visit.content - kLeaf];
      consider(closest_on(corners.a, corners.b, corners.c, point), corners.triangle, false);
      continue;
    }
    const Node& node = nodes_[visit.content];
    const Eigen::Array4f squared = distances(node.low, node.high);
    const std::size_t first = size;
    for (int child = 0; child < 4; ++child) {
      const Visit next = {squared[child], node.children[static_cast<std::size_t>(child)]};
      if (next.content == kNone || !(next.squared_distance <= limit)) continue;
      std::size_t at = size++;  // the nearest one is looked at first
      for (; at > first && open[at - 1].squared_distance < next.squared_distance; --at) {
        open[at] = open[at - 1];
      }
      open[at] = next;
    }
  }
  return best;
}

const Vec3& TriangleTree::feature_normal(std::uint32_t triangle, int feature) const {
  const auto k = static_cast<std::size_t>(feature);
  if (k == 0) return face_normals_[triangle];
  if (k <= 3) return vertex_normals_[mesh_.triangles[triangle][k - 1]];
  return side_normals_[triangle][k - 4];
}

double TriangleTree::signed_distance(const Vec3& point, std::uint32_t hint) const {
  const Closest found = closest_point(point, hint);
  const double distance = std::sqrt(found.squared_distance);
  return feature_normal(found.triangle, found.feature).dot(point - found.point) < 0.0 ? -distance
                                                                                      : distance;
}

TriangleTree::SignedClosest TriangleTree::signed_closest_point(const Vec3& point,
                                                               std::uint32_t hint) const {
  const Closest found = closest_point(point, hint);
  const TriangleMesh::Triangle& t = mesh_.triangles[found.triangle];
  const Vec3& a = mesh_.vertices[t[0]];
  const Vec3& b = mesh_.vertices[t[1]];
  const Vec3& c = mesh_.vertices[t[2]];
  const Vec3& normal = feature_normal(found.triangle, found.feature);
  const Vec3 away = point - found.point;
  const double distance = std::sqrt(found.squared_distance);
  SignedClosest result;
  result.foot = found.point;
  result.triangle = found.triangle;
  result.distance = normal.dot(away) < 0.0 ? -distance : distance;
  // On the surface the direction from the closest point is undefined.
  const double size = a.cwiseAbs().maxCoeff() + (b - a).norm();
  const bool on_surface = distance <= kOnSurface * size;
  result.outward = on_surface ? Vec3(normal.normalized()) : Vec3(away / result.distance);
  const Vec3 area = (b - a).cross(c - a);
  const double square = area.squaredNorm();
  if (square > 0.0) {
    result.weights[0] = area.dot((c - b).cross(found.point - b)) / square;
    result.weights[1] = area.dot((a - c).cross(found.point - c)) / square;
    result.weights[2] = 1.0 - result.weights[0] - result.weights[1];
  } else {
    result.weights[0] = 1.0;
  }
  return result;
}

std::optional<TriangleTree::RayHit> TriangleTree::first_exit(const Vec3& origin,
                                                             const Vec3& direction,
                                                             std::uint32_t ignored) const {
  std::optional<RayHit> best;
  double nearest = std::numeric_limits<double>::infinity();
  const Vec3 from_origin = origin - origin_;
  const auto entry = [&](const Node& node, int child) {
    double from = 0.0, to = nearest;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = static_cast<double>(node.low(child, axis)) - from_origin[axis];
      const double high = static_cast<double>(node.high(child, axis)) - from_origin[axis];
      if (direction[axis] == 0.0) {
        if (low > 0.0 || high < 0.0) return std::numeric_limits<double>::infinity();
        continue;
      }
      const double first = low / direction[axis], second = high / direction[axis];
      from = std::max(from, std::min(first, second));
      to = std::min(to, std::max(first, second));
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
  };
  const auto consider = [&](std::uint32_t triangle) {
    const Vec3& normal = face_normals_[triangle];
    const double along = normal.dot(direction);
    if (triangle == ignored || !(along > 0.0)) return;
    const TriangleMesh::Triangle& t = mesh_.triangles[triangle];
    const double distance = normal.dot(mesh_.vertices[t[0]] - origin) / along;
    if (!(distance >= 0.0 && distance < nearest)) return;
    const Vec3 point = origin + distance * direction;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& from = mesh_.vertices[t[k]];
      if (!(normal.dot((mesh_.vertices[t[(k + 1) % 3]] - from).cross(point - from)) >= 0.0)) return;
    }
    nearest = distance;
    best = RayHit{distance, triangle};
  };
  struct Visit {
    double entry;
    std::uint32_t content;
  };
  std::array<Visit, kMaxOpen> open;
  std::size_t size = 0;
  open[size++] = {0.0, 0};
  while (size > 0) {
    const Visit visit = open[--size];
    if (!(visit.entry < nearest)) continue;
    if (visit.content >= kLeaf) {
      consider(order_[visit.content - kLeaf]);
      continue;
    }
    const Node& node = nodes_[visit.content];
    const std::size_t first = size;
    for (int child = 0; child < 4; ++child) {
      const Visit next = {entry(node, child), node.children[static_cast<std::size_t>(child)]};
      if (next.content == kNone || !(next.entry < nearest)) continue;
      std::size_t at = size++;
      for (; at > first && open[at - 1].entry < next.entry; --at) open[at] = open[at - 1];
      open[at] = next;
    }
  }
  return best;
}

}  // namespace clast
