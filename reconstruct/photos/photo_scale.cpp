#include "reconstruct/photos/photo_scale.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace {

const FoundMarker& marker_of(const std::vector<FoundMarker>& markers, int id) {
  std::string known;
  for (const FoundMarker& marker : markers) {
    if (marker.id == id) return marker;
    known += (known.empty() ? "" : ", ") + std::to_string(marker.id);
  }
  throw InputError("scale bar: marker " + std::to_string(id) + " was not found; found " +
                   (known.empty() ? "none" : known) +
                   ". A marker must be seen whole, sharp and with a white margin in 3 photos");
}

std::string percent(double share) { return with_digits(100.0 * share, 2) + " %"; }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double mean_factor(const std::vector<ScaleMeasure>& measures, std::size_t without) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (!measures[i].used || i == without) continue;
    sum += measures[i].factor;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

void ScaleOptions::check() const {
  for (const ScaleBar& bar : bars) {
    if (bar.first == bar.second) {
      throw InputError("scale bar: both ends are marker " + std::to_string(bar.first));
    }
    if (!(bar.length > 0.0 && bar.length < 1e4)) {
      throw InputError("scale bar: " + with_digits(bar.length, 6) + " m is no distance");
    }
  }
  if (marker_side && !(*marker_side > 0.0 && *marker_side < 100.0)) {
    throw InputError("marker_side = " + with_digits(*marker_side, 6) + " m is no side of a marker");
  }
  if (!(largest_disagreement > 0.0 && largest_disagreement < 1.0)) {
    throw InputError("largest_disagreement = " + with_digits(largest_disagreement, 6) +
                     " must be between 0 and 1");
  }
}

PhotoScale scale_from_markers(const std::vector<FoundMarker>& markers,
                              const ScaleOptions& options) {
  options.check();
  PhotoScale scale;
  scale.from_bars = !options.bars.empty();
  for (const ScaleBar& bar : options.bars) {
    const FoundMarker &a = marker_of(markers, bar.first), &b = marker_of(markers, bar.second);
    scale.measures.push_back(
        {"markers " + std::to_string(bar.first) + " and " + std::to_string(bar.second), bar.length,
         bar.length / (a.centre() - b.centre()).norm(), 0.0, true});
  }
  if (!scale.from_bars && options.marker_side) {
    for (const FoundMarker& marker : markers) {
      scale.measures.push_back({"marker " + std::to_string(marker.id), *options.marker_side,
                                *options.marker_side / marker.side(), 0.0, true});
    }
  }
  if (scale.measures.empty()) {
    throw InputError(options.marker_side
                         ? "no marker was found in three photos; lay markers beside the block that "
                           "are sharp and whole in many photos, or give the scale another way"
                         : "no scale: neither a distance between markers nor their side is given");
  }
  std::vector<double> factors;
  for (const ScaleMeasure& measure : scale.measures) factors.push_back(measure.factor);
  const double middle = median(factors);
  const double most = options.largest_disagreement;
  std::size_t used = 0;
  for (ScaleMeasure& measure : scale.measures) {
    measure.used = std::abs(measure.factor / middle - 1.0) <= most;
    used += measure.used ? 1 : 0;
  }
  const std::size_t all = scale.measures.size();
  if (2 * used <= all && all > 1) {
    std::string values;
    for (const ScaleMeasure& measure : scale.measures) {
      values += (values.empty() ? "" : ", ") + measure.name + ": " +
                with_digits(measure.factor, 6) + " m per unit";
    }
    throw InputError("the sizes contradict each other by more than " + percent(most) + " (" +
                     values + "); measure the markers again, or give the distances you trust");
  }
  scale.metres_per_unit = mean_factor(scale.measures, all);
  double squares = 0.0;
  for (std::size_t i = 0; i < all; ++i) {
    ScaleMeasure& measure = scale.measures[i];
    const double others = mean_factor(scale.measures, i);
    if (others > 0.0) measure.left_out = others / measure.factor - 1.0;
    if (measure.used) {
      squares += std::pow(measure.factor / scale.metres_per_unit - 1.0, 2);
      continue;
    }
    scale.notes.push_back(measure.name + " disagrees by " + percent(std::abs(measure.left_out)) +
                          " with the other " + std::to_string(used) + " (limit " + percent(most) +
                          "): wrong size or a bent board? Left out");
  }
  if (used > 1) scale.spread = std::sqrt(squares / static_cast<double>(used - 1));
  if (used == 1) {
    scale.notes.push_back("the scale rests on " + scale.measures.front().name +
                          " alone, and nothing checks it");
  }
  if (scale.from_bars && options.marker_side && !markers.empty()) {
    double sides = 0.0;
    for (const FoundMarker& marker : markers) sides += marker.side();
    scale.side_check =
        scale.metres_per_unit * sides / static_cast<double>(markers.size()) / *options.marker_side -
        1.0;
    if (std::abs(*scale.side_check) > most) {
      scale.notes.push_back("by the distances between markers, their sides are " +
                            percent(std::abs(*scale.side_check)) +
                            (*scale.side_check > 0.0 ? " longer" : " shorter") +
                            " than given: check both");
    }
  }
  return scale;
}

}  // namespace clast
