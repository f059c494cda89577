#include "massprops/columns.hpp"

#include <algorithm>
#include <cmath>

namespace clast {
namespace {

// A plane this close to vertical bounds a column on its side, not along it.
constexpr double kVertical = 1e-12;

/// Integrals of 1, z, z^2 over intervals.
struct Chord {
  double length = 0.0, first = 0.0, second = 0.0;

  void add(double low, double high, double sign = 1.0) {
    length += sign * (high - low);
    first += sign * 0.5 * (high * high - low * low);
    second += sign * (high * high * high - low * low * low) / 3.0;
  }
};

struct Interval {
  double low, high;
};

/// z <= or >= x_slope x + y_slope y + height.
struct Bound {
  double x_slope, y_slope, height;
  double at(double x, double y) const { return x_slope * x + y_slope * y + height; }
};

/// A piece made ready for vertical lines.
class LinePiece {
 public:
  explicit LinePiece(const SkinPiece& piece, double radius)
      : box(piece.box),
        round_(piece.round),
        centre_(piece.centre),
        axis_(piece.axis),
        radius_squared_(radius * radius) {
    for (const HalfSpace& plane : piece.planes) {
      const Vec3& n = plane.normal;
      if (std::abs(n.z()) < kVertical) {
        walls_.push_back({n.x(), n.y(), plane.offset});
        continue;
      }
      const Bound bound{-n.x() / n.z(), -n.y() / n.z(), plane.offset / n.z()};
      (n.z() > 0.0 ? upper_ : lower_).push_back(bound);
    }
  }

  /// The part of the line at (x, y) inside; empty when low >= high.
  Interval cut(double x, double y) const {
    Interval result = round_cut(x, y);
    for (const Bound& bound : lower_) result.low = std::max(result.low, bound.at(x, y));
    for (const Bound& bound : upper_) result.high = std::min(result.high, bound.at(x, y));
    for (const Bound& wall : walls_) {
      if (wall.x_slope * x + wall.y_slope * y > wall.height) return {0.0, 0.0};
    }
    return result;
  }

  Bounds box;

 private:
  Interval round_cut(double x, double y) const {
    if (round_ == SkinPiece::Round::none) return {box.low.z(), box.high.z()};
    const double dx = x - centre_.x();
    const double dy = y - centre_.y();
    const double along = dx * axis_.x() + dy * axis_.y();
    const double a = 1.0 - axis_.z() * axis_.z();
    const double b = -along * axis_.z();
    const double c = dx * dx + dy * dy - along * along - radius_squared_;
    if (a < kVertical) return c <= 0.0 ? Interval{box.low.z(), box.high.z()} : Interval{0.0, 0.0};
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0.0)) return {0.0, 0.0};
    const double half = std::sqrt(discriminant);
    return {centre_.z() + (-b - half) / a, centre_.z() + (-b + half) / a};
  }

  SkinPiece::Round round_;
  Vec3 centre_, axis_;  // no axis for a ball: the cylinder's formulas then give the sphere's chord
  double radius_squared_;
  std::vector<Bound> lower_, upper_, walls_;
};

/// A core triangle made ready for vertical lines.
struct LineTriangle {
  std::array<Vec3, 3> corner;
  std::array<bool, 3> turned;  ///< edge i runs from the larger to the smaller vertex index
  Bound plane{0.0, 0.0, 0.0};
  Bounds box;
};

std::vector<LineTriangle> line_triangles(const TriangleMesh& core) {
  std::vector<LineTriangle> result;
  result.reserve(core.triangles.size());
  for (const auto& triangle : core.triangles) {
    LineTriangle t;
    for (int i = 0; i < 3; ++i) {
      t.corner[i] = core.vertices[triangle[i]];
      t.turned[i] = triangle[i] > triangle[(i + 1) % 3];
      t.box.include(t.corner[i]);
    }
    const Vec3 n = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]);
    // Seen edge-on, or without area: the height is clamped to the triangle's own range.
    if (std::abs(n.z()) > 0.0) {
      t.plane = {-n.x() / n.z(), -n.y() / n.z(), n.dot(t.corner[0]) / n.z()};
    }
    result.push_back(t);
  }
  return result;
}

/// +1 where a line that rises at (x, y) leaves through the triangle, -1 where it enters, 0 beside
/// it. Each edge is judged from its smaller vertex index, so both its triangles agree to the bit
/// and no line slips between them or hits both.
int crossing(const LineTriangle& t, double x, double y) {
  int left_of = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3& p = t.corner[t.turned[i] ? (i + 1) % 3 : i];
    const Vec3& q = t.corner[t.turned[i] ? i : (i + 1) % 3];
    const bool left = (q.x() - p.x()) * (y - p.y()) > (q.y() - p.y()) * (x - p.x());
    left_of += left != t.turned[i];
  }
  return left_of == 3 ? 1 : left_of == 0 ? -1 : 0;
}

struct Crossing {
  double z;
  int sign;
};

/// Everything found along one column.
struct Column {
  Chord excess;
  std::vector<Interval> intervals;
  std::vector<Crossing> crossings;

  void clear() {
    excess = {};
    intervals.clear();
    crossings.clear();
  }

  void add_core() {
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
      return a.z < b.z || (a.z == b.z && a.sign < b.sign);
    });
    int depth = 0;
    double entered = 0.0;
    for (const auto& [z, sign] : crossings) {
      excess.length += sign * z;
      excess.first += sign * 0.5 * z * z;
      excess.second += sign * z * z * z / 3.0;
      if (depth == 0 && sign < 0) entered = z;
      if (depth == 1 && sign > 0) intervals.push_back({entered, z});
      depth -= sign;
    }
  }

  void take_union() {
    std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
      return a.low < b.low || (a.low == b.low && a.high < b.high);
    });
    for (std::size_t i = 0; i < intervals.size();) {
      double high = intervals[i].high;
      std::size_t next = i + 1;
      while (next < intervals.size() && intervals[next].low <= high) {
        high = std::max(high, intervals[next].high);
        ++next;
      }
      excess.add(intervals[i].low, high, -1.0);
      i = next;
    }
  }

  /// Rounding can unbalance the crossings only within about 1e-16 of a vertex; such a line tells
  /// nothing, and one column of a grid may be left out.
  bool balanced() const {
    int sum = 0;
    for (const Crossing& c : crossings) sum += c.sign;
    return sum == 0;
  }
};

struct Grid {
  double x0, y0, step;
  std::size_t columns, rows;
  double x(std::size_t i) const { return x0 + step * static_cast<double>(i); }
  double y(std::size_t j) const { return y0 + step * static_cast<double>(j); }

  struct Range {
    std::size_t first, end;
  };
  static Range range(double low, double high, double start, double step, std::size_t count) {
    const double last = static_cast<double>(count);
    const double from = std::clamp(std::ceil((low - start) / step), 0.0, last);
    const double to = std::clamp(std::floor((high - start) / step) + 1.0, from, last);
    return {static_cast<std::size_t>(from), static_cast<std::size_t>(to)};
  }
  Range columns_over(const Bounds& box) const {
    return range(box.low.x(), box.high.x(), x0, step, columns);
  }
  Range rows_over(const Bounds& box) const {
    return range(box.low.y(), box.high.y(), y0, step, rows);
  }
};

/// Items of each row, by the rows their boxes cover.
template <class Item>
std::vector<std::vector<std::uint32_t>> by_first_row(const std::vector<Item>& items,
                                                     const Grid& grid) {
  std::vector<std::vector<std::uint32_t>> result(grid.rows);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const Grid::Range rows = grid.rows_over(items[i].box);
    if (rows.first < rows.end) result[rows.first].push_back(i);
  }
  return result;
}

/// The items whose boxes cover the row that is being worked on.
template <class Item>
class ActiveItems {
 public:
  ActiveItems(const std::vector<Item>& items, const Grid& grid)
      : items_(items), grid_(grid), starts_(by_first_row(items, grid)) {}

  template <class Visit>
  void visit(std::size_t row, const Visit& visit_item) {
    active_.insert(active_.end(), starts_[row].begin(), starts_[row].end());
    std::erase_if(active_,
                  [&](std::uint32_t i) { return grid_.rows_over(items_[i].box).end <= row; });
    for (const std::uint32_t i : active_) {
      const Grid::Range span = grid_.columns_over(items_[i].box);
      for (std::size_t column = span.first; column < span.end; ++column) {
        visit_item(items_[i], column);
      }
    }
  }

 private:
  const std::vector<Item>& items_;
  const Grid& grid_;
  std::vector<std::vector<std::uint32_t>> starts_;
  std::vector<std::uint32_t> active_;
};

std::vector<LinePiece> line_pieces(const std::vector<SkinPiece>& pieces, double radius) {
  std::vector<LinePiece> result;
  result.reserve(pieces.size());
  for (const SkinPiece& piece : pieces) result.emplace_back(piece, radius);
  return result;
}

Grid make_grid(const TriangleMesh& core, double radius, std::size_t per_side) {
  Bounds box = bounds(core);
  box.low -= Vec3::Constant(radius);
  box.high += Vec3::Constant(radius);
  const Vec3 size = box.high - box.low;
  Grid grid{};
  grid.step = std::max(size.x(), size.y()) / static_cast<double>(per_side);
  grid.x0 = box.low.x() + 0.5 * grid.step;
  grid.y0 = box.low.y() + 0.5 * grid.step;
  grid.columns = static_cast<std::size_t>(std::ceil(size.x() / grid.step)) + 1;
  grid.rows = static_cast<std::size_t>(std::ceil(size.y() / grid.step)) + 1;
  return grid;
}

void add_column(Moments& sum, const Chord& chord, double x, double y) {
  sum.volume += chord.length;
  sum.first += Vec3(x * chord.length, y * chord.length, chord.first);
  Mat3& m = sum.second;
  m(0, 0) += x * x * chord.length;
  m(0, 1) += x * y * chord.length;
  m(0, 2) += x * chord.first;
  m(1, 1) += y * y * chord.length;
  m(1, 2) += y * chord.first;
  m(2, 2) += chord.second;
}

}  // namespace

std::array<Moments, 4> excess_by_columns(const TriangleMesh& core, const Skin& skin,
                                         std::size_t per_side) {
  const Grid grid = make_grid(core, skin.radius, per_side);
  const std::vector<LineTriangle> triangles = line_triangles(core);
  const std::vector<LinePiece> pieces = line_pieces(skin.pieces, skin.radius);
  const std::vector<LinePiece> overlaps = line_pieces(skin.overlaps, skin.radius);
  ActiveItems active_triangles(triangles, grid);
  ActiveItems active_pieces(pieces, grid);
  ActiveItems active_overlaps(overlaps, grid);

  std::array<Moments, 4> sums;
  std::vector<Column> columns(grid.columns);
  for (std::size_t row = 0; row < grid.rows; ++row) {
    const double y = grid.y(row);
    for (Column& column : columns) column.clear();
    active_triangles.visit(row, [&](const LineTriangle& t, std::size_t i) {
      const double x = grid.x(i);
      const int sign = crossing(t, x, y);
      if (sign == 0) return;
      const double z = std::clamp(t.plane.at(x, y), t.box.low.z(), t.box.high.z());
      columns[i].crossings.push_back({z, sign});
    });
    active_pieces.visit(row, [&](const LinePiece& piece, std::size_t i) {
      const Interval cut = piece.cut(grid.x(i), y);
      if (!(cut.low < cut.high)) return;
      columns[i].excess.add(cut.low, cut.high);
      columns[i].intervals.push_back(cut);
    });
    active_overlaps.visit(row, [&](const LinePiece& piece, std::size_t i) {
      const Interval cut = piece.cut(grid.x(i), y);
      if (cut.low < cut.high) columns[i].excess.add(cut.low, cut.high, -1.0);
    });
    for (std::size_t i = 0; i < grid.columns; ++i) {
      Column& column = columns[i];
      if (!column.balanced()) continue;
      column.add_core();
      column.take_union();
      add_column(sums[2 * (row % 2) + i % 2], column.excess, grid.x(i), y);
    }
  }

  const double cell = 4.0 * grid.step * grid.step;
  for (Moments& sum : sums) {
    sum.volume *= cell;
    sum.first *= cell;
    sum.second *= cell;
    sum.second.triangularView<Eigen::StrictlyLower>() = sum.second.transpose();
  }
  return sums;
}

}  // namespace clast
