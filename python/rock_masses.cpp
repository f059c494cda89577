// Rock masses cut into blocks: what `clast cut` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "core/error.hpp"
#include "library/library_update.hpp"
#include "library/mass_file.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/watched_call.hpp"

namespace clast::python_detail {

namespace py = pybind11;

namespace {

/// What is asked of a cut.
struct CutRequest {
  MassFile file;
  MassBlockOptions options;
  std::optional<std::filesystem::path> output;  ///< library; none: nothing is written
  bool replace = false;
};

CutRequest request_from(Keywords& given) {
  CutRequest request;
  for (const std::string& joints : given.texts("joints")) {
    request.options.joints.push_back(read_joint_set(joints));
  }
  given.take("mass", request.file.path);
  given.take("units", request.file.units);
  given.take("up", request.file.up);
  given.take("output", request.output);
  given.take("replace", request.replace);
  given.take("prefix", request.options.prefix);
  given.take("seed", request.options.cutting.seed);
  given.take("least_volume", request.options.cutting.least_volume);
  given.take("most_blocks", request.options.cutting.most_blocks);
  given.take("density", request.options.block.density);
  given.take("radius_share", request.options.block.radius_share);
  given.take("threads", request.options.threads);
  given.done();
  check_block_id(request.options.prefix + "0001");
  request.options.block.check();
  return request;
}

/// (blocks, volume of the mass, volume of the blocks, why pieces became no block)
py::tuple cut(const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  CutRequest request = request_from(given);
  const MassBlocks made = watched(progress, [&](const Progress& step) {
    if (request.output) check_library_place(*request.output);
    request.options.progress = step;
    MassBlocks blocks = blocks_of_mass_file(request.file, request.options);
    if (blocks.blocks.empty()) {
      throw GeometryError(request.file.path.string() +
                          ": no piece became a block; the first: " + blocks.failed.front());
    }
    if (request.output) {
      update_library(*request.output, {.make = true}, [&](BlockLibrary& library) {
        for (const Block& block : blocks.blocks) library.add(block, request.replace);
      });
    }
    return blocks;
  });
  py::list blocks;
  for (const Block& block : made.blocks) blocks.append(std::make_shared<Block>(block));
  return py::make_tuple(blocks, made.volume, made.block_volume, made.failed);
}

}  // namespace

void bind_rock_masses(py::module_& module) { module.def("cut", &cut); }

}  // namespace clast::python_detail
