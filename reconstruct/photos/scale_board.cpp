#include "reconstruct/photos/scale_board.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace {

/// A point of the board where it was measured and where the model has it.
struct BoardPoint {
  int id = 0;  ///< of the marker, or number of the corner
  std::string name;
  Vec3 metres, units;
};

/// Differences between the distances of the board and of the model.
struct Likeness {
  double rms = 0.0;    ///< of distances, m
  double worst = 0.0;  ///< m
  double reach = 0.0;  ///< longest distance, m
};

Likeness likeness(const std::vector<BoardPoint>& points, std::size_t without) {
  double metres = 0.0, units = 0.0;
  Likeness result;
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        if (i == without || j == without) continue;
        visit((points[i].metres - points[j].metres).norm(),
              (points[i].units - points[j].units).norm());
      }
    }
  };
  double count = 0.0;
  each([&](double m, double u) {
    metres += m;
    units += u;
    count += 1.0;
    result.reach = std::max(result.reach, m);
  });
  each([&](double m, double u) {
    const double off = std::abs(metres / units * u - m);
    result.rms += off * off / count;
    result.worst = std::max(result.worst, off);
  });
  result.rms = std::sqrt(result.rms);
  return result;
}

struct AlikePoints {
  std::vector<BoardPoint> points;
  std::vector<std::string> notes;  ///< names the others
  std::vector<int> misplaced;      ///< the others
};

AlikePoints alike(std::vector<BoardPoint> points, double most) {
  std::vector<std::string> notes;
  std::vector<int> misplaced;
  const std::size_t all = points.size();
  constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();
  for (;;) {
    const Likeness now = likeness(points, kNobody);
    if (points.size() < 3 || now.worst <= most * now.reach) {
      return {points, notes, misplaced};
    }
    if (points.size() == 3 || 2 * (points.size() - 1) <= all) {
      throw InputError(
          "the board contradicts the photos: distances on it differ by up to " +
          format_significant(now.worst, 3) + " m of " + format_significant(now.reach, 3) +
          " m, and " + std::to_string(points.size()) + " of its " + std::to_string(all) +
          " points are too few to find which is wrong; measure the board again, or check its file");
    }
    std::size_t worst = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double rms = likeness(points, i).rms;
      if (rms < least) {
        least = rms;
        worst = i;
      }
    }
    notes.push_back(points[worst].name +
                    " is not at its position on the board: without it distances agree to " +
                    format_significant(least, 2) + " m instead of " +
                    format_significant(now.rms, 2) + " m. It was left out");
    misplaced.push_back(points[worst].id);
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(worst));
  }
}

KnownLength between(const std::string& name, const BoardPoint& a, const BoardPoint& b) {
  return {name, (a.metres - b.metres).norm(), (a.units - b.units).norm(), {}};
}

}  // namespace

void ScaleBoard::check() const {
  MarkerOptions{.dictionary = dictionary}.check();
  if (dictionary == "auto" || dictionary == "none") {
    throw InputError("board: the dictionary \"" + dictionary +
                     "\" is unknown; name that of the board");
  }
  if (charuco) {
    charuco->check();
    if (!markers.empty()) {
      throw InputError(
          "board: its file has both single markers and a ChArUco board; give only one of them");
    }
    return;
  }
  if (markers.size() < 2) {
    throw InputError("board: " + std::to_string(markers.size()) +
                     " markers; at least two are needed for a distance");
  }
  for (std::size_t i = 0; i < markers.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::string pair =
          std::to_string(markers[j].id) + " and " + std::to_string(markers[i].id);
      if (markers[i].id == markers[j].id) {
        throw InputError("board: marker " + std::to_string(markers[i].id) +
                         " is given twice; keep one");
      }
      const double distance = (markers[i].centre - markers[j].centre).norm();
      if (!(distance > 0.0 && distance < 1e4)) {
        throw InputError("board: markers " + pair + " are " + format_significant(distance, 6) +
                         " m apart; must be above 0 and below 10000 m");
      }
    }
  }
}

BoardLengths measure_marker_distances(const ScaleBoard& board,
                                      const std::vector<LocatedMarker>& markers,
                                      double max_disagreement) {
  BoardLengths result;
  std::vector<BoardPoint> points;
  std::string missing;
  for (const BoardMarker& known : board.markers) {
    const auto found = std::find_if(markers.begin(), markers.end(),
                                    [&](const LocatedMarker& one) { return one.id == known.id; });
    if (found == markers.end()) {
      missing += (missing.empty() ? "" : ", ") + std::to_string(known.id);
    } else {
      points.push_back(
          {known.id, "marker " + std::to_string(known.id), known.centre, found->centre()});
    }
  }
  if (!missing.empty()) {
    result.notes.push_back("no three photos show marker " + missing +
                           " of the board completely and sharply");
  }
  const AlikePoints kept = alike(std::move(points), max_disagreement);
  result.notes.insert(result.notes.end(), kept.notes.begin(), kept.notes.end());
  result.misplaced = kept.misplaced;
  for (std::size_t i = 0; i < kept.points.size(); ++i) {
    for (std::size_t j = i + 1; j < kept.points.size(); ++j) {
      const BoardPoint &a = kept.points[i], &b = kept.points[j];
      KnownLength length =
          between("markers " + std::to_string(a.id) + " and " + std::to_string(b.id), a, b);
      length.markers = {a.id, b.id};
      result.lengths.push_back(length);
    }
  }
  return result;
}

BoardLengths measure_charuco_lengths(const CharucoBoard& board,
                                     const std::vector<BoardCorner>& corners,
                                     double max_disagreement) {
  BoardLengths result;
  std::vector<BoardPoint> points;
  const int wide = board.columns - 1;
  for (const BoardCorner& corner : corners) {
    const Vec3 position(corner.index % wide, corner.index / wide, 0.0);
    points.push_back({corner.index, "corner " + std::to_string(corner.index),
                      board.square * position, corner.position});
  }
  const AlikePoints kept = alike(std::move(points), max_disagreement);
  result.notes.insert(result.notes.end(), kept.notes.begin(), kept.notes.end());
  result.misplaced = kept.misplaced;
  const auto add = [&](const std::string& name, int axis, int index) {
    const BoardPoint *first = nullptr, *last = nullptr;
    for (const BoardPoint& point : kept.points) {
      if (std::lround(point.metres[axis] / board.square) != index) continue;
      if (!first) first = &point;
      last = &point;
    }
    if (first == last) return;
    result.lengths.push_back(between(name + " " + std::to_string(index + 1) + " of the board, " +
                                         first->name + " to " + last->name,
                                     *first, *last));
  };
  for (int row = 0; row < board.rows - 1; ++row) add("row", 1, row);
  for (int column = 0; column < wide; ++column) add("column", 0, column);
  if (result.lengths.empty()) {
    throw InputError("ChArUco board: " + std::to_string(kept.points.size()) +
                     " of its corners were found in three photos, but no two in one row; show it "
                     "larger and sharp in more photos, and check dictionary, columns and rows in "
                     "its file");
  }
  return result;
}

}  // namespace clast
