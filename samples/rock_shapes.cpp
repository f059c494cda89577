#include "samples/rock_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/random.hpp"

namespace clast {
namespace {

/// The icosahedron with every face cut into frequency^2 triangles, pushed out to the unit sphere.
TriangleMesh geodesic_sphere(int frequency) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  const std::array<Vec3, 12> corners = {Vec3(-1, g, 0),  Vec3(1, g, 0),   Vec3(-1, -g, 0),
                                        Vec3(1, -g, 0),  Vec3(0, -1, g),  Vec3(0, 1, g),
                                        Vec3(0, -1, -g), Vec3(0, 1, -g),  Vec3(g, 0, -1),
                                        Vec3(g, 0, 1),   Vec3(-g, 0, -1), Vec3(-g, 0, 1)};
  constexpr int kFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                 {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                 {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                 {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  TriangleMesh sphere;
  // A grid point is named by the corners it lies between and its whole-number weights on them.
  std::map<std::vector<std::pair<int, int>>, std::uint32_t> known;
  const auto vertex = [&](const int(&face)[3], int a, int b, int c) {
    std::vector<std::pair<int, int>> name;
    Vec3 point = Vec3::Zero();
    const int weights[3] = {a, b, c};
    for (int k = 0; k < 3; ++k) {
      if (weights[k] > 0) name.emplace_back(face[k], weights[k]);
    }
    std::sort(name.begin(), name.end());
    for (const auto& [corner, weight] : name) point += weight * corners[corner];
    const auto [entry, is_new] =
        known.emplace(name, static_cast<std::uint32_t>(sphere.vertices.size()));
    if (is_new) sphere.vertices.push_back(point.normalized());
    return entry->second;
  };
  for (const auto& face : kFaces) {
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        const int k = frequency - i - j;
        sphere.triangles.push_back(
            {vertex(face, k, i, j), vertex(face, k - 1, i + 1, j), vertex(face, k - 1, i, j + 1)});
        if (k < 2) continue;
        sphere.triangles.push_back({vertex(face, k - 1, i + 1, j),
                                    vertex(face, k - 2, i + 1, j + 1),
                                    vertex(face, k - 1, i, j + 1)});
      }
    }
  }
  return sphere;
}

/// The planes normal . p = distance that bound a block around the origin.
struct Facet {
  Vec3 normal;
  double distance;
};

std::vector<Facet> facets_of(const RockRecipe& recipe, Random& random) {
  const Vec3 half = recipe.lengths / 2.0;
  std::vector<Facet> facets;
  for (int i = 0; i < recipe.joint_faces; ++i) {
    const int axis = i / 2;
    Vec3 normal = (i % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(axis);
    normal += 0.08 * random.unit_vector();  // joint sets are never quite at right angles
    facets.push_back({normal.normalized(), half[axis]});
  }
  for (int i = 0; i < recipe.facets; ++i) {
    // Tangent to the ellipsoid of the wanted lengths, then moved: inwards it cuts a facet.
    const Vec3 on_sphere = random.unit_vector();
    const Vec3 normal = on_sphere.cwiseQuotient(half).normalized();
    const double support = normal.cwiseProduct(half).norm();
    const double moved =
        recipe.joint_faces > 0 ? random.uniform(1.12, 1.3) : random.uniform(0.86, 1.08);
    facets.push_back({normal, support * moved});
  }
  return facets;
}

/// Distance from the origin to the surface. The planes are joined by a p-norm, which rounds the
/// edges like wear does and stays a function of direction.
double facet_radius(const std::vector<Facet>& facets, const RockRecipe& recipe,
                    const Vec3& direction) {
  const double sharpness = recipe.sharpness;
  double sum = 0.0;
  if (recipe.bound > 0.0) {
    const Vec3 bounding_half = 0.5 * recipe.bound * recipe.lengths;
    sum = std::pow(direction.cwiseQuotient(bounding_half).norm(), sharpness);
  }
  for (const Facet& facet : facets) {
    const double inverse = facet.normal.dot(direction) / facet.distance;
    if (inverse > 0.0) sum += std::pow(inverse, sharpness);
  }
  return std::pow(sum, -1.0 / sharpness);
}

/// Surface relief: per octave a few plane waves of random direction and phase, halved in height
/// as the wavelength halves.
class Relief {
 public:
  Relief(double height, double longest_wave, int octaves, Random& random) {
    for (int octave = 0; octave < octaves; ++octave) {
      for (int i = 0; i < kWavesPerOctave; ++i) {
        waves_.push_back({2.0 * kPi / longest_wave * random.unit_vector(),
                          random.uniform(0.0, 2.0 * kPi),
                          height / std::sqrt(kWavesPerOctave / 2.0)});
      }
      longest_wave /= 2.0;
      height /= 2.0;
    }
  }
  double at(const Vec3& point) const {
    double sum = 0.0;
    for (const Wave& wave : waves_)
      sum += wave.height * std::cos(wave.vector.dot(point) + wave.phase);
    return sum;
  }

 private:
  static constexpr int kWavesPerOctave = 8;
  struct Wave {
    Vec3 vector;
    double phase;
    double height;
  };
  std::vector<Wave> waves_;
};

TriangleMesh centred_rock(const RockRecipe& recipe, Random& random) {
  const std::vector<Facet> facets = facets_of(recipe, random);
  const double mean_length = std::cbrt(recipe.lengths.prod());
  const Relief relief(recipe.roughness * mean_length, 0.6 * mean_length, recipe.octaves, random);
  TriangleMesh mesh = geodesic_sphere(recipe.frequency);
  for (Vec3& vertex : mesh.vertices) {
    // Directions follow the ellipsoid, so that triangles are of like size on a long block too.
    const Vec3 direction = vertex.cwiseProduct(recipe.lengths).normalized();
    double radius = facet_radius(facets, recipe, direction);
    if (recipe.notch > 0.0) {
      // A notch in one side: deepest on the plane x = 0, fading out behind the middle.
      const double across = direction.x() / 0.4;
      const double side = std::clamp(0.3 + 1.2 * direction.y(), 0.0, 1.0);
      radius *= 1.0 - recipe.notch * side * std::exp(-std::pow(across, 4));
    }
    radius += relief.at(radius * direction) + recipe.scan_noise * random.normal();
    vertex = radius * direction;
  }
  return mesh;
}

}  // namespace

TriangleMesh centred_rock(const RockRecipe& recipe) {
  Random random(recipe.seed);
  return centred_rock(recipe, random);
}

TriangleMesh rock(const RockRecipe& recipe) {
  Random random(recipe.seed);
  TriangleMesh mesh = centred_rock(recipe, random);
  const Pose place{{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), 1.0}, random.rotation()};
  return transformed(std::move(mesh), place);
}

const std::vector<RockRecipe>& sample_recipes() {
  static const std::vector<RockRecipe> kRecipes = {
      {.name = "B01_compact", .lengths = {0.80, 0.72, 0.66}, .seed = 101},
      {.name = "B02_platy", .lengths = {1.00, 0.92, 0.36}, .frequency = 11, .seed = 102},
      {.name = "B03_bladed", .lengths = {1.05, 0.70, 0.38}, .seed = 103},
      {.name = "B04_elongated", .lengths = {1.05, 0.50, 0.43}, .seed = 104},
      {.name = "B05_very_elongated", .lengths = {1.50, 0.46, 0.35}, .frequency = 11, .seed = 105},
      {.name = "B06_cuboid",
       .lengths = {0.46, 0.37, 0.28},
       .joint_faces = 6,
       .facets = 10,
       .sharpness = 30.0,
       .frequency = 9,
       .seed = 106},
      {.name = "B07_concave",
       .lengths = {1.20, 1.05, 0.62},
       .notch = 0.6,
       .roughness = 0.006,
       .frequency = 12,
       .seed = 137}};
  return kRecipes;
}

RockRecipe make_fine_recipe() {
  RockRecipe recipe = sample_recipes().front();
  recipe.name = "B01_fine";
  recipe.frequency = 16;
  return recipe;
}

}  // namespace clast
