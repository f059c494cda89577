#include "report/charts/contour_field.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "mesh/plan_geometry.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

double bending(double squared_distance) {
  return squared_distance > 0.0 ? 0.5 * squared_distance * std::log(squared_distance) : 0.0;
}

struct Corner {
  Vec2 position;
  double value = 0.0;
};

std::string point_text(const Vec2& place) {
  return format_fixed(place.x(), 1) + " " + format_fixed(place.y(), 1);
}

/// The part of the triangle that is at least so high.
std::vector<Vec2> above(const std::array<Corner, 3>& triangle, double level) {
  std::vector<Vec2> part;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &here = triangle[i], &next = triangle[(i + 1) % 3];
    if (here.value >= level) part.push_back(here.position);
    if ((here.value >= level) != (next.value >= level)) {
      const double share = (level - here.value) / (next.value - here.value);
      part.push_back(here.position + share * (next.position - here.position));
    }
  }
  return part;
}

/// Returns the two points where the level crosses the triangle, or none.
std::vector<Vec2> crossing(const std::array<Corner, 3>& triangle, double level) {
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &here = triangle[i], &next = triangle[(i + 1) % 3];
    if ((here.value >= level) == (next.value >= level)) continue;
    const double share = (level - here.value) / (next.value - here.value);
    places.push_back(here.position + share * (next.position - here.position));
  }
  return places;
}

/// Calls with every triangle of a lattice whose centre is inside the hull; corners beyond it are
/// drawn to it by the clip of the picture.
void visit_lattice(const ThinPlateSpline& surface, std::span<const Vec2> hull, double side,
                   const std::function<void(const std::array<Corner, 3>&)>& visit) {
  Vec2 low = hull.front(), high = hull.front();
  for (const Vec2& corner : hull) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double height = side * std::sqrt(0.75);
  const auto rows = static_cast<int>(std::ceil((high.y() - low.y()) / height)) + 1;
  const auto columns = static_cast<int>(std::ceil((high.x() - low.x()) / side)) + 2;
  const auto corner = [&](int row, int column) {
    const double shift = row % 2 == 0 ? 0.0 : -0.5 * side;
    const Vec2 place(low.x() + shift + side * (column - 0.5), low.y() + height * (row - 0.5));
    return Corner{place, surface.value_at(place)};
  };
  const auto offer = [&](const Corner& a, const Corner& b, const Corner& c) {
    const Vec2 centre = (a.position + b.position + c.position) / 3.0;
    const bool near = is_inside(hull, a.position) || is_inside(hull, b.position) ||
                      is_inside(hull, c.position) || is_inside(hull, centre);
    if (near) visit({a, b, c});
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Corner a = corner(row, column), b = corner(row, column + 1);
      const int left = row % 2 == 0 ? column : column - 1;
      const Corner c = corner(row + 1, left + 1), d = corner(row + 1, left);
      offer(a, c, d);
      offer(a, b, c);
    }
  }
}

std::string closed_path(std::span<const Vec2> places) {
  std::string path;
  for (std::size_t i = 0; i < places.size(); ++i) {
    path += (i == 0 ? "M" : "L") + point_text(places[i]);
  }
  return path + "Z";
}

bool is_on_level(const std::array<Corner, 3>& triangle, double level) {
  return std::all_of(triangle.begin(), triangle.end(),
                     [&](const Corner& corner) { return corner.value >= level; });
}

/// Triangles of the lattice that touch along a row, as one trapezoid.
class WholeTriangles {
 public:
  /// Adds a triangle; returns the path of the trapezoid that it completes.
  std::string add(const std::array<Corner, 3>& triangle) {
    Row top{triangle[0].position.y()}, bottom{triangle[0].position.y()};
    for (const Corner& corner : triangle) {
      top.y = std::min(top.y, corner.position.y());
      bottom.y = std::max(bottom.y, corner.position.y());
    }
    for (const Corner& corner : triangle) {
      (corner.position.y() == top.y ? top : bottom).include(corner.position.x());
    }
    std::string path;
    if (!(any_ && top.y == top_.y && bottom.y == bottom_.y && top.low <= top_.high &&
          bottom.low <= bottom_.high)) {
      path = finish();
      top_ = top;
      bottom_ = bottom;
    }
    any_ = true;
    top_.include(top.high);
    bottom_.include(bottom.high);
    return path;
  }
  std::string finish() {
    if (!std::exchange(any_, false)) return "";
    std::vector<Vec2> corners = {{top_.low, top_.y}};
    if (top_.high > top_.low) corners.emplace_back(top_.high, top_.y);
    corners.emplace_back(bottom_.high, bottom_.y);
    if (bottom_.high > bottom_.low) corners.emplace_back(bottom_.low, bottom_.y);
    return closed_path(corners);
  }

 private:
  struct Row {
    double y = 0.0, low = 1e300, high = -1e300;
    void include(double x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  };
  Row top_, bottom_;
  bool any_ = false;
};

}  // namespace

ThinPlateSpline::ThinPlateSpline(std::span<const Vec2> places, std::span<const double> values)
    : places_(places.begin(), places.end()), centre_(Vec2::Zero()) {
  const std::size_t count = places.size();
  for (const Vec2& place : places) centre_ += place / static_cast<double>(count);
  for (const Vec2& place : places) scale_ = std::max(scale_, (place - centre_).norm());
  for (Vec2& place : places_) place = (place - centre_) / scale_;
  const auto size = static_cast<Eigen::Index>(count + 3);
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(size);
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < count; ++k) {
      system(row, static_cast<Eigen::Index>(k)) = bending((places_[i] - places_[k]).squaredNorm());
    }
    const std::array<double, 3> plane = {1.0, places_[i].x(), places_[i].y()};
    for (int k = 0; k < 3; ++k) {
      system(row, size - 3 + k) = system(size - 3 + k, row) = plane[k];
    }
    wanted[row] = values[i];
  }
  const Eigen::VectorXd solved = system.fullPivLu().solve(wanted);
  weights_.assign(solved.begin(), solved.end());
}

double ThinPlateSpline::value_at(const Vec2& place) const {
  const Vec2 scaled = (place - centre_) / scale_;
  const std::size_t count = places_.size();
  double value =
      weights_[count] + weights_[count + 1] * scaled.x() + weights_[count + 2] * scaled.y();
  for (std::size_t i = 0; i < count; ++i) {
    value += weights_[i] * bending((scaled - places_[i]).squaredNorm());
  }
  return value;
}

std::vector<Vec2> plan_convex_hull(std::span<const Vec2> places) {
  std::vector<Vec2> sorted(places.begin(), places.end());
  std::sort(sorted.begin(), sorted.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  constexpr double kStraight = 1e-6;  // px^2
  std::vector<Vec2> hull;
  const auto add = [&](const Vec2& place, std::size_t fewest) {
    while (hull.size() >= fewest &&
           twice_area(hull[hull.size() - 2], hull.back(), place) <= kStraight) {
      hull.pop_back();
    }
    hull.push_back(place);
  };
  for (const Vec2& place : sorted) add(place, 2);
  const std::size_t lower = hull.size() + 1;
  for (std::size_t i = sorted.size(); i-- > 0;) add(sorted[i], lower);
  if (!hull.empty()) hull.pop_back();
  return hull;
}

bool is_inside(std::span<const Vec2> hull, const Vec2& place) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (twice_area(hull[i], hull[(i + 1) % hull.size()], place) < 0.0) return false;
  }
  return hull.size() > 2;
}

std::string format_band_path(const ThinPlateSpline& surface, std::span<const Vec2> hull,
                             double level, double side) {
  std::string path;
  WholeTriangles whole;
  visit_lattice(surface, hull, side, [&](const std::array<Corner, 3>& triangle) {
    const std::vector<Vec2> part = above(triangle, level);
    if (part.size() < 3) return;
    if (is_on_level(triangle, level)) {
      path += whole.add(triangle);
    } else {
      path += closed_path(part);
    }
  });
  return path + whole.finish();
}

ContourLine trace_contour_line(const ThinPlateSpline& surface, std::span<const Vec2> hull,
                               double level, double side) {
  ContourLine line;
  visit_lattice(surface, hull, side, [&](const std::array<Corner, 3>& triangle) {
    const std::vector<Vec2> places = crossing(triangle, level);
    if (places.size() != 2) return;
    line.pieces.emplace_back(places[0], places[1]);
    line.path += "M" + point_text(places[0]) + "L" + point_text(places[1]);
  });
  return line;
}

}  // namespace clast::report_detail
