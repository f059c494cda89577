#include "study/calibrate/detail/site_outcomes.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace clast::study_detail {
namespace {

struct OutcomeColumn {
  const char* name;
  const char* unit;
  double (*value)(const OutcomeAtMoment&);
  void (*set)(OutcomeAtMoment&, double);
};
template <double OutcomeAtMoment::*member>
constexpr OutcomeColumn column_of(const char* name, const char* unit) {
  return {name, unit, [](const OutcomeAtMoment& at) { return at.*member; },
          [](OutcomeAtMoment& at, double value) { at.*member = value; }};
}
template <int axis>
constexpr OutcomeColumn place_column(const char* name) {
  return {name, "m", [](const OutcomeAtMoment& at) { return at.position[axis]; },
          [](OutcomeAtMoment& at, double value) { at.position[axis] = value; }};
}
using OutcomeColumns = std::span<const OutcomeColumn>;
constexpr OutcomeColumn kBarrierColumns[] = {
    column_of<&OutcomeAtMoment::speed>("speed_m_s", "m/s"),
    column_of<&OutcomeAtMoment::spin>("spin_rad_s", "rad/s"),
    column_of<&OutcomeAtMoment::height>("height_m", "m"),
    column_of<&OutcomeAtMoment::energy>("energy_j", "J")};
constexpr OutcomeColumn kMomentColumns[] = {
    column_of<&OutcomeAtMoment::speed>("speed_m_s", "m/s"),
    column_of<&OutcomeAtMoment::spin>("spin_rad_s", "rad/s"),
    column_of<&OutcomeAtMoment::energy>("energy_j", "J"),
    column_of<&OutcomeAtMoment::depth>("depth_m", "m"),
    place_column<0>("x_m"),
    place_column<1>("y_m")};

void write_doubles(Hdf5Group& group, const std::string& name, const std::string& unit,
                   const std::vector<double>& values, const std::vector<std::size_t>& shape = {}) {
  group.write<double>(name, values, shape);
  if (!unit.empty()) group.set_unit(name, unit);
}

/// A table of runs x barriers or moments for each column.
void write_outcomes(Hdf5Group& group, OutcomeColumns columns, const MemberOutcomes& members,
                    std::vector<OutcomeAtMoment> ReleaseOutcome::*of, std::size_t width) {
  for (const OutcomeColumn& column : columns) {
    std::vector<double> values;
    std::size_t rows = 0;
    for (const std::vector<ReleaseOutcome>& member : members) {
      rows += member.size();
      for (const ReleaseOutcome& outcome : member) {
        for (const OutcomeAtMoment& at : outcome.*of) values.push_back(column.value(at));
      }
    }
    write_doubles(group, column.name, column.unit, values, {rows, width});
  }
}

void read_release_outcomes(const CheckedGroup& group, OutcomeColumns columns,
                           std::vector<ReleaseOutcome>& runs,
                           std::vector<OutcomeAtMoment> ReleaseOutcome::*of, std::size_t width) {
  if (width == 0) return;
  for (ReleaseOutcome& run : runs) (run.*of).resize(width);
  for (const OutcomeColumn& column : columns) {
    const auto values = group.column<double>(column.name, runs.size() * width);
    for (std::size_t i = 0; i < values.size(); ++i) {
      column.set((runs[i / width].*of)[i % width], values[i]);
    }
  }
}

/// Impacts by their number, then times, as `SiteDescription::moments` has them.
void write_moments(Hdf5Group& group, const std::vector<ObservedMoment>& moments) {
  std::vector<double> impacts, times;
  for (const ObservedMoment& moment : moments) {
    (moment.kind == ObservedMoment::Kind::kImpact ? impacts : times).push_back(moment.value);
  }
  write_doubles(group, "impacts", "", impacts);
  write_doubles(group, "times_s", "s", times);
}

std::vector<ObservedMoment> read_moments(const Hdf5Group& group) {
  std::vector<ObservedMoment> moments;
  if (!group.contains("impacts")) return moments;
  for (const double number : group.read<double>("impacts")) {
    moments.push_back({ObservedMoment::Kind::kImpact, number});
  }
  for (const double time : group.read<double>("times_s")) {
    moments.push_back({ObservedMoment::Kind::kTime, time});
  }
  return moments;
}

}  // namespace

void write_site_outcomes(Hdf5Group group, const SiteDescription& site,
                         const MemberOutcomes& members, const std::vector<bool>& done) {
  group.set_attribute<std::string>("name", site.name);
  group.write<std::string>("blocks", site.blocks);
  group.write<std::string>("shapes", site.shapes);
  group.write<std::string>("barriers", site.barriers);
  group.write<std::string>("releases", site.releases);
  if (!site.moments.empty()) write_moments(group, site.moments);
  group.write<double>("downslope", std::span(site.downslope.data(), 2));
  group.write<double>("middle_of_starts_m", std::span(site.mean_start.data(), 2));
  group.set_unit("middle_of_starts_m", "m");
  group.write<std::uint8_t>("done", std::vector<std::uint8_t>(done.begin(), done.end()));
  std::vector<std::uint32_t> member, block, point, release;
  std::vector<double> start, stop;
  for (std::uint32_t m = 0; m < members.size(); ++m) {
    for (const ReleaseOutcome& outcome : members[m]) {
      member.push_back(m);
      block.push_back(outcome.block);
      point.push_back(outcome.point);
      release.push_back(outcome.release);
      start.insert(start.end(), outcome.start.begin(), outcome.start.end());
      stop.insert(stop.end(), outcome.stop.begin(), outcome.stop.end());
    }
  }
  Hdf5Group runs = group.create_group("runs");
  runs.write<std::uint32_t>("member", member);
  runs.write<std::uint32_t>("block", block);
  runs.write<std::uint32_t>("point", point);
  runs.write<std::uint32_t>("release", release);
  write_doubles(runs, "start_m", "m", start, {member.size(), 2});
  write_doubles(runs, "stop_m", "m", stop, {member.size(), 2});
  write_outcomes(runs, kBarrierColumns, members, &ReleaseOutcome::barriers, site.barriers.size());
  if (site.moments.empty()) return;
  Hdf5Group moments = runs.create_group("moments");
  write_outcomes(moments, kMomentColumns, members, &ReleaseOutcome::moments, site.moments.size());
}

SiteDescription read_site_description(const CheckedGroup& site) {
  SiteDescription facts;
  facts.name = site.group.read_attribute<std::string>("name");
  facts.blocks = site.group.read<std::string>("blocks");
  facts.shapes = site.column<std::string>("shapes", facts.blocks.size());
  facts.barriers = site.group.read<std::string>("barriers");
  const std::vector<double> downslope = site.column<double>("downslope", 2);
  const std::vector<double> middle = site.column<double>("middle_of_starts_m", 2);
  facts.downslope = {downslope[0], downslope[1]};
  facts.mean_start = {middle[0], middle[1]};
  if (site.group.contains("releases")) facts.releases = site.group.read<std::string>("releases");
  facts.moments = read_moments(site.group);
  return facts;
}

MemberOutcomes read_release_outcomes(const CheckedGroup& runs, const SiteDescription& facts,
                                     std::size_t members) {
  const auto member = runs.group.read<std::uint32_t>("member");
  const std::size_t rows = member.size();
  const auto block = runs.column<std::uint32_t>("block", rows);
  const auto point = runs.column<std::uint32_t>("point", rows);
  const auto start = runs.column<double>("start_m", 2 * rows);
  const auto stop = runs.column<double>("stop_m", 2 * rows);
  const auto release = runs.group.contains("release") ? runs.column<std::uint32_t>("release", rows)
                                                      : std::vector<std::uint32_t>(rows, 0);
  std::vector<ReleaseOutcome> outcomes(rows);
  read_release_outcomes(runs, kBarrierColumns, outcomes, &ReleaseOutcome::barriers,
                        facts.barriers.size());
  if (!facts.moments.empty()) {
    read_release_outcomes(runs.open_group("moments"), kMomentColumns, outcomes,
                          &ReleaseOutcome::moments, facts.moments.size());
  }
  MemberOutcomes all(members);
  for (std::size_t i = 0; i < rows; ++i) {
    if (member[i] >= members)
      runs.throw_damaged("member", "refers to a member that does not exist");
    if (block[i] >= facts.blocks.size())
      runs.throw_damaged("block", "refers to a block that does not exist");
    if (!facts.releases.empty() && release[i] >= facts.releases.size()) {
      runs.throw_damaged("release", "refers to a release set that does not exist");
    }
    ReleaseOutcome& outcome = outcomes[i];
    outcome.block = block[i];
    outcome.point = point[i];
    outcome.release = release[i];
    outcome.start = {start[2 * i], start[2 * i + 1]};
    outcome.stop = {stop[2 * i], stop[2 * i + 1]};
    all[member[i]].push_back(std::move(outcome));
  }
  return all;
}

}  // namespace clast::study_detail
