#include "dem/simulation/physics_digest.hpp"

#include <span>
#include <vector>

#include "core/files/digest.hpp"
#include "core/number_text.hpp"
#include "dem/contact/stiffness.hpp"
#include "dem/motion/box_body.hpp"
#include "dem/simulation/release.hpp"
#include "dem/simulation/world.hpp"

namespace clast {
namespace {

/// Rounding errors are in the sixteenth digit and grow by some orders in half a second of bounces.
constexpr int kDigits = 6;
/// Upper bound of the speed of the blocks, m/s.
constexpr double kFastest = 8.0;

/// Makes a slope of 0.6 (zone 0) that ends on a flat (zone 1).
TerrainSurface slope_and_flat() {
  TriangleMesh mesh;
  mesh.vertices = {{-6, -4, 3.6}, {0, -4, 0}, {0, 4, 0}, {-6, 4, 3.6}, {6, -4, 0}, {6, 4, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  return {std::move(mesh), {0, 0, 1, 1}};
}

/// Makes zones with all parameters except soil memory, which single releases do not have.
std::vector<GroundParameters> all_kinds_of_ground() {
  GroundParameters slope{0.08, 0.6, 0.2, 0.1};
  slope.friction_min = 0.3;
  slope.slip_growth = 4.0;
  slope.slip_memory = 0.1;
  slope.scar_drag = 0.5;
  slope.soil_density = 1500.0;
  return {slope, {0.2, 0.5, 0.3}};
}

RigidState tumbling(const Vec3& position) {
  RigidState state;
  state.position = position;
  state.orientation = Quat(0.8, 0.3, -0.2, 0.4).normalized();
  state.velocity = {3.0, 0.4, -2.0};
  state.angular_velocity = {0.5, 4.0, -1.0};
  return state;
}

void add_numbers(std::string& text, const std::vector<double>& values) {
  for (const double number : values) text += format_significant(number, kDigits) + " ";
  text += "\n";
}

void add_state(std::string& text, const RigidState& state) {
  std::vector<double> values(state.position.begin(), state.position.end());
  values.insert(values.end(), state.velocity.begin(), state.velocity.end());
  values.insert(values.end(), state.angular_velocity.begin(), state.angular_velocity.end());
  add_numbers(text, values);
}

void add_stiffness(std::string& text, const ContactStiffness& stiffness) {
  add_numbers(text, {stiffness.normal, stiffness.tangential, stiffness.rolling, stiffness.time_step,
                     stiffness.max_time_step});
}

ContactStiffness stiffness_of(std::span<const RigidBody> bodies,
                              std::span<const GroundParameters> zones, double gravity,
                              const ContactLaw& law, bool mass) {
  StiffnessOptions options;
  options.law = law;
  options.multi_block = mass;
  return choose_stiffness(bodies, zones, kFastest, gravity, options).stiffness;
}

}  // namespace

std::string simulate_reference_motions(double gravity) {
  const TerrainSurface terrain = slope_and_flat();
  std::vector<GroundParameters> zones = all_kinds_of_ground();
  const std::vector<RigidBody> bodies = {make_box_body({0.9, 0.6, 0.4}, 0.04, 600.0),
                                         make_box_body({0.5, 0.5, 0.3}, 0.04, 200.0)};
  std::string text;
  for (const std::string& law : contact_law_names()) {
    ReleaseSettings settings;
    settings.law = parse_contact_law(law);
    settings.gravity = gravity;
    settings.max_time = 0.9;
    settings.stiffness =
        stiffness_of(std::span(bodies.data(), 1), zones, gravity, settings.law, false);
    const ReleaseResult run =
        simulate_release(terrain, zones, bodies[0], tumbling({-3.0, 0.3, 2.5}), settings);
    text += law + "\n";
    add_stiffness(text, settings.stiffness);
    add_state(text, run.final_state);
    add_numbers(text, {run.max_penetration, run.path_length});
  }
  WorldSettings together;
  together.law = ElastoplasticLaw();
  together.gravity = gravity;
  together.between_bodies = {0.1, 0.5, 0.1};
  for (GroundParameters& zone : zones) zone.soil_memory = 0.2;
  together.stiffness = stiffness_of(bodies, zones, gravity, together.law, true);
  World world(bodies, together, terrain, zones);
  world.add_body(0, tumbling({-1.0, 0.3, 1.6}));
  RigidState second = tumbling({0.2, 0.5, 1.5});
  second.velocity.x() = -1.0;
  world.add_body(1, second);
  world.run_until_rest(0.6);
  add_stiffness(text, together.stiffness);
  for (std::size_t body = 0; body < world.body_count(); ++body) add_state(text, world.state(body));
  return text;
}

const std::string& physics_digest() {
  static const std::string digest = sha256(simulate_reference_motions());
  return digest;
}

std::string describe_physics_difference(const std::string& stored, const std::string& now) {
  constexpr std::size_t kShown = 10;
  if (stored.empty() || now.empty() || stored == now) return "";
  return "this version of clast computes different motions (physics digest " +
         stored.substr(0, kShown) + ", here " + now.substr(0, kShown) + ")";
}

}  // namespace clast
