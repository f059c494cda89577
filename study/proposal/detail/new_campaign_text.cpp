// The text of a proposed campaign.
#include <algorithm>
#include <map>
#include <string_view>

#include "core/angle.hpp"
#include "core/files/toml_text.hpp"
#include "core/number_text.hpp"
#include "study/proposal/new_campaign.hpp"

namespace clast {
namespace {

constexpr std::string_view kCampaign =
    R"(# A campaign to begin with, written by clast new campaign. It runs as it is, but where blocks
# start, what the ground is and where they are counted are proposals: go through all of it before
# you use its results. Paths are relative to this file, lengths in metres, x and y on the map;
# every key is in docs/formats.md.
#   clast check FILE      says whether it would run, and what would
#   clast simulate FILE -o results.h5
#   clast compare results.h5 -o report
<notes>
[blocks]
library            = <library>
<blocks>
[terrain]
surface            = <surface>
border_distance_m  = <margin>  # releases nearer to the border are warned of

# Ground. energy_restitution is the share of energy that an impact gives back, friction decides on
# which slopes blocks slide, rolling_friction how far they roll. All three are usual values of
# kinds of ground and not of this site, and decide how far blocks go: calibrate them on stops seen
# there, or give ranges, friction = { uniform = [0.5, 0.8] } with [ensemble] members = 20. How far
# a block turns before rolling resistance has built up matters as much: rolling_length_m is half
# the length of the ground that carries a block, here half of S of the middle block. Sources and
# effects: docs/parameters.md.
<ground>
# Releases: on ground of <slope> degrees at a height of <height> m, proposed from the shape of the
# terrain. Put the places where blocks come loose: a line, a { polygon = [[x, y], ...], count = N },
# or a file of points.
[release]
points             = <points>
height_m           = 1  # of fall to the ground
orientations       = { random = <orientations>, seed = 1 }  # at each point; take 64 or more for results

# Where passing blocks are counted, with speed, energy and height: across the path, <descent> m below
# the releases and <distance> m away. Move it to what is to be protected, and add others.
[[barrier]]
name               = <barrier>
from               = <from>
to                 = <to>

[run]
max_time_s         = <time>  # a run that lasts longer is stopped there; trial runs took up to <longest> s
downslope          = <downslope>  # lateral deviation is measured from it
)";

constexpr std::string_view kZone = R"(
# <why> <type> (<description>).
# <source>.
[ground.<zone>]
energy_restitution = <e_n^2>
friction           = <mu>
rolling_friction   = <mu_R>
rolling_length_m   = <a>
)";

constexpr std::string_view kSizedBlocks =
    R"(# <count>. To take only some of them, add select = ["ID", ...] or
# select = { scheme = "garcia", class = "compact" }. To compare shapes alone, bring all to one mass:
# scale            = "equal-mass"
)";

constexpr std::string_view kUnscaledBlocks =
    R"(# The photographs of these blocks gave no scale: their shape is known, their size is not. The mass
# is an assumption; put the one that you mean.
scale              = { mass_kg = <mass> }  # of each
)";

/// The text with a value in the place of each "<name>".
std::string filled(std::string_view text, const std::map<std::string, std::string>& values) {
  std::string result;
  for (std::size_t open = 0; (open = text.find('<')) != text.npos;) {
    const std::size_t close = text.find('>');
    result += text.substr(0, open);
    result += values.at(std::string(text.substr(open + 1, close - open - 1)));
    text.remove_prefix(close + 1);
  }
  return result.append(text);
}

std::string toml_list(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts)
    result += (result.empty() ? "" : ", ") + format_toml_string(text);
  return "[" + result + "]";
}

std::string pair_text(double x, double y) {
  return "[" + format_decimals(x, 3) + ", " + format_decimals(y, 3) + "]";
}

std::string place_text(const Vec3& place) { return pair_text(place.x(), place.y()); }

std::string format_blocks_table(const ProposedBlocks& blocks) {
  const std::string select =
      blocks.selected.empty() ? "" : "select             = " + toml_list(blocks.selected) + "\n";
  const std::string about =
      blocks.mass ? filled(kUnscaledBlocks, {{"mass", format_significant(*blocks.mass, 6)}})
                  : filled(kSizedBlocks, {{"count", format_count(blocks.count, "block")}});
  return select + about;
}

/// The number with a comment, all in one column.
std::string commented(double value, const std::string& remark) {
  std::string text = format_significant(value, 3);
  text.resize(std::max<std::size_t>(text.size(), 5), ' ');
  return text + "  # " + remark;
}

std::string zone_text(const ProposedGround& zone, double rolling_length) {
  const auto usual = [](const TypicalValue& number, const std::string& symbol) {
    return commented(number.value, symbol + ", usual " + format_significant(number.low, 3) +
                                       " to " + format_significant(number.high, 3));
  };
  return filled(kZone,
                {{"why", zone.identified_by_name ? "By its name:"
                                                 : "Its name gives no ground type; assumed to be"},
                 {"type", zone.type.name},
                 {"description", zone.type.description},
                 {"source", zone.type.source},
                 {"zone", format_toml_key(zone.zone)},
                 {"e_n^2", usual(zone.type.energy_restitution, "e_n^2")},
                 {"mu", usual(zone.type.friction, "mu")},
                 {"mu_R", usual(zone.type.rolling_friction, "mu_R")},
                 {"a", commented(rolling_length, "a; calibrate it too")}});
}

}  // namespace

std::string format_campaign_text(const CampaignProposal& proposal, const std::string& library,
                                 const std::vector<std::string>& surface) {
  const ProposedReleaseAndBarrier& places = proposal.places;
  std::string notes, ground;
  for (const std::string& doubt : proposal.proposal_warnings) notes += "#\n# NOTE: " + doubt + "\n";
  for (const ProposedGround& zone : proposal.ground) {
    ground += zone_text(zone, 0.5 * proposal.blocks.shortest_side);
  }
  const std::string line = place_text(places.releases.from) + ", " + place_text(places.releases.to);
  return filled(
      kCampaign,
      {{"notes", notes},
       {"library", format_toml_string(library)},
       {"blocks", format_blocks_table(proposal.blocks)},
       {"surface", surface.size() == 1 ? format_toml_string(surface.front()) : toml_list(surface)},
       {"margin", format_significant(places.margin, 2)},
       {"ground", ground},
       {"slope", format_decimals(places.release_slope * kDegreesPerRadian, 0)},
       {"height", format_decimals(places.releases.from.z(), 0)},
       {"points", places.release_points == 1 ? "[" + place_text(places.releases.from) + "]"
                                             : "{ line = [" + line + "], count = " +
                                                   std::to_string(places.release_points) + " }"},
       {"orientations", std::to_string(proposal.orientations)},
       {"descent", format_decimals(places.descent, 0)},
       {"distance", format_decimals(places.distance, 0)},
       {"barrier", format_toml_string(places.barrier_name)},
       {"from", place_text(places.barrier.from)},
       {"to", place_text(places.barrier.to)},
       {"time", format_significant(proposal.max_time, 4)},
       {"longest", format_significant(proposal.trial.longest, 2)},
       {"downslope", pair_text(places.downslope.x(), places.downslope.y())}});
}

}  // namespace clast
