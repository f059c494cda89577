#include "dem/surface/indexed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clast::dem_detail {
namespace {

/// Target number of faces per cell, as in a regular grid of squares.
constexpr double kFacesPerCell = 2.0;
constexpr double kMaxCells = 4e7;

}  // namespace

NearestPoint nearest_point_on_face(const SurfaceFeatures& surface, std::uint32_t face,
                                   const Vec3& query) {
  NearestPoint nearest = project_onto_face(surface, face, query);
  determine_query_side(surface, query, nearest);
  return nearest;
}

void determine_query_side(const SurfaceFeatures& surface, const Vec3& query, NearestPoint& foot) {
  if (foot.within_face) return;
  foot.normal = foot.edge != kNoFeature ? surface.edge_normal(surface.edges[foot.edge])
                                        : surface.vertex_normals[foot.vertex];
  foot.distance = std::copysign(foot.distance, foot.normal.dot(query - foot.point));
}

NearestPoint project_onto_face(const SurfaceFeatures& surface, std::uint32_t face,
                               const Vec3& query) {
  const SurfaceFace& f = surface.faces[face];
  const Vec3& origin = surface.vertices[f.vertices[0]];
  const double height = f.normal.dot(query - origin);
  NearestPoint best;
  best.face = face;
  // Side of the foot for each of the three edges. If it is inside all of them, the face is nearest.
  std::array<double, 3> depth;
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const Vec3& corner = surface.vertices[f.vertices[k]];
    const Vec3 along = surface.vertices[f.vertices[(k + 1) % 3]] - corner;
    depth[k] = f.normal.cross(along).dot(query - corner);
    inside = inside && depth[k] >= 0.0;
  }
  if (inside) {
    best.within_face = true;
    best.point = query - height * f.normal;
    best.normal = f.normal;
    best.distance = height;
    return best;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (depth[k] >= 0.0) continue;
    const SurfaceEdge& edge = surface.edges[f.edges[k]];
    const Vec3& start = surface.vertices[edge.vertices[0]];
    const double along = edge.direction.dot(query - start);
    const bool before = along <= 0.0, inner = !before && along < edge.length;
    const std::uint32_t end = edge.vertices[before ? 0 : 1];
    const Vec3 point = inner ? Vec3(start + along * edge.direction) : surface.vertices[end];
    const double squared_distance = (query - point).squaredNorm();
    if (squared_distance < nearest) {
      nearest = squared_distance;
      best.point = point;
      best.edge = inner ? f.edges[k] : kNoFeature;
      best.vertex = inner ? kNoFeature : end;
    }
  }
  best.distance = std::sqrt(nearest);
  return best;
}

bool is_on_border(const SurfaceFeatures& surface, const NearestPoint& nearest) {
  const auto border = [&](std::uint32_t e) { return surface.edges[e].kind == EdgeKind::kBorder; };
  if (nearest.edge != kNoFeature) return border(nearest.edge);
  if (nearest.vertex == kNoFeature) return false;
  const std::span<const std::uint32_t> edges = surface.edges_at(nearest.vertex);
  return std::any_of(edges.begin(), edges.end(), border);
}

PlanGrid::PlanGrid(const SurfaceFeatures& surface) {
  Bounds extent;
  for (const Vec3& vertex : surface.vertices) extent.include(vertex);
  const Vec2 span = (extent.high - extent.low).head<2>().cwiseMax(1e-9);
  const double cells = std::clamp(surface.faces.size() / kFacesPerCell, 1.0, kMaxCells);
  size_ = std::max(std::sqrt(span.x() * span.y() / cells), std::max(span.x(), span.y()) / 30000.0);
  corner_ = extent.low.head<2>();
  columns_ = static_cast<int>(span.x() / size_) + 1;
  rows_ = static_cast<int>(span.y() / size_) + 1;

  const auto face_range = [&](const SurfaceFace& face) {
    Bounds box;
    for (const std::uint32_t v : face.vertices) box.include(surface.vertices[v]);
    return std::pair(cell_range(box.low.x(), box.high.x(), box.low.y(), box.high.y()), box);
  };
  const std::size_t count = static_cast<std::size_t>(columns_) * rows_;
  offsets_.assign(count + 1, 0);
  lows_.assign(count, std::numeric_limits<float>::infinity());
  highs_.assign(count, -std::numeric_limits<float>::infinity());
  for (const SurfaceFace& face : surface.faces) {
    const auto [cells_hit, box] = face_range(face);
    const float low =
        std::nextafter(static_cast<float>(box.low.z()), -std::numeric_limits<float>::infinity());
    const float high =
        std::nextafter(static_cast<float>(box.high.z()), std::numeric_limits<float>::infinity());
    for (int row = cells_hit.first_row; row <= cells_hit.last_row; ++row) {
      for (int column = cells_hit.first_column; column <= cells_hit.last_column; ++column) {
        const std::size_t c = static_cast<std::size_t>(row) * columns_ + column;
        ++offsets_[c + 1];
        lows_[c] = std::min(lows_[c], low);
        highs_[c] = std::max(highs_[c], high);
      }
    }
  }
  for (std::size_t c = 0; c < count; ++c) offsets_[c + 1] += offsets_[c];
  faces_.resize(offsets_[count]);
  std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    const CellRange cells_hit = face_range(surface.faces[f]).first;
    for (int row = cells_hit.first_row; row <= cells_hit.last_row; ++row) {
      for (int column = cells_hit.first_column; column <= cells_hit.last_column; ++column) {
        faces_[next[static_cast<std::size_t>(row) * columns_ + column]++] = f;
      }
    }
  }
}

PlanGrid::CellRange PlanGrid::cell_range(double x_low, double x_high, double y_low,
                                         double y_high) const {
  const auto clamp_low = [&](double value, double corner, int count) {
    const double cell = std::floor((value - corner) / size_);
    return cell < 0.0 ? 0 : cell >= count ? count : static_cast<int>(cell);
  };
  const auto clamp_high = [&](double value, double corner, int count) {
    const double cell = std::floor((value - corner) / size_);
    return cell < 0.0 ? -1 : cell >= count ? count - 1 : static_cast<int>(cell);
  };
  return {clamp_low(x_low, corner_.x(), columns_), clamp_high(x_high, corner_.x(), columns_),
          clamp_low(y_low, corner_.y(), rows_), clamp_high(y_high, corner_.y(), rows_)};
}

PlanGrid::Cell PlanGrid::cell(int column, int row) const {
  const std::size_t c = static_cast<std::size_t>(row) * columns_ + column;
  return {{faces_.data() + offsets_[c], faces_.data() + offsets_[c + 1]}, lows_[c], highs_[c]};
}

std::optional<NearestPoint> IndexedSurface::nearest_point(const Vec3& query, double reach,
                                                          std::uint32_t guess) const {
  std::optional<NearestPoint> best;
  double limit = reach;
  const auto measure = [&](std::uint32_t f) {
    const SurfaceFace& face = features.faces[f];
    const Vec3& a = features.vertices[face.vertices[0]];
    if (std::abs(face.normal.dot(query - a)) > limit) return;
    const Vec3& b = features.vertices[face.vertices[1]];
    const Vec3& c = features.vertices[face.vertices[2]];
    const Vec3 below = a.cwiseMin(b).cwiseMin(c) - query, above = query - a.cwiseMax(b).cwiseMax(c);
    if (below.cwiseMax(above).cwiseMax(0.0).squaredNorm() > limit * limit) return;
    const NearestPoint candidate = project_onto_face(features, f, query);
    const double distance = std::abs(candidate.distance);
    // Ties go to the smaller face index, so that the order of visits does not matter.
    if (distance < limit || (distance == limit && (!best || f < best->face))) {
      limit = distance;
      best = candidate;
    }
  };
  const auto visit = [&](int column, int row) {
    const PlanGrid::Cell cell = grid.cell(column, row);
    if (query.z() - cell.high > limit || cell.low - query.z() > limit) return;
    for (const std::uint32_t f : cell.faces) measure(f);
  };
  if (guess != kNoFeature) measure(guess);
  // Rings of cells around the query; a ring k cells away is at least k - 1 cells distant.
  const PlanGrid::CellRange all = grid.cell_range(-1e300, 1e300, -1e300, 1e300);
  const PlanGrid::CellRange home = grid.cell_range(query.x(), query.x(), query.y(), query.y());
  const int home_column = std::clamp(home.first_column, all.first_column, all.last_column);
  const int home_row = std::clamp(home.first_row, all.first_row, all.last_row);
  const int last_ring = std::max(grid.column_count(), grid.row_count());
  for (int ring = 0; ring <= last_ring; ++ring) {
    const PlanGrid::CellRange window =
        grid.cell_range(query.x() - limit, query.x() + limit, query.y() - limit, query.y() + limit);
    const int left = home_column - ring, right = home_column + ring;
    const int front = home_row - ring, back = home_row + ring;
    if (ring > 0 && left < window.first_column && right > window.last_column &&
        front < window.first_row && back > window.last_row) {
      break;
    }
    for (int row = std::max(front, window.first_row); row <= std::min(back, window.last_row);
         ++row) {
      const bool whole = row == front || row == back;
      if (whole) {
        for (int column = std::max(left, window.first_column);
             column <= std::min(right, window.last_column); ++column) {
          visit(column, row);
        }
      } else {
        if (left >= window.first_column && left <= window.last_column) visit(left, row);
        if (right >= window.first_column && right <= window.last_column) visit(right, row);
      }
    }
  }
  if (best) determine_query_side(features, query, *best);
  return best;
}

double IndexedSurface::height_clearance(const Vec3& query, double reach) const {
  const PlanGrid::CellRange window =
      grid.cell_range(query.x() - reach, query.x() + reach, query.y() - reach, query.y() + reach);
  double clearance = reach;
  for (int row = window.first_row; row <= window.last_row; ++row) {
    for (int column = window.first_column; column <= window.last_column; ++column) {
      const PlanGrid::Cell cell = grid.cell(column, row);
      if (!cell.faces.empty()) clearance = std::min(clearance, query.z() - cell.high);
    }
  }
  return std::max(clearance, 0.0);
}

std::vector<std::uint32_t> IndexedSurface::find_faces_near(const Bounds& box, double reach) const {
  std::vector<std::uint32_t> found;
  const Vec3 low = box.low.array() - reach;
  const Vec3 high = box.high.array() + reach;
  const PlanGrid::CellRange window = grid.cell_range(low.x(), high.x(), low.y(), high.y());
  for (int row = window.first_row; row <= window.last_row; ++row) {
    for (int column = window.first_column; column <= window.last_column; ++column) {
      const PlanGrid::Cell cell = grid.cell(column, row);
      if (cell.low > high.z() || cell.high < low.z()) continue;
      for (const std::uint32_t f : cell.faces) {
        Bounds bounds;
        for (const std::uint32_t v : features.faces[f].vertices)
          bounds.include(features.vertices[v]);
        if ((bounds.low.array() <= high.array()).all() &&
            (bounds.high.array() >= low.array()).all()) {
          found.push_back(f);
        }
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

IndexedSurface build_indexed_surface(const TriangleMesh& mesh, double radius,
                                     std::span<const std::array<std::uint32_t, 2>> wires) {
  IndexedSurface surface;
  surface.features = extract_surface_features(mesh, wires);
  surface.radius = radius;
  for (const Vec3& vertex : mesh.vertices) surface.extent.include(vertex);
  surface.face_of_vertex.assign(mesh.vertices.size(), 0);
  for (std::size_t f = mesh.triangles.size(); f-- > 0;) {
    for (const std::uint32_t v : mesh.triangles[f]) {
      surface.face_of_vertex[v] = static_cast<std::uint32_t>(f);
    }
  }
  surface.grid = PlanGrid(surface.features);
  return surface;
}

IndexedSurface build_indexed_surface(const SpheroPolyhedron& body) {
  const bool wire = body.faces.empty();
  IndexedSurface surface = build_indexed_surface(
      core_mesh(body), body.radius,
      wire ? std::span(body.edges) : std::span<const SpheroPolyhedron::Edge>());
  surface.is_block = true;
  return surface;
}

}  // namespace clast::dem_detail
