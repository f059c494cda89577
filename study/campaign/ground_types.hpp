#pragma once
/// Typical parameters of ground types, for sites without measurements.
#include <span>
#include <string>
#include <vector>

namespace clast {

struct TypicalValue {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Ground type with published parameters. docs/parameters.md explains the derivation and
/// reliability of each value.
///
/// e_n^2 is (R_n / (1 + (v / 9 m/s)^2))^2 at v = 10 m/s, where R_n is that of the matching soil
/// type of Rockyfor3D. Its range is from 0.01, which fitted the drop tests of Garcia et al. on all
/// ground types, to R_n^2 for slow impacts. mu and mu_R are those of the most similar ground of
/// Garcia et al. The minimum friction of RAMMS::ROCKFALL is a lower limit of mu for soils.
/// @cite garcia2022 (Table 2) @cite dorren2016 @cite ramms2015
struct GroundType {
  std::string name;                     ///< such as "talus"
  std::string description;              ///< appearance in the field
  TypicalValue energy_restitution;      ///< e_n^2
  TypicalValue friction;                ///< mu
  TypicalValue rolling_friction;        ///< mu_R
  std::string source;                   ///< sources of mu, mu_R and R_n
  std::vector<std::string> names = {};  ///< words in zone names, lower case, singular
};

/// Returns all types: rock, talus, scree, and hard, medium and soft soil.
std::span<const GroundType> typical_ground_types();

/// Returns the type of that name.
/// @throws InputError  if there is no such type; the message lists all types
const GroundType& ground_type(const std::string& name);

/// Finds the type whose name occurs in a zone name; "upper_cliff", for example, is rock. Null if no
/// type ("blue") or more than one type matches.
const GroundType* find_ground_type(const std::string& zone);

/// Returns the type assumed for zones with other names. Its parameters are between rock and soil.
const GroundType& default_ground_type();

}  // namespace clast
