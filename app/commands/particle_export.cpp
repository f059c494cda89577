#include "app/commands/particle_export.hpp"

#include <iostream>
#include <memory>
#include <optional>

#include "app/interruption.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "app/progress_bar.hpp"
#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "library/block_library.hpp"
#include "report/particle_report.hpp"

namespace clast {

namespace {

double number_of(const std::string& text, const std::string& option) {
  const std::optional<double> number = parse_number(text);
  if (!number) throw InputError(option + ": \"" + text + "\" is not a number");
  return *number;
}

/// "volume=0.01,surface=0.02": what is left out keeps its default.
ShapeErrors parse_errors(const std::string& text, ShapeErrors errors) {
  for (const std::string& item : split_comma_separated(text)) {
    const std::size_t equals = item.find('=');
    const std::string name = item.substr(0, equals);
    double* const value = name == "volume"    ? &errors.volume
                          : name == "inertia" ? &errors.inertia
                          : name == "surface" ? &errors.surface
                                              : nullptr;
    if (value == nullptr || equals == std::string::npos) {
      throw InputError("--error: \"" + item + "\" is not volume=, inertia= or surface= with a " +
                       "number, such as surface=0.02");
    }
    *value = number_of(item.substr(equals + 1), "--error");
  }
  return errors;
}

void apply_texts(ParticleExportArgs& args) {
  ParticleExportOptions& options = args.options;
  options.clump.error = parse_errors(args.error, options.clump.error);
  for (const std::string& level : split_comma_separated(args.levels)) {
    options.levels.push_back(number_of(level, "--levels"));
  }
  if (!args.shape.empty()) options.shape = find_particle_shape(args.shape);
  if (args.equal_spheres > 0) options.clump.balls = args.equal_spheres;
  if (args.parts > 0) options.max_parts = args.parts;
  if (args.part_vertices > 0) options.max_part_vertices = args.part_vertices;
  options.check();
}

ParticleExport export_watched(const std::vector<const Block*>& blocks,
                              const std::filesystem::path& folder,
                              const ParticleExportOptions& options,
                              ParticleExportObserver* observer) {
  const InterruptionWatch watch;
  std::unique_ptr<ProgressBar> bar;
  try {
    const auto progress = [&](const ProgressUpdate& step) {
      if (watch.interrupted()) throw Cancelled();
      if (!bar) {
        bar = std::make_unique<ProgressBar>("blocks", step.total);
        bar->start_from(step.done_before);
      }
      bar->update(step.done);
    };
    return export_particles(blocks, folder, options, progress, observer);
  } catch (const Cancelled&) {
    throw InputError("interrupted; the same command continues with the blocks that are left");
  }
}

}  // namespace

void add_particle_options(CLI::App& command, ParticleExportArgs& args) {
  command
      .add_option("--error", args.error,
                  "Largest errors of particles (--to): of the volume, of the inertia tensor over "
                  "the smallest principal moment, and Hausdorff distance of the surfaces over L. "
                  "Default: volume=0.01,inertia=0.02,surface=0.02")
      ->type_name("LIST");
  command
      .add_option("--shape", args.shape,
                  "Shape of particles: spheres, parts (convex) or polyhedron (convex hull); "
                  "default: by engine")
      ->check(CLI::IsMember({"spheres", "parts", "polyhedron"}))
      ->type_name("NAME");
  command
      .add_option("--max-spheres", args.options.clump.max_balls,
                  "Largest number of spheres for --error")
      ->check(integer_in_range(1, 2000))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--equal-spheres", args.equal_spheres,
                  "The same number of spheres for all blocks, with the errors that result")
      ->check(integer_in_range(1, 2000))
      ->type_name("N");
  command
      .add_option("--levels", args.levels,
                  "Several surface errors, such as 0.05,0.02,0.01: each block is written at each")
      ->type_name("LIST");
  command
      .add_option("--smallest-sphere", args.options.clump.smallest_sphere,
                  "Smallest radius of a sphere over L; it sets the time step of the engine")
      ->type_name("SHARE")
      ->capture_default_str();
  command.add_option("--parts", args.parts, "Largest number of convex parts; default: 32")
      ->check(integer_in_range(1, 1000))
      ->type_name("N");
  command
      .add_option("--part-vertices", args.part_vertices,
                  "Largest number of vertices of a convex part, 16 or more; default: no limit")
      ->check(integer_in_range(16, 100000))
      ->type_name("N");
  command.add_flag("--hull", args.options.hull,
                   "Write the convex hull of concave blocks, also beyond --error");
  command
      .add_option("--report", args.report,
                  "Folder for a page about each particle (--to) with block, shape and their "
                  "distance in 3-D, and a table of all, particles.html")
      ->type_name("DIR");
  command
      .add_option("--threads", args.options.threads,
                  "Threads for particles, 0: one for each core; does not affect the files")
      ->check(integer_in_range(0, 4096))
      ->type_name("N")
      ->capture_default_str();
}

const std::vector<std::string>& particle_option_names() {
  static const std::vector<std::string> kNames = {
      "--error",  "--shape",           "--max-spheres", "--equal-spheres",
      "--levels", "--smallest-sphere", "--parts",       "--part-vertices",
      "--hull",   "--report",          "--threads"};
  return kNames;
}

void run_particle_export(const std::string& library, const std::vector<std::string>& ids,
                         const std::filesystem::path& folder, ParticleExportArgs args) {
  check_usage([&] { apply_texts(args); });
  const BlockLibrary blocks = BlockLibrary::read(library);
  const std::vector<const Block*> chosen = blocks.select_blocks(ids);
  if (chosen.empty()) throw InputError(library + ": holds no block to export");
  std::optional<ParticleReport> report;
  if (!args.report.empty()) report.emplace(args.report, args.options);
  const ParticleExport result =
      export_watched(chosen, folder, args.options, report ? &*report : nullptr);
  for (const std::string& failure : result.failures) {
    std::cerr << "clast: " << format_for_terminal(failure) << "\n";
  }
  std::cout << escape_nonprintable(folder.string()) << ": " << format_count(result.written, "block")
            << " written for " << find_particle_engine(args.options.engine).program;
  if (result.kept > 0) std::cout << ", " << result.kept << " kept from an earlier export";
  std::cout << "; particles.csv and particles.json state errors, mass and inertia\n";
  if (report) {
    const std::filesystem::path page = report->finish(folder, chosen, result.failures);
    std::cout << "Report: " << escape_nonprintable(page.string()) << "\n";
  }
  if (!result.failures.empty()) {
    throw GeometryError(format_count(result.failures.size(), "block") + " of " +
                        std::to_string(chosen.size()) + " could not be written");
  }
}

}  // namespace clast
