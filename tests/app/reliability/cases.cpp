#include "tests/app/reliability/cases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/angle.hpp"
#include "core/files/digest.hpp"
#include "core/number_text.hpp"
#include "tests/app/reliability/odd_cases.hpp"
#include "tests/app/reliability/right_answer.hpp"
#include "tests/support/cloud_sample.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/field_scene.hpp"
#include "tests/support/scan_damage.hpp"

namespace clast::reliability {

namespace {

using Amounts = std::vector<double>;

/// Every vertex was moved: where it was can't be known, so twice the effect is allowed.
DamagedScan of_moved(const Body& body, const TriangleMesh& moved) {
  return of(body, moved, at_least_usual(effect(body.truth, truth_of(moved)), 2.0));
}

Kind jitter_kind(const std::string& name, Jitter jitter) {
  return {name, "% of L", Amounts{0.1, 0.3, 1.0},
          [jitter](const Body& body, double amount, Random& random) {
            return of_moved(body, jittered(body.fine, jitter, kPercent * amount, random));
          }};
}

/// Both surfaces are the block's as likely as not, so either is right where it is said that there
/// are two.
DamagedScan of_two(const Body& body, TriangleMesh doubled, double factor) {
  const std::vector<std::string> said = {"twice", "copy", "doubled", "second surface"};
  Truth copy = body.truth;
  copy.volume *= factor * factor * factor;
  copy.axes = {factor * copy.axes.L, factor * copy.axes.I, factor * copy.axes.S};
  DamagedScan scan = of(body, std::move(doubled));
  scan.expected.push_back({copy, {}, said});
  return scan;
}

DamagedScan of_crossing(const Body& body, double radius, std::size_t count, Random& random) {
  const TriangleMesh crossing = with_crossing_balls(body.fine, count, radius, random);
  // Dropped or kept, both are right: what the balls add at most is allowed.
  Truth kept = truth_of(crossing);
  kept.volume =
      body.truth.volume + static_cast<double>(count) * 4.0 / 3.0 * kPi * radius * radius * radius;
  return of(body, crossing, at_least_usual(effect(body.truth, kept), 1.0));
}

DamagedScan of_cloud(const Body& body, const CloudSample& sample, Random& random) {
  TriangleMesh cloud;
  cloud.vertices = sampled_cloud(body.mesh, sample, random);
  return of(body, std::move(cloud), cloud_tolerance(sample.points, sample.noise));
}

Kind cloud_kind(const std::string& name, Amounts points, double noise, double outliers) {
  return {name, "points", std::move(points), [=](const Body& body, double amount, Random& random) {
            const auto count = static_cast<std::size_t>(amount);
            return of_cloud(body, {.points = count, .noise = noise, .outliers = outliers}, random);
          }};
}

DamagedScan cloud_without_bottom(const Body& body, double share, Random& random) {
  const Bounds box = bounds(body.mesh);
  const double level = std::lerp(box.low.z(), box.high.z(), share);
  return of_cloud(body, {.density = [=](const Vec3& p) { return p.z() < level ? 0.0 : 1.0; }},
                  random);
}

DamagedScan cloud_on_ground(const Body& body, double buried, Random& random) {
  const std::uint64_t seed = random.next_bits();
  const FieldGround ground(random.uniform(0.0, 0.2), 0.003, 6, 1.5, seed);
  const TriangleMesh standing = buried_at(body.mesh, 0.0, 0.0, buried, ground);
  const FieldCounts counts{.per_block = 8000, .ground = 16000, .noise = 0.001, .half = 1.5};
  TriangleMesh cloud;
  cloud.vertices = field_scene({standing}, ground, counts, seed + 1).points;
  return of(body, std::move(cloud), cloud_tolerance(8000, counts.noise));
}

std::vector<Kind> lost_kinds() {
  return {
      {"nothing", "", {0.0}, [](const Body& body, double, Random&) { return of(body, body.mesh); }},
      {"faces lost at random",
       "% of the faces",
       {1.0, 5.0, 10.0, 20.0, 30.0},
       [](const Body& body, double amount, Random& random) {
         return of(body, without_faces(body.mesh, kPercent * amount, random));
       }},
      {"vertices lost at random",
       "% of the vertices",
       {1.0, 5.0, 10.0},
       [](const Body& body, double amount, Random& random) {
         return of(body, without_vertices(body.mesh, kPercent * amount, random));
       }},
      {"clumps of faces lost",
       "clumps of up to 6 % of L",
       {3.0, 8.0, 20.0},
       [](const Body& body, double amount, Random& random) {
         const auto count = static_cast<std::size_t>(amount);
         return of(body, without_clumps(body.fine, count, 6.0 * kPercent, random));
       }},
      {"a patch lost",
       "% of L as radius",
       {5.0, 10.0, 20.0},
       [](const Body& body, double amount, Random& random) {
         return of(body, without_clumps(body.fine, 1, kPercent * amount, random));
       }},
      {"a side not seen",
       "degrees about its direction",
       {30.0, 45.0, 60.0},
       [](const Body& body, double amount, Random& random) {
         return of(body, without_side(body.fine, random.unit_vector(), kRadiansPerDegree * amount));
       }},
      {"cut by a plane",
       "% of the height",
       {5.0, 10.0, 20.0, 25.0, 30.0, 40.0, 50.0, 60.0},
       [](const Body& body, double amount, Random& random) {
         return of(body, cut_off(body.mesh, random.unit_vector(), kPercent * amount));
       }},
      {"cut by several planes",
       "planes, 5 to 20 % of the height each",
       {2.0, 3.0},
       [](const Body& body, double amount, Random& random) {
         TriangleMesh mesh = body.mesh;
         for (int i = 0; i < static_cast<int>(amount); ++i) {
           const double share = random.uniform(0.05, 0.2);
           mesh = cut_off(mesh, random.unit_vector(), share);
         }
         return of(body, std::move(mesh));
       }},
  };
}

std::vector<Kind> added_kinds() {
  constexpr double kWhole = std::numeric_limits<double>::infinity();
  return {
      {"doubled, one larger",
       "% larger",
       {0.5, 1.0, 2.0, 5.0},
       [](const Body& body, double amount, Random& random) {
         const double factor = 1.0 + kPercent * amount;
         return of_two(body, with_copy(body.mesh, factor, Vec3::Zero(), kWhole, random), factor);
       }},
      {"doubled, one moved",
       "% of L",
       {0.5, 1.0, 2.0, 5.0},
       [](const Body& body, double amount, Random& random) {
         const Vec3 shift = kPercent * amount * random.unit_vector();
         return of_two(body, with_copy(body.mesh, 1.0, shift, kWhole, random), 1.0);
       }},
      {"a patch doubled",
       "% of L off it",
       {-2.0, -0.5, 0.5, 2.0, 5.0},
       [](const Body& body, double amount, Random& random) {
         const double factor = 1.0 + 2.0 * kPercent * amount;  // about the middle of a side of L
         return of(body, with_copy(body.fine, factor, Vec3::Zero(), 0.25, random));
       }},
      {"two halves that overlap",
       "% of L between them",
       {0.1, 1.0},
       [](const Body& body, double amount, Random& random) {
         const Vec3 shift = kPercent * amount * random.unit_vector();
         TriangleMesh moved = body.mesh;
         const Vec3 direction = random.unit_vector();
         for (Vec3& v : moved.vertices) {
           if (v.dot(direction) < 0.0) v += shift;
         }
         return of(body, in_two_halves(body.fine, direction, 0.1, shift),
                   at_least_usual(effect(body.truth, truth_of(moved)), 2.0));
       }},
      {"faces stored twice",
       "% of the faces",
       {5.0, 30.0},
       [](const Body& body, double amount, Random& random) {
         return of(body, with_duplicates(body.mesh, kPercent * amount, random));
       }},
      {"faces flipped",
       "% of the faces",
       {5.0, 30.0, 50.0},
       [](const Body& body, double amount, Random& random) {
         return of(body, with_flipped_faces(body.mesh, kPercent * amount, random));
       }},
      {"faces that share no vertices",
       "of L between them",
       {1e-7, 1e-6},
       [](const Body& body, double amount, Random& random) {
         return of(body, as_soup(body.mesh, amount, random));
       }},
      {"islands beside it",
       "of up to 4 % of L",
       {1.0, 20.0},
       [](const Body& body, double amount, Random& random) {
         const auto count = static_cast<std::size_t>(amount);
         return of(body, with_islands(body.mesh, count, 4.0 * kPercent, random));
       }},
      {"bubbles inside",
       "of up to 3 % of L",
       {1.0, 5.0},
       [](const Body& body, double amount, Random& random) {
         const auto count = static_cast<std::size_t>(amount);
         return of(body, with_bubbles(body.mesh, count, 3.0 * kPercent, random));
       }},
      {"balls that cross the surface",
       "of 2 % of L",
       {1.0, 5.0},
       [](const Body& body, double amount, Random& random) {
         return of_crossing(body, 2.0 * kPercent, static_cast<std::size_t>(amount), random);
       }},
      {"spikes",
       "of up to 20 % of L",
       {1.0, 5.0},
       [](const Body& body, double amount, Random& random) {
         const auto count = static_cast<std::size_t>(amount);
         return of(body, with_spikes(body.fine, count, 20.0 * kPercent, random));
       }},
      {"a bad scan, all at once",
       "times the usual",
       {0.5, 1.0, 1.5},
       [](const Body& body, double amount, Random& random) {
         return of(body, damaged(body.fine, Damage::of_intensity(amount), random.next_bits()).mesh);
       }},
  };
}

std::vector<Kind> moved_kinds() {
  return {jitter_kind("vertices moved all ways", Jitter::kAllWays),
          jitter_kind("vertices moved along normals", Jitter::kAlongNormals),
          jitter_kind("vertices moved outward", Jitter::kOutward),
          jitter_kind("one-sided noise", Jitter::kOneSidedNoise)};
}

std::vector<Kind> cloud_kinds() {
  const auto uneven = [](auto&& density) {
    return [=](const Body& body, double amount, Random& random) {
      const Vec3 direction = random.unit_vector();
      return of_cloud(
          body,
          {.points = static_cast<std::size_t>(amount), .density = density(body.mesh, direction)},
          random);
    };
  };
  return {
      cloud_kind("cloud", {2000, 8000, 30000}, 0.0, 0.0),
      cloud_kind("cloud, noise of 0.2 % of L", {2000, 8000, 30000}, 0.002, 0.0),
      cloud_kind("cloud, noise of 0.5 % of L", {2000, 8000, 30000}, 0.005, 0.0),
      cloud_kind("cloud, 2 % outliers", {8000, 30000}, 0.0, 0.02),
      {"cloud, a third as dense on one side",
       "points",
       {8000, 30000},
       uneven([](const TriangleMesh& mesh, const Vec3& direction) {
         return falling_density(mesh, direction, 1.0 / 3.0);
       })},
      {"cloud, a twentieth as dense on one half",
       "points",
       {8000, 30000},
       uneven([](const TriangleMesh& mesh, const Vec3& direction) {
         return halved_density(mesh, direction, 1.0 / 20.0);
       })},
      {"cloud without its bottom",
       "% of the height",
       {5.0, 10.0, 25.0},
       [](const Body& body, double amount, Random& random) {
         return cloud_without_bottom(body, kPercent * amount, random);
       }},
      {"cloud on ground",
       "% of the height buried",
       {5.0, 15.0},
       [](const Body& body, double amount, Random& random) {
         return cloud_on_ground(body, kPercent * amount, random);
       }},
  };
}

}  // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> kAll = [] {
    std::vector<Kind> all;
    for (auto& some : {lost_kinds(), added_kinds(), moved_kinds(), cloud_kinds(), odd_kinds()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return kAll;
}

std::string Case::level() const {
  return kind->unit.empty() ? "" : format_significant(amount, 6) + " " + kind->unit;
}

std::string Case::name() const { return kind->name + ": " + level() + ": " + body->name; }

std::uint64_t Case::seed() const { return std::stoull(sha256(name()).substr(0, 16), nullptr, 16); }

DamagedScan Case::scan() const {
  Random random(seed());
  const Pose turn{Vec3::Zero(), random.rotation()};
  const Body turned{body->name, transformed(body->mesh, turn), transformed(body->fine, turn),
                    body->truth};
  return kind->make(turned, amount, random);
}

std::vector<Case> make_cases(const std::vector<Body>& bodies) {
  std::vector<Case> cases;
  for (const Kind& kind : kinds()) {
    for (const double amount : kind.amounts) {
      for (std::size_t i = 0; i < bodies.size(); i += kind.every) {
        cases.push_back({&kind, amount, &bodies[i]});
      }
    }
  }
  return cases;
}

}  // namespace clast::reliability
