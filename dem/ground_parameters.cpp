#include "dem/ground_parameters.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

void GroundParameters::check(const std::string& zone) const {
  const auto refuse = [&](const std::string& field, double value, const std::string& expected) {
    throw InputError("ground " + zone + ": " + field + " = " + with_digits(value, 6) +
                     "; must be " + expected);
  };
  if (!(energy_restitution > 0.0 && energy_restitution <= 1.0)) {
    refuse("energy_restitution", energy_restitution, "above 0 and at most 1");
  }
  if (!(friction >= 0.0 && std::isfinite(friction))) refuse("friction", friction, "0 or more");
  if (!(rolling_friction >= 0.0 && std::isfinite(rolling_friction))) {
    refuse("rolling_friction", rolling_friction, "0 or more");
  }
  if (!(rolling_length >= 0.0 && std::isfinite(rolling_length))) {
    refuse("rolling_length", rolling_length, "0 m (none stated) or more");
  }
}

}  // namespace clast
