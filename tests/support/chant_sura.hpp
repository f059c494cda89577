#pragma once
/// Impacts of concrete blocks at Chant Sura, from the folder of real data. None of it is part of
/// the project. @cite caviezel2019
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "massprops/solid.hpp"
#include "shapes/convex_hull.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {

inline constexpr double kConcrete = 2650.0;  ///< kg/m^3, with steel

/// Of a file of the folder, whose texts may be quoted.
inline std::vector<ReferenceRow> chant_sura_rows(const std::string& name) {
  std::ifstream file(test_data("chant_sura/" + name));
  std::vector<std::string> heading;
  std::vector<ReferenceRow> rows;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::string cell;
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) {
        cells.push_back(std::exchange(cell, ""));
      } else if (c != '"' && c != '\r') {
        cell += c;
      }
    }
    cells.push_back(cell);
    if (heading.empty()) {
      heading = cells;
      continue;
    }
    ReferenceRow row;
    for (std::size_t i = 0; i < heading.size() && i < cells.size(); ++i) row[heading[i]] = cells[i];
    rows.push_back(row);
  }
  return rows;
}

inline Vec3 vector_in(const ReferenceRow& row, const std::string& prefix, const std::string& unit) {
  return {value(row, prefix + "x" + unit), value(row, prefix + "y" + unit),
          value(row, prefix + "z" + unit)};
}

/// A box of these sides with all edges and corners cut by the share `cut` of each side.
inline TriangleMesh cut_box(const Vec3& sides, double cut) {
  std::vector<Vec3> corners;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 p = (0.5 - cut) * sides;
      p[axis] = 0.5 * sides[axis];
      for (int k = 0; k < 3; ++k) p[k] *= (corner >> k & 1) ? 1.0 : -1.0;
      corners.push_back(p);
    }
  }
  return convex_hull(corners);
}

/// Of the blocks of 1 m^3, m.
inline Vec3 eota_sides(bool plate) {
  return plate ? Vec3(1.413631418, 1.413631418, 0.706815709) : Vec3(1.122, 1.122, 1.122);
}

/// EOTA block 221 ("plate") or 111 ("cube"): those of 1 m^3, scaled by mass.
inline TriangleMesh eota_mesh(double mass, bool plate) {
  const Vec3 of_cubic_metre = eota_sides(plate);
  double low = 0.0, high = 0.5;  // volume falls with the cut
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    const double volume = solid_mass_properties(cut_box(of_cubic_metre, middle), 1.0).volume;
    (volume > 1.0 ? low : high) = middle;
  }
  const double scale = std::cbrt(mass / kConcrete);
  return cut_box(scale * of_cubic_metre, low);
}

/// One of the impacts between two flights.
struct ThrownImpact {
  std::string name;
  double mass = 0.0;  ///< kg
  bool plate = false;
  Vec2 place = Vec2::Zero();             ///< of the centre, map, m
  Vec3 velocity = Vec3::Zero();          ///< before, m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< before, rad/s; not a number where it is not known
  double speed = 0.0;                    ///< after, m/s
  double spin = 0.0;                     ///< after, rad/s; not a number where it is not known
};

inline std::vector<ThrownImpact> observed_impacts() {
  const std::vector<ReferenceRow> path =
      chant_sura_rows("observed_trajectories_contact_extended.csv");
  const auto spin_at = [&](const std::string& segment, bool last) {
    Vec3 spin = Vec3::Zero();
    for (const ReferenceRow& row : path) {
      if (row.at("segment_id") != segment) continue;
      const bool known = !row.at("omega_x_radps").empty();
      spin = known ? vector_in(row, "omega_", "_radps") : Vec3::Constant(std::nan(""));
      if (!last) break;
    }
    return spin;
  };
  std::vector<ThrownImpact> impacts;
  for (const ReferenceRow& row : chant_sura_rows("observed_contact_events_extended.csv")) {
    ThrownImpact impact;
    impact.name = row.at("event_id");
    impact.mass = value(row, "mass_kg");
    impact.plate = row.at("trajectory_id").find('W') != std::string::npos;
    impact.place = {value(row, "x_m"), value(row, "y_m")};
    impact.velocity = vector_in(row, "incoming_v", "_mps");
    impact.angular_velocity = spin_at(row.at("source_segment_id"), true);
    impact.speed = vector_in(row, "outgoing_v", "_mps").norm();
    impact.spin = spin_at(row.at("next_segment_id"), false).norm();
    impacts.push_back(impact);
  }
  return impacts;
}

}  // namespace clast
