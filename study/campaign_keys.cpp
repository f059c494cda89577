#include "study/campaign_keys.hpp"

#include <stdexcept>

#include "study/ground_fields.hpp"

namespace clast {

namespace {

/// Of a ground zone, or of two blocks, which have no soil.
std::vector<std::string> ground_keys(bool with_soil) {
  std::vector<std::string> keys;
  for (const GroundField& field : ground_fields()) {
    if (with_soil || !field.of_soil) keys.emplace_back(field.name);
  }
  return keys;
}

}  // namespace

const std::vector<CampaignTable>& campaign_tables() {
  static const std::vector<CampaignTable> tables = {
      {"blocks", {"library", "select", "scale", "allow_any_size", "draw"}},
      {"block_group", {"name", "select", "ground"}},
      {"terrain",
       {"surface", "zones", "up", "radius_m", "resolution_m", "percentile", "outliers_m", "fill_m",
        "crack_m", "spike_steepness", "smoothing", "tolerance_m", "breaklines", "cut_zones",
        "border_distance_m"}},
      {"ground", ground_keys(true)},
      {"ensemble", {"members", "seed", "design", "posterior"}},
      {"release",
       {"name", "points", "orientations", "frame", "height_m", "velocity_m_s",
        "angular_velocity_rad_s", "seed", "sequence", "realisations", "order", "remove"}},
      {"mass", {"in_place", "height_m", "polygon", "thickness_m", "realisations", "seed"}},
      {"contact",
       {"law", "weights", "stiffness", "stiffness_n_m", "tangential_stiffness_n_m",
        "rolling_stiffness_n_m_rad", "time_step_s", "blocks"}},
      {"contact.blocks", ground_keys(false)},
      {"barrier", {"name", "from", "to", "through", "direction"}},
      {"run",
       {"max_time_s", "rest_energy_j_kg", "rest_duration_s", "gravity_m_s2", "downslope",
        "trajectory_interval_s"}}};
  return tables;
}

const std::vector<std::string>& campaign_keys(const std::string& table) {
  for (const CampaignTable& one : campaign_tables()) {
    if (one.name == table) return one.keys;
  }
  throw std::out_of_range("no campaign table " + table);
}

}  // namespace clast
