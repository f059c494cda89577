#include "classify/schemes.hpp"

#include <cmath>

#include "core/error.hpp"

namespace clast {
namespace {

// Axes are written in decimals: 0.42 m / 0.6 m is a hair under 0.7 in binary, and 1.3 - 1 a hair
// over 0.3. A ratio this close to a limit is on it.
constexpr double kOnLimit = 1e-12;

bool at_least(double value, double limit) { return value >= limit - kOnLimit; }
bool above(double value, double limit) { return value > limit + kOnLimit; }

}  // namespace

std::string sneed_folk_class(const Axes& axes) {
  const double compactness = axes.S / axes.L;
  if (at_least(compactness, 0.7)) return "C";
  const double index = *disc_rod_index(axes);  // S < L here
  const std::string form = !at_least(index, 0.33) ? "P" : above(index, 0.67) ? "E" : "B";
  if (at_least(compactness, 0.5)) return "C" + form;
  return at_least(compactness, 0.3) ? form : "V" + form;
}

std::string zingg_class(const Axes& axes) {
  const bool round = at_least(axes.I / axes.L, 2.0 / 3.0);
  const bool thick = at_least(axes.S / axes.I, 2.0 / 3.0);
  if (round) return thick ? "spheroid" : "disc";
  return thick ? "rod" : "blade";
}

std::string garcia_class(const Axes& axes) {
  return above(elongation_s_c(axes), 0.3) ? "elongated" : "compact";
}

const std::vector<std::string>& scheme_names() {
  static const std::vector<std::string> names = {"sneed-folk", "zingg", "garcia"};
  return names;
}

const std::vector<std::string>& class_names(const std::string& scheme) {
  static const std::vector<std::string> sneed_folk = {"C", "CP", "CB", "CE", "P",
                                                      "B", "E",  "VP", "VB", "VE"};
  static const std::vector<std::string> zingg = {"disc", "spheroid", "blade", "rod"};
  static const std::vector<std::string> garcia = {"compact", "elongated"};
  if (scheme == "sneed-folk") return sneed_folk;
  if (scheme == "zingg") return zingg;
  if (scheme == "garcia") return garcia;
  throw InputError("unknown classification scheme \"" + scheme +
                   "\"; known are sneed-folk, zingg and garcia");
}

std::string shape_class(const std::string& scheme, const Axes& axes) {
  class_names(scheme);  // refuses an unknown scheme
  if (scheme == "sneed-folk") return sneed_folk_class(axes);
  return scheme == "zingg" ? zingg_class(axes) : garcia_class(axes);
}

}  // namespace clast
