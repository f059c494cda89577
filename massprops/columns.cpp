#include "massprops/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace clast {
namespace {

// A plane this close to vertical bounds a column on its side, not along it.
constexpr double kVertical = 1e-12;
// Regions that a random column meets this many times on average are missed by all columns in one
// case of twenty.
constexpr double kUnseenColumns = 3.0;
constexpr std::size_t kFewColumns = 10;

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

/// x_slope x + y_slope y <= limit: a side of the shadow that a piece's planes cast along z.
struct Side {
  double x_slope, y_slope, limit;
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
        shadow_.push_back({n.x(), n.y(), plane.offset});
        continue;
      }
      const Bound bound{-n.x() / n.z(), -n.y() / n.z(), plane.offset / n.z()};
      (n.z() > 0.0 ? upper_ : lower_).push_back(bound);
    }
    // A line meets the planes' common part where every lower bound is below every upper one.
    for (const Bound& low : lower_) {
      for (const Bound& high : upper_) {
        shadow_.push_back({low.x_slope - high.x_slope, low.y_slope - high.y_slope,
                           high.height - low.height});
      }
    }
  }

  /// The x between which lines at `y` can meet the piece; none when low >= high.
  Interval reach(double y) const {
    Interval range{box.low.x(), box.high.x()};
    if (round_ == SkinPiece::Round::sphere) {
      const double dy = y - centre_.y();
      const double half = std::sqrt(std::max(radius_squared_ - dy * dy, 0.0));
      range.low = std::max(range.low, centre_.x() - half);
      range.high = std::min(range.high, centre_.x() + half);
    }
    for (const Side& side : shadow_) {
      const double room = side.limit - side.y_slope * y;
      if (side.x_slope > 0.0) {
        range.high = std::min(range.high, room / side.x_slope);
      } else if (side.x_slope < 0.0) {
        range.low = std::max(range.low, room / side.x_slope);
      } else if (room < 0.0) {
        return {0.0, 0.0};
      }
    }
    return range;
  }

  /// The part of the line at (x, y) inside, x within reach; empty when low >= high.
  Interval cut(double x, double y) const {
    Interval result = round_cut(x, y);
    for (const Bound& bound : lower_) result.low = std::max(result.low, bound.at(x, y));
    for (const Bound& bound : upper_) result.high = std::min(result.high, bound.at(x, y));
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
  std::vector<Bound> lower_, upper_;
  std::vector<Side> shadow_;
};

/// A core triangle made ready for vertical lines.
struct LineTriangle {
  std::array<Vec3, 3> corner;
  std::array<bool, 3> turned;  ///< edge i runs from the larger to the smaller vertex index
  Bound plane{0.0, 0.0, 0.0};
  Bounds box;

  Interval reach(double) const { return {box.low.x(), box.high.x()}; }
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
  Range columns_over(const Interval& reach) const {
    return range(reach.low, reach.high, x0, step, columns);
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
    const double y = grid_.y(row);
    for (const std::uint32_t i : active_) {
      const Grid::Range span = grid_.columns_over(items_[i].reach(y));
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
  // Even, so that all columns belong to a block of two by two.
  grid.columns = 2 * (static_cast<std::size_t>(std::ceil(size.x() / grid.step)) / 2 + 1);
  grid.rows = 2 * (static_cast<std::size_t>(std::ceil(size.y() / grid.step)) / 2 + 1);
  return grid;
}

Moments column_moments(const Chord& chord, double x, double y) {
  Moments m;
  m.volume = chord.length;
  m.first = Vec3(x * chord.length, y * chord.length, chord.first);
  m.second << x * x * chord.length, x * y * chord.length, x * chord.first,  //
      x * y * chord.length, y * y * chord.length, y * chord.first,          //
      x * chord.first, y * chord.first, chord.second;
  return m;
}

/// The sum over the columns and its scatter. Columns come two rows at a time.
class BlockSum {
 public:
  explicit BlockSum(std::size_t columns) : lower_(columns), upper_(columns) {}

  std::vector<Moments>& row(std::size_t number) { return number % 2 == 0 ? lower_ : upper_; }

  /// Takes in the blocks of two by two columns that the two rows hold.
  void add_rows() {
    for (std::size_t i = 0; i + 1 < lower_.size(); i += 2) {
      add_block({&lower_[i], &lower_[i + 1], &upper_[i], &upper_[i + 1]});
    }
  }

  /// @param cell  area of a column
  Excess result(double cell) const {
    Excess excess;
    excess.moments.add(sum_, cell);
    excess.volume_scatter = cell * std::sqrt(volume_squares_);
    excess.second_scatter = cell * std::sqrt(second_squares_);
    excess.columns = columns_;
    return excess;
  }

 private:
  void add_block(const std::array<const Moments*, 4>& block) {
    Moments sum;
    for (const Moments* m : block) sum += *m;
    for (const Moments* m : block) columns_ += m->volume != 0.0;
    if (sum.volume == 0.0 && block[0]->volume == 0.0 && block[1]->volume == 0.0 &&
        block[2]->volume == 0.0) {
      return;
    }
    // A linear course costs the midpoint rule nothing and drops out of the twist; of independent
    // errors in the four columns, the twist has the variance of their sum.
    Moments twist;
    for (int i = 0; i < 4; ++i) twist.add(*block[i], i == 0 || i == 3 ? 1.0 : -1.0);
    const double trace = twist.second.trace();
    volume_squares_ += twist.volume * twist.volume;
    second_squares_ += trace * trace + twist.second.squaredNorm();
    sum_ += sum;
  }

  std::vector<Moments> lower_, upper_;
  Moments sum_;
  double volume_squares_ = 0.0, second_squares_ = 0.0;
  std::size_t columns_ = 0;
};

}  // namespace

Excess excess_by_columns(const TriangleMesh& core, const Skin& skin, std::size_t per_side) {
  const Grid grid = make_grid(core, skin.radius, per_side);
  const std::vector<LineTriangle> triangles = line_triangles(core);
  const std::vector<LinePiece> pieces = line_pieces(skin.pieces, skin.radius);
  const std::vector<LinePiece> overlaps = line_pieces(skin.overlaps, skin.radius);
  ActiveItems active_triangles(triangles, grid);
  ActiveItems active_pieces(pieces, grid);
  ActiveItems active_overlaps(overlaps, grid);

  BlockSum sum(grid.columns);
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
    std::vector<Moments>& moments = sum.row(row);
    for (std::size_t i = 0; i < grid.columns; ++i) {
      Column& column = columns[i];
      if (column.balanced()) {
        column.add_core();
        column.take_union();
      } else {
        column.clear();
      }
      moments[i] = column_moments(column.excess, grid.x(i), y);
    }
    if (row % 2 == 1) sum.add_rows();
  }

  const double cell = grid.step * grid.step;
  Excess excess = sum.result(cell);
  if (excess.columns < kFewColumns) excess.unseen = kUnseenColumns * cell * skin.radius;
  return excess;
}

}  // namespace clast
