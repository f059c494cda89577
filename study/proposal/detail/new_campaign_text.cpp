// The text of a proposed campaign.
#include <algorithm>

#include "core/angle.hpp"
#include "core/number_text.hpp"
#include "study/proposal/new_campaign.hpp"

namespace clast {
namespace {

/// A TOML string in double quotes.
std::string toml_string(const std::string& text) {
  std::string result = "\"";
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      result += {'\\', character};
    } else if (byte < 0x20 || byte == 0x7f) {
      constexpr const char* kHex = "0123456789ABCDEF";
      result += std::string("\\u00") + kHex[byte >> 4] + kHex[byte & 15];
    } else {
      result += character;
    }
  }
  return result + "\"";
}

/// A key as it is where TOML allows that.
std::string key(const std::string& name) {
  const bool bare =
      !name.empty() && name.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyz"
                           "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos;
  return bare ? name : toml_string(name);
}

/// Words on lines of comment, each at most `width` characters.
std::string comment(const std::string& text, std::size_t width = 98) {
  std::string lines, line = "#";
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (line.size() + 1 + end - at > width && line.size() > 1) {
      lines += line + "\n";
      line = "#";
    }
    line += " " + text.substr(at, end - at);
    at = end + 1;
  }
  return lines + line + "\n";
}

/// "key = value" with a comment behind, all in one column.
std::string entry(const std::string& name, const std::string& value, const std::string& remark) {
  std::string line =
      name + std::string(name.size() < 18 ? 18 - name.size() : 0, ' ') + " = " + value;
  if (!remark.empty()) {
    line += std::string(line.size() < 30 ? 30 - line.size() : 2, ' ') + "# " + remark;
  }
  return line + "\n";
}

std::string toml_list(const std::vector<std::string>& texts) {
  std::string result = "[";
  for (const std::string& text : texts)
    result += (result.size() > 1 ? ", " : "") + toml_string(text);
  return result + "]";
}

std::string plan(const MapPoint& point) {
  return "[" + with_decimals(point.x(), 3) + ", " + with_decimals(point.y(), 3) + "]";
}

std::string degrees(double angle) { return with_decimals(angle * kDegreesPerRadian, 0); }

std::string blocks_text(const ProposedBlocks& blocks, const std::string& library) {
  std::string text = "[blocks]\n" + entry("library", toml_string(library), "");
  if (!blocks.selected.empty()) {
    text += comment("Left out: " + blocks.left_out.front() +
                    (blocks.left_out.size() > 1
                         ? ", and " + std::to_string(blocks.left_out.size() - 1) + " more"
                         : "") +
                    ".");
    text += entry("select", toml_list(blocks.selected), "");
  }
  if (blocks.mass) {
    text += comment(
        "The photographs of these blocks gave no scale: their shape is known, their size is not. "
        "The mass is an assumption; put the one that you mean.");
    return text + entry("scale", "{ mass_kg = " + with_digits(*blocks.mass, 6) + " }", "of each");
  }
  const std::string from = with_digits(blocks.lightest, 3), to = with_digits(blocks.heaviest, 3);
  text +=
      comment(counted(blocks.count, "block") + " of " + (from == to ? from : from + " to " + to) +
              " kg. To take only some of them, add select = [\"ID\", ...] or select = { scheme = "
              "\"garcia\", class = \"compact\" }. To compare shapes alone, bring all to one mass:");
  return text + "# scale            = \"equal-mass\"\n";
}

std::string value_entry(const std::string& name, const UsualValue& number,
                        const std::string& symbol) {
  return entry(
      name, with_digits(number.value, 3),
      symbol + ", usual " + with_digits(number.low, 3) + " to " + with_digits(number.high, 3));
}

std::string ground_text(const std::vector<ProposedGround>& ground, double rolling_length) {
  std::string text = comment(
      "Ground. energy_restitution is the share of energy that an impact gives back, friction "
      "decides on which slopes blocks slide, rolling_friction how far they roll. All three are "
      "usual values of kinds of ground and not of this site, and decide how far blocks go: "
      "calibrate them on stops seen there, or give ranges, friction = { uniform = [0.5, 0.8] } "
      "with [ensemble] members = 20. How far a block turns before rolling resistance has built up "
      "matters as much: rolling_length_m is half the length of the ground that carries a block, "
      "here half of S of the middle block. Sources and effects: docs/parameters.md.");
  for (const ProposedGround& zone : ground) {
    text += "\n" +
            comment((zone.by_name ? "By its name: "
                                  : "Its name says no kind of ground; "
                                    "taken for ") +
                    zone.type.name + " (" + zone.type.description + "). " + zone.type.source + ".");
    text += "[ground." + key(zone.zone) + "]\n" +
            value_entry("energy_restitution", zone.type.energy_restitution, "e_n^2") +
            value_entry("friction", zone.type.friction, "mu") +
            value_entry("rolling_friction", zone.type.rolling_friction, "mu_R") +
            entry("rolling_length_m", with_digits(rolling_length, 2), "a; calibrate it too");
  }
  return text;
}

std::string release_text(const CampaignProposal& proposal) {
  const ProposedPlaces& places = proposal.places;
  std::string text = comment(
      "Releases: on ground of " + degrees(places.release_slope) + " degrees at a height of " +
      with_decimals(places.release_from.z(), 0) +
      " m, proposed from the shape of the terrain. Put the places where blocks come loose: a "
      "line, a { polygon = [[x, y], ...], count = N }, or a file of points.");
  text += "[release]\n";
  if (places.release_points > 1) {
    text += entry("points",
                  "{ line = [" + plan(places.release_from) + ", " + plan(places.release_to) +
                      "], count = " + std::to_string(places.release_points) + " }",
                  "");
  } else {
    text += entry("points", "[" + plan(places.release_from) + "]", "");
  }
  text += entry("height_m", with_digits(proposal.drop_height, 3), "of fall to the ground");
  return text + entry("orientations",
                      "{ random = " + std::to_string(proposal.orientations) + ", seed = 1 }",
                      "at each point; take 64 or more for results");
}

std::string barrier_text(const ProposedPlaces& places) {
  return comment(
             "Where passing blocks are counted, with speed, energy and height: across the way "
             "down, " +
             with_decimals(places.descent, 0) + " m below the releases and " +
             with_decimals(places.distance, 0) +
             " m away. Move it to what is to be protected, and add others.") +
         "[[barrier]]\n" + entry("name", toml_string(places.barrier_name), "") +
         entry("from", plan(places.barrier_from), "") + entry("to", plan(places.barrier_to), "");
}

}  // namespace

std::string campaign_text(const CampaignProposal& proposal, const std::string& library,
                          const std::vector<std::string>& surface) {
  const ProposedPlaces& places = proposal.places;
  std::string text = comment(
      "A campaign to begin with, written by clast new campaign. It runs as it is, but where blocks "
      "start, what the ground is and where they are counted are proposals: go through all of it "
      "before you use its results. Paths are relative to this file, lengths in metres, x and y on "
      "the map; every key is in docs/formats.md.");
  text +=
      "#   clast check FILE      says whether it would run, and what would\n"
      "#   clast simulate FILE -o results.h5\n"
      "#   clast compare results.h5 -o report\n";
  for (const std::string& doubt : proposal.doubts) text += "#\n" + comment("NOTE: " + doubt);
  text += "\n" + blocks_text(proposal.blocks, library);
  text +=
      "\n[terrain]\n" +
      entry("surface", surface.size() == 1 ? toml_string(surface.front()) : toml_list(surface), "");
  text += entry("border_distance_m", with_digits(places.margin, 2),
                "releases nearer to the border are warned of");
  text += "\n" + ground_text(proposal.ground, 0.5 * proposal.blocks.shortest_side);
  text += "\n" + release_text(proposal);
  text += "\n" + barrier_text(places);
  text += "\n[run]\n" + entry("max_time_s", with_digits(proposal.max_time, 4),
                              "a run that lasts longer is stopped there; trial runs took up to " +
                                  with_digits(proposal.trial.longest, 2) + " s");
  return text + entry("downslope",
                      "[" + with_decimals(places.downslope.x(), 3) + ", " +
                          with_decimals(places.downslope.y(), 3) + "]",
                      "lateral deviation is measured from it");
}

}  // namespace clast
