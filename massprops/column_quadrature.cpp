#include "massprops/column_quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace clast::massprops_detail {
namespace {

constexpr double kSigmas = 3.0;
// Mean number of column hits of a region that random columns miss once in twenty cases.
constexpr double kUnseenColumns = 3.0;
constexpr std::size_t kFewColumns = 10;
// Share of the radius below which the excess of a column is rounding.
constexpr double kMet = 1e-9;

/// Integrals of 1, z, z^2 over intervals.
struct Chord {
  double length = 0.0, first = 0.0, second = 0.0;

  void add(double low, double high, double sign = 1.0) {
    length += sign * (high - low);
    first += sign * 0.5 * (high * high - low * low);
    second += sign * (high * high * high - low * low * low) / 3.0;
  }
};

struct Crossing {
  double z;
  int sign;
};

/// Everything found along one column.
struct Column {
  Chord excess;
  std::vector<LineInterval> intervals;
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

  void subtract_union() {
    std::sort(intervals.begin(), intervals.end(), [](const LineInterval& a, const LineInterval& b) {
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

  /// Rounding can unbalance the crossings only within about 1e-16 of a vertex; such a line
  /// is left out, as one column of a grid may be.
  bool balanced() const {
    int sum = 0;
    for (const Crossing& c : crossings) sum += c.sign;
    return sum == 0;
  }
};

struct Grid {
  double x0, y0, step;
  std::size_t columns, rows;

  Grid(const Bounds& box, std::size_t columns_per_side) {
    const Vec3 size = box.high - box.low;
    step = std::max(size.x(), size.y()) / static_cast<double>(columns_per_side);
    x0 = box.low.x() + 0.5 * step;
    y0 = box.low.y() + 0.5 * step;
    // Even, so that all columns belong to a block of two by two.
    columns = 2 * (static_cast<std::size_t>(std::ceil(size.x() / step)) / 2 + 1);
    rows = 2 * (static_cast<std::size_t>(std::ceil(size.y() / step)) / 2 + 1);
  }

  double x(std::size_t i) const { return x0 + step * static_cast<double>(i); }
  double y(std::size_t j) const { return y0 + step * static_cast<double>(j); }

  struct Range {
    std::size_t first, end;
  };
  Range columns_in(const LineInterval& range) const { return within(range, x0, columns); }
  Range rows_in(const LineInterval& range) const { return within(range, y0, rows); }

 private:
  Range within(const LineInterval& range, double start, std::size_t count) const {
    const double last = static_cast<double>(count);
    const double from = std::clamp(std::ceil((range.low - start) / step), 0.0, last);
    const double to = std::clamp(std::floor((range.high - start) / step) + 1.0, from, last);
    return {static_cast<std::size_t>(from), static_cast<std::size_t>(to)};
  }
};

/// Goes over the rows, and on each over the columns that items (pieces, triangles) can meet there.
template <class Items>
class Sweep {
 public:
  Sweep(const Items& items, const Grid& grid) : items_(items), grid_(grid) {}

  /// `visit_item(item, column)`; rows must come in ascending order.
  template <class Visit>
  void visit(std::size_t row, const Visit& visit_item) {
    for (; next_ < items_.size(); ++next_) {
      const Grid::Range rows = grid_.rows_in(items_.y_range(next_));
      if (rows.first > row) break;
      if (rows.end > row) active_.push_back({static_cast<std::uint32_t>(next_), rows.end});
    }
    std::erase_if(active_, [&](const Active& item) { return item.end <= row; });
    const double y = grid_.y(row);
    for (const Active& item : active_) {
      const Grid::Range span = grid_.columns_in(items_.x_range(item.index, y));
      for (std::size_t column = span.first; column < span.end; ++column) {
        visit_item(item.index, column);
      }
    }
  }

 private:
  struct Active {
    std::uint32_t index;
    std::size_t end;  ///< row past its last
  };
  const Items& items_;
  const Grid& grid_;
  std::size_t next_ = 0;  ///< first item that no row has reached yet
  std::vector<Active> active_;
};

SolidMoments column_moments(const Chord& chord, double x, double y) {
  SolidMoments m;
  m.volume = chord.length;
  m.first = Vec3(x * chord.length, y * chord.length, chord.first);
  m.second << x * x * chord.length, x * y * chord.length, x * chord.first,  //
      x * y * chord.length, y * y * chord.length, y * chord.first,          //
      x * chord.first, y * chord.first, chord.second;
  return m;
}

/// Frobenius norm of tr(M) I - M, squared.
double tensor_square(const Mat3& second) {
  const double trace = second.trace();
  return trace * trace + second.squaredNorm();
}

/// The sum over the columns and its error. Columns come two rows at a time.
class BlockSum {
 public:
  /// @param least  length in a column from which on it counts as meeting something
  BlockSum(std::size_t columns, double least) : least_(least), lower_(columns), upper_(columns) {}

  std::vector<SolidMoments>& row(std::size_t number) { return number % 2 == 0 ? lower_ : upper_; }
  std::size_t columns_met() const { return met_; }

  /// Adds the blocks of two by two columns in the two rows.
  void add_rows() {
    for (std::size_t i = 0; i + 1 < lower_.size(); i += 2) {
      add_block({&lower_[i], &lower_[i + 1], &upper_[i], &upper_[i + 1]});
    }
  }

  /// @param cell  area of a column
  OverlapIntegral result(double cell) const {
    OverlapIntegral excess;
    for (const SolidMoments& grid : grids_) excess.moments.add_scaled(grid, cell);
    double volume_spread = 0.0, second_spread = 0.0;
    for (const SolidMoments& grid : grids_) {
      SolidMoments departure = excess.moments;
      departure.add_scaled(grid, -4.0 * cell);
      volume_spread = std::max(volume_spread, std::abs(departure.volume));
      second_spread = std::max(second_spread, std::sqrt(tensor_square(departure.second)));
    }
    excess.volume_error = std::max(volume_spread, kSigmas * cell * std::sqrt(volume_squares_));
    excess.second_moment_error =
        std::max(second_spread, kSigmas * cell * std::sqrt(second_squares_));
    return excess;
  }

 private:
  void add_block(const std::array<const SolidMoments*, 4>& block) {
    SolidMoments twist;
    for (int i = 0; i < 4; ++i) {
      grids_[i] += *block[i];
      twist.add_scaled(*block[i], i == 0 || i == 3 ? 1.0 : -1.0);
      met_ += std::abs(block[i]->volume) > least_;
    }
    volume_squares_ += twist.volume * twist.volume;
    second_squares_ += tensor_square(twist.second);
  }

  double least_;
  std::vector<SolidMoments> lower_, upper_;
  std::array<SolidMoments, 4> grids_;  ///< by place in the block
  double volume_squares_ = 0.0, second_squares_ = 0.0;
  std::size_t met_ = 0;
};

Bounds grown(Bounds box, double margin) {
  box.low -= Vec3::Constant(margin);
  box.high += Vec3::Constant(margin);
  return box;
}

}  // namespace

ColumnQuadrature::ColumnQuadrature(const TriangleMesh& core, const OffsetLayer& skin)
    : box_(grown(bounds(core), skin.radius)),
      radius_(skin.radius),
      triangles_(core),
      pieces_(skin.pieces, skin.radius),
      overlaps_(skin.overlaps, skin.radius) {}

OverlapIntegral ColumnQuadrature::integrate_overlap(std::size_t columns_per_side) const {
  const Grid grid(box_, columns_per_side);
  Sweep triangles(triangles_, grid);
  Sweep pieces(pieces_, grid);
  Sweep overlaps(overlaps_, grid);
  BlockSum sum(grid.columns, kMet * radius_);
  std::vector<Column> columns(grid.columns);
  for (std::size_t row = 0; row < grid.rows; ++row) {
    const double y = grid.y(row);
    for (Column& column : columns) column.clear();
    triangles.visit(row, [&](std::size_t triangle, std::size_t i) {
      const double x = grid.x(i);
      const int sign = triangles_.crossing_sign(triangle, x, y);
      if (sign != 0)
        columns[i].crossings.push_back({triangles_.crossing_height(triangle, x, y), sign});
    });
    pieces.visit(row, [&](std::size_t piece, std::size_t i) {
      const LineInterval cut = pieces_.clip_line(piece, grid.x(i), y);
      if (!(cut.low < cut.high)) return;
      columns[i].excess.add(cut.low, cut.high);
      columns[i].intervals.push_back(cut);
    });
    overlaps.visit(row, [&](std::size_t piece, std::size_t i) {
      const LineInterval cut = overlaps_.clip_line(piece, grid.x(i), y);
      if (cut.low < cut.high) columns[i].excess.add(cut.low, cut.high, -1.0);
    });
    std::vector<SolidMoments>& moments = sum.row(row);
    for (std::size_t i = 0; i < grid.columns; ++i) {
      Column& column = columns[i];
      if (column.balanced()) {
        column.add_core();
        column.subtract_union();
      } else {
        column.clear();
      }
      moments[i] = column_moments(column.excess, grid.x(i), y);
    }
    if (row % 2 == 1) sum.add_rows();
  }
  const double cell = grid.step * grid.step;
  OverlapIntegral excess = sum.result(cell);
  if (sum.columns_met() < kFewColumns) {
    const double unseen = kUnseenColumns * cell * radius_;
    const double reach = 0.5 * box_.diagonal();
    excess.volume_error += unseen;
    excess.second_moment_error += unseen * reach * reach;
  }
  return excess;
}

}  // namespace clast::massprops_detail
