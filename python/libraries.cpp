// Block libraries, and what a library is written to.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <map>

#include "core/error.hpp"
#include "core/files/output_folder.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "library/block_export.hpp"
#include "library/block_ranges.hpp"
#include "library/library_update.hpp"
#include "particles/particle_export.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/watched_call.hpp"
#include "report/blocks/gallery.hpp"
#include "report/particle_report.hpp"

namespace clast::python_detail {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

/// Blocks that Python shares.
using Blocks = std::vector<std::shared_ptr<Block>>;

Blocks shared_blocks(const BlockLibrary& library) {
  Blocks blocks;
  for (const Block& block : library.blocks()) blocks.push_back(std::make_shared<Block>(block));
  return blocks;
}

Blocks read_blocks(const fs::path& path) {
  return run_without_gil([&] { return shared_blocks(BlockLibrary::read(path)); });
}

Blocks change(const fs::path& path, bool make, const std::function<void(BlockLibrary&)>& how) {
  return run_without_gil(
      [&] { return shared_blocks(update_library(path, {.create_if_missing = make}, how)); });
}

Blocks add(const fs::path& path, const Blocks& added, bool replace) {
  return change(path, true, [&](BlockLibrary& library) {
    for (const std::shared_ptr<Block>& block : added) library.add(*block, replace);
  });
}

Blocks remove(const fs::path& path, const std::vector<std::string>& ids) {
  return change(path, false, [&](BlockLibrary& library) {
    for (const std::string& id : ids) library.find_block(id);  // all are there, or none is removed
    for (const std::string& id : ids) library.remove(id);
  });
}

Blocks set_notes(const fs::path& path, const std::string& id, const py::dict& keywords) {
  Keywords given(keywords);
  std::optional<std::string> site, note;
  std::optional<double> weighed;
  std::optional<std::array<double, 3>> taped;
  given.read("site", site);
  given.read("note", note);
  given.read("weighed", weighed);
  given.read("taped", taped);
  given.check_all_used();
  if (!site && !note && !weighed && !taped) {
    throw InputError("nothing to set; give site, note, taped or weighed");
  }
  if (weighed && !kBlockMassRange.contains(*weighed)) {
    throw InputError("weighed = " + format_significant(*weighed, 6) + " must be " +
                     kBlockMassRange.describe());
  }
  std::optional<Axes> axes;
  if (taped) {
    for (const double length : *taped) {
      if (kBlockLengthRange.contains(length)) continue;
      throw InputError("taped: " + format_significant(length, 6) + " must be " +
                       kBlockLengthRange.describe());
    }
    axes = Axes::sorted((*taped)[0], (*taped)[1], (*taped)[2]);
  }
  return change(path, false, [&](BlockLibrary& library) {
    FieldNotes& field = library.find_block(id).field;
    if (site) field.site = to_utf8(*site);
    if (note) field.note = to_utf8(*note);
    if (axes) field.taped_axes = axes;
    if (weighed) field.weighed_mass = weighed;
  });
}

std::vector<const Block*> pointers(const Blocks& blocks) {
  std::vector<const Block*> all;
  for (const std::shared_ptr<Block>& block : blocks) all.push_back(block.get());
  return all;
}

template <class Value>
void take_choice(Keywords& given, const char* name, const std::map<std::string, Value>& choices,
                 Value& field) {
  std::optional<std::string> chosen;
  given.read(name, chosen);
  if (!chosen) return;
  const auto found = choices.find(*chosen);
  if (found == choices.end()) {
    std::string known;
    for (const auto& [choice, value] : choices) known += (known.empty() ? "" : ", ") + choice;
    throw InputError(std::string(name) + " = \"" + *chosen + "\" must be one of " + known);
  }
  field = found->second;
}

ShapeErrors take_errors(Keywords& given) {
  ShapeErrors errors = ClumpOptions().error;
  std::map<std::string, double> limits;
  given.read("error", limits);
  for (const auto& [name, limit] : limits) {
    double* const field = name == "volume"    ? &errors.volume
                          : name == "inertia" ? &errors.inertia
                          : name == "surface" ? &errors.surface
                                              : nullptr;
    if (field == nullptr) {
      throw InputError("error: \"" + name + "\" must be one of volume, inertia, surface");
    }
    *field = limit;
  }
  return errors;
}

/// (number of blocks written, number kept, messages on blocks that were left out)
py::tuple export_as_particles(const Blocks& blocks, const fs::path& folder,
                              const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  ParticleExportOptions options;
  given.read("to", options.engine);
  options.clump.error = take_errors(given);
  std::optional<std::string> shape;
  given.read("shape", shape);
  if (shape) options.shape = find_particle_shape(*shape);
  given.read("max_spheres", options.clump.max_balls);
  given.read("equal_spheres", options.clump.balls);
  given.read("levels", options.levels);
  given.read("smallest_sphere", options.clump.smallest_sphere);
  given.read("parts", options.max_parts);
  given.read("part_vertices", options.max_part_vertices);
  given.read("hull", options.hull);
  given.read("replace", options.replace);
  given.read("threads", options.threads);
  std::optional<fs::path> pages;
  given.read("report", pages);
  given.check_all_used();
  std::optional<ParticleReport> report;
  if (pages) report.emplace(*pages, options);
  const ParticleExport result = run_with_progress(progress, [&](const ProgressCallback& step) {
    const std::vector<const Block*> chosen = pointers(blocks);
    ParticleExport done =
        export_particles(chosen, folder, options, step, report ? &*report : nullptr);
    if (report) report->finish(folder, chosen, done.failures);
    return done;
  });
  return py::make_tuple(result.written, result.kept, result.failures);
}

py::tuple export_to(const Blocks& blocks, const fs::path& folder, const py::dict& keywords) {
  Keywords given(keywords);
  BlockExportOptions options;
  if (const std::vector<std::string> formats = given.read_texts("format"); !formats.empty()) {
    options.formats = formats;
  }
  take_choice(given, "what",
              {{"skin", ExportedSurface::kSkin},
               {"core", ExportedSurface::kCore},
               {"both", ExportedSurface::kBoth},
               {"surface", ExportedSurface::kSurface}},
              options.surface);
  take_choice(given, "frame",
              {{"source", ExportFrame::kSource}, {"principal", ExportFrame::kPrincipal}},
              options.frame);
  given.read("up", options.up);
  given.read("segments", options.segments);
  given.read("replace", options.replace);
  given.check_all_used();
  if (folder.empty()) throw InputError("the folder to export to has no name");
  std::vector<std::string> notes;
  const std::vector<fs::path> written = run_without_gil([&] {
    return export_blocks(pointers(blocks), folder, options,
                         [&](const std::string& note) { notes.push_back(note); });
  });
  std::vector<std::string> files;
  for (const fs::path& file : written) files.push_back(file.string());
  return py::make_tuple(files, notes);
}

std::string write_pages(const Blocks& blocks, const std::string& title, const fs::path& folder,
                        bool replace) {
  return run_without_gil([&] {
    OutputFolder output(folder, gallery_folder_kind(), replace);
    const fs::path page = write_gallery(pointers(blocks), title, output.temporary_path());
    output.commit();
    return (folder / page.filename()).string();
  });
}

}  // namespace

void bind_libraries(py::module_& module) {
  module.def("library_read", &read_blocks);
  module.def("library_add", &add);
  module.def("library_remove", &remove);
  module.def("library_set", &set_notes);
  module.def("blocks_export", &export_to);
  module.def("blocks_export_particles", &export_as_particles);
  module.def("blocks_report", &write_pages);
  module.def("renamed", [](const Block& block, const std::string& id) {
    check_block_id(id);
    const auto copy = std::make_shared<Block>(block);
    copy->id = id;
    return copy;
  });
}

}  // namespace clast::python_detail
