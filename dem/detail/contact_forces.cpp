#include "dem/detail/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clast::dem_detail {
namespace {

/// A contact that vanishes and one that appears are the same contact, carried over to another
/// feature, when they are closer than this share of the block's smallest side ...
constexpr double kHandOverShare = 0.03;
/// ... and their normals are within 45 degrees.
constexpr double kHandOverCosine = 0.7071067811865476;
/// Normals whose cosine is above this are those of one plane.
constexpr double kSameNormal = 1.0 - 1e-12;
/// A new contact's closing speed explains its overlap when it leaves no more than this share of it.
constexpr double kExplained = 1e-6;

/// A vector perpendicular to `before` turned to be perpendicular to `normal`, as long as it was.
Vec3 turned_into_plane(const Vec3& vector, const Vec3& before, const Vec3& normal) {
  if (normal == before) return vector;
  const double length = vector.norm();
  const Vec3 flat = vector - vector.dot(normal) * normal;
  const double flat_length = flat.norm();
  return flat_length > 1e-300 ? Vec3(flat * (length / flat_length)) : Vec3(Vec3::Zero());
}

void limit(Vec3& vector, double largest) {
  const double squared = vector.squaredNorm();
  if (squared > largest * largest) vector *= largest / std::sqrt(squared);
}

}  // namespace

ContactForces::ContactForces(std::span<const GroundParameters> zones,
                             std::span<const std::uint16_t> zone_of_face, const BlockSurface& block,
                             double size, const ContactStiffness& stiffness, ContactWeights weights,
                             const ContactLaw& law)
    : zones_(zones),
      zone_of_face_(zone_of_face),
      patches_(block, weights),
      stiffness_(stiffness),
      tangential_give_(1.0 / stiffness.tangential),
      rolling_give_(1.0 / stiffness.rolling),
      near_(kHandOverShare * size) {
  std::visit(
      [&]<class Law>(const Law&) {
        ByZone<Law> by_zone;
        for (const GroundParameters& zone : zones) {
          by_zone.laws.push_back(Law::of(stiffness.normal, zone));
        }
        laws_ = std::move(by_zone);
      },
      law);
}

ContactLoad ContactForces::update(const std::vector<ContactPoint>& points, const BodyMotion& block,
                                  const BodyMotion& other, double duration, EnergyLedger& ledger) {
  if (points.empty() && contacts_.empty()) return {};
  return std::visit(
      [&](const auto& by_zone) {
        return updated(by_zone.laws, points, block, other, duration, ledger);
      },
      laws_);
}

template <class Law>
ContactLoad ContactForces::updated(const std::vector<Law>& laws,
                                   const std::vector<ContactPoint>& points, const BodyMotion& block,
                                   const BodyMotion& other, double duration, EnergyLedger& ledger) {
  ContactLoad load;
  const double k_t = stiffness_.tangential, k_r = stiffness_.rolling;
  const Vec3 spin = block.angular_velocity - other.angular_velocity;
  const bool other_moves = other.moves();
  const auto mean_velocity = [&](const Vec3& place) {
    return other_moves ? Vec3(block.velocity_at(place) - other.velocity_at(place))
                       : block.velocity_at(place);
  };
  const auto mean_velocity_from = [&](const Vec3& place) {
    return other_moves ? Vec3(block.velocity_from(place) - other.velocity_from(place))
                       : block.velocity_from(place);
  };
  const auto begin_velocity = [&](const Vec3& place) {
    return other_moves ? Vec3(block.begin_velocity_at(place) - other.begin_velocity_at(place))
                       : block.begin_velocity_at(place);
  };
  const auto take_event = [&](const NormalResponse& response, double weight, const Vec3& normal,
                              const Vec3& place) {
    if (response.impulse == 0.0 && response.moment == 0.0) return;
    if (!load.event) load.event.emplace();
    EventLoad& event = *load.event;
    const Vec3 arm = place - block.world_from_body.translation;
    const Vec3 arm_of_other = place - other.world_from_body.translation;
    const Vec3 impulse = weight * response.impulse * normal;
    event.impulse += impulse;
    event.angular_impulse += arm.cross(impulse);
    event.angular_impulse_on_other -= arm_of_other.cross(impulse);
    // Shifting two moving bodies would change their angular momentum about each other.
    if (other.inverse_mass > 0.0) return;
    const Vec3 moment = weight * response.moment * normal;
    event.moment += moment;
    event.angular_moment += arm.cross(moment);
  };

  match(points);
  const std::span<const double> weights = patches_.share(points, block.world_from_body.rotation);
  std::vector<Contact>& now = now_;
  now.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    now.emplace_back(points[i], zone_of_face_.empty() ? 0 : zone_of_face_[points[i].ground_face],
                     weights[i]);
  }
  hand_on_springs();
  if constexpr (Law::kNeedsEffectiveMass) find_effective_masses(block, other);

  for (std::size_t i = 0; i < now.size(); ++i) {
    Contact& contact = now[i];
    const Law& law = laws[contact.zone];
    const GroundParameters& ground = zones_[contact.zone];
    const Vec3& n = contact.point.normal;
    const double overlap = contact.point.overlap;
    const double w = contact.weight;
    const double mass = contact.effective_mass;
    const Vec3 arm = contact.place - block.world_from_body.translation;
    const Vec3 moving = mean_velocity(contact.place);
    const double closing = -moving.dot(n);
    const Vec3 sliding = moving + closing * n;

    // Where it was a step ago, what it held then, and the power it took at the begin of the step.
    OverlapPath path{duration, 0.0, overlap, 0.0};
    double normal_before = 0.0, stored_before = 0.0, power_before = 0.0, weight_before = w;
    const Vec3 tangential_before = contact.tangential, rolling_before = contact.rolling;
    bool continuous = true;
    if (previous_of_[i] >= 0) {
      const Contact& previous = contacts_[previous_of_[i]];
      path.before = previous.point.overlap;
      // On another feature it goes on as before only if the surface does too.
      const bool same = previous.point.kind == contact.point.kind &&
                        previous.point.block_feature == contact.point.block_feature &&
                        (previous.point.ground_feature == contact.point.ground_feature ||
                         previous.point.normal.dot(n) > kSameNormal);
      path.rate = same ? -begin_velocity(previous.place).dot(previous.point.normal)
                       : (path.after - path.before) / duration;
      normal_before = previous.normal;
      stored_before = previous.stored;
      weight_before = previous.weight;
      const Vec3 force = previous.normal * previous.point.normal + previous.tangential;
      power_before = -previous.weight *
                     (force.dot(mean_velocity_from(previous.place)) + previous.rolling.dot(spin));
    } else {
      // It has come from as far as its speed allows; an overlap that this does not explain begins
      // as the law lets a contact without a past begin.
      path.rate = -begin_velocity(contact.place - duration * moving).dot(n);
      path.before = overlap - closing * duration;
      continuous = path.before <= kExplained * overlap;
      if (continuous) path.before = std::min(0.0, path.before);
      if (!continuous) normal_before = law.first_force(path.before, path.rate, mass);
    }

    NormalResponse response;
    if (duration > 0.0) {
      response = law.along(path, normal_before, mass);
    } else {
      response.force = law.first_force(overlap, path.rate, mass);
    }
    contact.normal = response.force;
    contact.tangential = tangential_before - k_t * duration * sliding;
    limit(contact.tangential, ground.friction * contact.normal);
    if (ground.rolling_friction > 0.0) {
      contact.rolling = rolling_before - k_r * duration * spin;
      // The arm of Eq. 5 is perpendicular to the axis about which the block rolls: the length of
      // the moment times the arm is that of the product of both.
      const double squared = contact.rolling.squaredNorm();
      const double largest =
          ground.rolling_friction * contact.normal * arm.cross(contact.rolling).norm();
      if (squared > largest) contact.rolling *= largest / squared;
    } else {
      contact.rolling = Vec3::Zero();
    }

    const Vec3 force = w * (contact.normal * n + contact.tangential);
    load.force += force;
    load.torque += arm.cross(force) + w * contact.rolling;
    load.torque_on_other -=
        (contact.place - other.world_from_body.translation).cross(force) + w * contact.rolling;
    if (continuous) take_event(response, w, n, contact.place);

    // Each law's own dissipation: its work less what it stores more, with the mean weight of the
    // step. What the forces took beyond that, because weights, zones, normals or the contacts
    // changed, is booked apart.
    const double mean_weight = 0.5 * (weight_before + w);
    const double law_before = law.stored(std::max(0.0, path.before));
    const double normal = mean_weight * (response.work - law.stored(overlap) + law_before);
    const double tangential_squared = tangential_before.squaredNorm();
    const double friction =
        -0.5 * mean_weight *
        (duration * (tangential_before + contact.tangential).dot(sliding) +
         (contact.tangential.squaredNorm() - tangential_squared) * tangential_give_);
    const double rolling =
        -0.5 * mean_weight *
        (duration * (rolling_before + contact.rolling).dot(spin) +
         (contact.rolling.squaredNorm() - rolling_before.squaredNorm()) * rolling_give_);
    const double power = -force.dot(moving) - w * contact.rolling.dot(spin);
    contact.stored = stored_in(contact, law);
    const double stored_more = contact.stored - stored_before;
    ledger.normal += normal;
    ledger.friction += friction;
    ledger.rolling += rolling;
    ledger.reassigned +=
        0.5 * duration * (power_before + power) - normal - friction - rolling - stored_more;
  }

  for (std::size_t j = 0; j < contacts_.size(); ++j) {
    if (carried_on_[j]) continue;
    const Contact& gone = contacts_[j];
    const Law& law = laws[gone.zone];
    const Vec3& n = gone.point.normal;
    const Vec3 moving = mean_velocity_from(gone.place);
    const double closing = -moving.dot(n);
    const double overlap = gone.point.overlap;
    const double taken = -0.5 * duration * gone.weight *
                         ((gone.normal * n + gone.tangential).dot(moving) + gone.rolling.dot(spin));
    const OverlapPath path{duration, overlap, overlap + closing * duration,
                           -begin_velocity(gone.place).dot(n)};
    double own = 0.0;
    if (path.after <= 0.0) {  // parted; else it slid off and its law never came to an end
      const NormalResponse response = law.along(path, gone.normal, gone.effective_mass);
      take_event(response, gone.weight, n, gone.place);
      const double normal = gone.weight * (response.work + law.stored(overlap));
      const double friction = -0.5 * gone.weight *
                              (duration * gone.tangential.dot(moving) -
                               gone.tangential.squaredNorm() * tangential_give_);
      const double rolling =
          -0.5 * gone.weight *
          (duration * gone.rolling.dot(spin) - gone.rolling.squaredNorm() * rolling_give_);
      ledger.normal += normal;
      ledger.friction += friction;
      ledger.rolling += rolling;
      own = normal + friction + rolling;
    }
    ledger.reassigned += taken + gone.stored - own;
  }
  std::swap(contacts_, now_);
  if (load.event && other.inverse_mass == 0.0) shift_overlaps(laws, *load.event, block, ledger);
  return load;
}

void ContactForces::match(const std::vector<ContactPoint>& points) {
  previous_of_.assign(points.size(), -1);
  carried_on_.assign(contacts_.size(), 0);
  const auto carry_on = [&](std::size_t i, std::size_t j) {
    previous_of_[i] = static_cast<int>(j);
    carried_on_[j] = 1;
  };
  // The same pair of features. Both lists are in the same order, so the search goes on where the
  // last one ended.
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t tried = 0; tried < contacts_.size(); ++tried) {
      const std::size_t j = (next + tried) % contacts_.size();
      const ContactPoint& a = points[i];
      const ContactPoint& b = contacts_[j].point;
      if (carried_on_[j] || a.kind != b.kind || a.block_feature != b.block_feature ||
          a.ground_feature != b.ground_feature || a.normal.dot(b.normal) < kHandOverCosine) {
        continue;
      }
      carry_on(i, j);
      next = j + 1;
      break;
    }
  }
  const auto hand_over = [&](const auto& related) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (previous_of_[i] >= 0) continue;
      std::optional<std::size_t> best;
      double best_cosine = kHandOverCosine;
      for (std::size_t j = 0; j < contacts_.size(); ++j) {
        if (carried_on_[j] || !related(points[i], contacts_[j].point)) continue;
        const double cosine = points[i].normal.dot(contacts_[j].point.normal);
        if (cosine > best_cosine) {
          best_cosine = cosine;
          best = j;
        }
      }
      if (best) carry_on(i, *best);
    }
  };
  // The same block feature on the next ground feature, or the same ground feature under the next
  // block feature; then whatever took over at the same place.
  hand_over([](const ContactPoint& a, const ContactPoint& b) {
    return a.kind == b.kind &&
           (a.block_feature == b.block_feature ||
            (a.kind != ContactKind::kVertexGround && a.ground_feature == b.ground_feature));
  });
  hand_over([&](const ContactPoint& a, const ContactPoint& b) {
    return (a.foot - b.foot).squaredNorm() < near_ * near_;
  });
}

void ContactForces::hand_on_springs() {
  // Points on which a weight grows or shrinks within a law.
  handed_.assign(now_.size(), {});
  for (std::size_t i = 0; i < now_.size(); ++i) {
    Contact& contact = now_[i];
    double weight_before = 0.0;
    if (previous_of_[i] >= 0) {
      const Contact& previous = contacts_[previous_of_[i]];
      weight_before = previous.weight;
      contact.tangential =
          turned_into_plane(previous.tangential, previous.point.normal, contact.point.normal);
      contact.rolling = previous.rolling;
    }
    HandedShare& handed = handed_[patches_.law_of(i)];
    const double more = contact.weight - weight_before;
    if (more > 0.0) {
      handed.gained += more;
    } else {
      handed.lost -= more;
      handed.tangential -= more * contact.tangential;
      handed.rolling -= more * contact.rolling;
    }
  }
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const HandedShare& handed = handed_[patches_.law_of(i)];
    if (!(handed.lost > 0.0)) continue;
    Contact& contact = now_[i];
    const double weight_before = previous_of_[i] >= 0 ? contacts_[previous_of_[i]].weight : 0.0;
    const double more = contact.weight - weight_before;
    if (!(more > 0.0)) continue;
    // What more is gained than lost keeps the point's own springs.
    const double taken = more / std::max(handed.gained, handed.lost);
    const double own = 1.0 - taken * handed.lost / contact.weight;
    const Vec3 tangential = own * contact.tangential + taken / contact.weight * handed.tangential;
    contact.tangential = tangential - tangential.dot(contact.point.normal) * contact.point.normal;
    contact.rolling = own * contact.rolling + taken / contact.weight * handed.rolling;
  }
}

void ContactForces::find_effective_masses(const BodyMotion& block, const BodyMotion& other) {
  // The unit force of a law acts through all its points: how easily that moves both bodies.
  law_action_.assign(now_.size(), {});
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const Contact& contact = now_[i];
    const std::size_t law = patches_.law_of(i);
    const Vec3 force = contact.weight * contact.point.normal;
    LawAction& action = law_action_[law];
    action.force += force;
    action.torque += (contact.place - block.world_from_body.translation).cross(force);
    action.torque_on_other += (contact.place - other.world_from_body.translation).cross(force);
  }
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const LawAction& action = law_action_[patches_.law_of(i)];
    const double mobility = (block.inverse_mass + other.inverse_mass) * action.force.squaredNorm() +
                            action.torque.dot(block.turned_by(action.torque)) +
                            action.torque_on_other.dot(other.turned_by(action.torque_on_other));
    now_[i].effective_mass = mobility > 0.0 ? 1.0 / mobility : 0.0;
  }
}

template <class Law>
void ContactForces::shift_overlaps(const std::vector<Law>& laws, const EventLoad& event,
                                   const BodyMotion& block, EnergyLedger& ledger) {
  const Vec3 shift = block.inverse_mass * event.moment;
  const Vec3 turn = block.turned_by(event.angular_moment);
  for (Contact& contact : contacts_) {
    const Vec3 moved = shift + turn.cross(contact.place - block.world_from_body.translation);
    const double before = contact.stored;
    contact.point.overlap = std::max(0.0, contact.point.overlap - moved.dot(contact.point.normal));
    contact.stored = stored_in(contact, laws[contact.zone]);
    ledger.reassigned -= contact.stored - before;
  }
}

template <class Law>
double ContactForces::stored_in(const Contact& contact, const Law& law) const {
  return contact.weight * (law.stored(contact.point.overlap) +
                           0.5 * (contact.tangential.squaredNorm() * tangential_give_ +
                                  contact.rolling.squaredNorm() * rolling_give_));
}

double ContactForces::stored_energy() const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) sum += contact.stored;
  return sum;
}

double ContactForces::max_overlap() const {
  double largest = 0.0;
  for (const Contact& contact : contacts_) largest = std::max(largest, contact.point.overlap);
  return largest;
}

std::optional<ContactForces::Deepest> ContactForces::deepest() const {
  const auto found = std::max_element(
      contacts_.begin(), contacts_.end(),
      [](const Contact& a, const Contact& b) { return a.point.overlap < b.point.overlap; });
  if (found == contacts_.end()) return std::nullopt;
  return Deepest{static_cast<std::uint32_t>(contacts_.size()), found->point.overlap, found->place,
                 found->zone};
}

double ContactForces::settled_depth() {
  // One law carries with its weighted mean overlap: that is the depth that Eq. 2 speaks of.
  std::vector<double> depth(contacts_.size(), 0.0);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const ContactPoint& point = contacts_[i].point;
    depth[patches_.law_of(i)] +=
        contacts_[i].weight * point.overlap * std::max(0.0, point.normal.z());
  }
  return depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
}

double ContactForces::rest_stiffness() const {
  return std::visit(
      [&](const auto& by_zone) {
        double smallest = stiffness_.normal;
        for (const Contact& contact : contacts_) {
          smallest = std::min(smallest, by_zone.laws[contact.zone].rest_stiffness());
        }
        return smallest;
      },
      laws_);
}

}  // namespace clast::dem_detail
