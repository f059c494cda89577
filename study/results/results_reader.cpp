#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "core/files/hdf5_file.hpp"
#include "core/number_text.hpp"
#include "library/body_record.hpp"
#include "study/campaign/checked_group.hpp"
#include "study/campaign/ground_fields.hpp"
#include "study/results/detail/results_layout.hpp"
#include "study/results/results.hpp"
#include "study/results/stored_columns.hpp"

namespace clast {

using namespace study_detail;
namespace fs = std::filesystem;

namespace {

void read_shapes(const CheckedGroup& reader, CampaignHeader& results) {
  const std::size_t count = reader.group.child_names().size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = std::to_string(i);
    results.shapes.push_back(
        read_body(reader.group.open_group(name), reader.file + ": " + reader.path + "/" + name));
  }
}

/// Optional parameters were added to schema 4 later, and are 0 if absent.
std::vector<GroundParameters> read_ground_parameters(const CheckedGroup& reader, std::size_t rows) {
  std::vector<GroundParameters> parameters(rows);
  for (const GroundParameterField& field : ground_parameter_fields()) {
    if (!field.required && !reader.group.contains(field.name)) continue;
    const auto values = reader.column<double>(field.name, rows);
    for (std::size_t i = 0; i < rows; ++i) parameters[i].*field.value = values[i];
  }
  return parameters;
}

void read_ground_sets(const CheckedGroup& reader, CampaignHeader& results) {
  const auto groups = reader.group.read<std::string>("group");
  const std::size_t zones = results.zone_names.size();
  const auto members = reader.column<std::uint32_t>("member", groups.size());
  reader.check_values_below("member", members, groups.size());
  const auto parameters = read_ground_parameters(reader, groups.size() * zones);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto first = parameters.begin() + static_cast<std::ptrdiff_t>(i * zones);
    results.ground_sets.push_back(
        {groups[i], members[i], {first, first + static_cast<std::ptrdiff_t>(zones)}});
  }
}

// Refuses blocks that are impossible for any shape.
void check_blocks(const CheckedGroup& reader, const CampaignHeader& results) {
  constexpr double kRounding = 1e-6;
  for (const BlockSummary& block : results.blocks) {
    const auto require = [&](bool fine, const char* name, std::initializer_list<double> values) {
      if (fine) return;
      std::string list;
      for (const double value : values)
        list += (list.empty() ? "" : ", ") + format_significant(value, 6);
      reader.throw_damaged(name, "is " + list + ", which is impossible for block " + block.id);
    };
    require(block.mass > 0.0 && std::isfinite(block.mass), "mass_kg", {block.mass});
    require(block.volume >= 0.0 && std::isfinite(block.volume), "volume_m3", {block.volume});
    require(block.scale > 0.0 && std::isfinite(block.scale), "scale", {block.scale});
    require(std::isfinite(block.axes.L) && block.axes.L >= block.axes.I &&
                block.axes.I >= block.axes.S && block.axes.S > 0.0,
            "L_m", {block.axes.L, block.axes.I, block.axes.S});
    const Vec3& moments = block.moments;
    require(moments.allFinite() && moments.minCoeff() >= 0.0 &&
                2.0 * moments.maxCoeff() <= (1.0 + kRounding) * moments.sum(),
            "principal_moments_kg_m2", {moments.x(), moments.y(), moments.z()});
  }
}

void read_blocks(const CheckedGroup& reader, CampaignHeader& results) {
  const std::vector<std::string> ids = reader.group.read<std::string>("id");
  const std::size_t rows = ids.size();
  const auto mass = reader.column<double>("mass_kg", rows);
  const auto longest = reader.column<double>("L_m", rows);
  const auto middle = reader.column<double>("I_m", rows);
  const auto shortest = reader.column<double>("S_m", rows);
  const auto garcia = reader.column<std::string>("garcia", rows);
  const auto sneed_folk = reader.column<std::string>("sneed_folk", rows);
  const auto zingg = reader.column<std::string>("zingg", rows);
  const auto library_id = reader.column<std::string>("library_id", rows);
  const auto group = reader.column<std::string>("group", rows);
  const auto scale = reader.column<double>("scale", rows);
  const auto volume = reader.column<double>("volume_m3", rows);
  const auto shape = reader.column<std::uint32_t>("shape", rows);
  reader.check_values_below("shape", shape, results.shapes.size());
  const auto moments = reader.vectors<Vec3>("principal_moments_kg_m2");
  if (moments.size() != rows)
    reader.throw_damaged("principal_moments_kg_m2", "has not one row per block");
  // Added to schema 4 later.
  const auto text_or_none = [&](const char* name) {
    return reader.group.contains(name) ? reader.column<std::string>(name, rows)
                                       : std::vector<std::string>(rows);
  };
  const std::vector<std::string> parents = text_or_none("parent");
  const std::vector<std::string> variations = text_or_none("variation");
  for (std::size_t i = 0; i < rows; ++i) {
    results.blocks.push_back({ids[i],
                              mass[i],
                              {longest[i], middle[i], shortest[i]},
                              garcia[i],
                              sneed_folk[i],
                              zingg[i],
                              library_id[i],
                              group[i],
                              scale[i],
                              volume[i],
                              shape[i],
                              moments[i],
                              parents[i],
                              variations[i]});
  }
  check_blocks(reader, results);
}

void read_stored_barriers(const CheckedGroup& reader, CampaignHeader& results) {
  const std::vector<std::string> names = reader.group.read<std::string>("name");
  if (reader.group.contains("points_m")) {
    const auto counts = reader.column<std::uint32_t>("point_count", names.size());
    const auto points = reader.vectors<Vec2>("points_m");
    // Added to schema 4 later.
    const std::vector<std::string> directions =
        reader.group.contains("direction") ? reader.column<std::string>("direction", names.size())
                                           : std::vector<std::string>(names.size(), "either");
    std::size_t at = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (counts[i] < 2 || counts[i] > points.size() - at) {
        reader.throw_damaged("point_count", "does not fit points_m");
      }
      const auto begin = points.begin() + static_cast<std::ptrdiff_t>(at);
      if (directions[i] != "either" && directions[i] != "forward") {
        reader.throw_damaged("direction", "is neither either nor forward");
      }
      results.barriers.push_back(
          {names[i], {begin, begin + counts[i]}, parse_counted_direction(directions[i])});
      at += counts[i];
    }
    if (at != points.size())
      reader.throw_damaged("points_m", "has more points than the barriers have in total");
    return;
  }
  // Schema 2 had straight barriers only.
  const auto from = reader.vectors<Vec2>("from_m");
  const auto to = reader.vectors<Vec2>("to_m");
  if (from.size() != names.size() || to.size() != names.size()) {
    reader.throw_damaged("from_m", "and to_m do not have one row per name");
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    results.barriers.push_back({names[i], {from[i], to[i]}, CountedDirection::kEither});
  }
}

void read_ground_distributions(const CheckedGroup& reader, CampaignHeader& results) {
  results.zone_names = reader.group.read<std::string>("zone");
  results.ground = read_ground_parameters(reader, results.zone_names.size());
}

void read_terrain_group(const CheckedGroup& reader, CampaignHeader& results) {
  Terrain& terrain = results.terrain;
  terrain.surface.vertices = reader.vectors<Vec3>("vertices_m");
  const std::vector<std::uint32_t> corners = reader.group.read<std::uint32_t>("triangles");
  if (corners.size() % 3 != 0) reader.throw_damaged("triangles", "is not a table of 3 columns");
  reader.check_values_below("triangles", corners, terrain.surface.vertices.size());
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    terrain.surface.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  terrain.zone = reader.column<std::uint16_t>("zone", terrain.surface.triangles.size());
  terrain.zone_names = results.zone_names;
  reader.check_values_below("zone", terrain.zone, terrain.zone_names.size());
  terrain.report.notes = reader.group.read<std::string>("notes");
  terrain.sources = reader.group.read<std::string>("sources");
  const std::vector<Vec3> origin = reader.vectors<Vec3>("origin_m");
  if (origin.size() != 1) reader.throw_damaged("origin_m", "is not one point");
  terrain.frame = {origin.front(), reader.group.read_attribute<std::string>("crs")};
  results.frame = terrain.frame;
}

/// Reads rows by their columns, which are as long as "run".
/// @param common    values that all rows share, of columns that the file does not have
/// @param contacts  whether the runs tell of them
template <class Row>
void read_rows(const CheckedGroup& reader, std::vector<Row>& rows,
               const std::map<std::string, double>& common = {}, bool contacts = true) {
  rows.resize(reader.length("run"));
  visit_columns(
      kRowType<Row>, [&](const std::string& name, const auto&, const auto&, const auto& field) {
        using Value = std::remove_reference_t<decltype(std::invoke(field, rows.front()))>;
        if (!contacts && depends_on_contact_data(name)) {
          if constexpr (std::is_same_v<Value, double>) {
            for (Row& row : rows) std::invoke(field, row) = std::nan("");
          }
          return;
        }
        if constexpr (std::is_same_v<Value, double>) {
          if (const auto one = common.find(name); one != common.end()) {
            for (Row& row : rows) std::invoke(field, row) = one->second;
            return;
          }
        }
        const auto values = reader.column<StoredType<Row, decltype(field)>>(name, rows.size());
        if constexpr (std::is_same_v<Value, StopReason>) {
          reader.check_values_below(name, values, static_cast<std::size_t>(StopReason::kError) + 1);
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
          std::invoke(field, rows[i]) = static_cast<Value>(values[i]);
        }
      });
}

template <class Row>
void check_values_below(const CheckedGroup& reader, const char* name, const std::vector<Row>& rows,
                        std::uint32_t Row::*field, std::size_t limit) {
  std::vector<std::uint32_t> values;
  for (const Row& row : rows) values.push_back(row.*field);
  reader.check_values_below(name, values, limit);
}

void check_runs(const CheckedGroup& reader, const CampaignResults& results) {
  const std::vector<RunRecord>& runs = results.runs;
  check_values_below(reader, "run", runs, &RunRecord::run, results.planned_runs);
  check_values_below(reader, "block", runs, &RunRecord::block, results.blocks.size());
  check_values_below(reader, "ground_set", runs, &RunRecord::ground_set,
                     results.ground_sets.size());
  check_values_below(reader, "point", runs, &RunRecord::point, results.release_points.size());
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (runs[i].run <= runs[i - 1].run) {
      reader.throw_damaged("run", "holds " + std::to_string(runs[i].run) + " after " +
                                      std::to_string(runs[i - 1].run));
    }
  }
}

// Reads the stiffness from attributes of /contact, if it is the same for all runs; no depths.
std::map<std::string, double> common_stiffness(const Hdf5Group& contact) {
  std::map<std::string, double> common;
  visit_stiffness([&](const char* name, const auto&...) {
    if (common.empty() && !contact.has_attribute(name)) return;
    common[name] =
        contact.has_attribute(name) ? contact.read_attribute<double>(name) : std::nan("");
  });
  return common;
}

// Crossings and impacts are in order of runs that there are.
template <class Event>
void check_events(const CheckedGroup& reader, const std::vector<Event>& events,
                  const CampaignResults& results) {
  auto run = results.runs.begin();
  for (const Event& event : events) {
    while (run != results.runs.end() && run->run < event.run) ++run;
    if (run == results.runs.end() || run->run != event.run) {
      reader.throw_damaged("run", "holds run " + std::to_string(event.run) +
                                      ", which is not stored or not in order");
    }
  }
}

/// Added to schema 4 later; absent where every run had the terrain to itself.
void read_stays(const CheckedGroup& reader, CampaignResults& results) {
  const auto each = reader.group.read_attribute<std::int64_t>("blocks_each");
  if (each < 1 || results.planned_runs % each != 0) {
    reader.throw_damaged("@blocks_each", "is " + std::to_string(each) + " of " +
                                             std::to_string(results.planned_runs) + " runs");
  }
  GroundParameters between_blocks;
  for (const GroundParameterField& field : ground_parameter_fields()) {
    if (!field.required && !reader.group.has_attribute(field.name)) continue;
    between_blocks.*field.value = reader.group.read_attribute<double>(field.name);
  }
  results.persistent_blocks = {static_cast<std::uint32_t>(each), between_blocks};
  // Masses and removal came later still: without them, blocks came one by one, and all stayed.
  if (reader.group.has_attribute("at_once")) {
    results.persistent_blocks->at_once = reader.group.read_attribute<std::int64_t>("at_once") != 0;
  }
  std::map<std::string, double> absent;
  if (!reader.group.contains("removed_at_s")) absent["removed_at_s"] = std::nan("");
  read_rows(reader, results.persistent_block_records, absent, results.has_contacts());
  check_events(reader, results.persistent_block_records, results);
}

}  // namespace

CampaignResults read_results(const fs::path& path) {
  if (path.extension() == ".part" && fs::is_regular_file(path)) {
    throw InputError(path.string() +
                     ": holds the runs of an unfinished campaign; continue it first, by clast "
                     "simulate with `resume`");
  }
  const Hdf5File file = Hdf5File::open(path, kResultsFormat, kResultsSchema);
  const CheckedGroup root{path.string(), "", file.root()};
  const auto schema = root.group.read_attribute<std::int64_t>("schema_version");
  if (schema < kOldestResultsSchema) {
    throw InputError(path.string() + ": has schema version " + std::to_string(schema) +
                     " of an older clast, which kept less of each run; run the campaign again");
  }
  CampaignResults results;
  results.file = path;
  results.program_version = root.group.read_attribute<std::string>("program_version");
  results.campaign_sha256 = root.group.read_attribute<std::string>("campaign_sha256");
  results.campaign_text = root.column<std::string>("campaign", 1).front();
  results.inputs = root.group.read<std::string>("inputs");
  results.warnings = root.group.read<std::string>("warnings");
  // Added to schema 4 later.
  if (root.group.has_attribute("engine")) {
    results.engine = root.group.read_attribute<std::string>("engine");
  }
  if (root.group.has_attribute("physics_digest")) {
    results.physics_digest = root.group.read_attribute<std::string>("physics_digest");
  }
  const auto planned = root.group.read_attribute<std::int64_t>("planned_runs");
  if (planned < 0 || planned > std::numeric_limits<std::uint32_t>::max()) {
    root.throw_damaged("@planned_runs", "is " + std::to_string(planned));
  }
  results.planned_runs = static_cast<std::uint32_t>(planned);
  if (root.group.contains("downslope")) {
    const std::vector<Vec2> downslope = root.vectors<Vec2>("downslope");
    if (downslope.size() != 1) root.throw_damaged("downslope", "is not one direction");
    results.downslope = downslope.front();
  }
  results.release_points = root.vectors<Vec3>("release_points_m");
  results.release_sets = root.group.read<std::string>("release_sets");
  results.set_of_point = root.column<std::uint32_t>("set_of_point", results.release_points.size());
  root.check_values_below("set_of_point", results.set_of_point, results.release_sets.size());
  read_shapes(root.open_group("shapes"), results);
  read_blocks(root.open_group("blocks"), results);
  read_stored_barriers(root.open_group("barriers"), results);
  read_ground_distributions(root.open_group("ground"), results);
  read_ground_sets(root.open_group("ground_sets"), results);

  const Hdf5Group contact = root.group.open_group("contact");
  results.law = parse_contact_law(contact.read_attribute<std::string>("law"));
  results.weighting = parse_contact_weighting(contact.read_attribute<std::string>("weights"));
  read_terrain_group(root.open_group("terrain"), results);

  read_rows(root.open_group("runs"), results.runs, common_stiffness(contact),
            results.has_contacts());
  check_runs(root.open_group("runs"), results);
  const CheckedGroup crossings = root.open_group("crossings"), impacts = root.open_group("impacts");
  read_rows(crossings, results.crossings);
  check_values_below(crossings, "barrier", results.crossings, &Crossing::barrier,
                     results.barriers.size());
  check_events(crossings, results.crossings, results);
  read_rows(impacts, results.impacts);
  check_values_below(impacts, "zone", results.impacts, &Impact::zone, results.zone_names.size());
  check_events(impacts, results.impacts, results);
  if (root.group.contains("stays")) read_stays(root.open_group("stays"), results);
  if (root.group.contains("energies")) {
    const CheckedGroup energies = root.open_group("energies");
    read_rows(energies, results.energies);
    check_events(energies, results.energies, results);
  }
  return results;
}

}  // namespace clast
