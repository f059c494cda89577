#include "study/results.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "core/error.hpp"
#include "core/hdf5_file.hpp"
#include "core/output_file.hpp"
#include "study/results_layout.hpp"

namespace clast {

namespace fs = std::filesystem;
using namespace results_layout;

std::string results_layout::trajectory_name(std::uint32_t run) {
  char name[16];
  std::snprintf(name, sizeof name, "%08u", run);
  return name;
}

fs::path partial_results(const fs::path& target) {
  fs::path part = target;
  part += ".part";
  return part;
}

namespace {

template <class T>
void append_one(Hdf5Group& group, const std::string& name, const T& value) {
  group.append<T>(name, std::span<const T>(&value, 1));
}

void write_texts(Hdf5Group& group, const std::string& name, const std::vector<std::string>& texts) {
  group.write<std::string>(name, texts);
}

template <class Row, class Field>
void write_column(Hdf5Group& group, const std::string& name, const std::string& unit,
                  const std::vector<Row>& rows, const Field& field) {
  using T = std::decay_t<decltype(field(rows.front()))>;
  std::vector<T> values;
  for (const Row& row : rows) values.push_back(field(row));
  group.write<T>(name, values);
  if (!unit.empty()) group.set_unit(name, unit);
}

template <class Vector>
void write_vectors(Hdf5Group& group, const std::string& name, const std::string& unit,
                   const std::vector<Vector>& vectors) {
  constexpr auto kSize = static_cast<std::size_t>(Vector::SizeAtCompileTime);
  std::vector<double> flat;
  flat.reserve(kSize * vectors.size());
  for (const Vector& vector : vectors) flat.insert(flat.end(), vector.begin(), vector.end());
  group.write<double>(name, flat, {vectors.size(), kSize});
  if (!unit.empty()) group.set_unit(name, unit);
}

void write_terrain_group(Hdf5Group group, const Terrain& terrain, const MapFrame& frame) {
  write_vectors(group, "vertices_m", "m", terrain.surface.vertices);
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * terrain.surface.triangles.size());
  for (const auto& triangle : terrain.surface.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  group.write<std::uint32_t>("triangles", corners, {terrain.surface.triangles.size(), 3});
  group.write<std::uint16_t>("zone", terrain.zone);
  write_texts(group, "notes", terrain.report.notes);
  write_texts(group, "sources", terrain.sources);
  write_vectors(group, "origin_m", "m", std::vector<Vec3>{frame.origin});
  group.set_attribute<std::string>("crs", frame.crs);
}

void write_header(Hdf5Group root, const CampaignResults& header) {
  root.set_attribute<std::string>("campaign_sha256", header.campaign_sha256);
  root.set_attribute<std::int64_t>("planned_runs", header.planned_runs);
  write_texts(root, "campaign", {header.campaign_text});
  write_texts(root, "inputs", header.inputs);
  write_texts(root, "warnings", header.warnings);
  if (header.downslope) {
    write_vectors(root, "downslope", "", std::vector<Vec2>{*header.downslope});
  }
  write_vectors(root, "release_points_m", "m", header.release_points);

  Hdf5Group blocks = root.create_group("blocks");
  const auto& list = header.blocks;
  write_column(blocks, "id", "", list, [](const BlockSummary& b) { return b.id; });
  write_column(blocks, "mass_kg", "kg", list, [](const BlockSummary& b) { return b.mass; });
  write_column(blocks, "L_m", "m", list, [](const BlockSummary& b) { return b.axes.L; });
  write_column(blocks, "I_m", "m", list, [](const BlockSummary& b) { return b.axes.I; });
  write_column(blocks, "S_m", "m", list, [](const BlockSummary& b) { return b.axes.S; });
  write_column(blocks, "garcia", "", list, [](const BlockSummary& b) { return b.garcia; });
  write_column(blocks, "sneed_folk", "", list, [](const BlockSummary& b) { return b.sneed_folk; });
  write_column(blocks, "zingg", "", list, [](const BlockSummary& b) { return b.zingg; });

  Hdf5Group barriers = root.create_group("barriers");
  std::vector<Vec2> from, to;
  for (const Barrier& barrier : header.barriers) {
    from.push_back(barrier.from);
    to.push_back(barrier.to);
  }
  write_column(barriers, "name", "", header.barriers, [](const Barrier& b) { return b.name; });
  write_vectors(barriers, "from_m", "m", from);
  write_vectors(barriers, "to_m", "m", to);

  Hdf5Group ground = root.create_group("ground");
  const auto& zones = header.ground;
  write_texts(ground, "zone", header.zone_names);
  write_column(ground, "energy_restitution", "", zones,
               [](const GroundParameters& g) { return g.energy_restitution; });
  write_column(ground, "friction", "", zones, [](const GroundParameters& g) { return g.friction; });
  write_column(ground, "rolling_friction", "", zones,
               [](const GroundParameters& g) { return g.rolling_friction; });

  Hdf5Group contact = root.create_group("contact");
  contact.set_attribute<std::string>("law", "energy-restitution");
  contact.set_attribute<std::string>("weights", name_of(header.weights));
  contact.set_attribute<double>("stiffness_n_m", header.stiffness.normal);
  contact.set_attribute<double>("tangential_stiffness_n_m", header.stiffness.tangential);
  contact.set_attribute<double>("rolling_stiffness_n_m_rad", header.stiffness.rolling);
  contact.set_attribute<double>("time_step_s", header.stiffness.time_step);

  write_terrain_group(root.create_group("terrain"), header.terrain, header.frame);
}

// Empty columns, so that a file without runs or crossings has the same datasets as any other.
void make_columns(Hdf5Group root) {
  const auto make = [](Hdf5Group& group, const auto& columns, auto type) {
    for (const auto& column : columns) {
      group.append<decltype(type)>(column.name, {});
      if (*column.unit) group.set_unit(column.name, column.unit);
    }
  };
  Hdf5Group runs = root.create_group("runs");
  make(runs, kRunIndices, std::uint32_t{});
  for (const StateOfRun& state : kRunStates) {
    for (const StateValue& column : kStateValues) {
      runs.append<double>(state.prefix + std::string(column.name), {});
      if (*column.unit) runs.set_unit(state.prefix + std::string(column.name), column.unit);
    }
  }
  make(runs, kRunValues, double{});
  make(runs, kRunCounts, std::int64_t{});
  for (const char* name : {kStopReason, kBelowGround, kRunStored}) {
    runs.append<std::uint8_t>(name, {});
  }
  for (const char* name : {kFirstCrossing, kCrossingCount}) runs.append<std::uint32_t>(name, {});
  runs.append<std::string>(kMessage, {});
  Hdf5Group crossings = root.create_group("crossings");
  make(crossings, kCrossingIndices, std::uint32_t{});
  make(crossings, kCrossingValues, double{});
  crossings.append<std::uint8_t>(kForward, {});
  Hdf5Group trajectories = root.create_group("trajectories");
  std::string row_names = "time_s";
  for (const StateValue& row : kStateValues) row_names += std::string(" ") + row.name;
  trajectories.set_attribute<std::string>("rows", row_names);
}

void append_crossings(Hdf5Group& group, std::vector<Crossing> crossings) {
  const auto append = [&](const auto& columns, auto type) {
    for (const auto& column : columns) {
      std::vector<decltype(type)> values;
      for (Crossing& crossing : crossings) values.push_back(column.field(crossing));
      group.append<decltype(type)>(column.name, values);
    }
  };
  append(kCrossingIndices, std::uint32_t{});
  append(kCrossingValues, double{});
  std::vector<std::uint8_t> forward;
  for (const Crossing& crossing : crossings) forward.push_back(crossing.forward ? 1 : 0);
  group.append<std::uint8_t>(kForward, forward);
}

void append_run(Hdf5Group& group, RunRecord run, std::uint32_t first_crossing,
                std::uint32_t crossing_count) {
  for (const RunIndex& column : kRunIndices) append_one(group, column.name, column.field(run));
  for (const StateOfRun& state : kRunStates) {
    for (const StateValue& column : kStateValues) {
      append_one(group, state.prefix + std::string(column.name), column.field(state.field(run)));
    }
  }
  for (const RunValue& column : kRunValues) append_one(group, column.name, column.field(run));
  for (const RunCount& column : kRunCounts) {
    append_one(group, column.name, static_cast<std::int64_t>(column.field(run)));
  }
  append_one(group, kStopReason, static_cast<std::uint8_t>(run.result.stop_reason));
  append_one(group, kBelowGround, static_cast<std::uint8_t>(run.result.below_ground ? 1 : 0));
  append_one(group, kMessage, run.result.message);
  append_one(group, kFirstCrossing, first_crossing);
  append_one(group, kCrossingCount, crossing_count);
}

void write_trajectory(Hdf5Group& group, std::uint32_t run, const Trajectory& trajectory) {
  if (trajectory.time.empty()) return;
  const std::size_t frames = trajectory.time.size();
  std::vector<double> rows(kTrajectoryRows * frames);
  for (std::size_t i = 0; i < frames; ++i) {
    rows[i] = trajectory.time[i];
    RigidState state = trajectory.states[i];
    for (std::size_t k = 1; k < kTrajectoryRows; ++k) {
      rows[k * frames + i] = kStateValues[k - 1].field(state);
    }
  }
  group.write<double>(trajectory_name(run), rows, {kTrajectoryRows, frames});
}

std::multiset<std::string> digests(const std::vector<std::string>& inputs) {
  std::multiset<std::string> result;
  for (const std::string& input : inputs) result.insert(input.substr(input.rfind(' ') + 1));
  return result;
}

void check_same_campaign(const fs::path& part, const CampaignResults& stored,
                         const CampaignResults& header) {
  std::string difference;
  if (stored.campaign_sha256 != header.campaign_sha256) {
    difference = "another campaign file";
  } else if (digests(stored.inputs) != digests(header.inputs)) {
    difference = "other input files";
    for (const std::string& input : header.inputs) {
      if (digests(stored.inputs).count(input.substr(input.rfind(' ') + 1)) == 0) {
        difference += " (" + input.substr(0, input.rfind(' ')) + " has changed)";
        break;
      }
    }
  } else if (stored.program_version != header.program_version) {
    difference = "clast " + stored.program_version + ", this is clast " + header.program_version;
  } else if (stored.planned_runs != header.planned_runs) {
    difference = std::to_string(stored.planned_runs) + " planned runs, now there are " +
                 std::to_string(header.planned_runs);
  }
  if (difference.empty()) return;
  throw InputError(part.string() + ": was begun with " + difference +
                   "; start again without resuming, which replaces it");
}

}  // namespace

struct ResultsWriter::Impl {
  Impl(fs::path the_target, Hdf5File the_file)
      : target(std::move(the_target)),
        file(std::make_unique<Hdf5File>(std::move(the_file))),
        runs(std::make_unique<Hdf5Group>(file->root().group("runs"))),
        crossings(std::make_unique<Hdf5Group>(file->root().group("crossings"))),
        trajectories(std::make_unique<Hdf5Group>(file->root().group("trajectories"))) {}

  void add(const RunRecord& run, const std::vector<Crossing>& crossed,
           const Trajectory& trajectory) {
    write_trajectory(*trajectories, run.run, trajectory);
    if (!crossed.empty()) append_crossings(*crossings, crossed);
    const auto count = static_cast<std::uint32_t>(crossed.size());
    append_run(*runs, run, crossing_rows, count);
    crossing_rows += count;
    stored.push_back(run.run);
  }

  fs::path target;
  std::unique_ptr<Hdf5File> file;
  std::unique_ptr<Hdf5Group> runs, crossings, trajectories;
  std::vector<std::uint32_t> stored;
  std::uint32_t crossing_rows = 0;
};

ResultsWriter::ResultsWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ResultsWriter::~ResultsWriter() = default;
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;

const std::vector<std::uint32_t>& ResultsWriter::stored_runs() const { return impl_->stored; }

ResultsWriter ResultsWriter::create(const fs::path& target, const CampaignResults& header) {
  const fs::path part = partial_results(target);
  // Written whole before it takes the place of an older one.
  OutputFile fresh(part);
  {
    Hdf5File file = Hdf5File::create(fresh.temporary(), kFormat, kSchemaVersion);
    write_header(file.root(), header);
    make_columns(file.root());
    file.flush();
  }
  fresh.commit();
  return ResultsWriter(
      std::make_unique<Impl>(target, Hdf5File::open(part, kFormat, kSchemaVersion, true)));
}

ResultsWriter ResultsWriter::resume(const fs::path& target, const CampaignResults& header) {
  const fs::path part = partial_results(target);
  const CampaignResults stored = read_results(part);
  check_same_campaign(part, stored, header);

  // A kill can leave half a run behind. The complete runs move to a fresh file.
  OutputFile fresh(part);
  std::uint32_t crossing_rows = 0;
  {
    const Hdf5File old_file = Hdf5File::open(part, kFormat, kSchemaVersion);
    const Hdf5Group old_trajectories = old_file.root().group("trajectories");
    Hdf5File file = Hdf5File::create(fresh.temporary(), kFormat, kSchemaVersion);
    write_header(file.root(), header);
    make_columns(file.root());
    Hdf5Group runs = file.root().group("runs");
    Hdf5Group crossings = file.root().group("crossings");
    Hdf5Group trajectories = file.root().group("trajectories");
    append_crossings(crossings, stored.crossings);
    for (const RunRecord& run : stored.runs) {
      const auto count = static_cast<std::uint32_t>(
          std::count_if(stored.crossings.begin() + crossing_rows, stored.crossings.end(),
                        [&](const Crossing& crossing) { return crossing.run == run.run; }));
      append_run(runs, run, crossing_rows, count);
      append_one<std::uint8_t>(runs, kRunStored, 1);
      crossing_rows += count;
      const std::string name = trajectory_name(run.run);
      if (old_trajectories.has(name)) trajectories.copy_from(old_trajectories, name);
    }
    file.flush();
  }
  fresh.commit();
  auto impl = std::make_unique<Impl>(target, Hdf5File::open(part, kFormat, kSchemaVersion, true));
  for (const RunRecord& run : stored.runs) impl->stored.push_back(run.run);
  impl->crossing_rows = crossing_rows;
  return ResultsWriter(std::move(impl));
}

void ResultsWriter::add(const RunRecord& run, const std::vector<Crossing>& crossings,
                        const Trajectory& trajectory) {
  impl_->add(run, crossings, trajectory);
  // The marker goes to disk after all that it vouches for.
  impl_->file->flush();
  append_one<std::uint8_t>(*impl_->runs, kRunStored, 1);
  impl_->file->flush();
}

void ResultsWriter::finish() {
  impl_->file->root().set_attribute<std::int64_t>("finished_runs",
                                                  static_cast<std::int64_t>(impl_->stored.size()));
  impl_->file->flush();
  impl_->runs.reset();
  impl_->crossings.reset();
  impl_->trajectories.reset();
  impl_->file.reset();
  const fs::path part = partial_results(impl_->target);
  std::error_code code;
  fs::rename(part, impl_->target, code);
  if (code) {
    throw InputError(part.string() + ": can't be renamed to " + impl_->target.string() + " (" +
                     code.message() + "); the results are complete, rename the file by hand");
  }
}

}  // namespace clast
