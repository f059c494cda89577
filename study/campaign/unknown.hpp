#pragma once
/// Parameters of a campaign that a calibration finds.
#include <string>
#include <utility>
#include <vector>

#include "core/number_range.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

/// A number of campaigns that is not known but for its range, in which every value is as likely as
/// any other beforehand.
struct Unknown {
  std::string parameter;  ///< its place in a campaign: "ground.blue.friction", "release.height_m"
  double low = 0.0;       ///< in the unit of the parameter's name
  double high = 1.0;
  bool logarithmic = false;  ///< it is the logarithm of which every value is as likely

  /// The value that the share `below` of the range lies below.
  /// @param below  in [0, 1]
  double value(double below) const;
  /// The share of the range that lies below `value`.
  double share_below(double value) const;
};

/// All that can be calibrated, by name, with the range that campaigns allow; "ZONE" stands for the
/// name of a ground zone, "CLASS" for that of a shape class.
std::vector<std::pair<std::string, NumberRange>> calibratable_parameters();
/// @throws InputError  no parameter that can be calibrated; lists those that can
NumberRange parameter_range(const std::string& parameter);

/// Does the campaign have this parameter: the zone, a contact, a start with a height, blocks that
/// are drawn by such a law or class?
bool has_parameter(const Campaign& campaign, const std::string& parameter);
/// Why a campaign has not: "no campaign has this zone".
std::string explain_missing_parameter(const std::string& parameter);

/// Gives the parameter this value, in all block groups that do not have one of their own and in all
/// release sets. The order in which several are set does not matter: shares of classes are settled
/// when blocks are drawn (`class_fractions`).
/// @param campaign  that has it
void set_parameter(Campaign& campaign, const std::string& parameter, double value);

/// Does it shape the ground alone, so that starts and contacts stay as they are planned?
bool is_ground_parameter(const std::string& parameter);
/// Does it change where or how blocks start?
bool is_of_release(const std::string& parameter);
/// Does it change which blocks are drawn, or how large?
bool is_block_parameter(const std::string& parameter);
/// The shape class whose share it is; empty: it is no share.
std::string fraction_class(const std::string& parameter);

}  // namespace clast
