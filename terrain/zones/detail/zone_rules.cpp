#include "terrain/zones/detail/zone_rules.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {
namespace terrain_detail {
namespace {

ZoneRule::Condition condition_of(const std::string& text, const std::string& rule) {
  ZoneRule::Condition condition;
  const std::size_t sign = text.find_first_of("<>");
  const std::string what = text.substr(0, sign);
  condition.of_slope = what == "slope";
  std::optional<double> bound;
  if (sign != std::string::npos) {
    condition.above = text[sign] == '>';
    condition.or_equal = sign + 1 < text.size() && text[sign + 1] == '=';
    bound = parse_number(text.substr(sign + (condition.or_equal ? 2 : 1)));
  }
  if ((what != "slope" && what != "height") || !bound || !(std::abs(*bound) < 1e9)) {
    throw InputError(
        "zones: \"" + rule +
        "\" is not a rule; write for example rock=slope>60, scree=height<1450&slope>=30 "
        "(degrees, m) or soil=else");
  }
  condition.bound = condition.of_slope ? *bound * kRadiansPerDegree : *bound;
  return condition;
}

}  // namespace

bool ZoneRule::applies(double slope, double height) const {
  for (const Condition& condition : conditions) {
    const double value = condition.of_slope ? slope : height;
    const bool holds = (condition.or_equal && value == condition.bound) ||
                       (condition.above ? value > condition.bound : value < condition.bound);
    if (!holds) return false;
  }
  return true;
}

std::vector<ZoneRule> parse_zone_rules(const std::vector<std::string>& texts) {
  std::vector<ZoneRule> rules;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    ZoneRule rule{.zone = text.substr(0, equals), .conditions = {}};
    const std::string when = equals == std::string::npos ? "" : text.substr(equals + 1);
    if (rule.zone.empty() || rule.zone.find_first_of("<>") != std::string::npos || when.empty()) {
      throw InputError("zones: \"" + text + "\" is not a rule; write NAME=slope>60 or NAME=else");
    }
    if (when != "else") {
      for (std::size_t begin = 0; begin <= when.size();) {
        const std::size_t end = std::min(when.find('&', begin), when.size());
        rule.conditions.push_back(condition_of(when.substr(begin, end - begin), text));
        begin = end + 1;
      }
    }
    rules.push_back(std::move(rule));
  }
  return rules;
}

}  // namespace terrain_detail

bool are_zone_rules(const std::vector<std::string>& zones) {
  for (const std::string& zone : zones) {
    if (zone.find('=') != std::string::npos) return !parse_zone_file(zones);
  }
  return false;
}

}  // namespace clast
