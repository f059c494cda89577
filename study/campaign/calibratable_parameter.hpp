#pragma once
/// Campaign parameters that can be calibrated.
#include <string>
#include <utility>
#include <vector>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

/// Unknown parameter with a uniform prior on a range.
struct UnknownParameter {
  std::string
      parameter;     ///< path in a campaign, such as "ground.blue.friction" or "release.height_m"
  double low = 0.0;  ///< lower end of the range, in the unit of the parameter name
  double high = 1.0;
  bool logarithmic = false;  ///< true if the prior is uniform in the logarithm of the value

  /// Returns the quantile of the prior.
  /// @param below  probability in [0, 1]
  double prior_quantile(double probability) const;
  /// Returns the prior probability of values below `value`.
  double probability_below(double value) const;
};

/// Returns all parameters that can be calibrated, with their allowed range. "ZONE" and "CLASS" are
/// placeholders for the names of ground zones and shape classes.
std::vector<std::pair<std::string, NumberRange>> calibratable_parameters();
/// Returns the allowed range of a parameter.
/// @throws InputError  if the parameter cannot be calibrated; the message lists those that can
NumberRange calibratable_range(const std::string& parameter);

/// True if the campaign has this parameter. It must have the zone, block contacts, release height,
/// mass distribution or shape class to which the parameter refers.
bool has_parameter(const Campaign& campaign, const std::string& parameter);
/// Returns the reason why a campaign lacks this parameter, such as "no campaign has this zone".
std::string explain_missing_parameter(const std::string& parameter);

/// Sets a parameter in all release sets, and in all block groups that have no value of their own.
/// The order of several calls has no influence.
/// @param campaign  must have the parameter
void set_parameter(Campaign& campaign, const std::string& parameter, double value);

/// True if the parameter affects the ground only, not starts and contacts between blocks.
bool is_ground_parameter(const std::string& parameter);
/// True if the parameter changes release positions or velocities.
bool is_release_parameter(const std::string& parameter);
/// True if the parameter changes the selection or the size of sampled blocks.
bool is_block_parameter(const std::string& parameter);
/// Returns the shape class if the parameter is a class fraction; otherwise empty.
std::string class_of_fraction_parameter(const std::string& parameter);

}  // namespace clast
