#include "study/campaign/calibratable_parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "classify/schemes.hpp"
#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast {

using namespace study_detail;
namespace {

constexpr const char* kGround = "ground.";
constexpr const char* kSharePrefix = "blocks.share.";

/// A parameter that is not of a zone or class.
struct Settable {
  const char* name;
  NumberRange range;
  void (*set)(Campaign& campaign, double value);
  /// Null: every campaign has it.
  bool (*has)(const Campaign& campaign) = nullptr;
  const char* why_not = "";  ///< no campaign has it
};

template <class Set>
void in_releases(Campaign& campaign, const Set& set) {
  for (ReleaseSet& release : campaign.releases) set(release);
}

template <int axis>
void set_velocity(Campaign& campaign, double value) {
  in_releases(campaign, [&](ReleaseSet& release) { release.velocity[axis] = value; });
}
template <int axis>
void set_spin(Campaign& campaign, double value) {
  in_releases(campaign, [&](ReleaseSet& release) { release.angular_velocity[axis] = value; });
}

bool has_height(const Campaign& campaign) {
  return std::all_of(campaign.releases.begin(), campaign.releases.end(),
                     [](const ReleaseSet& release) { return release.drop_height.has_value(); });
}

/// True if the masses of drawn blocks have this law.
template <Distribution::Law law>
bool has_mass(const Campaign& campaign) {
  const std::optional<BlockSampling>& draw = campaign.blocks.draw;
  return draw && draw->mass && draw->mass->law == law;
}
template <double Distribution::*number>
void set_mass(Campaign& campaign, double value) {
  (*campaign.blocks.draw->mass).*number = value;
}

std::span<const Settable> settables() {
  using Law = Distribution::Law;
  static constexpr NumberRange kSpeed{-kMaxInitialSpeed, kMaxInitialSpeed, "m/s"};
  static constexpr NumberRange kSpin{-kMaxInitialSpin, kMaxInitialSpin, "rad/s"};
  static constexpr const char* kLogNormal =
      "no campaign has [blocks] draw with mass_kg = { log_normal = [median, sigma] }";
  static constexpr const char* kNormal =
      "no campaign has [blocks] draw with mass_kg = { normal = [mean, std] }";
  static constexpr std::array<Settable, 15> kSettables{
      {{"blocks.mass_kg", kBlockMassRange, &set_mass<&Distribution::first>, &has_mass<Law::kFixed>,
        "no campaign has [blocks] draw with a number as mass_kg"},
       {"blocks.mass_median_kg", kBlockMassRange, &set_mass<&Distribution::first>,
        &has_mass<Law::kLogNormal>, kLogNormal},
       {"blocks.mass_sigma", kLogSigmaRange, &set_mass<&Distribution::second>,
        &has_mass<Law::kLogNormal>, kLogNormal},
       {"blocks.mass_mean_kg", kBlockMassRange, &set_mass<&Distribution::first>,
        &has_mass<Law::kNormal>, kNormal},
       {"blocks.mass_std_kg", kBlockMassRange, &set_mass<&Distribution::second>,
        &has_mass<Law::kNormal>, kNormal},
       {"contact.stiffness_n_m", kStiffnessRange,
        [](Campaign& campaign, double value) { campaign.stiffness.normal = value; }},
       {"contact.tangential_stiffness_n_m", kStiffnessRange,
        [](Campaign& campaign, double value) { campaign.stiffness.tangential = value; }},
       {"contact.rolling_stiffness_n_m_rad", kRollingStiffnessRange,
        [](Campaign& campaign, double value) { campaign.stiffness.rolling = value; }},
       {"release.height_m", kDropHeightRange,
        [](Campaign& campaign, double value) {
          in_releases(campaign, [&](ReleaseSet& release) { release.drop_height = value; });
        },
        &has_height, "no campaign releases blocks at a height_m"},
       {"release.velocity_x_m_s", kSpeed, &set_velocity<0>},
       {"release.velocity_y_m_s", kSpeed, &set_velocity<1>},
       {"release.velocity_z_m_s", kSpeed, &set_velocity<2>},
       {"release.spin_x_rad_s", kSpin, &set_spin<0>},
       {"release.spin_y_rad_s", kSpin, &set_spin<1>},
       {"release.spin_z_rad_s", kSpin, &set_spin<2>}}};
  return kSettables;
}

const Settable* settable(const std::string& parameter) {
  for (const Settable& one : settables()) {
    if (parameter == one.name) return &one;
  }
  return nullptr;
}

/// "ground.ZONE.FIELD", where zones may have points in their names; null: no such field.
struct ZoneField {
  std::string zone;
  const GroundParameterField* field = nullptr;
};

ZoneField zone_field(const std::string& parameter) {
  ZoneField found;
  const std::size_t point = parameter.rfind('.');
  const std::size_t begin = std::string(kGround).size();
  if (!parameter.starts_with(kGround) || point <= begin) return found;
  found.zone = parameter.substr(begin, point - begin);
  for (const GroundParameterField& field : ground_parameter_fields()) {
    if (parameter.substr(point + 1) == field.name) found.field = &field;
  }
  return found;
}

}  // namespace

double UnknownParameter::prior_quantile(double probability) const {
  if (!logarithmic) return low + (high - low) * probability;
  return low * std::pow(high / low, probability);
}

double UnknownParameter::probability_below(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return std::log(value / low) / std::log(high / low);
}

std::vector<std::pair<std::string, NumberRange>> calibratable_parameters() {
  std::vector<std::pair<std::string, NumberRange>> all;
  for (const GroundParameterField& field : ground_parameter_fields()) {
    all.push_back({kGround + std::string("ZONE.") + field.name, field.range});
  }
  all.push_back({kSharePrefix + std::string("CLASS"), kClassFractionRange});
  for (const Settable& one : settables()) all.push_back({one.name, one.range});
  return all;
}

NumberRange calibratable_range(const std::string& parameter) {
  if (const Settable* found = settable(parameter)) return found->range;
  if (const GroundParameterField* field = zone_field(parameter).field) return field->range;
  if (!class_of_fraction_parameter(parameter).empty()) return kClassFractionRange;
  std::vector<std::string> names;
  if (parameter.starts_with(kSharePrefix)) {
    for (const std::string& scheme : kSelectingSchemes) {
      const std::vector<std::string>& of_scheme = class_names(scheme);
      names.insert(names.end(), of_scheme.begin(), of_scheme.end());
    }
    throw InputError("is not the fraction of a class; classes are " + comma_separated(names));
  }
  for (const auto& [name, range] : calibratable_parameters()) names.push_back(name);
  throw InputError("is not a parameter that can be calibrated; these are " +
                   comma_separated(names));
}

bool has_parameter(const Campaign& campaign, const std::string& parameter) {
  if (const ZoneField of_zone = zone_field(parameter); of_zone.field) {
    return campaign.ground.contains(of_zone.zone);
  }
  if (const std::string name = class_of_fraction_parameter(parameter); !name.empty()) {
    const std::optional<BlockSampling>& draw = campaign.blocks.draw;
    return draw && std::any_of(draw->shares.begin(), draw->shares.end(),
                               [&](const auto& share) { return share.first == name; });
  }
  const Settable* found = settable(parameter);
  return found && (!found->has || found->has(campaign));
}

std::string explain_missing_parameter(const std::string& parameter) {
  if (!class_of_fraction_parameter(parameter).empty()) {
    return "no campaign has [blocks] draw with this class in shares";
  }
  const Settable* found = settable(parameter);
  return found ? found->why_not : "no campaign has this zone";
}

void set_parameter(Campaign& campaign, const std::string& parameter, double value) {
  if (const ZoneField of_zone = zone_field(parameter); of_zone.field) {
    Distribution number;
    number.first = value;
    campaign.ground.at(of_zone.zone).*of_zone.field->distribution = number;
    return;
  }
  if (const std::string name = class_of_fraction_parameter(parameter); !name.empty()) {
    campaign.blocks.draw->set_shares[name] = value;
    return;
  }
  if (const Settable* found = settable(parameter)) found->set(campaign, value);
}

bool is_ground_parameter(const std::string& parameter) {
  return zone_field(parameter).field != nullptr;
}

bool is_release_parameter(const std::string& parameter) {
  return parameter.starts_with("release.") && settable(parameter);
}

bool is_block_parameter(const std::string& parameter) {
  return !class_of_fraction_parameter(parameter).empty() ||
         (parameter.starts_with("blocks.") && settable(parameter));
}

std::string class_of_fraction_parameter(const std::string& parameter) {
  if (!parameter.starts_with(kSharePrefix)) return "";
  const std::string name = parameter.substr(std::string(kSharePrefix).size());
  for (const std::string& scheme : kSelectingSchemes) {
    const std::vector<std::string>& classes = class_names(scheme);
    if (std::find(classes.begin(), classes.end(), name) != classes.end()) return name;
  }
  return "";
}

}  // namespace clast
