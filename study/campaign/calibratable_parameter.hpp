#pragma once
/// Campaign parameters that can be calibrated.
#include <string>
#include <utility>
#include <vector>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

/// Unknown campaign parameter with a uniform prior on a range.
struct UnknownParameter {
  std::string parameter;  ///< name of the parameter, such as "ground.blue.friction"
  double low = 0.0;       ///< lower end of the range, in the unit of the parameter
  double high = 1.0;
  bool logarithmic = false;  ///< true if the prior is uniform in the logarithm of the value

  /// Returns the value of the parameter for a prior probability.
  /// @param probability  prior probability, in [0, 1]
  double prior_quantile(double probability) const;
  /// Returns the prior probability of values below `value`.
  double probability_below(double value) const;
};

/// Returns the names of all parameters that can be calibrated, with their allowed ranges. "ZONE"
/// and "CLASS" are placeholders for names of ground zones and shape classes.
std::vector<std::pair<std::string, NumberRange>> calibratable_parameters();
/// Returns the allowed range of a parameter that can be calibrated.
/// @throws InputError  if the parameter cannot be calibrated; the message lists those that can
NumberRange calibratable_range(const std::string& parameter);

/// True if a campaign has the parameter, for example the ground zone or shape class to which it
/// refers.
bool has_parameter(const Campaign& campaign, const std::string& parameter);
/// Returns the reason why a campaign lacks this parameter, such as "no campaign has this zone".
std::string explain_missing_parameter(const std::string& parameter);

/// Sets a parameter of a campaign, in all release sets and in all block groups without a value of
/// their own.
/// @param campaign  campaign that has the parameter
void set_parameter(Campaign& campaign, const std::string& parameter, double value);

/// True if the parameter affects the ground only, not starts and contacts between blocks.
bool is_ground_parameter(const std::string& parameter);
/// True if the parameter changes release positions or velocities.
bool is_release_parameter(const std::string& parameter);
/// True if the parameter changes the selection or the size of sampled blocks.
bool is_block_parameter(const std::string& parameter);
/// Returns the shape class whose fraction the parameter is; empty for other parameters.
std::string class_of_fraction_parameter(const std::string& parameter);

}  // namespace clast
