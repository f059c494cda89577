#include "study/results/results_file.hpp"

#include <cstdio>

#include "core/files/hdf5_file.hpp"
#include "core/files/output_file.hpp"
#include "library/body_record.hpp"
#include "study/campaign/ground_fields.hpp"
#include "study/results/detail/results_layout.hpp"
#include "study/results/stored_columns.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

void write_texts(Hdf5Group& group, const std::string& name, const std::vector<std::string>& texts) {
  group.write<std::string>(name, texts);
}

template <class Rows, class Field>
void write_column(Hdf5Group& group, const std::string& name, const std::string& unit,
                  const Rows& rows, const Field& field) {
  using T = std::decay_t<decltype(field(rows.front()))>;
  std::vector<T> values;
  for (const auto& row : rows) values.push_back(field(row));
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

// Cores of the library blocks in their principal frame, as the block library keeps them.
void write_shapes(Hdf5Group group, const std::vector<SpheroPolyhedron>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    write_body(group.create_group(std::to_string(i)), shapes[i]);
  }
}

void write_ground_sets(Hdf5Group group, const CampaignHeader& header) {
  const std::vector<GroundParameterSet>& sets = header.ground_sets;
  write_column(group, "group", "", sets, [](const GroundParameterSet& set) { return set.group; });
  write_column(group, "member", "", sets, [](const GroundParameterSet& set) { return set.member; });
  for (const GroundParameterField& field : ground_parameter_fields()) {
    std::vector<double> values;
    for (const GroundParameterSet& set : sets) {
      for (const GroundParameters& zone : set.zones) values.push_back(zone.*field.value);
    }
    group.write<double>(field.name, values, {sets.size(), header.zone_names.size()});
  }
}

void write_header(Hdf5Group root, const CampaignHeader& header) {
  root.set_attribute<std::string>("campaign_sha256", header.campaign_sha256);
  root.set_attribute<std::int64_t>("planned_runs", header.planned_runs);
  if (!header.engine.empty()) root.set_attribute<std::string>("engine", header.engine);
  if (!header.physics_digest.empty()) {
    root.set_attribute<std::string>("physics_digest", header.physics_digest);
  }
  write_texts(root, "campaign", {header.campaign_text});
  write_texts(root, "inputs", header.inputs);
  write_texts(root, "warnings", header.warnings);
  if (header.downslope) {
    write_vectors(root, "downslope", "", std::vector<Vec2>{*header.downslope});
  }
  write_vectors(root, "release_points_m", "m", header.release_points);
  write_texts(root, "release_sets", header.release_sets);
  root.write<std::uint32_t>("set_of_point", header.set_of_point);

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
  write_column(blocks, "library_id", "", list,
               [](const BlockSummary& b) { return b.library_block(); });
  write_column(blocks, "group", "", list, [](const BlockSummary& b) { return b.group; });
  write_column(blocks, "parent", "", list, [](const BlockSummary& b) { return b.parent; });
  write_column(blocks, "variation", "", list, [](const BlockSummary& b) { return b.variation; });
  write_column(blocks, "scale", "", list, [](const BlockSummary& b) { return b.scale; });
  write_column(blocks, "volume_m3", "m^3", list, [](const BlockSummary& b) { return b.volume; });
  write_column(blocks, "shape", "", list, [](const BlockSummary& b) { return b.shape; });
  std::vector<Vec3> moments;
  for (const BlockSummary& block : list) moments.push_back(block.moments);
  write_vectors(blocks, "principal_moments_kg_m2", "kg m^2", moments);
  write_shapes(root.create_group("shapes"), header.shapes);

  Hdf5Group barriers = root.create_group("barriers");
  std::vector<Vec2> points;
  for (const Barrier& barrier : header.barriers) {
    points.insert(points.end(), barrier.vertices.begin(), barrier.vertices.end());
  }
  write_column(barriers, "name", "", header.barriers, [](const Barrier& b) { return b.name; });
  write_column(barriers, "point_count", "", header.barriers,
               [](const Barrier& b) { return static_cast<std::uint32_t>(b.vertices.size()); });
  write_vectors(barriers, "points_m", "m", points);
  write_column(barriers, "direction", "", header.barriers,
               [](const Barrier& b) { return name_of(b.counted); });

  Hdf5Group ground = root.create_group("ground");
  const auto& zones = header.ground;
  write_texts(ground, "zone", header.zone_names);
  for (const GroundParameterField& field : ground_parameter_fields()) {
    write_column(ground, field.name, field.unit, zones,
                 [&](const GroundParameters& zone) { return zone.*field.value; });
  }

  write_ground_sets(root.create_group("ground_sets"), header);

  Hdf5Group contact = root.create_group("contact");
  contact.set_attribute<std::string>("law", name_of(header.law));
  contact.set_attribute<std::string>("weights", name_of(header.weighting));

  write_terrain_group(root.create_group("terrain"), header.terrain, header.frame);
}

/// @param contacts  whether the runs tell of them
template <class Row>
void write_rows(Hdf5Group group, const std::vector<Row>& rows, bool contacts = true) {
  visit_columns(kRowType<Row>, [&](const std::string& name, const std::string& unit, const auto&,
                                   const auto& field) {
    if (!contacts && depends_on_contact_data(name)) return;
    write_column(group, name, unit, rows,
                 [&](const Row& row) { return to_stored_value(std::invoke(field, row)); });
  });
}

void write_stays(Hdf5Group group, const CampaignHeader& header,
                 const std::vector<PersistentBlockRecord>& rows) {
  const PersistentBlocksSettings& stay = *header.persistent_blocks;
  group.set_attribute<std::int64_t>("blocks_each", stay.blocks_per_realisation);
  group.set_attribute<std::int64_t>("at_once", stay.at_once ? 1 : 0);
  for (const GroundParameterField& field : ground_parameter_fields()) {
    if (!field.is_soil_parameter)
      group.set_attribute<double>(field.name, stay.between_blocks.*field.value);
  }
  write_rows(group, rows, header.has_contacts());
}

void write_trajectory(Hdf5Group& group, std::uint32_t run, const Trajectory& trajectory) {
  if (trajectory.time.empty()) return;
  std::vector<double> rows = trajectory.time;
  visit_columns(kRowType<RigidState>,
                [&](const auto&, const auto&, const auto&, const auto& field) {
                  for (const RigidState& state : trajectory.states) rows.push_back(field(state));
                });
  group.write<double>(trajectory_dataset_name(run), rows,
                      {trajectory_row_count(), trajectory.time.size()});
}

}  // namespace

std::string trajectory_dataset_name(std::uint32_t run) {
  char name[16];
  std::snprintf(name, sizeof name, "%08u", run);
  return name;
}

void write_results_file(const fs::path& target, const CampaignHeader& header, std::size_t count,
                        const std::function<StoredRun(std::size_t)>& run) {
  OutputFile output(target, {.kind = kResultsFormat});
  {
    Hdf5File file = Hdf5File::create(output.temporary_path(), kResultsFormat, kResultsSchema);
    Hdf5Group root = file.root();
    write_header(root, header);
    Hdf5Group trajectories = root.create_group("trajectories");
    std::string row_names = "time_s";
    visit_columns(kRowType<RigidState>,
                  [&](const std::string& name, const auto&...) { row_names += " " + name; });
    trajectories.set_attribute<std::string>("rows", row_names);
    std::vector<RunRecord> records;
    std::vector<Crossing> crossings;
    std::vector<Impact> impacts;
    std::vector<PersistentBlockRecord> stays;
    std::vector<EnergyRecord> energies;
    for (std::size_t i = 0; i < count; ++i) {
      const StoredRun stored = run(i);
      records.push_back(stored.record);
      crossings.insert(crossings.end(), stored.crossings.begin(), stored.crossings.end());
      impacts.insert(impacts.end(), stored.impacts.begin(), stored.impacts.end());
      stays.insert(stays.end(), stored.persistent_block_records.begin(),
                   stored.persistent_block_records.end());
      energies.insert(energies.end(), stored.energies.begin(), stored.energies.end());
      write_trajectory(trajectories, stored.record.run, stored.trajectory);
    }
    write_rows(root.create_group("runs"), records, header.has_contacts());
    write_rows(root.create_group("crossings"), crossings);
    write_rows(root.create_group("impacts"), impacts);
    if (header.persistent_blocks) write_stays(root.create_group("stays"), header, stays);
    if (header.persistent_blocks && header.has_contacts())
      write_rows(root.create_group("energies"), energies);
    file.flush();
  }
  output.commit();
}

void check_results_disk_space(const fs::path& target, const CampaignHeader& header,
                              std::size_t runs) {
  const OutputFile trial(target, {.kind = kResultsFormat});
  {
    Hdf5File file = Hdf5File::create(trial.temporary_path(), kResultsFormat, kResultsSchema);
    write_header(file.root(), header);
    file.flush();
  }
  const std::uint64_t without_runs = fs::file_size(trial.temporary_path());
  fs::resize_file(trial.temporary_path(), 0);  // what it takes is free again
  check_disk_space(trial.target_path(),
                   {without_runs, runs * ResultsJournal::smallest_record_size()});
}

}  // namespace clast::study_detail
