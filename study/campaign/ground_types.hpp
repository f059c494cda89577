#pragma once
/// Usual parameters of kinds of ground: something to start from where nothing was measured.
#include <span>
#include <string>
#include <vector>

namespace clast {

/// A number to start from, and between which limits to vary it.
struct TypicalValue {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// A kind of ground with what is published about it. How each number was found, and how far it can
/// be trusted: docs/parameters.md.
///
/// e_n^2 is (R_n / (1 + (v / 9 m/s)^2))^2 at v = 10 m/s, with R_n of the soil type that Rockyfor3D
/// has for this ground; from 0.01, which fitted the drop tests of Garcia et al. on every ground, to
/// R_n^2, for slow impacts. mu and mu_R are those of the ground of Garcia et al. that is most like
/// it. Friction of RAMMS::ROCKFALL grows while a block slides, so only its smallest value is taken,
/// as a lower limit of soils. @cite garcia2022 (Table 2) @cite dorren2016 @cite ramms2015
struct GroundType {
  std::string name;                     ///< "talus"
  std::string description;              ///< what it looks like
  TypicalValue energy_restitution;        ///< e_n^2
  TypicalValue friction;                  ///< mu
  TypicalValue rolling_friction;          ///< mu_R
  std::string source;                   ///< where mu and mu_R come from, and R_n
  std::vector<std::string> names = {};  ///< of zones: words, lower case, singular
};

/// Rock, talus, scree, and hard, medium and soft soil.
std::span<const GroundType> typical_ground_types();

/// @throws InputError  no such type; the message lists them
const GroundType& ground_type(const std::string& name);

/// The type that the name of a zone speaks of, whatever else is in it: "upper_cliff" is rock. None
/// where it says nothing ("blue"), or names two types.
const GroundType* find_ground_type(const std::string& zone);

/// What a zone is taken for whose name says nothing: between rock and soil.
const GroundType& default_ground_type();

}  // namespace clast
