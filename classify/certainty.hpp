#pragma once
/// How sure a shape class is, given what the axes are known to.
#include <string>
#include <vector>

#include "classify/schemes.hpp"

namespace clast {

/// What an axis measured by tape is known to, m.
inline constexpr double kTapeError = 0.05;

/// A class with its nearest limit and with what the error of the axes allows.
struct ClassCertainty {
  std::string name;
  std::string ratio;        ///< that is nearest to one of its limits, as "S/L"
  double value = 0.0;       ///< of the ratio
  double limit = 0.0;       ///< nearest to it
  double distance = 0.0;    ///< between the two
  bool near_limit = false;  ///< closer than 0.05, or closer than the error of the axes
  bool is_certain = true;   ///< the class is the same for all axes within the error
  std::vector<std::string>
      possible_others;  ///< every other class that axes within the error can have
};

/// Each axis may be off by `axis_error` either way, independently of the others. `possible_others`
/// is complete and holds nothing else: the ratios that axes L >= I >= S within the error can have
/// are a convex polygon, which the limits of the scheme cut into pieces of one class each; see
/// docs/theory.md.
/// @param axis_error  m, zero or positive
/// @throws InputError  unknown scheme, or error negative or not finite
ClassCertainty class_certainty(const std::string& scheme, const Axes& axes, double axis_error,
                               const SchemeOptions& options = {});

/// "S/L 0.698 is 0.002 from 0.7; C possible" or, for a class that survives, without the end.
std::string describe_certainty(const ClassCertainty& certainty);

}  // namespace clast
