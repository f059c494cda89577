#include "tests/app/reliability/bodies.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "massprops/solid.hpp"
#include "reconstruct/scan.hpp"
#include "reconstruct/simplify.hpp"
#include "samples/rock_shapes.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/reference_data.hpp"

namespace clast::reliability {

namespace {

constexpr std::size_t kMaxVertices = 2000;
constexpr std::size_t kFineTriangles = 1500;
constexpr double kSameVolume = 1e-3;  ///< relative, of a mesh and its row of the reference table

/// Every triangle cut into four at the middles of its edges: the same surface.
TriangleMesh cut_in_four(const TriangleMesh& mesh) {
  TriangleMesh result{mesh.vertices, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, fresh] = middles.try_emplace(
        {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(result.vertices.size()));
    if (fresh) result.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    return entry->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const TriangleMesh::Triangle& t :
         {TriangleMesh::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      result.triangles.push_back(t);
    }
  }
  return result;
}

Body body_of(const std::string& name, TriangleMesh mesh) {
  if (mesh.vertices.size() > kMaxVertices) {
    mesh = simplify_mesh(mesh, {.target_vertices = kMaxVertices});
  }
  const OrientedBox box = smallest_box(mesh.vertices);
  for (Vec3& v : mesh.vertices) v = (v - box.centre) / box.lengths[0];
  Body body{name, mesh, mesh, truth_of(mesh)};
  while (body.fine.triangles.size() < kFineTriangles) body.fine = cut_in_four(body.fine);
  return body;
}

/// @param reference  volume in the file's units; 0: none is known
Body real_body(const std::string& file, double reference) {
  const Scan scan = read_scan(test_data(file));
  const double volume = signed_volume(scan.mesh);
  if (reference > 0.0 && std::abs(volume / reference - 1.0) > kSameVolume) {
    throw InputError(file + " has the volume " + std::to_string(volume) + " and not " +
                     std::to_string(reference) + " as in the reference table");
  }
  return body_of(std::filesystem::path(file).stem().string(), scan.mesh);
}

std::vector<RockRecipe> made_recipes() {
  std::vector<RockRecipe> recipes = sample_recipes();
  for (const RockRecipe& further :
       {RockRecipe{.name = "plate", .lengths = {1.0, 0.85, 0.12}, .frequency = 12, .seed = 201},
        RockRecipe{.name = "needle", .lengths = {1.0, 0.15, 0.12}, .frequency = 12, .seed = 202},
        RockRecipe{.name = "blade", .lengths = {1.0, 0.45, 0.15}, .frequency = 12, .seed = 203},
        RockRecipe{.name = "cube",
        .lengths = {0.8, 0.8, 0.8},
        .joint_faces = 6,
        .facets = 0,
        .sharpness = 60.0,
        .frequency = 12,
        .seed = 204},
        RockRecipe{.name = "deep_notch",
        .lengths = {1.0, 0.9, 0.8},
        .notch = 0.75,
        .frequency = 12,
        .seed = 205},
        RockRecipe{.name = "notched_plate",
        .lengths = {1.0, 0.8, 0.25},
        .notch = 0.5,
        .frequency = 12,
        .seed = 206},
        RockRecipe{.name = "boulder",
        .lengths = {1.0, 0.9, 0.8},
        .facets = 60,
        .sharpness = 8.0,
        .roughness = 0.02,
        .seed = 207}}) {
    recipes.push_back(further);
  }
  return recipes;
}

}  // namespace

Truth truth_of(const TriangleMesh& closed) {
  const Vec3 sides = smallest_box(closed.vertices).lengths;
  return {signed_volume(closed), {sides[0], sides[1], sides[2]}};
}

std::vector<Body> make_bodies() {
  std::vector<std::pair<std::string, double>> files;
  for (const ReferenceRow& row : mesh_reference()) {
    if (row.at("kind") != "mesh" || row.at("boundary_edges") != "0") continue;
    // Bubbles and slivers are no part of the block.
    const bool several = !row.at("largest_component_volume").empty();
    files.emplace_back("meshes/" + row.at("file"),
                       value(row, several ? "largest_component_volume" : "volume"));
  }
  for (const char* name : {"SP1A", "SP2A", "SP2B", "SP3A"}) {
    files.emplace_back(std::string("authume/blocks/") + name + ".stl", 0.0);
  }
  const std::vector<RockRecipe> recipes = made_recipes();
  std::vector<Body> bodies(files.size() + recipes.size());
  parallel_for(bodies.size(), 0, [&](std::size_t i) {
    bodies[i] = i < files.size()
                    ? real_body(files[i].first, files[i].second)
                    : body_of(recipes[i - files.size()].name, rock(recipes[i - files.size()]));
  });
  return bodies;
}

}  // namespace clast::reliability
