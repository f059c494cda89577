#include "dem/simulation/motion_settings.hpp"

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

void MotionSettings::check() const {
  const auto require = [](bool fine, const char* field, double value, const char* range) {
    if (fine && std::isfinite(value)) return;
    throw InputError(std::string(field) + " = " + format_significant(value, 6) + "; must be " +
                     range);
  };
  const auto positive = [&](const char* field, double value) {
    require(value > 0.0, field, value, "above 0");
  };
  positive("normal stiffness", stiffness.normal);
  positive("tangential stiffness", stiffness.tangential);
  positive("rolling stiffness", stiffness.rolling);
  positive("time step", stiffness.time_step);
  positive("rest_energy", rest_energy);
  positive("rest_duration", rest_duration);
  require(gravity >= 0.0, "gravity", gravity, "0 or more");
  require(start_overlap >= 0.0, "start_overlap", start_overlap, "0 or more");
}

void check_zone_parameters(const TerrainSurface& terrain, std::span<const GroundParameters> zones) {
  if (zones.size() >= terrain.zone_count()) return;
  throw SimulationError("terrain has " + std::to_string(terrain.zone_count()) +
                        " ground zones but parameters are given for " +
                        std::to_string(zones.size()) + "; give them for each zone");
}

void check_start_position(const TerrainSurface& terrain, const Vec3& position,
                          const std::string& name) {
  if (!terrain.covers(position.x(), position.y())) {
    throw SimulationError(name + " starts at (" + format_significant(position.x(), 9) + ", " +
                          format_significant(position.y(), 9) +
                          "), which is not on the terrain; move it onto the ground");
  }
  const std::optional<double> ground = terrain.height_at(position.x(), position.y(), position.z());
  if (ground && position.z() < *ground) {
    throw SimulationError(name + " starts below the ground, " +
                          format_significant(*ground - position.z(), 6) + " m deep; raise it");
  }
}

}  // namespace clast
