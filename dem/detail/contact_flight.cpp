// How far or how long no contact can come: what lets a block fly on at once.
#include <algorithm>
#include <cmath>

#include "dem/detail/contact_search.hpp"
#include "dem/detail/flying_ball.hpp"
#include "dem/detail/free_flight.hpp"

namespace clast::dem_detail {
namespace {

/// The flight of the ball around the block is enough when it is this many times what is worthwhile:
/// less than what a closer search costs.
constexpr double kBallSteps = 16.0;
constexpr double kLongestFlight = 60.0;  ///< s
/// The search for a longer flight starts at the first of these numbers of margins and goes on in
/// strides.
constexpr double kFirstLook = 0.125, kLastLook = 8.0, kStride = 4.0;

double distance_in(double time, double speed, double acceleration) {
  return time * (speed + 0.5 * acceleration * time);
}

}  // namespace

double ContactSearch::safe_travel() {
  if (!contacts_.empty() || moved_ < search_at_) return travel_;
  // At a speed of 1 the time is the distance.
  const double first = kFirstLook * margin_;
  const double distance = search_time({.acceleration = 1e300, .top_speed = 1.0}, first);
  if (distance < first) search_at_ = moved_ + 0.5 * distance;
  return travel_ + distance;
}

double ContactSearch::safe_time(const FlightBounds& flight, double worthwhile) {
  if (!contacts_.empty() || moved_ < search_at_) return 0.0;
  const double ball = clear_time(ground_.grid,
                                 {.centre = tests_.position(),
                                  .velocity = flight.velocity,
                                  .gravity = flight.gravity,
                                  .radius = bounding_radius_ + reach_},
                                 kLongestFlight);
  if (ball >= kBallSteps * worthwhile) return ball;
  const double time = std::max(ball, search_time(flight, worthwhile));
  if (time < worthwhile) search_at_ = moved_ + 0.5 * time * flight.top_speed;
  return time;
}

double ContactSearch::search_time(const FlightBounds& flight, double first) {
  // Measuring what could touch first, and only that, gives how long the block can fly; each stride
  // is made only when the one before was clear.
  double wanted = first;
  while (true) {
    double time = wanted;
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      time = std::min(time, part_time(p, flight, wanted));
    }
    if (time < wanted ||
        distance_in(wanted, flight.top_speed, flight.gravity) >= kLastLook * margin_) {
      return time;
    }
    wanted *= kStride;
  }
}

double ContactSearch::part_time(std::uint32_t p, const FlightBounds& flight, double wanted) {
  const BlockPart& of_block = parts_.parts[p];
  PartState& part = part_states_[p];
  const Vec3 velocity = flight.velocity + flight.spin.cross(tests_.rotation() * of_block.centre);
  const double turning = flight.spin.norm() * of_block.radius;
  // By the speed that points of the part have now, or the top speed: the shorter way.
  const auto way_in = [&](double time, double speed) {
    return std::min(distance_in(time, speed + turning, flight.acceleration),
                    distance_in(time, flight.top_speed, flight.gravity));
  };
  const auto time_for = [&](double left, double per_across, double per_along, double speed) {
    const double per_whole = per_across + per_along;
    return std::max(time_over(left, speed + per_whole * turning, per_whole * flight.acceleration),
                    time_over(left, per_whole * flight.top_speed, per_whole * flight.gravity));
  };
  const double speed = velocity.norm(), whole = way_in(wanted, speed);
  if (part.near) {
    read_way(p);
    renew_ground(p, whole);
  } else if (part_due_[p] < moved_ + whole) {
    update_part(p, moved_ + whole);
  }
  if (!part.near) {
    const double gap = part_due_[p] - moved_;
    return gap >= whole ? wanted : time_for(gap, 0.0, 1.0, speed);
  }
  const double across = std::min(std::abs(velocity.dot(part.axis)), speed);
  const double along = std::sqrt(speed * speed - across * across);
  const Way ahead{way_in(wanted, across), way_in(wanted, along), whole};
  update_vertices(p, ahead);
  update_sides(p, ahead);
  part_due_[p] = next_visit(p);
  if (!part.due_vertices.empty()) return 0.0;
  const Way then = part.way + ahead;
  double time = wanted;
  if (list_end(part) < then.whole) {
    time = time_for(list_end(part) - part.way.whole, 0.0, 1.0, speed);
  }
  for (const Asleep& asleep : {part.other_vertices, part.all_features, part.all_pairs}) {
    if (!asleep.due(then)) continue;
    time = std::min(time, time_for(asleep.left(part.way), asleep.per_across, asleep.per_along,
                                   asleep.per_across * across + asleep.per_along * along));
  }
  return time;
}

}  // namespace clast::dem_detail
