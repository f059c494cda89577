#pragma once
/// Motion of all bodies of a simulation.
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "dem/simulation/detail/contact_pair_table.hpp"
#include "dem/simulation/detail/sleeping.hpp"
#include "dem/simulation/detail/time_step.hpp"
#include "dem/simulation/world.hpp"
#include "dem/surface/terrain_impl.hpp"

namespace clast::dem_detail {

/// Bodies and contacts of a simulation, with their integration in time. Objects cannot be moved,
/// because members refer to each other.
class WorldMotion {
 public:
  /// Makes a simulation without bodies.
  /// @param on  terrain, or null; must outlive this object
  /// @throws InputError  if settings are out of range
  /// @throws SimulationError  if a shape has no mass or a ground zone has no parameters
  WorldMotion(std::vector<RigidBody> of_shapes, const WorldSettings& with, const TerrainSurface* on,
              std::vector<GroundParameters> ground_zones);
  WorldMotion(const WorldMotion&) = delete;
  WorldMotion& operator=(const WorldMotion&) = delete;

  /// Adds a body.
  /// @param start  initial state, with a unit quaternion; the centre is above the terrain
  void add_body(std::size_t shape, const RigidState& start, bool fixed);
  /// Makes a fixed body a confining wall for the bodies of a range. It must be the body added last.
  void set_confined_bodies(std::size_t wall, const ConfinedBodyRange& confined) {
    bodies_[wall].confined = confined;
  }
  /// Removes a body and wakes the bodies that it touched. It becomes inactive and keeps its pose.
  void remove_body(std::size_t body);
  /// Frees fixed bodies. Each may be listed only once.
  void release_bodies(std::span<const std::size_t> bodies);
  /// Advances by one step. It is as long as the contacts allow, but at most `longest`, s.
  void advance(double longest);
  /// Returns the ascending indices of moving bodies, valid until the next step.
  std::span<const std::uint32_t> moving_bodies() {
    update_moving_list();
    return moving_;
  }
  /// Advances the time while no body moves, s.
  void advance_time(double duration) { time_ += duration; }

  /// Summarises the current contacts of a body (`World::contact_summary`).
  ContactSummary contact_summary(std::size_t body) const;
  /// Returns the energy balance since the first body was added.
  EnergyBalance energy_balance() const;
  EnergySample energy_sample() const;

  /// True if the body is idle, or if it has been slow and in contact for the rest duration.
  bool is_resting(const WorldBody& body) const {
    return body.is_idle() || body.resting_time >= settings_.rest_duration;
  }
  const WorldSettings& settings() const { return settings_; }
  const TerrainSurface* terrain() const { return terrain_; }
  std::span<const BodyShape> shapes() const { return shapes_; }
  const std::vector<WorldBody>& bodies() const { return bodies_; }
  const ContactPairTable& pairs() const { return pairs_; }
  /// True if the first step of the body has set up its contacts.
  bool is_prepared(std::size_t body) const { return body < prepared_count_; }
  std::size_t sleeping_count() const { return sleep_manager_.count(); }
  double time() const { return time_; }  ///< s
  std::uint64_t step_count() const { return steps_; }
  void set_observer(BodyObserver observer) { observer_ = std::move(observer); }

  /// Serialises the state that determines the future motion, between two steps.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    std::vector<std::size_t> shape_of_body;
    for (const WorldBody& body : bodies_) shape_of_body.push_back(body.shape - shapes_.data());
    bytes(shape_of_body);
    if constexpr (Bytes::kReads) {
      bodies_.clear();
      for (const std::size_t shape : shape_of_body) {
        if (shape >= shapes_.size()) throw InputError("the saved state belongs to another world");
        bodies_.emplace_back(shapes_[shape], RigidState(), false);
      }
      invalidate_lists();  // the lists of what moves, and places in the broad phase, are made anew
    }
    for (WorldBody& body : bodies_) bytes(body);
    pairs_.serialize(bytes, bodies_);
    bytes(soil_, prepared_count_, sleep_manager_, time_, step_length_, initial_, reassigned_,
          steps_);
  }

 private:
  ContactModel make_contact_model(std::span<const GroundParameters> zone_parameters,
                                  std::span<const std::uint16_t> zone_of_face,
                                  const SoilMemory* soil) const {
    return {zone_parameters,     zone_of_face,  settings_.stiffness,
            settings_.weighting, settings_.law, soil};
  }
  EnergyBalance losses() const {
    EnergyBalance sum = pairs_.losses().sum();
    sum.reassigned += reassigned_;
    return sum;
  }
  Vec3 gravity() const { return {0.0, 0.0, -settings_.gravity}; }

  void prepare_new_bodies();
  /// Updates the lists of moving bodies and active pairs if they are outdated.
  void update_moving_list();
  /// Marks the lists as outdated. Must be called if the moving bodies or active pairs change.
  void invalidate_lists() { listed_ = positions_known_ = false; }
  /// Predicate that is true for contact pairs with a body that starts to move.
  using IsNew = std::function<bool(const ContactPair&)>;
  /// Updates the contact pairs and computes the contacts of new pairs.
  void begin_new_pairs(const IsNew& is_new);
  void check_start_overlaps(const IsNew& is_new) const;
  /// Recomputes the contacts of all pairs at the present poses of the bodies.
  void update_all_pairs();
  void wake_touched();
  void put_to_sleep();
  void reapply_loads();
  /// Returns the sum of `RigidBodyIntegrator::verlet_start_loss` for steps of length `dt`, J.
  double verlet_start_losses(double dt);
  void set_step_length(double dt);
  void begin_body_steps(const TimeStep& step);
  void end_body_steps(double dt, bool flight);
  void remove_bodies_off_terrain();
  void deactivate(std::size_t body);
  void record_start_states();
  void notify_observer(double begin);

  WorldSettings settings_;
  const TerrainSurface* terrain_;
  std::vector<GroundParameters> zones_;
  SoilMemory soil_{zones_};
  std::vector<BodyShape> shapes_;
  ThreadPool team_;

  std::vector<WorldBody> bodies_;
  ContactPairTable pairs_{
      terrain_, make_contact_model(std::span(&settings_.between_bodies, 1), {}, nullptr),
      make_contact_model(std::span(&settings_.on_confining_walls, 1), {}, nullptr),
      make_contact_model(zones_,
                         terrain_ ? std::span<const std::uint16_t>(terrain_->impl().zones)
                                  : std::span<const std::uint16_t>(),
                         soil_.is_enabled() ? &soil_ : nullptr)};
  std::size_t prepared_count_ = 0;  ///< number of bodies whose contacts have been set up
  SleepManager sleep_manager_;
  BodyObserver observer_;
  /// State of a body at the start of the step. `free` is true if it has no contact there.
  struct StartState {
    std::uint32_t body;
    RigidState state;
    bool free = false;
  };
  /// Start states of moving bodies; empty without an observer.
  std::vector<StartState> start_states_;

  // Sleeping bodies should cost next to nothing, so a step works on these lists only.
  bool listed_ = false;                ///< true if both lists and the active pairs are up to date
  std::vector<std::uint32_t> moving_;  ///< ascending indices of moving bodies
  std::vector<std::uint32_t> awake_;   ///< bodies that are not asleep, including fixed ones
  bool positions_known_ = false;  ///< true if the broad phase knows the positions of resting bodies

  double time_ = 0.0;
  double step_length_ = settings_.stiffness.time_step;  ///< length of the last step, s
  double initial_ = 0.0;                                ///< energy of added bodies, J
  double reassigned_ = 0.0;                             ///< losses that belong to no pair, J
  std::uint64_t steps_ = 0;
};

/// Returns the name of a body in messages: "body 3".
std::string name_of_body(std::size_t body);

}  // namespace clast::dem_detail
