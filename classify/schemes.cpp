#include "classify/schemes.hpp"

#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/number_range.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

// Axes are written in decimals: 0.42 m / 0.6 m is a hair under 0.7 in binary, and 1.3 - 1 a hair
// over 0.3. A ratio this close to a limit is on it.
constexpr double kOnLimit = 1e-12;

bool at_least(double value, double limit) { return value >= limit - kOnLimit; }
bool above(double value, double limit) { return value > limit + kOnLimit; }

constexpr double kGarciaLimit = 0.3;
constexpr double kZinggLimit = 2.0 / 3.0;
constexpr double kNonCubical = 3.0;
constexpr double kFlaky = 0.625;
constexpr std::array kBlottPyeWords = {"extremely", "very", "moderately", "slightly", "not"};

std::array<double, 2> sneed_folk_limits(const SchemeOptions& options) {
  if (options.sneed_folk_thirds) return {1.0 / 3.0, 2.0 / 3.0};
  return {0.33, 0.67};
}

double blott_pye_limit(int step) { return 0.2 * (step + 1); }

const char* blott_pye_word(double ratio) {
  std::size_t word = 0;
  while (word < 4 && at_least(ratio, blott_pye_limit(static_cast<int>(word)))) ++word;
  return kBlottPyeWords[word];
}

std::vector<std::string> blott_pye_names() {
  std::vector<std::string> names;
  for (auto elongate = kBlottPyeWords.rbegin(); elongate != kBlottPyeWords.rend(); ++elongate) {
    for (auto flat = kBlottPyeWords.rbegin(); flat != kBlottPyeWords.rend(); ++flat) {
      names.push_back(std::string(*elongate) + " elongate, " + *flat + " flat");
    }
  }
  return names;
}

struct Scheme {
  std::string name;
  std::vector<std::string> classes;
  std::string (*shape_class)(const Axes&, const SchemeOptions&);
  std::vector<ClassifyingRatio> (*ratios)(const Axes&, const SchemeOptions&);
  std::vector<ClassBoundary> (*limits)(const SchemeOptions&);
};

ClassBoundary limit_of_I_L(double value) { return {.constant = -value, .i_l = 1.0}; }
ClassBoundary limit_of_S_L(double value) { return {.constant = -value, .s_l = 1.0}; }
ClassBoundary limit_of_S_I(double value) { return {.i_l = -value, .s_l = 1.0}; }
/// (1 - I/L) = value (1 - S/L)
ClassBoundary limit_of_disc_rod(double value) {
  return {.constant = 1.0 - value, .i_l = -1.0, .s_l = value};
}

std::vector<ClassifyingRatio> sneed_folk_ratios(const Axes& a, const SchemeOptions& options) {
  std::vector<ClassifyingRatio> ratios = {{"S/L", a.S / a.L, {0.3, 0.5, 0.7}}};
  if (at_least(a.S / a.L, 0.7)) return ratios;
  const auto [low, high] = sneed_folk_limits(options);
  ratios.push_back({"(L-I)/(L-S)", *disc_rod_index(a), {low, high}});
  return ratios;
}

std::vector<ClassifyingRatio> blott_pye_ratios(const Axes& a, const SchemeOptions&) {
  std::vector<double> limits;
  for (int step = 0; step < 4; ++step) limits.push_back(blott_pye_limit(step));
  return {{"I/L", a.I / a.L, limits}, {"S/I", a.S / a.I, limits}};
}

std::vector<ClassBoundary> blott_pye_limits(const SchemeOptions&) {
  std::vector<ClassBoundary> limits;
  for (int step = 0; step < 4; ++step) {
    limits.push_back(limit_of_I_L(blott_pye_limit(step)));
    limits.push_back(limit_of_S_I(blott_pye_limit(step)));
  }
  return limits;
}

const std::vector<Scheme>& schemes() {
  using A = Axes;
  using O = SchemeOptions;
  using Ratios = std::vector<ClassifyingRatio>;
  using Limits = std::vector<ClassBoundary>;
  static const std::vector<Scheme> all = {
      {"sneed-folk",
       {"C", "CP", "CB", "CE", "P", "B", "E", "VP", "VB", "VE"},
       sneed_folk_class,
       sneed_folk_ratios,
       [](const O& options) -> Limits {
         const auto [low, high] = sneed_folk_limits(options);
         return {limit_of_S_L(0.3), limit_of_S_L(0.5), limit_of_S_L(0.7), limit_of_disc_rod(low),
                 limit_of_disc_rod(high)};
       }},
      {"zingg",
       {"disc", "spheroid", "blade", "rod"},
       [](const A& a, const O&) { return zingg_class(a); },
       [](const A& a, const O&) -> Ratios {
         return {{"I/L", a.I / a.L, {kZinggLimit}}, {"S/I", a.S / a.I, {kZinggLimit}}};
       },
       [](const O&) -> Limits {
         return {limit_of_I_L(kZinggLimit), limit_of_S_I(kZinggLimit)};
       }},
      {"garcia",
       {"compact", "elongated"},
       [](const A& a, const O&) { return garcia_class(a); },
       [](const A& a, const O&) -> Ratios {
         return {{"s_c", elongation_index(a), {kGarciaLimit}}};
       },
       [](const O&) -> Limits { return {limit_of_I_L(1.0 / (1.0 + kGarciaLimit))}; }},
      {"williams",
       {"oblate", "neither", "prolate"},
       [](const A& a, const O&) { return williams_class(a); },
       [](const A& a, const O&) -> Ratios {
         return {{"W", williams_shape_index(a), {0.0}}};
       },
       [](const O&) -> Limits { return {{.s_l = -1.0, .i_l_squared = 1.0}}; }},
      {"erdogan",
       {"platy", "elongated", "undetermined"},
       erdogan_class,
       [](const A& a, const O& options) -> Ratios {
         return {{"L/I", a.L / a.I, {options.erdogan_limit}},
                 {"I/S", a.I / a.S, {options.erdogan_limit}}};
       },
       [](const O& options) -> Limits {
         return {limit_of_I_L(1.0 / options.erdogan_limit),
                 limit_of_S_I(1.0 / options.erdogan_limit)};
       }},
      {"blott-pye", blott_pye_names(), [](const A& a, const O&) { return blott_pye_class(a); },
       blott_pye_ratios, blott_pye_limits},
      {"en-933-4",
       {"cubical", "non-cubical"},
       [](const A& a, const O&) { return en_933_4_class(a); },
       [](const A& a, const O&) -> Ratios {
         return {{"L/S", a.L / a.S, {kNonCubical}}};
       },
       [](const O&) -> Limits { return {limit_of_S_L(1.0 / kNonCubical)}; }},
      {"flakiness",
       {"not flaky", "flaky"},
       [](const A& a, const O&) { return flakiness_class(a); },
       [](const A& a, const O&) -> Ratios {
         return {{"S/I", a.S / a.I, {kFlaky}}};
       },
       [](const O&) -> Limits { return {limit_of_S_I(kFlaky)}; }},
  };
  return all;
}

const Scheme& scheme_named(const std::string& name) {
  for (const Scheme& scheme : schemes()) {
    if (scheme.name == name) return scheme;
  }
  std::string known;
  for (const Scheme& scheme : schemes()) {
    if (!known.empty()) known += &scheme == &schemes().back() ? " and " : ", ";
    known += scheme.name;
  }
  throw InputError("unknown classification scheme \"" + name + "\"; known are " + known);
}

}  // namespace

void SchemeOptions::check() const {
  if (!kErdoganLimitRange.contains(erdogan_limit)) {
    throw InputError("erdogan_limit is " + format_significant(erdogan_limit, 6) +
                     "; it is a limit of L/I and I/S and must be " + kErdoganLimitRange.describe());
  }
}

std::string sneed_folk_class(const Axes& axes, const SchemeOptions& options) {
  const double q = axes.S / axes.L;
  if (at_least(q, 0.7)) return "C";
  const double index = *disc_rod_index(axes);  // S < L here
  const auto [low, high] = sneed_folk_limits(options);
  const std::string form = !at_least(index, low) ? "P" : above(index, high) ? "E" : "B";
  if (at_least(q, 0.5)) return "C" + form;
  return at_least(q, 0.3) ? form : "V" + form;
}

std::string zingg_class(const Axes& axes) {
  const bool round = at_least(axes.I / axes.L, kZinggLimit);
  const bool thick = at_least(axes.S / axes.I, kZinggLimit);
  if (round) return thick ? "spheroid" : "disc";
  return thick ? "rod" : "blade";
}

std::string garcia_class(const Axes& axes) {
  return above(elongation_index(axes), kGarciaLimit) ? "elongated" : "compact";
}

std::string williams_class(const Axes& axes) {
  const double w = williams_shape_index(axes);
  if (above(w, 0.0)) return "oblate";
  return at_least(w, 0.0) ? "neither" : "prolate";
}

std::string erdogan_class(const Axes& axes, const SchemeOptions& options) {
  const bool long_axis = at_least(axes.L / axes.I, options.erdogan_limit);
  const bool short_axis = at_least(axes.I / axes.S, options.erdogan_limit);
  if (long_axis == short_axis) return "undetermined";
  return long_axis ? "elongated" : "platy";
}

std::string blott_pye_class(const Axes& axes) {
  return std::string(blott_pye_word(axes.I / axes.L)) + " elongate, " +
         blott_pye_word(axes.S / axes.I) + " flat";
}

std::string en_933_4_class(const Axes& axes) {
  return above(axes.L / axes.S, kNonCubical) ? "non-cubical" : "cubical";
}

std::string flakiness_class(const Axes& axes) {
  return at_least(axes.S / axes.I, kFlaky) ? "not flaky" : "flaky";
}

const std::vector<std::string>& scheme_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Scheme& scheme : schemes()) all.push_back(scheme.name);
    return all;
  }();
  return names;
}

const std::vector<std::string>& class_names(const std::string& scheme) {
  return scheme_named(scheme).classes;
}

std::string shape_class(const std::string& scheme, const Axes& axes, const SchemeOptions& options) {
  return scheme_named(scheme).shape_class(axes, options);
}

std::vector<ClassifyingRatio> classifying_ratios(const std::string& scheme, const Axes& axes,
                                                 const SchemeOptions& options) {
  return scheme_named(scheme).ratios(axes, options);
}

std::vector<ClassBoundary> class_boundaries(const std::string& scheme,
                                            const SchemeOptions& options) {
  return scheme_named(scheme).limits(options);
}

}  // namespace clast
