// Thrown at Chant Sura: impacts of real concrete blocks on an alpine meadow, and their scars,
// against what the laws make of them with the parameters for such ground in docs/parameters.md.
// Prints the tables of docs/accuracy.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "core/statistics/statistics.hpp"
#include "dem/contact/stiffness.hpp"
#include "dem/search/ground_overlap.hpp"
#include "massprops/principal_frame.hpp"
#include "massprops/solid.hpp"
#include "tests/support/chant_sura.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

constexpr int kThrows = 24;
constexpr double kMinFlight = 0.01;  ///< s, that ends an impact

RigidBody eota(double mass, bool plate) {
  const TriangleMesh mesh = eota_mesh(mass, plate);
  const MassProperties properties = solid_mass_properties(mesh, kConcrete);
  const PrincipalFrame frame = principal_frame(properties);
  RigidBody body;
  body.shape = transformed(make_sphero_polyhedron(mesh, 0.0),
                           Pose{properties.centre, frame.rotation}.inverse());
  body.mass = properties.mass;
  body.moments = frame.moments;
  body.smallest_side = std::cbrt(mass / kConcrete) * eota_sides(plate).minCoeff();
  return body;
}

/// Whether a table has a column of this ground.
bool shown(std::size_t ground) { return ground == 0 || ground == 2 || ground == 5; }

/// What blocks meet, and by which law.
struct Ground {
  const char* name;
  ContactLaw law;
  bool drawn = false;  ///< over the ranges, else the values themselves
  bool grows = false, drags = false;

  /// Meadow: "soil medium" of docs/parameters.md. Growth and C_d as published for the site
  /// [lu2019]; the density is an assumption.
  GroundParameters parameters(Random& random) const {
    GroundParameters ground{0.02, 0.70, 0.35};
    if (drawn) {
      ground = {random.uniform(0.01, 0.11), random.uniform(0.35, 0.80), random.uniform(0.18, 0.50)};
    }
    if (grows) {
      ground.friction = 2.0;
      ground.friction_min = 0.55;
      ground.slip_growth = 3.0;
      ground.slip_memory = 1.0 / 185.0;
    }
    if (drags) {
      ground.scar_drag = 1.5;
      ground.soil_density = 1800.0;
    }
    return ground;
  }
};

const std::vector<Ground>& grounds() {
  static const std::vector<Ground> kGrounds = {
      {"energy-restitution", EnergyRestitutionLaw()},
      {"energy-restitution, ranges", EnergyRestitutionLaw(), true},
      {"elastoplastic", ElastoplasticLaw()},
      {"elastoplastic, ranges", ElastoplasticLaw(), true},
      {"elastoplastic, growing friction", ElastoplasticLaw(), false, true},
      {"elastoplastic, growing friction, scar drag", ElastoplasticLaw(), false, true, true}};
  return kGrounds;
}

/// The first impact of a throw: the last touch before a flight of 10 ms.
struct FirstImpact {
  RigidState last;
  double depth = 0.0, flown = 0.0;
  bool over = false, touched = false;

  void observe_step(const MotionStep& step) {
    if (over) return;
    if (!step.flight) {
      touched = true;
      flown = 0.0;
      last = step.end;
      depth = std::max(depth, step.contact_summary.overlap);
    } else if (touched) {
      flown += step.end_time - step.begin_time;
      over = flown >= kMinFlight;
    }
  }
};

struct Throw {
  bool touched = false;
  double speed = 0.0, spin = 0.0, depth = 0.0, energy_share = 0.0;
};

/// Throws a body that touches the terrain at the plan position of the start.
Throw thrown(const TerrainSurface& terrain, const RigidBody& body, RigidState start,
             const Ground& on, Random& random) {
  const GroundParameters ground = on.parameters(random);
  const std::vector<GroundParameters> zones = {ground};
  StiffnessOptions options;
  options.law = on.law;
  ReleaseSettings settings;
  settings.law = on.law;
  settings.max_time = 0.3;
  const double fastest = std::hypot(start.velocity.norm(), 3.0);
  settings.stiffness =
      choose_stiffness(std::span(&body, 1), zones, fastest, kTestGravity, options).stiffness;

  const GroundOverlap overlap(terrain, body);
  double low = *terrain.height_at(start.position.x(), start.position.y(), 0.0), high = low + 2.0;
  while (high - low > 1e-5) {
    const double middle = 0.5 * (low + high);
    start.position.z() = middle;
    (overlap.max_overlap(start) > 0.0 ? low : high) = middle;
  }
  start.position.z() = high;
  FirstImpact impact;
  const ReleaseResult result =
      simulate_release(terrain, zones, body, start, settings,
                       [&](const MotionStep& step) { impact.observe_step(step); });
  EXPECT_NE(result.stop_reason, StopReason::kError) << result.message;
  EXPECT_FALSE(result.below_ground);
  EXPECT_LT(result.energy.error, 0.01);
  return {impact.touched, impact.last.velocity.norm(), impact.last.angular_velocity.norm(),
          impact.depth, impact.last.velocity.squaredNorm() / start.velocity.squaredNorm()};
}

std::string spread(std::vector<double> values, int digits) {
  std::sort(values.begin(), values.end());
  const SampleSummary all = summarise_sample(values);
  char text[80];
  std::snprintf(text, sizeof(text), "%.*f (%.*f to %.*f)", digits, all.mean, digits,
                quantile(values, 0.05), digits, quantile(values, 0.95));
  return text;
}

/// How far off one law is over many impacts.
struct Score {
  std::vector<double> differences, measured;
  int inside = 0;

  void add(double observed, std::vector<double> values) {
    std::sort(values.begin(), values.end());
    differences.push_back(summarise_sample(values).mean - observed);
    measured.push_back(observed);
    if (quantile(values, 0.05) <= observed && observed <= quantile(values, 0.95)) ++inside;
  }
  std::string text(int digits) const {
    double sum = 0.0, squares = 0.0;
    for (const double difference : differences) {
      sum += difference;
      squares += difference * difference;
    }
    const auto count = static_cast<double>(differences.size());
    char text[80];
    std::snprintf(text, sizeof(text), "%+.*f, %.*f, %d of %zu", digits, sum / count, digits,
                  std::sqrt(squares / count), inside, differences.size());
    return text;
  }
};

/// The surveyed ground, every second node of it (10 cm), with the south-west corner of its crop as
/// the origin.
TerrainSurface surveyed_ground(Vec2& origin) {
  std::ifstream file(test_data("chant_sura/terrain_rf16_contact_extended.asc"));
  std::string key;
  std::size_t columns = 0, rows = 0;
  double cell = 0.0, none = 0.0;
  file >> key >> columns >> key >> rows >> key >> origin.x() >> key >> origin.y() >> key >> cell >>
      key >> none;
  TriangleMesh mesh;
  const std::size_t kept_columns = (columns + 1) / 2, kept_rows = (rows + 1) / 2;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      double height = 0.0;
      file >> height;
      if (i % 2 != 0 || j % 2 != 0) continue;
      mesh.vertices.emplace_back(cell * (static_cast<double>(i) + 0.5),
                                 cell * (static_cast<double>(rows - j) - 0.5), height - 2370.0);
    }
  }
  for (std::size_t j = 0; j + 1 < kept_rows; ++j) {
    for (std::size_t i = 0; i + 1 < kept_columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j * kept_columns + i);
      const auto below = static_cast<std::uint32_t>(a + kept_columns);
      mesh.triangles.push_back({a, below, below + 1});
      mesh.triangles.push_back({a, below + 1, a + 1});
    }
  }
  return ground(std::move(mesh));
}

// The attitude is not known: drawn evenly. No law may make energy or lose a block; what they make
// of the rebounds is printed. One "impact" leads away from the surveyed ground and is none there.
TEST(ChantSura, ReboundsOfElevenImpacts) {
  Vec2 origin;
  const TerrainSurface terrain = surveyed_ground(origin);
  const std::vector<ThrownImpact> impacts = observed_impacts();
  ASSERT_EQ(impacts.size(), 11u);
  std::printf("| impact | mass, kg | speed before, after, m/s | spin before, after, rad/s |");
  for (const char* name : {"energy-restitution", "elastoplastic", "with friction and drag"}) {
    std::printf(" speed, spin after: %s |", name);
  }
  std::printf("\n");
  std::vector<Score> speeds(grounds().size()), spins(grounds().size());
  int without = 0;
  for (const ThrownImpact& impact : impacts) {
    const RigidBody body = eota(impact.mass, impact.plate);
    std::printf("| %s | %.0f | %.1f, %.1f | %.1f, %.1f |", impact.name.c_str(), body.mass,
                impact.velocity.norm(), impact.speed, impact.angular_velocity.norm(), impact.spin);
    for (std::size_t g = 0; g < grounds().size(); ++g) {
      Random random(7);
      std::vector<double> speed, spin;
      for (int i = 0; i < kThrows; ++i) {
        RigidState start;
        start.position.head<2>() = impact.place - origin;
        start.velocity = impact.velocity;
        start.angular_velocity = impact.angular_velocity;
        start.orientation = random.rotation();
        if (!start.angular_velocity.allFinite()) start.angular_velocity = Vec3(8.0, 0.0, 0.0);
        const Throw one = thrown(terrain, body, start, grounds()[g], random);
        if (!one.touched) continue;
        speed.push_back(one.speed);
        spin.push_back(one.spin);
      }
      if (2 * speed.size() < kThrows) {
        if (g == 0) ++without;
        if (shown(g)) std::printf(" flies on |");
        continue;
      }
      speeds[g].add(impact.speed, speed);
      if (std::isfinite(impact.spin)) spins[g].add(impact.spin, spin);
      if (shown(g)) {
        std::printf(" %s; %s |", spread(speed, 1).c_str(), spread(spin, 1).c_str());
      }
    }
    std::printf("\n");
  }
  std::printf("\n| law | speed, m/s: bias, error, inside | spin, rad/s: bias, error, inside |\n");
  for (std::size_t g = 0; g < grounds().size(); ++g) {
    std::printf("| %s | %s | %s |\n", grounds()[g].name, speeds[g].text(1).c_str(),
                spins[g].text(1).c_str());
  }
  EXPECT_EQ(without, 1);
}

// On a plane: the published speeds normal to it and along it. The attitude is not known, nor the
// spin: drawn between none and that of rolling.
TEST(ChantSura, DepthsOfSixScars) {
  const std::vector<ReferenceRow> scars = chant_sura_rows("chant_sura_esurf_2019_impacts.csv");
  ASSERT_EQ(scars.size(), 6u);
  const TerrainSurface terrain = ground(plane_mesh(30.0, 6));
  std::printf("| scar | speed, m/s (normal) | depth, m | energy kept |");
  for (const char* name : {"energy-restitution", "elastoplastic", "with friction and drag"}) {
    std::printf(" depth, energy kept: %s |", name);
  }
  std::printf("\n");
  std::vector<Score> depths(grounds().size()), kept(grounds().size());
  for (const ReferenceRow& scar : scars) {
    const RigidBody body = eota(value(scar, "mass_kg"), true);
    const double depth = value(scar, "observed_scarring_depth_m");
    const double share = value(scar, "published_energy_transition_ratio");
    const double normal = value(scar, "incoming_normal_speed_mps");
    const double along = value(scar, "incoming_tangent_speed_mps");
    std::printf("| %s | %.1f (%.1f) | %.2f | %.2f |", scar.at("scar_id").c_str(),
                std::hypot(normal, along), normal, depth, share);
    for (std::size_t g = 0; g < grounds().size(); ++g) {
      Random random(11);
      std::vector<double> deep, energy;
      for (int i = 0; i < kThrows; ++i) {
        RigidState start;
        start.orientation = random.rotation();
        start.velocity = {along, 0.0, -normal};
        start.angular_velocity.y() =
            random.uniform() * along / (0.5 * std::cbrt(body.mass / kConcrete));
        const Throw one = thrown(terrain, body, start, grounds()[g], random);
        deep.push_back(one.depth);
        energy.push_back(one.energy_share);
      }
      depths[g].add(depth, deep);
      kept[g].add(share, energy);
      if (shown(g)) {
        std::printf(" %s; %s |", spread(deep, 2).c_str(), spread(energy, 2).c_str());
      }
    }
    std::printf("\n");
  }
  std::printf("\n| law | depth, m: bias, error, inside | energy kept: bias, error, inside |\n");
  for (std::size_t g = 0; g < grounds().size(); ++g) {
    std::printf("| %s | %s | %s |\n", grounds()[g].name, depths[g].text(3).c_str(),
                kept[g].text(2).c_str());
  }
}

}  // namespace
}  // namespace clast
