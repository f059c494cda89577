// Worlds: blocks that fall, hit the ground and each other, step by step.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "dem/contact/stiffness.hpp"
#include "dem/simulation/world.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/watched_call.hpp"
#include "study/campaign/ground_fields.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::python_detail {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

/// Steps between two looks at signals and progress.
constexpr int kStepsTogether = 256;

GroundParameters ground_from(const py::handle& object, const std::string& zone) {
  if (!py::isinstance<py::dict>(object)) {
    throw py::type_error("ground of " + zone + ": must be a dict of parameters");
  }
  Keywords given(py::reinterpret_borrow<py::dict>(object));
  GroundParameters ground;
  for (const GroundParameterField& field : ground_parameter_fields())
    given.read(field.name, ground.*field.value);
  given.check_all_used();
  ground.check(zone);
  return ground;
}

/// Bodies that move before the first step.
struct Waiting {
  std::size_t shape;
  RigidState state;
  bool fixed;
};

/// World with its terrain. Stiffness and time step are chosen for all blocks at the first step.
class Experiment {
 public:
  Experiment(std::shared_ptr<Terrain> terrain, const py::dict& keywords)
      : terrain_(std::move(terrain)) {
    Keywords given(keywords);
    take_settings(given);
    take_ground(given);
    double radius = 0.0;
    given.read("radius_m", radius);
    given.check_all_used();
    WorldSettings known = settings_;
    known.stiffness = {1.0, 1.0, 1.0, 1e-3, 1e-3};  // follows from the blocks, later
    known.check();
    if (terrain_) surface_.emplace(make_terrain_surface(*terrain_, radius));
  }

  /// Makes the block's shape known before the first step.
  std::size_t learn(const std::shared_ptr<Block>& block) {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (blocks_[i] == block) return i;
    }
    if (world_) {
      throw SimulationError("block " + block->id +
                            " is not known to this world, whose stiffness was chosen from its "
                            "blocks; add it, or declare it with know(), before the first step");
    }
    const RigidBody body = rigid_body(*block);
    body.check("block " + block->id);
    blocks_.push_back(block);
    bodies_.push_back(body);
    return blocks_.size() - 1;
  }

  std::size_t add(const std::shared_ptr<Block>& block, const py::object& position,
                  const py::dict& keywords) {
    Keywords given(keywords);
    RigidState state;
    state.position = local(parse_vector(position, "position"));
    Quat turn = Quat::Identity();
    if (given.has("orientation")) {
      turn = parse_rotation(given.given_object("orientation"), "orientation");
    }
    state.orientation = (turn * block->principal.rotation).normalized();
    if (given.has("velocity_m_s")) {
      state.velocity = parse_vector(given.given_object("velocity_m_s"), "velocity_m_s");
    }
    if (given.has("angular_velocity_rad_s")) {
      state.angular_velocity =
          parse_vector(given.given_object("angular_velocity_rad_s"), "angular_velocity_rad_s");
    }
    bool fixed = false;
    given.read("fixed", fixed);
    given.check_all_used();
    const std::size_t shape = learn(block);
    if (world_) {
      started().add_body(shape, state, fixed);
    } else {
      waiting_.push_back({shape, state, fixed});
    }
    shape_of_.push_back(shape);
    return shape_of_.size() - 1;
  }

  void remove(std::size_t body) { started().remove_body(checked(body)); }

  void step(std::size_t count) {
    World& world = started();
    for (std::size_t i = 0; i < count; ++i) {
      if (i % kStepsTogether == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
      world.step();
    }
  }

  /// "rest", "left_terrain" or "max_time".
  std::string run(double duration, const py::object& progress) {
    if (!(duration > 0.0) || !std::isfinite(duration)) {
      throw InputError("duration = " + format_significant(duration, 6) + " s must be positive");
    }
    World& world = started();
    const double begin = world.time(), end = begin + duration;
    StopReason reason = StopReason::kMaxTime;
    const auto job = [&](const ProgressCallback& report) {
      const double stretch = static_cast<double>(kStepsTogether) * settings_.stiffness.time_step;
      do {
        reason = world.run_until_rest(std::min(end, world.time() + stretch));
        report(progress_at(world.time() - begin, duration));
      } while (reason == StopReason::kMaxTime && world.time() < end);
    };
    running_ = true;
    try {
      call_with_progress(progress, job, busy_);
    } catch (...) {
      running_ = false;
      throw;
    }
    running_ = false;
    return name_of(reason);
  }

  double time() { return world_ ? started().time() : 0.0; }
  std::size_t count() const { return shape_of_.size(); }

  py::dict states() {
    World& world = started();
    const auto rows = static_cast<py::ssize_t>(count());
    py::array_t<double> position({rows, py::ssize_t{3}}), orientation({rows, py::ssize_t{4}}),
        velocity({rows, py::ssize_t{3}}), spin({rows, py::ssize_t{3}});
    py::array_t<bool> resting(rows), asleep(rows), gone(rows);
    for (py::ssize_t i = 0; i < rows; ++i) {
      const auto body = static_cast<std::size_t>(i);
      const RigidState& state = world.state(body);
      const Quat turn = state.orientation * blocks_[shape_of_[body]]->principal.rotation.inverse();
      const Vec3 place = map(state.position);
      for (int k = 0; k < 3; ++k) {
        position.mutable_at(i, k) = place[k];
        velocity.mutable_at(i, k) = state.velocity[k];
        spin.mutable_at(i, k) = state.angular_velocity[k];
      }
      const double numbers[] = {turn.w(), turn.x(), turn.y(), turn.z()};
      for (int k = 0; k < 4; ++k) orientation.mutable_at(i, k) = numbers[k];
      resting.mutable_at(i) = world.is_resting(body);
      asleep.mutable_at(i) = world.is_asleep(body);
      gone.mutable_at(i) = world.is_inactive(body);
    }
    return py::dict("position_m"_a = position, "orientation"_a = orientation,
                    "velocity_m_s"_a = velocity, "angular_velocity_rad_s"_a = spin,
                    "resting"_a = resting, "asleep"_a = asleep, "gone"_a = gone);
  }

  py::dict contacts(std::size_t body) {
    World& world = started();
    const ContactSummary touch = world.contact_summary(checked(body));
    return py::dict("points"_a = touch.contact_count, "overlap_m"_a = touch.overlap,
                    "force_n"_a = to_array(world.contact_force(body)),
                    "blocks"_a = world.touching_bodies(body));
  }

  py::dict energy() {
    const EnergyBalance balance = started().energy_balance();
    return py::dict("energy_initial_j"_a = balance.initial, "energy_final_j"_a = balance.final,
                    "energy_normal_j"_a = balance.normal, "energy_friction_j"_a = balance.friction,
                    "energy_rolling_j"_a = balance.rolling,
                    "energy_reassigned_j"_a = balance.reassigned, "energy_error"_a = balance.error);
  }

  py::dict contact() {
    started();
    const ContactStiffness& chosen = settings_.stiffness;
    return py::dict("stiffness_n_m"_a = chosen.normal,
                    "tangential_stiffness_n_m"_a = chosen.tangential,
                    "rolling_stiffness_n_m_rad"_a = chosen.rolling,
                    "time_step_s"_a = chosen.time_step, "warnings"_a = warnings_);
  }

 private:
  static ProgressUpdate progress_at(double passed, double duration) {
    constexpr double kParts = 1000.0;
    return {.done = static_cast<std::size_t>(kParts * std::min(1.0, passed / duration)),
            .total = static_cast<std::size_t>(kParts)};
  }

  void take_settings(Keywords& given) {
    std::optional<std::string> law, weights;
    given.read("law", law);
    given.read("weights", weights);
    if (law) settings_.law = parse_contact_law(*law);
    if (weights) settings_.weighting = parse_contact_weighting(*weights);
    given.read("gravity_m_s2", settings_.gravity);
    given.read("rest_energy_j_kg", settings_.rest_energy);
    given.read("rest_duration_s", settings_.rest_duration);
    given.read("threads", settings_.threads);
    given.read("stiffness_n_m", options_.normal);
    given.read("tangential_stiffness_n_m", options_.tangential);
    given.read("rolling_stiffness_n_m_rad", options_.rolling);
    given.read("time_step_s", options_.time_step);
    given.read("fastest_m_s", fastest_);
    options_.law = settings_.law;
    if (fastest_ && !(*fastest_ > 0.0 && std::isfinite(*fastest_))) {
      throw InputError("fastest_m_s = " + format_significant(*fastest_, 6) + " must be positive");
    }
  }

  void take_ground(Keywords& given) {
    if (given.has("between_blocks")) {
      settings_.between_bodies =
          ground_from(given.given_object("between_blocks"), "between_blocks");
    }
    const bool stated = given.has("ground");
    if (!terrain_) {
      if (stated) throw InputError("ground: a world without a terrain has no ground");
      return;
    }
    if (!stated) {
      throw InputError("ground: give the parameters of each zone, as {\"" +
                       terrain_->zone_names.front() +
                       "\": {\"energy_restitution\": 0.01, \"friction\": 0.7, "
                       "\"rolling_friction\": 0.2}}");
    }
    std::map<std::string, GroundParameters> parameters;
    for (const auto& [zone, values] : py::cast<py::dict>(given.given_object("ground"))) {
      const std::string name = py::str(zone);
      parameters[name] = ground_from(values, name);
    }
    for (const std::string& zone : terrain_->zone_names) {
      const auto found = parameters.find(zone);
      if (found == parameters.end()) {
        throw InputError("ground: the zone " + zone + " of the terrain has no parameters");
      }
      zones_.push_back(found->second);
      parameters.erase(found);
    }
    if (!parameters.empty()) {
      throw InputError("ground: the terrain has no zone " + parameters.begin()->first);
    }
  }

  Vec3 local(const Vec3& place) const { return terrain_ ? terrain_->frame.to_local(place) : place; }
  Vec3 map(const Vec3& place) const { return terrain_ ? terrain_->frame.to_map(place) : place; }

  /// No block is faster: from its start and its fall to the lowest place there is.
  double fastest() const {
    if (fastest_) return *fastest_;
    double lowest = surface_ ? surface_->extent().low.z() : INFINITY, fastest = 0.0;
    for (const Waiting& one : waiting_) lowest = std::min(lowest, one.state.position.z());
    for (const Waiting& one : waiting_) {
      const RigidBody& body = bodies_[one.shape];
      const double fall = std::max(one.state.position.z() - lowest, body.size());
      const double spin =
          body.moments.maxCoeff() / body.mass * one.state.angular_velocity.squaredNorm();
      fastest = std::max(fastest, std::sqrt(one.state.velocity.squaredNorm() + spin +
                                            2.0 * settings_.gravity * fall));
    }
    return fastest;
  }

  World& started() {
    if (running_)
      throw SimulationError("the world is moving; read its state after run() has returned");
    if (world_) return *world_;
    if (bodies_.empty()) throw SimulationError("the world is empty; add a block first");
    std::vector<GroundParameters> grounds = zones_;
    grounds.push_back(settings_.between_bodies);
    const StiffnessChoice choice =
        choose_stiffness(bodies_, grounds, fastest(), settings_.gravity, options_);
    settings_.stiffness = choice.stiffness;
    warnings_ = choice.warnings;
    World world =
        surface_ ? World(bodies_, settings_, *surface_, zones_) : World(bodies_, settings_);
    for (const Waiting& one : waiting_) world.add_body(one.shape, one.state, one.fixed);
    return world_.emplace(std::move(world));
  }

  std::size_t checked(std::size_t body) const {
    if (body < count()) return body;
    throw SimulationError("there is no block number " + std::to_string(body) + "; there are " +
                          format_count(count(), "block"));
  }

  std::shared_ptr<Terrain> terrain_;
  std::optional<TerrainSurface> surface_;
  std::vector<GroundParameters> zones_;
  WorldSettings settings_;
  StiffnessOptions options_;
  std::optional<double> fastest_;
  std::vector<std::shared_ptr<Block>> blocks_;  ///< one for each shape
  std::vector<RigidBody> bodies_;
  std::vector<std::size_t> shape_of_;  ///< of each block in the world
  std::vector<Waiting> waiting_;
  std::optional<World> world_;
  std::vector<std::string> warnings_;
  std::mutex busy_;
  bool running_ = false;  ///< on a thread of its own
};

}  // namespace

void bind_worlds(py::module_& module) {
  py::class_<Experiment>(module, "Experiment")
      .def(py::init<std::shared_ptr<Terrain>, const py::dict&>(), "terrain"_a.none(true),
           "settings"_a)
      .def("know", [](Experiment& self, const std::shared_ptr<Block>& b) { self.learn(b); })
      .def("add", &Experiment::add)
      .def("remove", &Experiment::remove)
      .def("step", &Experiment::step)
      .def("run", &Experiment::run)
      .def_property_readonly("time", &Experiment::time)
      .def("__len__", &Experiment::count)
      .def("states", &Experiment::states)
      .def("contacts", &Experiment::contacts)
      .def("energy", &Experiment::energy)
      .def("contact", &Experiment::contact);
}

}  // namespace clast::python_detail
