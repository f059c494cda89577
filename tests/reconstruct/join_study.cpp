#include "tests/reconstruct/join_study.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "mesh/geodesic_sphere.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "mesh/weld.hpp"
#include "reconstruct/joined_scan.hpp"
#include "reconstruct/registration/detail/disagreement.hpp"
#include "reconstruct/repair/components.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/reconstruct/reference_meshes.hpp"
#include "tests/support/partial_scans.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/strips.hpp"

namespace clast {
namespace {

const std::vector<std::string> kStones = {
    "chrono_curiosity_rock1.obj", "chrono_offroad_rock4.obj", "eesd_S02.stl",
    "eesd_stone01.stl",           "eesd_stone14.stl",         "eesd_stone15.stl",
    "eesd_stone18.stl",           "eesd_test_stone.stl",      "eros007790.tab",
    "rockable_rock.stl",          "ryugu_test.obj",           "ibois_stone_0.ply"};

/// A rock that is made for the study.
struct MadeRock {
  Vec3 half_axes;
  double bumps;               ///< see `rock_mesh`; 0: a hull of random points, with flat faces
  double hollow_depth = 0.0;  ///< of two hollows, as a fraction of the radius
};

const std::vector<MadeRock> kMadeRocks = {
    {{0.5, 0.4, 0.1}, 0.12},      {{0.5, 0.14, 0.12}, 0.12},    {{0.5, 0.4, 0.3}, 0.06},
    {{0.5, 0.35, 0.3}, 0.3},      {{0.5, 0.45, 0.06}, 0.15},    {{0.5, 0.1, 0.08}, 0.15},
    {{0.5, 0.4, 0.35}, 0.1, 0.5}, {{0.5, 0.3, 0.25}, 0.2, 0.4}, {{0.5, 0.38, 0.3}, 0.0},
    {{0.5, 0.3, 0.2}, 0.0}};

TriangleMesh make_rock(const MadeRock& recipe, std::uint64_t seed) {
  Random random(seed);
  if (recipe.bumps == 0.0) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 24; ++i) {
      corners.push_back(random.unit_vector().cwiseProduct(recipe.half_axes));
    }
    return convex_hull(corners);
  }
  TriangleMesh rock = rock_mesh(20, recipe.half_axes, seed, recipe.bumps);
  for (int i = 0; i < 2 && recipe.hollow_depth > 0.0; ++i) {
    const Vec3 towards = random.unit_vector();
    for (Vec3& v : rock.vertices) {
      const double apart = 1.0 - towards.dot(v.cwiseQuotient(recipe.half_axes).normalized());
      v *= 1.0 - recipe.hollow_depth * std::exp(-10.0 * apart);
    }
  }
  return rock;
}

/// A body of about one metre.
TriangleMesh make_body(std::size_t number) {
  const std::size_t kind = number % (kStones.size() + kMadeRocks.size());
  TriangleMesh mesh;
  if (kind < kStones.size()) {
    mesh = weld_vertices(read_mesh(data_file("meshes/" + kStones[kind])), 0.0);
    // Bubbles inside a stone are filled in blocks.
    mesh = std::move(reconstruct_detail::connected_components(mesh).front().mesh);
    if (signed_volume(mesh) < 0.0) flip_orientation(mesh);
  } else {
    mesh = make_rock(kMadeRocks[kind - kStones.size()], number + 1);
  }
  return scaled(mesh, 1.0 / bounds(mesh).diagonal());
}

/// A hull of points on two polygons, one above the other.
TriangleMesh make_prism(int corners, double radius, double height) {
  std::vector<Vec3> points;
  for (int i = 0; i < corners; ++i) {
    const double azimuth = 2.0 * kPi * i / corners;
    for (const double z : {0.0, height}) {
      points.push_back(Vec3(radius * std::cos(azimuth), radius * std::sin(azimuth), z));
    }
  }
  return convex_hull(points);
}

/// An ellipsoid, cut off below a height.
TriangleMesh make_ellipsoid(const Vec3& half_axes, double lowest = -1.0) {
  TriangleMesh ball = geodesic_sphere(30);
  for (Vec3& v : ball.vertices) v = Vec3(v.x(), v.y(), std::max(v.z(), lowest));
  for (Vec3& v : ball.vertices) v = v.cwiseProduct(half_axes);
  return convex_hull(ball.vertices);
}

/// A body that fits itself in several poses.
TriangleMesh make_symmetric_body(std::size_t number) {
  switch (number % 10) {
    case 0:
      return make_ellipsoid({0.5, 0.5, 0.5});
    case 1:
      return make_prism(4, 0.5, 0.5 * std::sqrt(2.0));
    case 2:
      return make_ellipsoid({0.5, 0.5, 0.3});
    case 3:
      return make_ellipsoid({0.5, 0.4, 0.3});
    case 4:
      return make_prism(4, 0.5, 0.4);
    case 5:
      return make_prism(6, 0.5, 0.6);
    case 6:
      return make_prism(3, 0.5, 0.5);
    case 7:
      return make_ellipsoid({0.5, 0.4, 0.4}, 0.0);
    case 8:
      return make_prism(48, 0.4, 0.8);
    default: {
      TriangleMesh box = make_prism(4, 0.5, 0.6);
      for (Vec3& v : box.vertices) v = Quat(Eigen::AngleAxisd(kPi / 4.0, Vec3::UnitZ())) * v;
      for (Vec3& v : box.vertices) v.y() *= 0.7;
      return box;
    }
  }
}

/// True if the class of the axes is that of the true axes within 1 %.
bool has_class(const Vec3& found, const Vec3& truth) {
  const auto of = [](const Vec3& l) { return sneed_folk_class({l[0], l[1], l[2]}); };
  const std::string own = of(found);
  for (int i = 0; i < 27; ++i) {
    const Vec3 varied = truth.cwiseProduct(
        Vec3(1.0 + 0.01 * (i % 3 - 1), 1.0 + 0.01 * (i / 3 % 3 - 1), 1.0 + 0.01 * (i / 9 - 1)));
    if (varied[0] >= varied[1] && varied[1] >= varied[2] && of(varied) == own) return true;
  }
  return false;
}

JoinRow judge(const JoinedScan& joined, const TriangleMesh& body, bool fits) {
  const double volume = signed_volume(body);
  const Vec3 sides = smallest_box(body.vertices).lengths;
  const TriangleMesh& mesh = joined.block.scan.mesh;
  const double found = signed_volume(mesh);
  const Vec3 found_sides = smallest_box(mesh.vertices).lengths;
  const Vec3 off = found_sides.cwiseQuotient(sides) - Vec3::Ones();
  const double volume_off = found / volume - 1.0;
  double low = found, high = found;
  if (joined.block.bounds) {
    low = joined.block.bounds->lower_volume;
    high = joined.block.bounds->upper_volume.value_or(1e300);
  }
  const bool held = low <= volume && volume <= high;
  const bool near = std::abs(volume_off) <= 0.01;
  const bool right = near && off.cwiseAbs().maxCoeff() <= 0.01 && has_class(found_sides, sides);
  JoinRow row;
  row.outcome = !fits ? "wrong" : right ? "right" : held ? "bracketed" : near ? "near" : "wrong";
  std::ostringstream text;
  text << volume_off << ',' << off[0] << ',' << off[1] << ',' << off[2] << ',' << low / volume
       << ',' << high / volume << ',' << joined.registration.overlap << ','
       << joined.registration.disagreeing_fraction << ',';
  if (joined.block.bounds && joined.block.bounds->sides) {
    const BoxSideBounds& side_bounds = *joined.block.bounds->sides;
    for (int k = 0; k < 3; ++k)
      text << side_bounds.lower[k] / sides[k] << ',' << side_bounds.upper[k] / sides[k] << ',';
  }
  row.text = text.str();
  return row;
}

PartialScanRecipe study_recipe(std::size_t points, Random& random) {
  PartialScanRecipe recipe;
  recipe.points = points;
  recipe.noise = random.uniform(0.001, 0.003);
  recipe.ground_points = 0.3;
  recipe.sunk = random.uniform(0.0, 0.02);
  return recipe;
}

constexpr std::size_t kFewPoints = 5000, kManyPoints = 15000;

JoinRow refused(const std::string& start, std::string reason) {
  for (char& c : reason) c = c == ',' || c == '\n' ? ';' : c;
  return {"refused", start + "refused,,,,,,,,," + reason};
}

/// Joins scans in their order and compares the result with the body.
JoinRow join_and_judge(const std::string& start, const std::vector<PartialScan>& scans,
                       const TriangleMesh& body, bool fits) {
  const std::vector<std::string> names = {"top",   "bottom", "third",   "fourth",
                                          "fifth", "sixth",  "seventh", "eighth"};
  std::vector<ScanToJoin> joining;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    joining.push_back({names[i], {scans[i].points, {}}, {}});
  }
  try {
    JoinRow row = judge(join_scans(joining, "B", {}, {.threads = 0}), body, fits);
    row.text = start + row.outcome + ',' + row.text;
    return row;
  } catch (const Error& error) {
    return refused(start, error.what());
  }
}

std::string start_of(const std::string& kind, std::size_t number, double overlap) {
  std::ostringstream start;
  start << kind << ',' << number << ',' << overlap << ',';
  return start.str();
}

JoinRow run_pair(const std::string& kind, std::size_t number, Random& random) {
  const bool symmetric = kind == "symmetric";
  const TriangleMesh body = symmetric ? make_symmetric_body(number) : make_body(number);
  const PartialScanner scanner(body);
  PartialScanRecipe a, b;
  a.points = b.points = kFewPoints;
  (random.uniform() < 0.5 ? a : b).points = kManyPoints;
  for (PartialScanRecipe* recipe : {&a, &b}) *recipe = study_recipe(recipe->points, random);
  const bool fits = kind == "same" || kind == "little" || symmetric;
  const double least = kind == "little" ? 0.1 : 0.3, most = kind == "little" ? 0.2 : 0.6;
  ScanPair pair = make_scan_pair(scanner, a, b, least, most, random);
  if (kind == "mirrored") {
    for (Vec3& p : pair.second.points) p.x() = -p.x();
  } else if (kind == "scaled") {
    for (Vec3& p : pair.second.points) p *= 1.02;
  } else if (kind == "other") {
    const TriangleMesh second = make_body(number + 1 + number / 7 % 5);
    pair.second = make_scan_pair(PartialScanner(second), a, b, least, most, random).second;
  }
  return join_and_judge(start_of(kind, number, pair.overlap), {pair.first, pair.second}, body,
                        fits);
}

JoinRow run_several(const std::string& kind, std::size_t count, std::size_t number,
                    Random& random) {
  const TriangleMesh body = make_body(number);
  const std::size_t dense = random.uniform_index(count);
  std::vector<PartialScanRecipe> recipes;
  for (std::size_t i = 0; i < count; ++i) {
    recipes.push_back(study_recipe(i == dense ? kManyPoints : kFewPoints, random));
  }
  const ScanChain chain = make_scan_chain(PartialScanner(body), recipes, 0.3, 0.6, random);
  return join_and_judge(start_of(kind, number, chain.overlap), chain.scans, body, true);
}

JoinRow run_strips(const std::string& kind, std::size_t number, Random& random) {
  const TriangleMesh body = make_body(number);
  StripRecipe recipe;
  recipe.passes = 2 + random.uniform_index(3);
  recipe.shift = random.uniform(0.005, 0.03);
  recipe.rotation = random.uniform(0.0, 0.5) * kPi / 180.0;
  recipe.overlap = random.uniform(0.5, 1.0);
  const StripScan strips = make_strips(body, recipe, random);
  FieldScanOptions options;
  options.find_ground = false;
  std::ostringstream start;
  start << kind << ',' << number << ',' << recipe.shift << ',';
  try {
    const std::optional<JoinedScan> aligned =
        align_passes({"strips", {strips.points, {}}, {}},
                     kind == "sources" ? strips.passes : std::vector<std::uint32_t>{}, "B", options,
                     {.threads = 0});
    if (!aligned) return refused(start.str(), "no second pass found");
    JoinRow row = judge(*aligned, body, true);
    row.text = start.str() + row.outcome + ',' + row.text;
    return row;
  } catch (const Error& error) {
    return refused(start.str(), error.what());
  }
}

/// Estimates a scale from the true pose and a scale that is up to 3 % off.
JoinRow run_scale(std::size_t number, Random& random) {
  using namespace reconstruct_detail;
  const TriangleMesh body = make_body(number);
  const bool little = random.uniform() < 0.5;
  PartialScanRecipe a = study_recipe(kFewPoints, random), b = study_recipe(kManyPoints, random);
  a.ground_points = b.ground_points = a.sunk = b.sunk = 0.0;
  const ScanPair pair =
      make_scan_pair(PartialScanner(body), a, b, little ? 0.1 : 0.3, little ? 0.2 : 0.6, random);
  const double cell =
      std::max(registration_cell(pair.first.points), registration_cell(pair.second.points));
  const SampledSurface first(orient_surface(pair.first.points, cell, {}));
  const SampledSurface second(orient_surface(pair.second.points, cell, {}));
  const Similarity near{pair.first.scan_from_block * pair.second.scan_from_block.inverse(),
                        random.uniform(0.97, 1.03)};
  const ScaleEstimate found = estimate_scale({{&first, {}}}, {&second, near});
  const double off = found.scale - 1.0;
  const bool is_close = std::abs(off) <= 0.005;
  const bool held = std::abs(off) <= 1.96 * found.standard_error;
  JoinRow row;
  row.outcome = is_close ? (held ? "right" : "near") : held ? "bracketed" : "wrong";
  std::ostringstream text;
  text << start_of("scale", number, pair.overlap) << row.outcome << ',' << off << ','
       << found.standard_error << ',';
  row.text = text.str();
  return row;
}

}  // namespace

const std::vector<JoinKind>& join_kinds() {
  static const std::vector<JoinKind> kKinds = {
      {"same", 's', 2},     {"little", 'l', 2},  {"other", 'o', 2},  {"mirrored", 'm', 2},
      {"scaled", 's', 2},   {"three", 300, 1},   {"four", 400, 0},   {"five", 500, 0},
      {"eight", 800, 0},    {"sources", 600, 2}, {"strips", 700, 2}, {"scale", 900, 4},
      {"symmetric", 200, 2}};
  return kKinds;
}

JoinRow run_join_case(const JoinKind& kind, std::size_t number, std::uint64_t base) {
  Random random(base + 1000 * number + kind.seed);
  if (kind.name == "three") return run_several(kind.name, 3, number, random);
  if (kind.name == "four") return run_several(kind.name, 4, number, random);
  if (kind.name == "five") return run_several(kind.name, 5, number, random);
  if (kind.name == "eight") return run_several(kind.name, 8, number, random);
  if (kind.name == "sources" || kind.name == "strips") return run_strips(kind.name, number, random);
  if (kind.name == "scale") return run_scale(number, random);
  return run_pair(kind.name, number, random);
}

}  // namespace clast
