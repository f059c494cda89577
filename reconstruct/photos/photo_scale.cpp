#include "reconstruct/photos/photo_scale.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace {

const LocatedMarker& marker_of(const std::vector<LocatedMarker>& markers, int id) {
  std::string known;
  for (const LocatedMarker& marker : markers) {
    if (marker.id == id) return marker;
    known += (known.empty() ? "" : ", ") + std::to_string(marker.id);
  }
  throw InputError(
      "scale bar: marker " + std::to_string(id) + " was not found; found " +
      (known.empty() ? "none" : known) +
      ". A marker must be completely visible, sharp and with a white margin in 3 photos");
}

std::string in_percent(double fraction) { return format_significant(100.0 * fraction, 2) + " %"; }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double mean_factor(const std::vector<ComparedLength>& measures, std::size_t without) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (!measures[i].used || i == without) continue;
    sum += measures[i].factor;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// Side of the markers: as given, otherwise that of the board.
std::optional<double> side_of_markers(const ScaleOptions& options) {
  if (options.marker_side || !options.board) return options.marker_side;
  return options.board->marker_side;
}

/// Known distances: of scale bars, and all of a board.
BoardLengths known_distances(const std::vector<LocatedMarker>& markers, const ScaleOptions& options,
                             const std::vector<BoardCorner>& corners) {
  BoardLengths known;
  if (options.board && options.board->charuco) {
    known = measure_charuco_lengths(*options.board->charuco, corners, options.max_disagreement);
  } else if (options.board) {
    known = measure_marker_distances(*options.board, markers, options.max_disagreement);
  }
  for (const ScaleBar& bar : options.bars) {
    const LocatedMarker &a = marker_of(markers, bar.first), &b = marker_of(markers, bar.second);
    known.lengths.push_back(
        {"markers " + std::to_string(bar.first) + " and " + std::to_string(bar.second),
         bar.length,
         (a.centre() - b.centre()).norm(),
         {bar.first, bar.second}});
  }
  return known;
}

[[noreturn]] void refuse_without_length(const std::vector<LocatedMarker>& markers,
                                        const ScaleOptions& options) {
  if (options.board) {
    throw InputError(
        "board: " + std::to_string(markers.size()) +
        " markers were found in three photos, but no two of the board; check its dictionary and "
        "ids, and that it is completely visible, flat and sharp in many photos");
  }
  throw InputError(
      options.marker_side
          ? "no marker was found in three photos; place markers beside the block that are sharp "
            "and completely visible in many photos, or give the scale another way"
          : "no scale: neither a distance between markers nor their side is given");
}

/// Excludes measures that differ from the median by more than the fraction `most`.
/// @returns how many are
std::size_t leave_out_disagreeing(std::vector<ComparedLength>& measures, double most) {
  std::vector<double> factors;
  for (const ComparedLength& measure : measures) factors.push_back(measure.factor);
  const double middle = median(factors);
  std::size_t used = 0;
  for (ComparedLength& measure : measures) {
    measure.used = std::abs(measure.factor / middle - 1.0) <= most;
    used += measure.used ? 1 : 0;
  }
  if (2 * used > measures.size() || measures.size() == 1) return used;
  std::string values;
  for (const ComparedLength& measure : measures) {
    values += (values.empty() ? "" : ", ") + measure.name + ": " +
              format_significant(measure.factor, 6) + " m per unit";
  }
  throw InputError("the sizes contradict each other by more than " + in_percent(most) + " (" +
                   values + "); measure the markers again, or give only the reliable distances");
}

/// Computes each measure's error against the mean of the others, and the spread of those used.
void compare_measures(PhotoScale& scale, std::size_t used, double most) {
  double squares = 0.0;
  for (std::size_t i = 0; i < scale.measures.size(); ++i) {
    ComparedLength& measure = scale.measures[i];
    const double others = mean_factor(scale.measures, i);
    if (others > 0.0) measure.leave_one_out_error = others / measure.factor - 1.0;
    if (measure.used) {
      squares += std::pow(measure.factor / scale.metres_per_unit - 1.0, 2);
      continue;
    }
    scale.notes.push_back(measure.name + " disagrees by " +
                          in_percent(std::abs(measure.leave_one_out_error)) + " with the other " +
                          std::to_string(used) + " (limit " + in_percent(most) +
                          "), so it is left out: check its size and that the board is flat");
  }
  if (used > 1) scale.spread = std::sqrt(squares / static_cast<double>(used - 1));
  if (used == 1) {
    scale.notes.push_back("the scale is based on " + scale.measures.front().name +
                          " alone, without a check");
  }
}

/// The markers' sides by the distances between them, against the side that was given.
void check_sides(PhotoScale& scale, const std::vector<LocatedMarker>& markers, double side,
                 double most) {
  double sides = 0.0;
  for (const LocatedMarker& marker : markers) sides += marker.side();
  scale.marker_side_ratio =
      scale.metres_per_unit * sides / static_cast<double>(markers.size()) / side - 1.0;
  if (std::abs(*scale.marker_side_ratio) <= most) return;
  scale.notes.push_back(
      "according to the distances between markers, the sides of the markers are " +
      in_percent(std::abs(*scale.marker_side_ratio)) +
      (*scale.marker_side_ratio > 0.0 ? " longer" : " shorter") + " than given: check both");
}

}  // namespace

void ScaleOptions::check() const {
  for (const ScaleBar& bar : bars) {
    if (bar.first == bar.second) {
      throw InputError("scale bar: both ends are marker " + std::to_string(bar.first) +
                       "; name two markers");
    }
    if (!(bar.length > 0.0 && bar.length < 1e4)) {
      throw InputError("scale bar: " + format_significant(bar.length, 6) +
                       " m can't be a distance; it must be above 0 and below 10000 m");
    }
  }
  if (board) board->check();
  if (marker_side && !(*marker_side > 0.0 && *marker_side < 100.0)) {
    throw InputError("marker_side = " + format_significant(*marker_side, 6) +
                     " m can't be the side of a marker; it must be above 0 and below 100 m");
  }
  if (!(max_disagreement > 0.0 && max_disagreement < 1.0)) {
    throw InputError("largest_disagreement = " + format_significant(max_disagreement, 6) +
                     " must be between 0 and 1");
  }
}

PhotoScale estimate_scale_from_markers(const std::vector<LocatedMarker>& markers,
                                       const ScaleOptions& options,
                                       const std::vector<BoardCorner>& corners) {
  options.check();
  PhotoScale scale;
  const std::optional<double> side = side_of_markers(options);
  auto [lengths, notes, misplaced] = known_distances(markers, options, corners);
  scale.notes = std::move(notes);
  if (!options.board || !options.board->charuco) scale.misplaced = std::move(misplaced);
  scale.from_bars = !lengths.empty();
  if (!scale.from_bars && side) {
    for (const LocatedMarker& marker : markers) {
      lengths.push_back({"marker " + std::to_string(marker.id), *side, marker.side(), {marker.id}});
    }
  }
  if (lengths.empty()) refuse_without_length(markers, options);
  for (const KnownLength& known : lengths) {
    scale.measures.push_back(
        {known.name, known.metres, known.metres / known.units, 0.0, true, known.markers});
  }
  const std::size_t used = leave_out_disagreeing(scale.measures, options.max_disagreement);
  scale.metres_per_unit = mean_factor(scale.measures, scale.measures.size());
  compare_measures(scale, used, options.max_disagreement);
  if (scale.from_bars && side && !markers.empty()) {
    check_sides(scale, markers, *side, options.max_disagreement);
  }
  return scale;
}

}  // namespace clast
