#include "reconstruct/registration/detail/nearest_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr int kCells = 48;        ///< along the longest side of the surface
constexpr double kMargin = 0.25;  ///< around the surface, as a fraction of its longest side

}  // namespace

NearestGrid::NearestGrid(const OrientedSurface& surface) : surface_(surface) {
  Bounds box;
  for (const Vec3& p : surface.points) box.include(p);
  const double side = (box.high - box.low).maxCoeff();
  cell_ = side / kCells;
  low_ = box.low - Vec3::Constant(kMargin * side);
  const Vec3 extent = box.high + Vec3::Constant(kMargin * side) - low_;
  std::size_t total = 1;
  for (int axis = 0; axis < 3; ++axis) {
    counts_[static_cast<std::size_t>(axis)] = static_cast<int>(extent[axis] / cell_) + 1;
    total *= static_cast<std::size_t>(counts_[static_cast<std::size_t>(axis)]);
  }
  near_.assign(total, kNoIndex);
  for (std::uint32_t i = 0; i < surface.size(); ++i) near_[cell_at(surface.points[i])] = i;
  propagate();
}

std::size_t NearestGrid::cell_at(const Vec3& position) const {
  std::size_t index = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const int count = counts_[static_cast<std::size_t>(axis)];
    const double along = (position[axis] - low_[axis]) / cell_;
    const int at = along <= 0.0 ? 0 : along >= count - 1 ? count - 1 : static_cast<int>(along);
    index = index * static_cast<std::size_t>(count) + static_cast<std::size_t>(at);
  }
  return index;
}

/// Passes points from cell to cell, forwards and backwards, as distance transforms do.
void NearestGrid::propagate() {
  const auto [nx, ny, nz] = counts_;
  const auto index = [&](int x, int y, int z) {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(nx) +
           static_cast<std::size_t>(x);
  };
  const auto visit = [&](int x, int y, int z, int sign) {
    const Vec3 centre = low_ + cell_ * Vec3(x + 0.5, y + 0.5, z + 0.5);
    std::uint32_t& own = near_[index(x, y, z)];
    double least = own == kNoIndex ? 1e300 : (surface_.points[own] - centre).squaredNorm();
    const auto offer = [&](int dx, int dy, int dz) {
      const int i = x + dx, j = y + dy, k = z + dz;
      if (i < 0 || j < 0 || k < 0 || i >= nx || j >= ny || k >= nz) return;
      const std::uint32_t other = near_[index(i, j, k)];
      if (other == kNoIndex || other == own) return;
      const double square = (surface_.points[other] - centre).squaredNorm();
      if (square >= least) return;
      least = square;
      own = other;
    };
    for (int a = -1; a <= 1; ++a) {
      for (int b = -1; b <= 1; ++b) offer(a, b, sign);
      offer(a, sign, 0);
    }
    offer(sign, 0, 0);
    offer(-sign, 0, 0);
  };
  for (int round = 0; round < 2; ++round) {
    for (int z = 0; z < nz; ++z) {
      for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) visit(x, y, z, -1);
        for (int x = nx - 1; x >= 0; --x) visit(x, y, z, -1);
      }
    }
    for (int z = nz - 1; z >= 0; --z) {
      for (int y = ny - 1; y >= 0; --y) {
        for (int x = nx - 1; x >= 0; --x) visit(x, y, z, 1);
        for (int x = 0; x < nx; ++x) visit(x, y, z, 1);
      }
    }
  }
}

std::uint32_t NearestGrid::nearest_point(const Vec3& position) const {
  std::uint32_t best = near_point(position);
  double least = (surface_.points[best] - position).squaredNorm();
  constexpr std::size_t kDescended = 12;  // neighbours that a step compares
  for (bool moved = true; moved;) {
    moved = false;
    const auto neighbours = surface_.neighbours_of(best);
    for (std::size_t i = 0; i < std::min(kDescended, neighbours.size()); ++i) {
      const double square = (surface_.points[neighbours[i]] - position).squaredNorm();
      if (square >= least) continue;
      least = square;
      best = neighbours[i];
      moved = true;
    }
  }
  return best;
}

}  // namespace clast::reconstruct_detail
