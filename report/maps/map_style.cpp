#include "report/maps/map_style.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/nice_number.hpp"
#include "core/number_text.hpp"
#include "report/charts/palette.hpp"

namespace clast::report_detail {
namespace {

constexpr std::size_t kMaxClasses = 8;
constexpr double kJoulesOfKilojoule = 1000.0;
constexpr std::size_t kMaxBlocks = 24;  // with a mark of their own

/// Pale to dark, from ColorBrewer.
using Ramp = std::array<Rgb, 5>;
constexpr Ramp kYellowRed = {
    {{255, 237, 160}, {254, 178, 76}, {252, 78, 42}, {189, 0, 38}, {77, 0, 20}}};
constexpr Ramp kYellowBlue = {
    {{237, 248, 177}, {127, 205, 187}, {29, 145, 192}, {34, 94, 168}, {8, 29, 88}}};
constexpr Ramp kBluePurple = {
    {{224, 236, 244}, {158, 188, 218}, {140, 107, 177}, {136, 65, 157}, {64, 0, 75}}};
constexpr Ramp kYellowGreen = {
    {{247, 252, 185}, {173, 221, 142}, {65, 171, 93}, {0, 104, 55}, {0, 50, 30}}};
constexpr Ramp kYellowBrown = {
    {{255, 247, 188}, {254, 196, 79}, {236, 112, 20}, {153, 52, 4}, {70, 25, 3}}};

enum class Limits { kThrees, kDecades, kEven };

/// Quantity of a layer; layers of one quantity have the same limits.
struct Quantity {
  const char* layer;
  const char* title;
  const char* quantity;
  const char* unit;
  double unit_size;
  Limits limits;
  const Ramp* ramp;
};

constexpr std::array<Quantity, 10> kQuantities = {
    {{"Reach_probability", "Reach probability", "fraction of runs", "%", 0.01, Limits::kDecades,
      &kYellowBlue},
     {"Nr_passages", "Passages", "passages", "runs", 1.0, Limits::kDecades, &kYellowBlue},
     {"E_mean", "Kinetic energy, mean", "energy", "J", 1.0, Limits::kThrees, &kYellowRed},
     {"E_95", "Kinetic energy, 95 %", "energy", "J", 1.0, Limits::kThrees, &kYellowRed},
     {"E_max", "Kinetic energy, largest", "energy", "J", 1.0, Limits::kThrees, &kYellowRed},
     {"Ph_95", "Passing height, 95 %", "height", "m", 1.0, Limits::kEven, &kYellowGreen},
     {"V_max", "Speed, largest", "speed", "m/s", 1.0, Limits::kEven, &kBluePurple},
     {"Deposit_mean", "Deposit, mean thickness", "thickness", "m", 1.0, Limits::kEven,
      &kYellowBrown},
     {"Deposit_max", "Deposit, largest thickness", "thickness", "m", 1.0, Limits::kEven,
      &kYellowBrown},
     {"Deposit_probability", "Deposit, probability", "fraction of realisations", "%", 0.01,
      Limits::kDecades, &kYellowBlue}}};

Quantity quantity_of(const RasterLayer& layer) {
  for (const Quantity& quantity : kQuantities) {
    if (layer.name == quantity.layer) return quantity;
  }
  const char* name = layer.name.c_str();
  return {name, name, name, "", 1.0, Limits::kEven, &kYellowRed};
}

struct AxisInterval {
  double low = INFINITY, high = -INFINITY;

  void include(const RasterLayer& layer) {
    for (const float value : layer.values) {
      if (!std::isfinite(value)) continue;
      low = std::min<double>(low, value);
      high = std::max<double>(high, value);
    }
  }
};

/// A limit as rasters can hold it: what is equal to it as a 32-bit float belongs to its class.
double limit(double value) { return static_cast<double>(static_cast<float>(value)); }

/// Limits at `steps` times powers of ten.
/// @param unit  in which they are round, and the limits that are returned
std::vector<double> limits_by_factors(const AxisInterval& span, double unit,
                                      std::span<const double> steps) {
  std::vector<double> falling;
  for (int power = static_cast<int>(std::floor(std::log10(span.high / unit))) + 1;
       falling.size() < kMaxClasses; --power) {
    // A quotient of whole numbers is the double nearest to 0.3; a product need not be.
    const double ten = std::pow(10.0, std::abs(power));
    const auto at = [&](double step) { return power < 0 ? step / ten : step * ten; };
    for (std::size_t i = steps.size(); i-- > 0;) {
      const double below = i > 0 ? at(steps[i - 1]) : at(steps.back()) / 10.0;
      if (limit(below * unit) >= span.high) continue;  // nothing would be in its class
      const bool is_last = falling.size() == kMaxClasses || limit(at(steps[i]) * unit) < span.low;
      if (is_last && !falling.empty()) return {falling.rbegin(), falling.rend()};
      falling.push_back(at(steps[i]));
    }
  }
  return {falling.rbegin(), falling.rend()};
}

/// Limits at multiples of a round number.
std::vector<double> even_limits(const AxisInterval& span, double unit) {
  const double step = round_up_to_nice_number(span.high / unit / static_cast<double>(kMaxClasses));
  std::vector<double> limits;
  for (double k = std::max(1.0, std::ceil(span.low / unit / step));; k += 1.0) {
    // The inverse of a small step is a whole number: 1, 2 or 5 times a power of ten.
    limits.push_back(step < 1.0 ? k / std::round(1.0 / step) : k * step);
    if (limit(limits.back() * unit) >= span.high) return limits;
  }
}

std::vector<double> limits_of(Limits limits, const AxisInterval& span, double unit) {
  constexpr std::array<double, 2> kThrees = {1.0, 3.0};
  constexpr std::array<double, 3> kDecades = {1.0, 2.0, 5.0};
  if (!(span.high > 0.0)) return {1.0};
  switch (limits) {
    case Limits::kThrees:
      return limits_by_factors(span, unit, kThrees);
    case Limits::kDecades:
      return limits_by_factors(span, unit, kDecades);
    case Limits::kEven:
      break;
  }
  return even_limits(span, unit);
}

/// Returns evenly spaced colours of a ramp.
std::vector<Rgb> colours_of(const Ramp& ramp, std::size_t count) {
  std::vector<Rgb> colours;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.5;
    const double place = share * static_cast<double>(ramp.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), ramp.size() - 2);
    const double rest = place - static_cast<double>(below);
    Rgb colour{};
    for (std::size_t k = 0; k < colour.size(); ++k) {
      colour[k] = static_cast<std::uint8_t>(
          std::lround(std::lerp<double, double, double>(ramp[below][k], ramp[below + 1][k], rest)));
    }
    colours.push_back(colour);
  }
  return colours;
}

ColourScale style_of(const Quantity& quantity, const AxisInterval& span) {
  ColourScale style{quantity.title, quantity.unit, quantity.unit_size, {}, {}, {}};
  if (quantity.limits == Limits::kThrees && span.high > kJoulesOfKilojoule) {
    style.unit = "kJ";
    style.unit_size = kJoulesOfKilojoule;
  }
  for (const double value : limits_of(quantity.limits, span, style.unit_size)) {
    style.breaks.push_back(limit(value * style.unit_size));
    style.numbers.push_back(format_significant(value, 6));
  }
  style.colours = colours_of(*quantity.ramp, style.breaks.size());
  return style;
}

/// Circles first for compact blocks and diamonds for others.
constexpr std::array<MarkShape, 10> kShapes = {{{"circle", "circle"},
                                                {"square", "square"},
                                                {"diamond", "diamond"},
                                                {"triangle-up", "equilateral_triangle"},
                                                {"pentagon", "pentagon"},
                                                {"triangle-down", "equilateral_triangle", 180},
                                                {"star", "star"},
                                                {"cross", "cross_fill"},
                                                {"hexagon", "hexagon"},
                                                {"triangle-right", "equilateral_triangle", 90}}};
constexpr std::size_t kFirstOfOthers = 2;

}  // namespace

std::string ColourScale::label(std::size_t class_index) const {
  const std::string unit_text = unit.empty() ? "" : " " + unit;
  if (class_index == 0) return "up to " + numbers[0] + unit_text;
  return numbers[class_index - 1] + " to " + numbers[class_index] + unit_text;
}

std::vector<ColourScale> choose_colour_scales(const MapRasterSet& rasters) {
  std::vector<ColourScale> styles;
  for (const RasterLayer& layer : rasters.layers) {
    const Quantity quantity = quantity_of(layer);
    AxisInterval span;
    for (const RasterLayer& other : rasters.layers) {
      if (std::string(quantity_of(other).quantity) == quantity.quantity) span.include(other);
    }
    styles.push_back(style_of(quantity, span));
  }
  return styles;
}

StopMarks choose_stop_marks(const Comparison& comparison) {
  const auto is_kind = [](const RunGroup& group, RunGroupKind kind) {
    return group.kind == kind && !group.file;
  };
  const auto blocks =
      std::count_if(comparison.groups.begin(), comparison.groups.end(),
                    [&](const RunGroup& group) { return is_kind(group, RunGroupKind::kBlock); });
  StopMarks result;
  result.by_block = static_cast<std::size_t>(blocks) <= kMaxBlocks;
  const RunGroupKind kind = result.by_block ? RunGroupKind::kBlock : RunGroupKind::kGarcia;
  std::size_t compact = 0, others = kFirstOfOthers;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const RunGroup& group = comparison.groups[g];
    if (!is_kind(group, kind)) continue;
    const std::string garcia = comparison.rows[group.rows.front()].block->garcia;
    std::size_t& next = garcia == "compact" ? compact : others;
    result.marks.push_back(
        {g, group.key, garcia, class_colour(garcia), kShapes[next++ % kShapes.size()]});
  }
  return result;
}

}  // namespace clast::report_detail
