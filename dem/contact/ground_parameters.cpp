#include "dem/contact/ground_parameters.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

void GroundParameters::check(const std::string& zone) const {
  const auto refuse = [&](const std::string& field, double value, const std::string& expected) {
    throw InputError("ground " + zone + ": " + field + " = " + format_significant(value, 6) +
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
    refuse("rolling_length", rolling_length, "0 m (no value) or more");
  }
  const auto not_negative = [&](const char* field, double value, const char* zero) {
    if (!(value >= 0.0 && std::isfinite(value))) {
      refuse(field, value, std::string("0 (") + zero + ") or more");
    }
  };
  not_negative("friction_min", friction_min, "no friction before sliding");
  not_negative("slip_growth", slip_growth, "friction is constant");
  not_negative("slip_memory", slip_memory, "slip has no memory");
  not_negative("scar_drag", scar_drag, "none");
  not_negative("soil_density", soil_density, "none stated");
  not_negative("soil_memory", soil_memory, "none");
  if (slip_growth > 0.0 && friction_min > friction) {
    refuse("friction_min", friction_min, "at most friction, " + format_significant(friction, 6));
  }
  if (!(slip_growth > 0.0) && (friction_min > 0.0 || slip_memory > 0.0)) {
    refuse("slip_growth", slip_growth, "above 0 if friction_min or slip_memory is given");
  }
  if ((scar_drag > 0.0) != (soil_density > 0.0)) {
    refuse(scar_drag > 0.0 ? "soil_density" : "scar_drag", 0.0,
           "above 0, since scar_drag and soil_density are used together");
  }
}

}  // namespace clast
