// [[mass]] of a campaign file.
#include <algorithm>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/campaign/barrier_line.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/plan_polygon.hpp"

namespace clast::study_detail {

namespace {

/// Shares that add up to 1 may be written with few digits.
constexpr double kMassShareSlack = 1e-6;

/// Refuses keys that hold for all masses in any but the first.
void refuse_repeated(const std::vector<DeclaredTable>& tables) {
  for (std::size_t i = 1; i < tables.size(); ++i) {
    for (const char* key : {"realisations", "seed"}) {
      tables[i].refuse_if_present(
          key, "applies to all masses together; give it only in the first [[mass]]");
    }
  }
}

void check_polygon(const DeclaredTable& table, const MultiBlockRelease& mass) {
  const TomlNode& node = *table.find("polygon");
  table.run_check("polygon", [&] { check_has_area(mass.polygon); });
  std::vector<Vec2> ring;
  for (const Vec2& corner : mass.polygon) {
    if (ring.empty() || corner != ring.back()) ring.push_back(corner);
  }
  if (ring.front() != ring.back()) ring.push_back(ring.front());
  if (const std::optional<LineSelfIntersection> found = find_line_self_intersection(ring)) {
    table.refuse("polygon", node,
                 "must not cross, touch or retrace itself, and its sides " +
                     std::to_string(found->first + 1) + " and " +
                     std::to_string(found->second + 1) + " meet at [" +
                     format_significant(found->position.x(), 9) + ", " +
                     format_significant(found->position.y(), 9) +
                     "]; give the corners in their order around it");
  }
}

/// Checks a mass whose blocks are where they were cut or scanned.
void check_places(const DeclaredTable& table, const Campaign& campaign,
                  const MultiBlockRelease& mass) {
  for (const char* key :
       {"thickness_m", "share", "count", "settle", "settle_time_s", "faces", "face_interval_s"}) {
    table.refuse_if_present(key, "applies to a heap; blocks in place already have their position");
  }
  if (campaign.blocks.draw || campaign.blocks.scale.kind != BlockScaling::Kind::kNone) {
    table.refuse("in_place",
                 "blocks in place are neither drawn nor scaled; leave [blocks] draw and scale out");
  }
  if (campaign.blocks.vary) {
    table.refuse("in_place", "blocks in place can't be varied; leave [blocks] vary out");
  }
  if (campaign.releases.size() == 1) {
    table.refuse_if_present("polygon",
                            "applies to a heap, or to one of several masses in place; a single "
                            "mass in place has all blocks");
    return;
  }
  table.require_key("polygon", "[[x, y], ...]; a block belongs to the mass in which it lies");
  check_polygon(table, mass);
}

/// Checks how the blocks of a heap settle.
void check_settling(const DeclaredTable& table, const MultiBlockRelease& mass) {
  if (!mass.settle) {
    for (const char* key : {"settle_time_s", "faces", "face_interval_s"}) {
      table.refuse_if_present(key, "applies to a heap that settles; add settle = true");
    }
    return;
  }
  if (table.value<std::string>("faces") == "one by one") {
    table.require_key("face_interval_s", "the time between the removal of two faces");
  } else {
    table.refuse_if_present("face_interval_s", "applies to faces = \"one by one\"");
  }
  if (const std::optional<std::size_t> corner = find_reflex_vertex(mass.polygon)) {
    const Vec2& place = mass.polygon[*corner];
    table.refuse("polygon",
                 "is not convex at its corner " + std::to_string(*corner + 1) + ", [" +
                     format_significant(place.x(), 9) + ", " + format_significant(place.y(), 9) +
                     "]; blocks settle behind the faces of a convex one, so divide it into several "
                     "[[mass]]");
  }
}

void check_heap(const DeclaredTable& table, const MultiBlockRelease& mass) {
  table.refuse_if_present("height_m", "applies to blocks in place; a heap lies on the ground");
  table.require_key("polygon", "[[x, y], ...]; or give in_place = true");
  check_polygon(table, mass);
  check_settling(table, mass);
  if (mass.count && mass.share) {
    table.refuse("count", "contradicts share; keep one of the two");
  }
}

/// Refuses shares that leave nothing to a mass, or a part of the blocks to none.
void check_mass_shares(const std::vector<DeclaredTable>& tables,
                       const std::vector<MultiBlockRelease>& masses) {
  double sum = 0.0;
  bool all = true, any = false;
  const DeclaredTable* last = nullptr;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    all &= masses[i].share.has_value();
    if (!masses[i].share) continue;
    any = true;
    sum += *masses[i].share;
    last = &tables[i];
  }
  if (!any || (all ? std::abs(sum - 1.0) <= kMassShareSlack : sum < 1.0)) return;
  last->refuse("share", "makes the sum of the fractions of all masses " +
                            format_significant(sum, 6) +
                            (all ? "; it must be 1, or leave share out of one mass"
                                 : "; some blocks must remain for the mass without a share"));
}

MultiBlockRelease read_mass(const DeclaredTable& table, const Campaign& campaign) {
  MultiBlockRelease mass;
  multi_block_release_keys().read(table, mass);
  if (mass.in_place) {
    check_places(table, campaign, mass);
  } else {
    check_heap(table, mass);
  }
  return mass;
}

}  // namespace

const MemberTable<MultiBlockRelease>& multi_block_release_keys() {
  using Mass = MultiBlockRelease;
  static const MemberTable<Mass> keys(
      {"mass", "A rock mass, whose blocks are released together", KeyTable::Repeat::kEither},
      {{"name", "", "name of the mass, required if there are several", text_format()},
       {"in_place", "", "blocks start at their position in the library", flag_format(),
        &Mass::in_place},
       {"height_m", "m", "height by which a mass in place is raised",
        number_format(kDropHeightRange), &Mass::height_offset},
       {"polygon", "m", "outline in plan of a heap, or of one of several masses in place",
        list_format(point_format(), 3), &Mass::polygon},
       {"thickness_m", "m", "largest height of a heap above the ground", number_format({1e-3, 1e3}),
        &Mass::thickness},
       {"share", "", "fraction of the blocks in this heap", number_format({1e-6, 1.0}),
        &Mass::share},
       {"count", "", "number of blocks in this heap", count_format(1, kMaxItemsPerSet),
        &Mass::count},
       {"release_time_s", "s", "time at which the blocks are released, since the first release",
        number_format({1e-6, 1e5, "s", "at the first release"}), &Mass::release_time},
       {"settle", "", "the blocks of a heap settle before it is released", flag_format(),
        &Mass::settle},
       {"settle_time_s", "s", "time after which the settled blocks must be at rest",
        number_format({1e-2, 1e4}), &Mass::settle_time},
       {"faces", "", "removal of the confining walls of a heap that settles",
        word_format({"together", "one by one"})},
       {"face_interval_s", "s", "time between the removal of two faces", number_format({1e-3, 1e4}),
        &Mass::face_interval},
       {"realisations", "", "number of releases of the masses", count_format(1, kMaxItemsPerSet)},
       {"seed", "", "seed of all random draws", seed_format()}});
  return keys;
}

std::vector<ReleaseSet> read_mass_releases(const TomlTable& top) {
  const std::vector<DeclaredTable> tables = find_tables(top, multi_block_release_keys());
  std::vector<ReleaseSet> releases;
  if (tables.empty()) return releases;
  if (top.find("release")) {
    tables.front().refuse(
        "the blocks of a mass are not released from points; leave out [release], or [mass]");
  }
  refuse_repeated(tables);
  ReleaseSet release;
  tables.front().read("seed", release.seed);
  release.orientation_seed = release.seed;
  release.orientation_source = "random";
  release.orientations = {Quat::Identity()};
  release.in_principal_frame = true;
  release.fresh_orientations = true;
  for (const DeclaredTable& table : tables) {
    if (tables.size() > 1) table.require_key("name", "a text in quotes, since there are several");
    release.name = table.read_text("name").value_or("");
    if (const TomlNode* name = table.find("name");
        name && release.name.find_first_not_of(" \t") == std::string::npos) {
      table.refuse("name", *name, "must not be blank");
    }
    check_unique_name(table, release.name, releases, "mass");
    releases.push_back(release);
  }
  return releases;
}

std::optional<PersistentBlocksPlan> read_multi_block_releases(const TomlTable& top,
                                                              const Campaign& campaign) {
  const std::vector<DeclaredTable> tables = find_tables(top, multi_block_release_keys());
  if (tables.empty()) return std::nullopt;
  const DeclaredTable& first = tables.front();
  if (!campaign.groups.empty()) {
    first.refuse("the blocks of a mass share one ground; leave the block groups out");
  }
  PersistentBlocksPlan plan;
  plan.realisations = read_realisations(first);
  for (const DeclaredTable& table : tables) {
    plan.masses.push_back(read_mass(table, campaign));
    if (plan.masses.back().in_place != plan.masses.front().in_place) {
      table.refuse(
          "either all masses are in place or none, since blocks in place are neither drawn nor "
          "packed; make a campaign for each kind");
    }
  }
  check_mass_shares(tables, plan.masses);
  const auto at_first = [](const MultiBlockRelease& mass) { return mass.release_time == 0.0; };
  if (std::none_of(plan.masses.begin(), plan.masses.end(), at_first)) {
    first.refuse("release_time_s",
                 "times count from the first release, but no mass is released at time 0; leave "
                 "release_time_s out of the mass that fails first");
  }
  plan.random_order = !plan.masses.front().in_place;
  plan.between_blocks = read_between_blocks(top, "the blocks of a mass");
  return plan;
}

}  // namespace clast::study_detail
