// The free flights of the paper's simulations, started from their first instant.
#include <gtest/gtest.h>

#include <map>

#include "core/angle.hpp"
#include "core/files/text_file.hpp"
#include "dem/motion/rigid_body.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

std::vector<ReferenceRow> read_reference_rows(const std::string& name) {
  std::istringstream lines(read_text_file(test_data(name)));
  std::vector<std::string> header;
  std::vector<ReferenceRow> rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::vector<std::string> fields;
    for (std::string cell; std::getline(cells, cell, ',');) fields.push_back(cell);
    if (header.empty()) {
      header = fields;
      continue;
    }
    ReferenceRow row;
    for (std::size_t i = 0; i < fields.size(); ++i) row[header[i]] = fields[i];
    rows.push_back(row);
  }
  return rows;
}

/// World axes y up there, z up here.
Vec3 z_up(const Vec3& v) { return {v.x(), -v.z(), v.y()}; }

RigidState state_of(const ReferenceRow& row) {
  const auto at = [&](const char* name) { return value(row, name); };
  RigidState state;
  state.position = z_up({at("x"), at("y"), at("z")});
  state.velocity = z_up({at("vx"), at("vy"), at("vz")});
  state.angular_velocity = z_up({at("wx"), at("wy"), at("wz")});
  const Quat turn(Eigen::AngleAxisd(kPi / 2.0, Vec3::UnitX()));
  state.orientation = turn * Quat(at("q0"), at("q1"), at("q2"), at("q3")).normalized();
  return state;
}

TEST(PublishedFlights, AreFollowed) {
  std::map<std::string, RigidBody> bodies;
  for (const ReferenceRow& row : read_reference_rows("garcia2022/table01_blocks.csv")) {
    RigidBody& body = bodies[row.at("block")];
    body.mass = 1.0;
    body.shape.vertices = {Vec3::Zero()};
    body.moments = {value(row, "Ix_kgm2"), value(row, "Iy_kgm2"), value(row, "Iz_kgm2")};
  }
  std::size_t compared = 0;
  double worst_spin = 0.0, worst_angle = 0.0, worst_height = 0.0;
  ReferenceRow first, last;
  for (const ReferenceRow& row : read_reference_rows("authume/sim/free_flight.csv")) {
    const bool goes_on = !last.empty() && last.at("segment") == row.at("segment") &&
                         value(row, "t") - value(last, "t") < 0.15;
    last = row;
    if (!goes_on) {
      first = row;
      continue;
    }
    const RigidState published = state_of(row);
    const RigidState flown = free_flight(bodies.at(row.at("block")), state_of(first),
                                         value(row, "t") - value(first, "t"), 9.81);
    const double spin = (flown.angular_velocity - published.angular_velocity).norm() /
                        published.angular_velocity.norm();
    const double angle = flown.orientation.angularDistance(published.orientation);
    const double height = std::abs(flown.position.z() - published.position.z());
    worst_spin = std::max(worst_spin, spin);
    worst_angle = std::max(worst_angle, angle);
    worst_height = std::max(worst_height, height);
    ++compared;
  }
  EXPECT_GT(compared, 200u);
  EXPECT_LT(worst_spin, 1e-3);
  EXPECT_LT(worst_angle, 0.1 * kRadiansPerDegree);
  EXPECT_LT(worst_height, 2e-3);
}

}  // namespace
}  // namespace clast
