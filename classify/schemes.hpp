#pragma once
/// Published shape classes.
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "core/number_range.hpp"

namespace clast {

/// What `SchemeOptions::erdogan_limit` may be.
inline constexpr NumberRange kErdoganLimit{1.0001, 1e3};

/// What the authors of the schemes left open.
struct SchemeOptions {
  bool sneed_folk_thirds = false;  ///< limits 1/3 and 2/3 of (L - I)/(L - S), not 0.33 and 0.67
  double erdogan_limit = 1.3;      ///< of L/I and I/S

  void check() const;  ///< throws InputError naming the field and its value
};

/// The ten classes of Sneed & Folk: C, CP, CB, CE, P, B, E, VP, VB, VE. @cite sneed1958
std::string sneed_folk_class(const Axes& axes, const SchemeOptions& options = {});
/// "disc", "spheroid", "blade" or "rod", with limits of 2/3. @cite zingg1935
std::string zingg_class(const Axes& axes);
/// "elongated" for s_c > 0.3, else "compact". @cite garcia2022
std::string garcia_class(const Axes& axes);
/// "oblate" for I^2 > L S, "prolate" for I^2 < L S, "neither" on the line between them.
/// @cite williams1965
std::string williams_class(const Axes& axes);
/// "platy": L/I below the limit, I/S not; "elongated": L/I not below, I/S below; else
/// "undetermined". @cite erdogan2006
std::string erdogan_class(const Axes& axes, const SchemeOptions& options = {});
/// 25 classes "..., ...": how elongate by I/L and how flat by S/I, each in steps of 0.2 from "not"
/// (0.8 and above) over "slightly", "moderately" and "very" to "extremely" (below 0.2).
/// @cite blott2008
std::string blott_pye_class(const Axes& axes);
/// "non-cubical" for L/S > 3, else "cubical": what the shape index of aggregates counts.
/// @cite en933-4
std::string en_933_4_class(const Axes& axes);
/// "flaky" for S < 0.625 I, else "not flaky": the bar sieve of width D/2 for grains whose I is
/// about 0.8 D. @cite en933-3
std::string flakiness_class(const Axes& axes);

/// "sneed-folk", "zingg", "garcia", "williams", "erdogan", "blott-pye", "en-933-4", "flakiness".
const std::vector<std::string>& scheme_names();
/// Class names of a scheme in the order they are listed in tables.
/// @throws InputError  unknown scheme; the message lists the known ones
const std::vector<std::string>& class_names(const std::string& scheme);
/// @throws InputError  unknown scheme
std::string shape_class(const std::string& scheme, const Axes& axes,
                        const SchemeOptions& options = {});

/// A ratio that the class depends on, and the values at which the class changes.
struct SchemeRatio {
  std::string name;
  double value = 0.0;
  std::vector<double> limits;  ///< ascending
};

/// The ratios that a scheme uses for these axes; crossing any limit that is next to the value
/// changes the class.
/// @throws InputError  unknown scheme
std::vector<SchemeRatio> scheme_ratios(const std::string& scheme, const Axes& axes,
                                       const SchemeOptions& options = {});

/// The values of I/L and S/L where one + I/L i + S/L s + (I/L)^2 ii is zero: on one side of it the
/// scheme may give another class than on the other.
struct SchemeLimit {
  double constant = 0.0;
  double i_l = 0.0;
  double s_l = 0.0;
  double i_l_squared = 0.0;
};

/// All limits of the scheme; between them the class is the same. Straight lines, but for Williams'
/// parabola, which is the only limit of its scheme.
/// @throws InputError  unknown scheme
std::vector<SchemeLimit> scheme_limits(const std::string& scheme,
                                       const SchemeOptions& options = {});

}  // namespace clast
