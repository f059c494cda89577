#include "samples/rock_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "mesh/geodesic_sphere.hpp"

namespace clast {
namespace {

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
