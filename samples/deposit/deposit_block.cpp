#include "samples/deposit/deposit_block.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/parallel.hpp"
#include "massprops/principal_frame.hpp"
#include "massprops/sphero.hpp"
#include "mesh/decimation.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/weld.hpp"
#include "samples/rock_shapes.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/oriented_box.hpp"
#include "shapes/rounding.hpp"

namespace clast {
namespace {

constexpr double kSizeExponent = 2.0;   // of the number of larger blocks
constexpr double kTriangleArea = 0.73;  // of the detailed surface, squares of the spacing
constexpr int kCoreFrequency = 9;       // of the surface from which the core is decimated
constexpr double kCoreRounding = 0.03;  // Minkowski radius of the core over S
constexpr double kBound = 1.4;          // ellipsoid around a rock over its lengths
constexpr double kLeastNaturalSide =
    12.0;                                 // S of an isolated rock, spacings, so that it stands out
constexpr double kFinestRelief = 0.0125;  // m; octaves of the relief go down to this wavelength

/// Draws a number log-uniformly, so that a ratio and its inverse are equally likely.
double draw_ratio(double low, double high, Random& random) {
  return low * std::pow(high / low, random.uniform());
}

/// A kind of rock: ranges of L/I and S/I, and its recipe apart from size and seed.
struct RockKind {
  const char* name;
  double weight;
  double l_low, l_high;
  double s_low, s_high;
  RockRecipe recipe;
};

const std::vector<RockKind>& rock_kinds() {
  static const std::vector<RockKind> kKinds = {
      {"compact", 0.20, 1.02, 1.25, 0.80, 0.97, {.facets = 24}},
      {"platy", 0.12, 1.05, 1.30, 0.30, 0.48, {.facets = 24}},
      {"bladed", 0.16, 1.35, 1.80, 0.45, 0.68, {.facets = 24}},
      {"elongated", 0.12, 1.60, 2.20, 0.75, 0.92, {.facets = 24}},
      {"needle", 0.04, 2.50, 3.20, 0.70, 0.88, {.facets = 24}},
      {"cuboid", 0.11, 1.02, 1.50, 0.65, 0.97, {.joint_faces = 6, .facets = 8, .sharpness = 35.0}},
      {"angular", 0.08, 1.10, 1.60, 0.55, 0.90, {.facets = 12, .sharpness = 40.0}},
      {"rounded", 0.07, 1.05, 1.50, 0.65, 0.95, {.facets = 60, .sharpness = 7.0}},
      {"notched", 0.06, 1.05, 1.40, 0.65, 0.90, {.facets = 24, .notch = 0.3}},
      {"concave", 0.04, 1.05, 1.40, 0.65, 0.90, {.facets = 24, .notch = 0.6}}};
  return kKinds;
}

const RockKind& draw_kind(Random& random) {
  double left = random.uniform();
  for (const RockKind& kind : rock_kinds()) {
    left -= kind.weight;
    if (left < 0.0) return kind;
  }
  return rock_kinds().front();
}

/// Frequency of the geodesic sphere whose triangles have about the wanted area on an ellipsoid.
int surface_frequency(const Vec3& axes, double triangle_area) {
  // Area of an ellipsoid by Thomsen's formula.
  constexpr double kPower = 1.6075;
  const double a = std::pow(axes[0] / 2.0, kPower), b = std::pow(axes[1] / 2.0, kPower),
               c = std::pow(axes[2] / 2.0, kPower);
  const double area = 4.0 * kPi * std::pow((a * b + a * c + b * c) / 3.0, 1.0 / kPower);
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(area / (20.0 * triangle_area)))), 8, 120);
}

/// Larger blocks have more vertices, so that deviations of core and surface grow less than I.
std::size_t core_vertices(double size) {
  return static_cast<std::size_t>(
      std::clamp(30.0 * std::pow(size / kSmallestBlock, 0.7), 30.0, 110.0));
}

/// Makes the rounded core of a closed surface; a convex one if the surface is too thin or too
/// concave for the radius.
SpheroPolyhedron make_core(const TriangleMesh& surface, std::size_t vertices) {
  const TriangleMesh simple = decimate_mesh(surface, vertices);
  const double radius = kCoreRounding * smallest_box(simple.vertices).lengths[2];
  if (inspect_mesh(simple).is_closed()) {
    if (std::optional<SpheroPolyhedron> core = try_inset_core(simple, radius)) return *core;
  }
  return inset_core(convex_hull(simple.vertices), radius);
}

/// Size that a block is to have, m.
struct WantedSize {
  double intermediate = 1.0;  ///< I
  double least_side = 0.0;    ///< larger than that if S would be smaller than this
};

/// Completes a block from its surface and the coarse surface of the same frame. The coarse one
/// decides on scale and pose, so that a block is the same at any spacing.
VirtualBlock finish_block(std::string shape, TriangleMesh surface, const TriangleMesh& coarse,
                          const WantedSize& size) {
  VirtualBlock block;
  block.shape = std::move(shape);
  block.size = size.intermediate;
  const Vec3 sides = smallest_box(coarse.vertices).lengths;
  const double factor = std::max(size.intermediate / sides[1], size.least_side / sides[2]);
  const SpheroPolyhedron core = make_core(scaled(coarse, factor), core_vertices(size.intermediate));
  const MassProperties mass = sphero_mass_properties(core, kRockDensity, 1e-3);
  const PrincipalFrame frame = principal_frame(mass);
  const Pose body_from_surface = Pose{mass.centre, frame.rotation}.inverse();
  block.surface = transformed(scaled(std::move(surface), factor), body_from_surface);
  block.core.shape = transformed(core, body_from_surface);
  block.core.mass = mass.mass;
  block.core.moments = frame.moments;
  block.core.smallest_side = smallest_box(core).lengths[2];
  block.axes = smallest_box(block.surface.vertices).lengths;
  block.volume = signed_volume(block.surface);
  return block;
}

VirtualBlock make_rock(const WantedSize& size, double spacing, Random random) {
  const RockKind& kind = draw_kind(random);
  RockRecipe recipe = kind.recipe;
  recipe.lengths = size.intermediate * Vec3(draw_ratio(kind.l_low, kind.l_high, random), 1.0,
                                            draw_ratio(kind.s_low, kind.s_high, random));
  if (recipe.joint_faces == 0) recipe.bound = kBound;
  recipe.roughness = draw_ratio(0.008, 0.018, random);
  recipe.scan_noise = 0.0;
  const double longest_wave = 0.6 * std::cbrt(recipe.lengths.prod());
  recipe.octaves =
      std::max(1, static_cast<int>(std::ceil(std::log2(longest_wave / kFinestRelief))));
  recipe.seed = random.next_bits();
  recipe.frequency = kCoreFrequency;
  const TriangleMesh coarse = centred_rock(recipe);
  recipe.frequency = surface_frequency(recipe.lengths, kTriangleArea * spacing * spacing);
  return finish_block(kind.name, centred_rock(recipe), coarse, size);
}

/// A scan, decimated to what the spacing shows and stretched at random along its principal axes.
VirtualBlock make_stone(const StoneScan& scan, const WantedSize& size, double spacing,
                        Random random) {
  const OrientedBox box = smallest_box(scan.mesh.vertices);
  const Vec3 stretch(draw_ratio(0.85, 1.2, random), 1.0, draw_ratio(0.85, 1.2, random));
  const double mirror = random.uniform() < 0.5 ? -1.0 : 1.0;
  TriangleMesh mesh = scan.mesh;
  for (Vec3& vertex : mesh.vertices) {
    const Vec3 in_box = box.axes.transpose() * (vertex - box.centre) / box.lengths[1];
    vertex = size.intermediate * stretch.cwiseProduct(in_box);
    vertex.x() *= mirror;
  }
  if (mirror < 0.0) {
    for (TriangleMesh::Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  const double triangles = surface_area(mesh) / (kTriangleArea * spacing * spacing);
  const TriangleMesh surface =
      decimate_mesh(mesh, static_cast<std::size_t>(std::max(300.0, triangles / 2.0)));
  return finish_block(scan.name, surface, surface, size);
}

}  // namespace

std::vector<StoneScan> read_stone_scans(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = lower_case_extension(entry.path());
    const std::vector<std::string>& known = readable_mesh_extensions();
    if (std::find(known.begin(), known.end(), extension) != known.end()) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<StoneScan> scans;
  for (const std::filesystem::path& file : files) {
    const TriangleMesh read = read_mesh_or_points(file);
    if (read.triangles.empty()) continue;
    const TriangleMesh mesh = weld_vertices(read, 0.0);
    const MeshReport report = inspect_mesh(mesh);
    const bool sound = report.is_closed() && report.is_oriented() && report.components == 1 &&
                       report.degenerate_triangles == 0 && report.pinched_vertices == 0;
    if (sound && signed_volume(mesh) > 0.0) scans.push_back({file.stem().string(), mesh});
  }
  if (scans.empty()) throw InputError(folder + " has no closed mesh; name a folder with some");
  return scans;
}

std::vector<double> draw_block_sizes(std::size_t count, double size_ratio, Random& random) {
  const double least = std::pow(size_ratio, -kSizeExponent);
  std::vector<double> sizes(count);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double share =
        (static_cast<double>(i) + random.uniform()) / static_cast<double>(sizes.size());
    sizes[i] = kSmallestBlock * std::pow(1.0 - share * (1.0 - least), -1.0 / kSizeExponent);
  }
  for (std::size_t i = sizes.size(); i > 1; --i) {
    std::swap(sizes[i - 1], sizes[random.uniform_index(i)]);
  }
  return sizes;
}

std::vector<VirtualBlock> make_deposit_blocks(const DepositRecipe& recipe, std::size_t count,
                                              std::span<const StoneScan> scans, unsigned threads) {
  Random random(recipe.seed);
  const std::vector<double> sizes = draw_block_sizes(count, recipe.size_ratio, random);
  std::vector<std::uint64_t> seeds;
  for (std::size_t i = 0; i < sizes.size(); ++i) seeds.push_back(random.next_bits());
  const double least_side =
      recipe.kind == DepositKind::kNatural ? kLeastNaturalSide * recipe.spacing() : 0.0;
  std::vector<VirtualBlock> blocks(sizes.size());
  parallel_for(blocks.size(), threads, [&](std::size_t i) {
    const Random own(seeds[i]);
    const WantedSize size{sizes[i], least_side};
    blocks[i] = scans.empty() || i % 2 == 0
                    ? make_rock(size, recipe.spacing(), own)
                    : make_stone(scans[i / 2 % scans.size()], size, recipe.spacing(), own);
  });
  return blocks;
}

}  // namespace clast
