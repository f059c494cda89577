#include "particles/particle_export.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "classify/schemes.hpp"
#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/ordered_jobs.hpp"
#include "core/version.hpp"

namespace clast {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kManifestFormat = "clast particles";
constexpr const char* kTableFile = "particles.csv";
constexpr std::chrono::seconds kManifestPeriod{5};

std::string class_of(const Vec3& lengths) {
  return sneed_folk_class({lengths[0], lengths[1], lengths[2]});
}

std::array<double, 4> quaternion_of(const ParticleRecord& record) {
  const Quat& q = record.particle.source_from_body.rotation;
  return {q.w(), q.x(), q.y(), q.z()};
}

TableColumns<ParticleRecord> identity_columns() {
  using R = const ParticleRecord&;
  return {{"name", "", "name in the files: the id with letters, digits and underscores",
           [](R r) { return r.particle.name; }},
          {"block", "", "id of the block", [](R r) { return r.particle.id; }},
          {"shape", "", "spheres, parts or polyhedron",
           [](R r) { return particle_shape_name(r.particle.shape); }},
          {"spheres", "", "number of spheres",
           [](R r) { return std::uint64_t{r.particle.balls.size()}; }},
          {"parts", "", "number of convex parts",
           [](R r) { return std::uint64_t{r.particle.parts.size()}; }},
          {"smallest_radius_m", "m", "radius of the smallest sphere",
           [](R r) {
             return r.particle.balls.empty() ? std::nan("") : r.particle.balls.back().radius;
           }},
          {"files", "", "files of the body", [](R r) { return comma_separated(r.files); }}};
}

TableColumns<ParticleRecord> error_columns() {
  using R = const ParticleRecord&;
  return {{"error_volume", "", "error of the volume, relative",
           [](R r) { return r.particle.errors.volume; }},
          {"error_inertia", "",
           "largest error of the inertia tensor at equal mass over the smallest principal moment",
           [](R r) { return r.particle.errors.inertia; }},
          {"error_surface", "", "Hausdorff distance of the surfaces over L",
           [](R r) { return r.particle.errors.surface; }},
          {"added_volume", "", "volume of parts or hull beyond the body, relative",
           [](R r) { return r.particle.added_volume; }}};
}

TableColumns<ParticleRecord> mass_columns() {
  using R = const ParticleRecord&;
  return {
      {"density_kg_m3", "kg/m^3", "density of the rock", [](R r) { return r.particle.density; }},
      {"volume_m3", "m^3", "true volume", [](R r) { return r.particle.volume; }},
      {"mass_kg", "kg", "true mass", [](R r) { return r.particle.mass; }},
      {"shape_volume_m3", "m^3", "volume of the exported shape",
       [](R r) { return r.particle.shape_mass.volume; }},
      {"engine_density_kg_m3", "kg/m^3",
       "density to type in where the engine computes the mass from the shape",
       [](R r) { return r.particle.mass / r.particle.shape_mass.volume; }}};
}

TableColumns<ParticleRecord> make_columns() {
  using R = const ParticleRecord&;
  return concatenated_columns<ParticleRecord>(
      {identity_columns(),
       error_columns(),
       mass_columns(),
       array_columns<ParticleRecord>({"J1_kg_m2", "J2_kg_m2", "J3_kg_m2"}, "kg m^2",
                                     "true principal moments of inertia",
                                     [](R r) { return r.particle.moments; }),
       array_columns<ParticleRecord>({"centre_x_m", "centre_y_m", "centre_z_m"}, "m",
                                     "centre of mass in the frame of the scan",
                                     [](R r) { return r.particle.source_from_body.translation; }),
       array_columns<ParticleRecord>({"q_w", "q_x", "q_y", "q_z"}, "",
                                     "rotation of the principal frame to the frame of the scan",
                                     quaternion_of),
       {{"class", "", "class of Sneed and Folk", [](R r) { return class_of(r.particle.lengths); }},
        {"shape_class", "", "that of the exported shape",
         [](R r) { return class_of(r.particle.shape_lengths); }}},
       array_columns<ParticleRecord>({"L_m", "I_m", "S_m"}, "m", "sides of the smallest box",
                                     [](R r) { return r.particle.lengths; }),
       array_columns<ParticleRecord>({"shape_L_m", "shape_I_m", "shape_S_m"}, "m",
                                     "those of the exported shape",
                                     [](R r) { return r.particle.shape_lengths; })});
}

/// Digest of all that the particles of a block depend on.
std::string block_key(const Block& block, const std::string& options) {
  Sha256 digest;
  const auto add = [&](const Vec3& vector) {
    digest.add({reinterpret_cast<const char*>(vector.data()), 3 * sizeof(double)});
  };
  for (const Vec3& vertex : block.body.vertices) add(vertex);
  for (const Vec3& vertex : block.surface.vertices) add(vertex);
  add({block.body.radius, block.density, block.mass.mass});
  add(block.mass.centre);
  add(block.principal.moments);
  digest.add(block.id + "\n" + options + "\n" + version());
  return digest.finish();
}

Json record_json(const ParticleRecord& record) {
  Json row;
  for (const TableColumn<ParticleRecord>& column : particle_columns()) {
    std::visit([&](const auto& value) { row[column.name] = value; }, column.value(record));
  }
  return row;
}

/// Manifest of an export, as far as it is finished.
class Manifest {
 public:
  /// Reads the finished blocks of an earlier export with the same options.
  Manifest(fs::path folder, const ParticleExportOptions& options)
      : folder_(std::move(folder)), options_(format_particle_options(options)) {
    const fs::path file = folder_ / kParticleManifest;
    std::error_code code;
    if (!fs::exists(file, code)) return;
    const Json old = Json::parse(read_text_file(file), nullptr, false);
    own_ = text_at(old, "format") == kManifestFormat;
    std::string problem;
    if (!own_) {
      problem = file.string() + ": is damaged or no manifest of clast";
    } else if (text_at(old, "program_version") != version()) {
      problem = folder_.string() + ": holds an export of clast " + text_at(old, "program_version");
    } else if (text_at(old, "options") != options_) {
      problem = folder_.string() + ": holds an export with other options (" +
                text_at(old, "options") + ")";
    } else if (!old.contains("blocks") || text_at(old, "digest") != digest_of(old["blocks"])) {
      problem = file.string() + ": is damaged";
    } else {
      for (const Json& block : old["blocks"]) blocks_[text_at(block, "block")] = block;
    }
    if (!problem.empty() && !options.replace)
      throw InputError(problem + "; name another folder or use `replace`");
  }

  /// True if files in the folder are of an export of clast.
  bool is_own() const { return own_; }

  std::string key(const Block& block) const { return block_key(block, options_); }

  bool has(const Block& block) const {
    const auto found = blocks_.find(block.id);
    if (found == blocks_.end() || text_at(found->second, "key") != key(block)) return false;
    for (const Json& particle : found->second["particles"]) {
      for (const Json& file : particle["file_list"]) {
        std::error_code code;
        if (!fs::exists(folder_ / file.get<std::string>(), code)) return false;
      }
    }
    return true;
  }

  void add(const Block& block, const std::vector<ParticleRecord>& records) {
    Json entry = {{"block", block.id}, {"key", key(block)}, {"particles", Json::array()}};
    for (const ParticleRecord& record : records) {
      Json row = record_json(record);
      row["file_list"] = record.files;
      entry["particles"].push_back(std::move(row));
    }
    blocks_[block.id] = std::move(entry);
    const auto now = std::chrono::steady_clock::now();
    if (now - written_ > kManifestPeriod) write();
  }

  /// Writes particles.json and particles.csv.
  void write() {
    Json all = {{"format", kManifestFormat},
                {"program_version", version()},
                {"options", options_},
                {"digest", ""},
                {"blocks", Json::array()}};
    CsvWriter csv;
    csv.write_header(csv_header(particle_columns()));
    for (const auto& [id, entry] : blocks_) {
      all["blocks"].push_back(entry);
      for (const Json& row : entry["particles"]) append_row(csv, row);
    }
    all["digest"] = digest_of(all["blocks"]);
    write_output(folder_ / kParticleManifest, all.dump(1) + "\n", {});
    write_output(folder_ / kTableFile, csv.take_text(), {});
    written_ = std::chrono::steady_clock::now();
  }

 private:
  /// Returns a text of an object; empty if it has none.
  static std::string text_at(const Json& object, const char* key) {
    return object.is_object() && object.contains(key) && object[key].is_string()
               ? object[key].get<std::string>()
               : "";
  }
  static std::string digest_of(const Json& blocks) { return sha256(blocks.dump()); }

  static void append_row(CsvWriter& csv, const Json& row) {
    for (const TableColumn<ParticleRecord>& column : particle_columns()) {
      const Json& cell = row[column.name];
      if (cell.is_number_unsigned())
        csv.write_count(cell.get<std::uint64_t>());
      else if (cell.is_number())
        csv.write_cell(cell.get<double>());
      else if (cell.is_string())
        csv.write_cell(cell.get<std::string>());
      else
        csv.write_empty_cells(1);
    }
    csv.end_row();
  }

  fs::path folder_;
  std::string options_;
  bool own_ = false;
  std::map<std::string, Json> blocks_;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

/// Names of files differ between blocks, as ids do, unless they differ in other characters only.
void check_names(const std::vector<const Block*>& blocks) {
  std::map<std::string, std::string> ids;
  for (const Block* block : blocks) {
    const auto [at, is_new] = ids.emplace(particle_name(block->id), block->id);
    if (is_new) continue;
    throw InputError("blocks " + at->second + " and " + block->id + " would both be written as " +
                     at->first + "; export one of them to another folder");
  }
}

/// Result of the job of one block.
struct Made {
  std::vector<Particle> particles;
  std::string failure;
};

}  // namespace

const TableColumns<ParticleRecord>& particle_columns() {
  static const TableColumns<ParticleRecord> kColumns = make_columns();
  return kColumns;
}

std::string format_particle_options(const ParticleExportOptions& options) {
  const ClumpOptions& clump = options.clump;
  std::string text = "engine=" + options.engine +
                     " shape=" + particle_shape_name(options.chosen_shape()) +
                     " volume=" + format_significant(clump.error.volume, 12) +
                     " inertia=" + format_significant(clump.error.inertia, 12) +
                     " surface=" + format_significant(clump.error.surface, 12) +
                     " max_spheres=" + std::to_string(clump.max_balls) +
                     " smallest_sphere=" + format_significant(clump.smallest_sphere, 12) +
                     " seed=" + std::to_string(clump.seed);
  if (clump.balls) text += " equal_spheres=" + std::to_string(*clump.balls);
  if (options.max_parts) text += " parts=" + std::to_string(*options.max_parts);
  if (options.max_part_vertices) {
    text += " part_vertices=" + std::to_string(*options.max_part_vertices);
  }
  if (options.hull) text += " hull=true";
  for (const double level : options.levels) text += " level=" + format_significant(level, 12);
  return text;
}

ParticleShape ParticleExportOptions::chosen_shape() const {
  return shape.value_or(find_particle_engine(engine).shapes.front());
}

void ParticleExportOptions::check() const {
  const ParticleEngine& known = find_particle_engine(engine);
  const ParticleShape chosen = chosen_shape();
  if (std::find(known.shapes.begin(), known.shapes.end(), chosen) == known.shapes.end()) {
    std::vector<std::string> names;
    for (const ParticleShape one : known.shapes) names.push_back(particle_shape_name(one));
    throw InputError("`shape` " + particle_shape_name(chosen) + " is not taken by " +
                     known.program + "; it takes " + comma_separated(names));
  }
  clump.check();
  const auto only_for = [&](bool given, const char* field, ParticleShape wanted) {
    if (!given || chosen == wanted) return;
    throw InputError(std::string("`") + field + "` applies to the shape " +
                     particle_shape_name(wanted) + ", not to " + particle_shape_name(chosen));
  };
  only_for(clump.balls.has_value(), "equal_spheres", ParticleShape::kSpheres);
  only_for(!levels.empty(), "levels", ParticleShape::kSpheres);
  only_for(max_parts.has_value(), "parts", ParticleShape::kParts);
  only_for(max_part_vertices.has_value(), "part_vertices", ParticleShape::kParts);
  only_for(hull, "hull", ParticleShape::kPolyhedron);
  if (clump.balls && !levels.empty()) {
    throw InputError("`equal_spheres` and `levels` exclude each other");
  }
  for (const double level : levels) ShapeErrors{0.5, 0.5, level}.check();
  ConvexPartOptions{.max_parts = max_parts.value_or(1), .max_vertices = max_part_vertices}.check();
}

ParticleExport export_particles(const std::vector<const Block*>& blocks, const fs::path& folder,
                                const ParticleExportOptions& options,
                                const ProgressCallback& progress,
                                ParticleExportObserver* observer) {
  options.check();
  if (blocks.empty()) throw InputError("there is no block to export");
  check_names(blocks);
  const ParticleEngine& engine = find_particle_engine(options.engine);
  check_output_target(folder / kTableFile, {});
  Manifest manifest(folder, options);
  const OverwritePolicy rules = {.replace = options.replace || manifest.is_own()};
  ParticleExport result;
  std::vector<const Block*> open;
  for (const Block* block : blocks) {
    if (manifest.has(*block) &&
        (observer == nullptr || observer->is_finished(*block, manifest.key(*block))))
      ++result.kept;
    else
      open.push_back(block);
  }
  const auto report = [&](std::size_t done) {
    if (progress)
      progress({.done = result.kept + done, .total = blocks.size(), .done_before = result.kept});
  };
  report(0);
  const auto make = [&](std::size_t i) {
    Made made;
    try {
      made.particles = make_particles(*open[i], options);
      if (observer != nullptr) {
        observer->on_particles_made(*open[i], made.particles, manifest.key(*open[i]));
      }
    } catch (const Error& error) {
      made.failure = error.what();
    }
    return made;
  };
  const auto take = [&](std::size_t i, Made& made) {
    if (!made.failure.empty()) {
      result.failures.push_back(made.failure);
    } else {
      std::vector<ParticleRecord> records;
      for (Particle& particle : made.particles) {
        ParticleRecord record;
        for (const ParticleFile& file : engine.write(particle)) {
          write_output(folder / file.name, file.text, rules);
          record.files.push_back(file.name);
        }
        record.particle = std::move(particle);
        records.push_back(std::move(record));
      }
      manifest.add(*open[i], records);
      ++result.written;
    }
    report(i + 1);
  };
  try {
    run_ordered_jobs(open.size(), options.threads, make, take);
  } catch (...) {
    manifest.write();
    throw;
  }
  manifest.write();
  return result;
}

}  // namespace clast
