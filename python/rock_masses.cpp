// Rock masses cut into blocks: what `clast cut` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "library/library_update.hpp"
#include "library/rock_mass_file.hpp"
#include "mesh/mesh_io.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/watched_call.hpp"
#include "study/campaign/released_blocks.hpp"

namespace clast::python_detail {

namespace py = pybind11;

namespace {

struct CutRequest {
  RockMassFile file;  ///< of a closed mesh; empty: the difference of two terrains
  BeforeAfterTerrains terrains;
  ReleasedMassOptions difference;
  std::optional<std::filesystem::path> scar;  ///< mesh of the difference
  RockMassOptions options;
  std::optional<std::filesystem::path> output;  ///< library; none: nothing is written
  bool replace = false;
};

CutRequest cut_request(Keywords& given) {
  CutRequest request;
  for (const std::string& joints : given.read_texts("joints")) {
    request.options.joints.push_back(parse_joint_set(joints));
  }
  given.read("mass", request.file.path);
  for (const std::string& file : given.read_texts("before"))
    request.terrains.before.emplace_back(file);
  for (const std::string& file : given.read_texts("after"))
    request.terrains.after.emplace_back(file);
  given.read("min_thickness", request.difference.min_thickness);
  given.read("polygon", request.difference.polygon);
  given.read("bodies", request.difference.bodies);
  given.read("resolution", request.difference.resolution);
  given.read("scar", request.scar);
  given.read("units", request.file.units);
  given.read("up", request.file.up);
  request.terrains.up = request.file.up;
  given.read("output", request.output);
  given.read("replace", request.replace);
  given.read("prefix", request.options.prefix);
  given.read("seed", request.options.cutting.seed);
  given.read("least_volume", request.options.cutting.min_volume);
  given.read("most_blocks", request.options.cutting.max_blocks);
  given.read("density", request.options.block.density);
  given.read("radius_share", request.options.block.radius_fraction);
  given.read("threads", request.options.threads);
  given.check_all_used();
  check_block_id(request.options.prefix + "0001");
  request.options.block.check();
  request.difference.min_volume = request.options.cutting.min_volume;
  request.difference.check();
  const bool both = !request.terrains.before.empty() && !request.terrains.after.empty();
  const bool none = request.terrains.before.empty() && request.terrains.after.empty();
  if (request.file.path.empty() ? !both : !none) {
    throw InputError("give a closed mesh of the mass, or both before and after");
  }
  if (request.scar && !both) throw InputError("scar applies to the mass between before and after");
  return request;
}

/// The mass between two terrains, written where asked, and its blocks where there are joints.
RockMassBlocks blocks_between(const CutRequest& request) {
  OverwritePolicy rules{.replace = request.replace};
  if (request.scar) {
    rules.kind = file_kind_by_extension(*request.scar);
    check_mesh_output(*request.scar, rules);
  }
  const ReleasedMass mass = read_released_mass(request.terrains, request.difference);
  if (request.scar) write_mesh(*request.scar, make_released_mass_mesh(mass), {.rules = rules});
  if (!request.options.joints.empty() || !request.scar) {
    return cut_released_mass(mass, request.terrains, request.difference, request.options);
  }
  RockMassBlocks uncut;
  uncut.volume = mass.volume();
  return uncut;
}

/// (blocks, volume of the mass, volume of the blocks, why pieces became no block)
py::tuple cut(const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  CutRequest request = cut_request(given);
  const RockMassBlocks made = run_with_progress(progress, [&](const ProgressCallback& step) {
    if (request.output) check_library_writable(*request.output);
    request.options.progress = step;
    const bool mesh = !request.file.path.empty();
    RockMassBlocks blocks =
        mesh ? cut_rock_mass_file(request.file, request.options) : blocks_between(request);
    if (request.options.joints.empty()) return blocks;
    if (blocks.blocks.empty()) {
      throw GeometryError((mesh ? request.file.path : request.terrains.before.front()).string() +
                          ": no piece became a block; first reason: " + blocks.failures.front());
    }
    if (request.output) {
      update_library(*request.output, {.create_if_missing = true}, [&](BlockLibrary& library) {
        for (const Block& block : blocks.blocks) library.add(block, request.replace);
      });
    }
    return blocks;
  });
  py::list blocks;
  for (const Block& block : made.blocks) blocks.append(std::make_shared<Block>(block));
  return py::make_tuple(blocks, made.volume, made.block_volume, made.failures);
}

}  // namespace

void bind_rock_masses(py::module_& module) { module.def("cut", &cut); }

}  // namespace clast::python_detail
