#include "samples/deposit/height_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace clast {
namespace {

// Lengths in spacings.
constexpr double kGravel = 0.3;           // standard deviation of the height of each vertex
constexpr double kPebbleRadius = 3.0;     // largest
constexpr double kPebbleDistance = 18.0;  // mean one

}  // namespace

HeightField::HeightField(const ScannedPlan& plan, double cell_size)
    : low(plan.low),
      cell(cell_size),
      columns(static_cast<int>(std::ceil((plan.high.x() - plan.low.x()) / cell_size)) + 1),
      rows(static_cast<int>(std::ceil((plan.high.y() - plan.low.y()) / cell_size)) + 1),
      heights(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0.0) {}

double HeightField::at(const Vec2& place) const {
  const Vec2 scaled = (place - low) / cell;
  const double x = std::clamp(scaled.x(), 0.0, columns - 1.001);
  const double y = std::clamp(scaled.y(), 0.0, rows - 1.001);
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const double u = x - i, v = y - j;
  return (1.0 - v) * ((1.0 - u) * heights[index(i, j)] + u * heights[index(i + 1, j)]) +
         v * ((1.0 - u) * heights[index(i, j + 1)] + u * heights[index(i + 1, j + 1)]);
}

void fill_heights(HeightField& field, unsigned threads,
                  const std::function<double(const Vec2&)>& height) {
  parallel_for(static_cast<std::size_t>(field.rows), threads, [&](std::size_t j) {
    const int row = static_cast<int>(j);
    for (int i = 0; i < field.columns; ++i) {
      field.heights[field.index(i, row)] = height(field.place(i, row));
    }
  });
}

void add_grains(HeightField& field, double spacing, Random& random) {
  const double area = field.cell * field.cell * field.columns * field.rows;
  const double distance = kPebbleDistance * spacing;
  for (int left = static_cast<int>(area / (distance * distance)); left > 0; --left) {
    const double radius = kPebbleRadius * spacing * std::sqrt(random.uniform(0.1, 1.0));
    const int i = static_cast<int>(random.uniform_index(static_cast<std::uint64_t>(field.columns)));
    const int j = static_cast<int>(random.uniform_index(static_cast<std::uint64_t>(field.rows)));
    const int reach = static_cast<int>(radius / field.cell);
    for (int y = std::max(0, j - reach); y <= std::min(field.rows - 1, j + reach); ++y) {
      for (int x = std::max(0, i - reach); x <= std::min(field.columns - 1, i + reach); ++x) {
        const double aside = (field.place(x, y) - field.place(i, j)).squaredNorm();
        const double rise = radius * radius - aside;
        if (rise > 0.0) field.heights[field.index(x, y)] += 0.7 * std::sqrt(rise);
      }
    }
  }
  for (double& height : field.heights) height += kGravel * spacing * random.normal();
}

TriangleMesh make_mesh(const HeightField& field) {
  TriangleMesh mesh;
  mesh.vertices.reserve(field.heights.size());
  for (int j = 0; j < field.rows; ++j) {
    for (int i = 0; i < field.columns; ++i) {
      const Vec2 place = field.place(i, j);
      mesh.vertices.emplace_back(place.x(), place.y(), field.heights[field.index(i, j)]);
    }
  }
  mesh.triangles.reserve(2 * field.heights.size());
  for (int j = 0; j + 1 < field.rows; ++j) {
    for (int i = 0; i + 1 < field.columns; ++i) {
      const auto a = static_cast<std::uint32_t>(field.index(i, j));
      const auto d = static_cast<std::uint32_t>(field.index(i, j + 1));
      mesh.triangles.push_back({a, a + 1, d + 1});
      mesh.triangles.push_back({a, d + 1, d});
    }
  }
  return mesh;
}

void smooth_heights(HeightField& field, int reach) {
  for (int pass = 0; pass < 6; ++pass) {
    const bool along_rows = pass % 2 == 0;
    const std::vector<double> before = field.heights;
    for (int j = 0; j < field.rows; ++j) {
      for (int i = 0; i < field.columns; ++i) {
        double sum = 0.0;
        for (int k = -reach; k <= reach; ++k) {
          const int x = std::clamp(along_rows ? i + k : i, 0, field.columns - 1);
          const int y = std::clamp(along_rows ? j : j + k, 0, field.rows - 1);
          sum += before[field.index(x, y)];
        }
        field.heights[field.index(i, j)] = sum / (2 * reach + 1);
      }
    }
  }
}

}  // namespace clast
