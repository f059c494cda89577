#pragma once
/// Published shape classification schemes.
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "core/number_range.hpp"

namespace clast {

/// Allowed range of `SchemeOptions::erdogan_limit`.
inline constexpr NumberRange kErdoganLimitRange{1.0001, 1e3};

/// Parameters that the authors of the schemes left open.
struct SchemeOptions {
  bool sneed_folk_thirds =
      false;  ///< true: limits of (L - I)/(L - S) are 1/3 and 2/3 instead of 0.33 and 0.67
  double erdogan_limit = 1.3;  ///< limit of L/I and I/S

  void check() const;  ///< throws InputError naming the field and its value
};

/// Returns one of the ten Sneed-Folk classes: C, CP, CB, CE, P, B, E, VP, VB, VE. @cite sneed1958
std::string sneed_folk_class(const Axes& axes, const SchemeOptions& options = {});
/// Returns "disc", "spheroid", "blade" or "rod", with limits of 2/3. @cite zingg1935
std::string zingg_class(const Axes& axes);
/// Returns "elongated" for s_c > 0.3, otherwise "compact". @cite garcia2022
std::string garcia_class(const Axes& axes);
/// Returns "oblate" for I^2 > L S, "prolate" for I^2 < L S, otherwise "neither".
/// @cite williams1965
std::string williams_class(const Axes& axes);
/// Returns "platy" if only L/I is below the limit, "elongated" if only I/S is, else "undetermined".
/// @cite erdogan2006
std::string erdogan_class(const Axes& axes, const SchemeOptions& options = {});
/// Returns one of 25 classes "..., ...", for elongation (by I/L) and flatness (by S/I). Steps of
/// 0.2 are "not" (0.8 and above), "slightly", "moderately", "very" and "extremely" (below 0.2).
/// @cite blott2008
std::string blott_pye_class(const Axes& axes);
/// Returns "non-cubical" for L/S > 3, otherwise "cubical" (shape index of aggregates).
/// @cite en933-4
std::string en_933_4_class(const Axes& axes);
/// Returns "flaky" for S < 0.625 I, otherwise "not flaky". This corresponds to a bar sieve of width
/// D/2 for grains with I of about 0.8 D.
/// @cite en933-3
std::string flakiness_class(const Axes& axes);

/// Returns all scheme names: "sneed-folk", "zingg", "garcia", "williams", "erdogan", "blott-pye",
/// "en-933-4", "flakiness".
const std::vector<std::string>& scheme_names();
/// Returns the class names of a scheme in table order.
/// @throws InputError  if the scheme is unknown; the message lists all schemes
const std::vector<std::string>& class_names(const std::string& scheme);
/// Returns the class of a block in a scheme.
/// @throws InputError  if the scheme is unknown
std::string shape_class(const std::string& scheme, const Axes& axes,
                        const SchemeOptions& options = {});

/// Axis ratio by which a scheme classifies blocks, with its class boundaries.
struct ClassifyingRatio {
  std::string name;
  double value = 0.0;
  std::vector<double> limits;  ///< ascending
};

/// Returns the ratios of given axes by which a scheme classifies them, with the limits at which the
/// class changes.
/// @throws InputError  if the scheme is unknown
std::vector<ClassifyingRatio> classifying_ratios(const std::string& scheme, const Axes& axes,
                                                 const SchemeOptions& options = {});

/// Class boundary: the points where constant + i_l (I/L) + s_l (S/L) + i_l_squared (I/L)^2 = 0.
struct ClassBoundary {
  double constant = 0.0;
  double i_l = 0.0;
  double s_l = 0.0;
  double i_l_squared = 0.0;
};

/// Returns all class boundaries of a scheme: lines, except for the parabola of Williams.
/// @throws InputError  if the scheme is unknown
std::vector<ClassBoundary> class_boundaries(const std::string& scheme,
                                            const SchemeOptions& options = {});

}  // namespace clast
