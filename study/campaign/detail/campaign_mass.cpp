// [[mass]] of a campaign file.
#include <algorithm>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/campaign/barrier_line.hpp"
#include "study/campaign/campaign_keys.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/plan_polygon.hpp"

namespace clast::study_detail {

namespace {

/// Shares that add up to 1 may be written with few digits.
constexpr double kMassShareSlack = 1e-6;

/// All of them, with their keys known.
std::vector<TomlTable> mass_tables(const TomlTable& top) {
  std::vector<TomlTable> tables;
  for (const TomlNode* node : tables_of(top, "mass")) {
    tables.emplace_back(*node, top.file(), "[mass]", campaign_keys("mass"));
  }
  return tables;
}

/// What holds for all masses together is given once.
void refuse_repeated(const std::vector<TomlTable>& tables) {
  for (std::size_t i = 1; i < tables.size(); ++i) {
    for (const char* key : {"realisations", "seed"}) {
      if (const TomlNode* node = tables[i].find(key)) {
        tables[i].refuse(key, *node,
                         "holds for all masses together; give it in the first [[mass]] alone");
      }
    }
  }
}

void check_polygon(const TomlTable& table, const MassPlan& mass) {
  try {
    check_has_area(mass.polygon);
  } catch (const InputError& error) {
    table.refuse("polygon", *table.find("polygon"), error.what());
  }
  std::vector<Vec2> ring;
  for (const Vec2& corner : mass.polygon) {
    if (ring.empty() || corner != ring.back()) ring.push_back(corner);
  }
  if (ring.front() != ring.back()) ring.push_back(ring.front());
  if (const std::optional<SelfContact> found = find_self_contact(ring)) {
    table.refuse("polygon", *table.find("polygon"),
                 "must not cross, touch or retrace itself, and its sides " +
                     std::to_string(found->first + 1) + " and " +
                     std::to_string(found->second + 1) + " meet at [" +
                     with_digits(found->place.x(), 9) + ", " + with_digits(found->place.y(), 9) +
                     "]; give the corners in their order around it");
  }
}

/// Of a mass whose blocks are where they were cut or scanned.
void read_places(const TomlTable& table, const Campaign& campaign, MassPlan& mass) {
  for (const char* key : {"thickness_m", "share", "count", "settle"}) {
    if (const TomlNode* node = table.find(key)) {
      table.refuse(key, *node, "is for a heap; blocks that are in place have theirs already");
    }
  }
  if (campaign.blocks.draw || campaign.blocks.scale.kind != BlockScale::Kind::kNone) {
    table.refuse("in_place", *table.find("in_place"),
                 "blocks in place are neither drawn nor scaled; leave [blocks] draw and scale out");
  }
  if (campaign.blocks.vary) {
    table.refuse("in_place", *table.find("in_place"),
                 "blocks in place run as they are; leave [blocks] vary out");
  }
  mass.raised = table.number("height_m", kDropHeight).value_or(0.0);
  const TomlNode* polygon = table.find("polygon");
  if (campaign.releases.size() == 1) {
    if (!polygon) return;
    table.refuse("polygon", *polygon,
                 "is for a heap, or for one of several masses in place; a single one has all "
                 "blocks");
  }
  mass.polygon = read_polygon(
      table, "polygon",
      table.required("polygon", "[[x, y], ...]; a block belongs to the mass that it lies in"));
  check_polygon(table, mass);
}

/// Whether and how the blocks of a heap settle.
void read_settling(const TomlTable& table, MassPlan& mass) {
  mass.settle = table.boolean("settle").value_or(false);
  for (const char* key : {"settle_time_s", "faces", "face_interval_s"}) {
    const TomlNode* node = table.find(key);
    if (node && !mass.settle)
      table.refuse(key, *node, "is for a heap that settles; add settle = true");
  }
  if (!mass.settle) return;
  mass.settle_time = table.number("settle_time_s", kSettleTime).value_or(mass.settle_time);
  if (campaign_choice(table, "mass", "faces") == "one by one") {
    table.required("face_interval_s", "the time from one face to the next");
    mass.face_interval = *table.number("face_interval_s", kFaceInterval);
  } else if (const TomlNode* node = table.find("face_interval_s")) {
    table.refuse("face_interval_s", *node, "is for faces = \"one by one\"");
  }
  if (const std::optional<std::size_t> corner = reflex_corner(mass.polygon)) {
    const Vec2& place = mass.polygon[*corner];
    table.refuse("polygon", *table.find("polygon"),
                 "is not convex at its corner " + std::to_string(*corner + 1) + ", [" +
                     with_digits(place.x(), 9) + ", " + with_digits(place.y(), 9) +
                     "]; blocks settle behind the faces of a convex one, so divide it into several "
                     "[[mass]]");
  }
}

void read_heap(const TomlTable& table, MassPlan& mass) {
  if (const TomlNode* node = table.find("height_m")) {
    table.refuse("height_m", *node, "is for blocks in place; a heap lies on the ground");
  }
  mass.polygon = read_polygon(table, "polygon",
                              table.required("polygon", "[[x, y], ...]; or give in_place = true"));
  mass.thickness = table.number("thickness_m", kThickness);
  check_polygon(table, mass);
  read_settling(table, mass);
  mass.share = table.number("share", kMassShare);
  if (const std::optional<std::uint64_t> count = table.count("count", 1, kMostPerSet)) {
    if (mass.share) {
      table.refuse("count", *table.find("count"), "contradicts share; keep one of the two");
    }
    mass.count = static_cast<std::uint32_t>(*count);
  }
}

/// Do the shares leave something to every mass, and nothing to none?
void check_mass_shares(const std::vector<TomlTable>& tables, const std::vector<MassPlan>& masses) {
  double sum = 0.0;
  bool all = true, any = false;
  const TomlTable* last = nullptr;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    all &= masses[i].share.has_value();
    if (!masses[i].share) continue;
    any = true;
    sum += *masses[i].share;
    last = &tables[i];
  }
  if (!any || (all ? std::abs(sum - 1.0) <= kMassShareSlack : sum < 1.0)) return;
  last->refuse("share", *last->find("share"),
               "makes the shares of all masses add up to " + with_digits(sum, 6) +
                   (all ? "; they must add up to 1, or leave share out of one mass"
                        : "; they must leave something to the mass without a share"));
}

MassPlan read_mass(const TomlTable& table, const Campaign& campaign) {
  MassPlan mass;
  mass.in_place = table.boolean("in_place").value_or(false);
  mass.release_time = table.number("release_time_s", kReleaseTime).value_or(0.0);
  if (mass.in_place) {
    read_places(table, campaign, mass);
  } else {
    read_heap(table, mass);
  }
  return mass;
}

}  // namespace

std::vector<ReleasePlan> read_mass_releases(const TomlTable& top) {
  const std::vector<TomlTable> tables = mass_tables(top);
  std::vector<ReleasePlan> releases;
  if (tables.empty()) return releases;
  if (top.find("release")) {
    tables.front().refuse(
        "the blocks of a mass are not released from points; leave out [release], or [mass]");
  }
  refuse_repeated(tables);
  ReleasePlan release;
  release.seed = tables.front().count("seed", 0, INT64_MAX).value_or(release.seed);
  release.orientation_seed = release.seed;
  release.orientation_source = "random";
  release.orientations = {Quat::Identity()};
  release.in_principal_frame = true;
  release.fresh_orientations = true;
  for (const TomlTable& table : tables) {
    if (tables.size() > 1) table.required("name", "a text in quotes, since there are several");
    release.name = table.text("name").value_or("");
    if (const TomlNode* name = table.find("name");
        name && release.name.find_first_not_of(" \t") == std::string::npos) {
      table.refuse("name", *name, "must not be blank");
    }
    for (const ReleasePlan& other : releases) {
      if (other.name != release.name) continue;
      table.refuse("name", *table.find("name"), "another mass has this name");
    }
    releases.push_back(release);
  }
  return releases;
}

std::optional<StayPlan> read_masses(const TomlTable& top, const Campaign& campaign) {
  const std::vector<TomlTable> tables = mass_tables(top);
  if (tables.empty()) return std::nullopt;
  const TomlTable& first = tables.front();
  if (!campaign.groups.empty()) {
    first.refuse("the blocks of a mass share one ground; leave the block groups out");
  }
  StayPlan plan;
  plan.realisations = read_realisations(first);
  for (const TomlTable& table : tables) {
    plan.masses.push_back(read_mass(table, campaign));
    if (plan.masses.back().in_place != plan.masses.front().in_place) {
      table.refuse(
          "either all masses are in place or none is, since blocks in place are neither drawn nor "
          "packed; make a campaign for each kind");
    }
  }
  check_mass_shares(tables, plan.masses);
  const auto at_first = [](const MassPlan& mass) { return mass.release_time == 0.0; };
  if (std::none_of(plan.masses.begin(), plan.masses.end(), at_first)) {
    first.refuse("release_time_s", *first.find("release_time_s"),
                 "times count from the first release, and no mass is released then; leave "
                 "release_time_s out of the one that fails first");
  }
  plan.random_order = !plan.masses.front().in_place;
  plan.between_blocks = read_between_blocks(top, "the blocks of a mass");
  return plan;
}

}  // namespace clast::study_detail
