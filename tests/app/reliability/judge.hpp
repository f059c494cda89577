#pragma once
/// Whether what a user is given of a damaged scan is right, honestly bracketed, refused, or
/// silently wrong. Knows the JSON of `clast reconstruct`, and nothing of its methods.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/app/reliability/bodies.hpp"
#include "tests/support/run_program.hpp"

namespace clast::reliability {

/// What volume and axes may be off to count as right, as shares of the true ones.
struct Tolerance {
  double volume = 0.01;
  std::array<double, 3> axes = {0.015, 0.015, 0.015};
};

/// An answer that is right.
struct Expected {
  Truth truth;
  Tolerance tolerance;
  /// Not empty: one of these words must stand in a warning. For scans with more than one answer.
  std::vector<std::string> said = {};
};

struct Range {
  double low = 0.0;
  double high = 0.0;  ///< infinite: said to be unknown
};

/// What the user is given.
struct Given {
  std::string refusal;  ///< not empty: there is no block
  std::string failure;  ///< not empty: crashed, hung, or failed otherwise
  double volume = 0.0;
  Axes axes;
  std::map<std::string, std::string> classes;  ///< by scheme
  std::optional<Range> volume_range;
  std::optional<std::array<Range, 3>> axes_range;
  std::map<std::string, std::vector<std::string>> possible_classes;
  std::vector<std::string> warnings;
};

/// Exit codes of `timeout` and of shells for what was killed.
Given given_by(const ProgramRun& run);

enum class Outcome { kRight, kBracketed, kRefused, kWrong };

struct Verdict {
  Outcome outcome = Outcome::kWrong;
  std::string why;              ///< of a wrong one: what is off and by how much; of a refusal: what
                                ///< was said
  std::optional<double> width;  ///< of a stated range of the volume over the true volume
  std::string missed;  ///< stated ranges that do not hold the truth, be the value right or not
};

/// Right: volume, L, I and S are each within the tolerance of the truth, and the classes are those
/// of the truth or of axes that are that near. Bracketed: those that are not lie within a range
/// that is stated, and the true class of each scheme is stated as possible. The best verdict over
/// the expected answers counts.
Verdict judge(const Given& given, const std::vector<Expected>& expected);

}  // namespace clast::reliability
