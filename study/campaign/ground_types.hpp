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

/// Ground type with typical contact parameters from publications (docs/parameters.md).
///
/// Energy restitution follows from the normal restitution of the matching soil type of Rockyfor3D
/// at 10 m/s. Friction coefficients are those of the most similar ground of Garcia et al. The
/// minimum friction of RAMMS::ROCKFALL is a lower limit for soils.
/// @cite garcia2022 (Table 2) @cite dorren2016 @cite ramms2015
struct GroundType {
  std::string name;                     ///< such as "talus"
  std::string description;              ///< appearance in the field
  TypicalValue energy_restitution;      ///< fraction of energy that an impact returns
  TypicalValue friction;                ///< friction coefficient
  TypicalValue rolling_friction;        ///< rolling friction coefficient
  std::string source;                   ///< publications from which the values are taken
  std::vector<std::string> names = {};  ///< words in names of ground zones that identify the type
};

/// Returns all ground types: rock, talus, scree, and hard, medium and soft soil.
std::span<const GroundType> typical_ground_types();

/// Returns the ground type of a name.
/// @throws InputError  if there is no such type; the message lists all types
const GroundType& ground_type(const std::string& name);

/// Finds the ground type that a zone name identifies; "upper_cliff", for example, is rock. Null if
/// no type or several types match.
const GroundType* find_ground_type(const std::string& zone);

/// Returns the ground type assumed for zones whose name identifies none. Its parameters are between
/// rock and soil.
const GroundType& default_ground_type();

}  // namespace clast
