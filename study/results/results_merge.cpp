#include <algorithm>
#include <span>

#include "core/error.hpp"
#include "study/results/results_file.hpp"

namespace clast {

using namespace study_detail;
namespace fs = std::filesystem;

namespace {

struct Part {
  CampaignResults results;
  TrajectoryFile trajectories;
};

/// A run, and the part that holds it.
struct RunPlace {
  std::uint32_t run = 0;
  std::size_t part = 0;
  std::size_t row = 0;             ///< into the part's runs
  std::size_t first_crossing = 0;  ///< into the part's crossings
  std::size_t first_impact = 0;    ///< into the part's impacts
  std::size_t first_stay = 0;      ///< into the part's stays
  std::size_t first_energy = 0;    ///< into the part's energies
};

void check_parts_of_one_campaign(const CampaignHeader& first, const CampaignHeader& other) {
  std::string difference;
  if (other.campaign_sha256 != first.campaign_sha256) {
    difference = "belongs to another campaign than ";
  } else if (other.inputs != first.inputs) {
    difference = "was made from different input files than ";
  } else if (other.program_version != first.program_version) {
    difference =
        "was made by clast " + other.program_version + ", not " + first.program_version + " like ";
  } else if (other.engine != first.engine) {
    difference = "was not computed by the same program as ";
  } else if (other.planned_runs != first.planned_runs) {
    difference = "has " + std::to_string(other.planned_runs) + " planned runs, not " +
                 std::to_string(first.planned_runs) + " like ";
  }
  if (difference.empty()) return;
  throw InputError(other.file.string() + ": " + difference + first.file.string() +
                   "; only parts of one campaign can be joined");
}

/// The digest that all parts have; empty where one has none, as of an older program.
/// @throws InputError  two parts have different ones
std::string common_physics(const std::vector<Part>& parts) {
  const CampaignHeader* known = nullptr;
  bool all = true;
  for (const Part& part : parts) {
    const CampaignHeader& results = part.results;
    all = all && !results.physics_digest.empty();
    if (results.physics_digest.empty()) continue;
    if (!known) known = &results;
    if (results.physics_digest == known->physics_digest) continue;
    throw InputError(results.file.string() +
                     ": was made by a program that computes different motions from that of " +
                     known->file.string() + " (physics digest " +
                     results.physics_digest.substr(0, 10) + ", there " +
                     known->physics_digest.substr(0, 10) + "), though both are clast " +
                     results.program_version + "; simulate all shards with one program");
  }
  return all ? known->physics_digest : "";
}

/// Those from `first` on that belong to the run.
template <class Event>
std::span<const Event> events_of(const std::vector<Event>& events, std::uint32_t run,
                                 std::size_t first) {
  std::size_t end = first;
  while (end < events.size() && events[end].run == run) ++end;
  return {events.data() + first, end - first};
}

std::vector<RunPlace> places_of(const std::vector<Part>& parts) {
  std::vector<RunPlace> places;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const CampaignResults& results = parts[part].results;
    std::size_t crossing = 0, impact = 0, stay = 0, energy = 0;
    for (std::size_t row = 0; row < results.runs.size(); ++row) {
      const std::uint32_t run = results.runs[row].run;
      places.push_back({run, part, row, crossing, impact, stay, energy});
      crossing += events_of(results.crossings, run, crossing).size();
      impact += events_of(results.impacts, run, impact).size();
      stay += events_of(results.persistent_block_records, run, stay).size();
      energy += events_of(results.energies, run, energy).size();
    }
  }
  std::sort(places.begin(), places.end(),
            [](const RunPlace& a, const RunPlace& b) { return a.run < b.run; });
  return places;
}

void check_complete(const std::vector<Part>& parts, const std::vector<RunPlace>& places) {
  const CampaignHeader& first = parts.front().results;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].run != places[i - 1].run) continue;
    throw InputError("run " + std::to_string(places[i].run) + " is in " +
                     parts[places[i - 1].part].results.file.string() + " and in " +
                     parts[places[i].part].results.file.string() + "; give every part once");
  }
  if (places.size() == first.planned_runs) return;
  std::uint32_t missing = 0;
  while (missing < places.size() && places[missing].run == missing) ++missing;
  throw InputError(std::to_string(first.planned_runs - places.size()) + " of " +
                   std::to_string(first.planned_runs) + " runs are in none of the parts, run " +
                   std::to_string(missing) + " first; of n shards it belongs to number (" +
                   std::to_string(missing / first.runs_per_realisation()) +
                   " mod n) + 1. Run the missing shard, then join");
}

}  // namespace

void merge_results(const std::vector<fs::path>& files, const fs::path& target) {
  if (files.empty()) throw InputError("no parts to join; name the files that the shards wrote");
  std::vector<Part> parts;
  for (const fs::path& file : files) {
    parts.push_back({read_results(file), TrajectoryFile(file)});
    check_parts_of_one_campaign(parts.front().results, parts.back().results);
  }
  parts.front().results.physics_digest = common_physics(parts);
  const std::vector<RunPlace> places = places_of(parts);
  check_complete(parts, places);
  write_results_file(target, parts.front().results, places.size(), [&](std::size_t i) {
    const RunPlace& place = places[i];
    const Part& part = parts[place.part];
    StoredRun run;
    run.record = part.results.runs[place.row];
    const auto crossings = events_of(part.results.crossings, place.run, place.first_crossing);
    run.crossings.assign(crossings.begin(), crossings.end());
    const auto impacts = events_of(part.results.impacts, place.run, place.first_impact);
    run.impacts.assign(impacts.begin(), impacts.end());
    const auto stays =
        events_of(part.results.persistent_block_records, place.run, place.first_stay);
    run.persistent_block_records.assign(stays.begin(), stays.end());
    const auto energies = events_of(part.results.energies, place.run, place.first_energy);
    run.energies.assign(energies.begin(), energies.end());
    if (part.trajectories.frame_count(place.run) > 0)
      run.trajectory = part.trajectories.read(place.run);
    return run;
  });
}

}  // namespace clast
