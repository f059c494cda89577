#include "dem/contact/stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

/// Largest settled depth with chosen stiffness: 2 cm, or 2 % of S for small blocks.
constexpr double kSettledDepth = 0.02;
constexpr double kSettledDepthFraction = 0.02;
/// Largest impact depth, as a fraction of S.
constexpr double kImpactDepthFraction = 0.25;
/// Time step times the highest contact frequency, in impacts and between them. Explicit stepping is
/// stable below 2 (docs/theory.md, Time step).
constexpr double kImpactStep = 0.2, kMassImpactStep = 0.4;
constexpr double kMaxStep = 0.4;
constexpr double kUnstableProduct = 2.0;
/// Largest displacement of a block in one step, as a fraction of the smallest S.
constexpr double kDisplacementFraction = 0.25;
/// Arm of the rolling spring, as a fraction of S: with k_r = k_t (S/2)^2, both springs are loaded
/// by equal displacements.
constexpr double kRollingArmFraction = 0.5;
/// Ratio of static stiffness to k_n below which a warning states the cost.
constexpr double kCostlyRestFraction = 1e-3;
/// Typical e_n^2 for comparison in messages: that of the zones in the cited paper.
constexpr double kUsualRestFraction = 0.01;

/// Most demanding value of each property over all bodies.
struct Demand {
  double normal = 0.0;  ///< k_n chosen for "auto", N/m
  double mobility = 0.0;
  double smallest_moment = 1e300;
  double smallest_side = 1e300;
};

Demand demand_of(std::span<const BodyStiffnessInputs> bodies, const GroundStiffnessInputs& ground,
                 double max_speed, double gravity) {
  Demand demand;
  for (const BodyStiffnessInputs& body : bodies) {
    const double depth = std::min(kSettledDepth, kSettledDepthFraction * body.smallest_side);
    const double deepest = kImpactDepthFraction * body.smallest_side;
    demand.normal =
        std::max({demand.normal, body.mass * gravity / (ground.static_stiffness_ratio * depth),
                  body.mass * max_speed * max_speed / (deepest * deepest)});
    demand.mobility = std::max(demand.mobility, body.mobility);
    demand.smallest_moment = std::min(demand.smallest_moment, body.smallest_moment);
    demand.smallest_side = std::min(demand.smallest_side, body.smallest_side);
  }
  return demand;
}

/// Sets the depths that the chosen stiffness leads to.
/// @returns  the largest settled depth as a fraction of its body's S
double find_depths(StiffnessChoice& choice, std::span<const BodyStiffnessInputs> bodies,
                   const GroundStiffnessInputs& ground, double max_speed, double gravity) {
  const double normal = choice.stiffness.normal;
  double deepest_share = 0.0;
  for (const BodyStiffnessInputs& body : bodies) {
    // Depth h of an impact: m v^2/2 + m g h = k h^2/2.
    const double weight = body.mass * gravity;
    const double impact =
        (weight + std::sqrt(weight * weight + normal * body.mass * max_speed * max_speed)) / normal;
    const double settled = std::max(weight / (normal * ground.static_stiffness_ratio),
                                    ground.residual_indentation_ratio * impact);
    choice.settled_depth = std::max(choice.settled_depth, settled);
    choice.impact_depth = std::max(choice.impact_depth, impact);
    deepest_share = std::max(deepest_share, settled / body.smallest_side);
  }
  return deepest_share;
}

std::string softness_warning(const StiffnessChoice& choice, double automatic,
                             double deepest_share) {
  return "k_n = " + format_significant(choice.stiffness.normal, 3) + " N/m is softer than the " +
         format_significant(automatic, 3) +
         " N/m that \"auto\" would choose: the settled depth is " +
         format_significant(choice.settled_depth, 3) + " m deep (" +
         format_significant(100.0 * deepest_share, 3) +
         " % of S), and the fastest impact penetrates " +
         format_significant(choice.impact_depth, 3) + " m deep";
}

std::string cost_warning(const ContactStiffness& chosen, double static_stiffness_ratio) {
  return "energy_restitution = " + format_significant(static_stiffness_ratio, 3) +
         " lets blocks rest on only that fraction of k_n, so \"auto\" chooses k_n = " +
         format_significant(chosen.normal, 3) + " N/m and steps of " +
         format_significant(chosen.time_step, 3) +
         " s: " + format_significant(std::sqrt(kUsualRestFraction / static_stiffness_ratio), 3) +
         " times the work of energy_restitution = 0.01";
}

std::string stiff_unloading_warning(const ContactStiffness& chosen,
                                    const GroundStiffnessInputs& ground) {
  const double restitution = 1.0 - ground.residual_indentation_ratio;
  return "energy_restitution = " + format_significant(restitution, 3) +
         " makes the ground unload 1/energy_restitution times as stiff as it loads, in steps of " +
         format_significant(chosen.time_step, 3) +
         " s: " + format_significant(std::sqrt(kUsualRestFraction / restitution), 3) +
         " times the work of energy_restitution = 0.01";
}

}  // namespace

std::vector<double> vertex_mobilities(const RigidBody& body) {
  std::vector<double> mobilities;
  mobilities.reserve(body.shape.vertices.size());
  for (const Vec3& vertex : body.shape.vertices) {
    const double length = vertex.norm();
    const Vec3 arm = length > 0.0 ? Vec3(vertex * (1.0 + body.shape.radius / length))
                                  : Vec3(body.shape.radius, 0.0, 0.0);
    // One eigenvalue of [x]^T A [x] is 0. The others follow from its trace and second invariant.
    const Vec3 easy = body.moments.cwiseInverse(), squared = arm.cwiseAbs2();
    const double trace = squared.sum() * easy.sum() - squared.dot(easy);
    const double second = squared.sum() * easy.prod() * squared.dot(body.moments);
    const double turning = 0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4.0 * second)));
    mobilities.push_back(1.0 / body.mass + turning);
  }
  return mobilities;
}

BodyStiffnessInputs body_stiffness_inputs(const RigidBody& body) {
  const std::vector<double> mobilities = vertex_mobilities(body);
  return {body.mass, body.smallest_side, body.moments.minCoeff(),
          *std::max_element(mobilities.begin(), mobilities.end())};
}

void GroundStiffnessInputs::include(const GroundStiffnessInputs& other) {
  static_stiffness_ratio = std::min(static_stiffness_ratio, other.static_stiffness_ratio);
  frequency_ratio = std::max(frequency_ratio, other.frequency_ratio);
  rolling_length = std::max(rolling_length, other.rolling_length);
  all_rolling_lengths_stated = all_rolling_lengths_stated && other.all_rolling_lengths_stated;
  residual_indentation_ratio =
      std::max(residual_indentation_ratio, other.residual_indentation_ratio);
}

GroundStiffnessInputs ground_stiffness_inputs(std::span<const GroundParameters> zones,
                                              const ContactLaw& law) {
  if (zones.empty()) {
    throw SimulationError(
        "stiffness: it is chosen from the ground parameters, but no ground zone is given; give "
        "one");
  }
  GroundStiffnessInputs ground;
  std::visit(
      [&]<NormalForceLaw Law>(const Law&) {
        for (const GroundParameters& zone : zones) {
          // Results of the law for a stiffness of 1 N/m and a frequency of 1 rad/s.
          const Law unit = Law::on_ground(1.0, zone);
          ground.include({unit.static_stiffness(), unit.highest_frequency(1.0), zone.rolling_length,
                          zone.rolling_length > 0.0,
                          Law::kIsPlastic ? 1.0 - zone.energy_restitution : 0.0});
        }
      },
      law);
  return ground;
}

StiffnessChoice choose_stiffness(std::span<const RigidBody> bodies,
                                 std::span<const GroundParameters> zones, double max_speed,
                                 double gravity, const StiffnessOptions& options) {
  std::vector<BodyStiffnessInputs> asked;
  for (const RigidBody& body : bodies) asked.push_back(body_stiffness_inputs(body));
  return choose_stiffness(asked, ground_stiffness_inputs(zones, options.law), max_speed, gravity,
                          options);
}

StiffnessChoice choose_stiffness(std::span<const BodyStiffnessInputs> bodies,
                                 const GroundStiffnessInputs& ground, double max_speed,
                                 double gravity, const StiffnessOptions& options) {
  if (bodies.empty()) {
    throw SimulationError(
        "stiffness: it is chosen from the masses of the blocks, but no block is given; give one");
  }
  const Demand demand = demand_of(bodies, ground, max_speed, gravity);
  StiffnessChoice choice;
  ContactStiffness& chosen = choice.stiffness;
  chosen.normal = options.normal.value_or(demand.normal);
  // Elastic stiffness of the ground; for plastic laws, that of unloading.
  chosen.tangential =
      options.tangential.value_or(chosen.normal / (1.0 - ground.residual_indentation_ratio));
  const double arm = kRollingArmFraction * demand.smallest_side;
  chosen.rolling = options.rolling.value_or(chosen.tangential * arm * arm);
  const double stiffest_rolling =
      std::max(ground.all_rolling_lengths_stated ? 0.0 : chosen.rolling,
               chosen.normal * ground.rolling_length * ground.rolling_length);
  const double frequency =
      std::max(ground.frequency_ratio * std::sqrt(chosen.normal * demand.mobility),
               std::sqrt(std::max(chosen.tangential * demand.mobility,
                                  stiffest_rolling / demand.smallest_moment)));
  // A step in contact must not carry a block through the ground, however soft it is.
  const double displacement =
      max_speed > 0.0 ? kDisplacementFraction * demand.smallest_side / max_speed : 1e300;
  const double impact_step = options.multi_block ? kMassImpactStep : kImpactStep;
  const double resolved = std::min(impact_step / frequency, displacement);
  chosen.time_step = options.time_step.value_or(resolved);
  // Half the allowed displacement, because contacts of low mobility allow twice this step.
  if (!options.time_step) chosen.max_time_step = std::min(kMaxStep / frequency, 0.5 * displacement);
  const double most = std::min(kUnstableProduct / frequency, displacement);
  if (chosen.time_step > most) {
    throw SimulationError("time step " + format_significant(chosen.time_step, 3) +
                          " s is too long: beyond " + format_significant(most, 3) +
                          " s contacts generate energy, or blocks pass through the ground; " +
                          format_significant(resolved, 3) +
                          " s resolves every contact: give this value, or leave the time step out");
  }

  const double deepest_share = find_depths(choice, bodies, ground, max_speed, gravity);
  if (chosen.normal < 0.999 * demand.normal) {
    choice.warnings.push_back(softness_warning(choice, demand.normal, deepest_share));
  }
  if (!options.normal && ground.static_stiffness_ratio < kCostlyRestFraction) {
    choice.warnings.push_back(cost_warning(chosen, ground.static_stiffness_ratio));
  }
  if (1.0 - ground.residual_indentation_ratio < kCostlyRestFraction) {
    choice.warnings.push_back(stiff_unloading_warning(chosen, ground));
  }
  if (chosen.time_step * frequency > 0.5) {
    choice.warnings.push_back("time step " + format_significant(chosen.time_step, 3) +
                              " s is long for this stiffness; " + format_significant(resolved, 3) +
                              " s resolves every contact");
  }
  return choice;
}

}  // namespace clast
