#pragma once
/// Campaign parameters that can be calibrated.
#include <string>
#include <utility>
#include <vector>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

/// Unknown parameter with a uniform prior on a range.
struct Unknown {
  std::string parameter;  ///< path in a campaign: "ground.blue.friction", "release.height_m"
  double low = 0.0;       ///< in the unit of the parameter name
  double high = 1.0;
  bool logarithmic = false;  ///< the prior is uniform in the logarithm

  /// Returns the prior quantile of a probability.
  /// @param below  probability in [0, 1]
  double value(double below) const;
  /// Returns the prior probability of values below `value`.
  double probability_below(double value) const;
};

/// Returns all parameters that can be calibrated, with their allowed range; "ZONE" and "CLASS"
/// stand for the names of ground zones and shape classes.
std::vector<std::pair<std::string, NumberRange>> calibratable_parameters();
/// Returns the allowed range of a parameter.
/// @throws InputError  if it cannot be calibrated; the message lists those that can
NumberRange parameter_range(const std::string& parameter);

/// True if the campaign has this parameter: its zone, a contact, a release height, or a matching
/// sampling law or class.
bool has_parameter(const Campaign& campaign, const std::string& parameter);
/// Returns why no campaign has this parameter: "no campaign has this zone".
std::string explain_missing_parameter(const std::string& parameter);

/// Sets a parameter in all block groups without a value of their own and in all release sets. The
/// order of several calls does not matter: class fractions are resolved when blocks are sampled
/// (`class_fractions`).
/// @param campaign  must have the parameter
void set_parameter(Campaign& campaign, const std::string& parameter, double value);

/// True if the parameter affects the ground only, so that starts and contacts stay as planned.
bool is_ground_parameter(const std::string& parameter);
/// True if the parameter changes release positions or velocities.
bool is_of_release(const std::string& parameter);
/// True if the parameter changes which blocks are sampled, or their size.
bool is_block_parameter(const std::string& parameter);
/// Returns the shape class if the parameter is a class fraction; otherwise empty.
std::string fraction_class(const std::string& parameter);

}  // namespace clast
