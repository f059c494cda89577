#include "tests/app/reliability/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "classify/schemes.hpp"
#include "core/number_text.hpp"

namespace clast::reliability {

namespace {

using Json = nlohmann::json;

constexpr int kRefused = 1, kTimedOut = 124, kKilled = 128;
/// A bound may be short of the truth by this share of it: blocks are measured to 1e-4.
constexpr double kSlack = 2e-4;
/// Schemes and their keys in the JSON.
const std::map<std::string, std::string> kSchemes = {
    {"sneed-folk", "sneed_folk"}, {"zingg", "zingg"}, {"garcia", "shape"}};

std::array<double, 3> sides(const Axes& axes) { return {axes.L, axes.I, axes.S}; }

/// An upper bound that is not there or null is said to be unknown.
double upper(const Json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::infinity();
}

bool holds(const Range& range, double value) {
  return value >= range.low * (1.0 - kSlack) && value <= range.high * (1.0 + kSlack);
}

std::string percent(double share) {
  return (share > 0.0 ? "+" : "") + format_significant(100.0 * share, 3) + " %";
}

std::string text_of(const Range& range) {
  return "[" + format_significant(range.low, 4) + ", " +
         (std::isfinite(range.high) ? format_significant(range.high, 4) : "unknown") + "]";
}

void read_ranges(const Json& block, Given& given) {
  if (!block.contains("unseen")) return;
  const Json& unseen = block.at("unseen");
  given.volume_range = {unseen.at("volume_lower_m3").get<double>(),
                        upper(unseen.value("volume_upper_m3", Json()))};
  // Null: not known, which holds anything.
  const Json lower = unseen.at("axes_lower_m"), upper_axes = unseen.at("axes_upper_m");
  std::array<Range, 3> ranges;
  for (std::size_t k = 0; k < 3; ++k) {
    ranges[k] = {lower.is_array() ? lower.at(k).get<double>() : 0.0,
                 upper(upper_axes.is_array() ? upper_axes.at(k) : Json())};
  }
  given.axes_range = ranges;
  for (const auto& [scheme, key] : kSchemes) {
    const Json& classes = unseen.at(key);
    given.possible_classes[scheme] =
        classes.is_array() ? classes.get<std::vector<std::string>>() : class_names(scheme);
  }
}

Given block_of(const Json& block) {
  Given given;
  given.volume = block.at("volume_m3");
  const auto& box = block.at("box_m");
  given.axes = {box[0], box[1], box[2]};
  for (const auto& [scheme, key] : kSchemes) given.classes[scheme] = block.at(key);
  read_ranges(block, given);
  given.warnings = block.at("warnings").get<std::vector<std::string>>();
  return given;
}

/// What of one expected answer is met by the values, what only by the ranges, and what by neither.
class Comparison {
 public:
  Comparison(const Given& given, const Expected& expected) : given_(given), expected_(expected) {
    compare("volume", given.volume, expected.truth.volume, expected.tolerance.volume,
            given.volume_range);
    const std::array<double, 3> ours = sides(given.axes), truth = sides(expected.truth.axes);
    bool all_right = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<Range> range =
          given.axes_range ? std::optional((*given.axes_range)[k]) : std::nullopt;
      all_right &=
          compare(std::string(1, "LIS"[k]), ours[k], truth[k], expected.tolerance.axes[k], range);
    }
    for (const auto& [scheme, key] : kSchemes) compare_class(scheme, all_right);
    require_words();
  }

  Verdict verdict() const {
    Verdict verdict;
    verdict.missed = missed_;
    if (given_.volume_range && std::isfinite(given_.volume_range->high)) {
      verdict.width =
          (given_.volume_range->high - given_.volume_range->low) / expected_.truth.volume;
    }
    verdict.outcome = !wrong_.empty()     ? Outcome::kWrong
                      : by_range_ == true ? Outcome::kBracketed
                                          : Outcome::kRight;
    verdict.why = wrong_;
    return verdict;
  }

 private:
  static void add(std::string& list, const std::string& what) {
    list += (list.empty() ? "" : "; ") + what;
  }

  bool compare(const std::string& name, double value, double truth, double tolerance,
               const std::optional<Range>& range) {
    const bool missed = range && !holds(*range, truth);
    const std::string beyond =
        missed ? ", true " + format_significant(truth, 4) + " not in " + text_of(*range) : "";
    if (missed) add(missed_, name + beyond);
    const double error = value / truth - 1.0;
    if (std::abs(error) <= tolerance) return true;
    if (range && !missed) {
      by_range_ = true;
      return false;
    }
    add(wrong_, name + " " + percent(error) + beyond);
    return false;
  }

  void compare_class(const std::string& scheme, bool axes_right) {
    const std::string truth = shape_class(scheme, expected_.truth.axes);
    const std::string& own = given_.classes.at(scheme);
    const auto possible = given_.possible_classes.find(scheme);
    const bool listed = possible != given_.possible_classes.end() &&
                        std::find(possible->second.begin(), possible->second.end(), truth) !=
                            possible->second.end();
    if (possible != given_.possible_classes.end() && !listed && own != truth) {
      add(missed_, scheme + " " + truth + " not among the possible classes");
    }
    if (own == truth || (axes_right && own == shape_class(scheme, given_.axes))) return;
    if (listed) {
      by_range_ = true;
      return;
    }
    add(wrong_, scheme + " " + own + " instead of " + truth);
  }

  void require_words() {
    if (expected_.said.empty()) return;
    for (const std::string& warning : given_.warnings) {
      for (const std::string& word : expected_.said) {
        if (warning.find(word) != std::string::npos) return;
      }
    }
    add(wrong_, "no warning says \"" + expected_.said.front() + "\"");
  }

  const Given& given_;
  const Expected& expected_;
  std::string wrong_, missed_;
  bool by_range_ = false;
};

}  // namespace

Given given_by(const ProgramRun& run) {
  Given given;
  if (run.exit_code == 0) {
    const Json blocks = Json::parse(run.out).at("blocks");
    if (blocks.size() == 1) return block_of(blocks[0]);
    given.failure = std::to_string(blocks.size()) + " blocks of one scan";
  } else if (run.exit_code == kTimedOut || run.exit_code > kKilled) {
    given.failure = "killed or timed out, exit code " + std::to_string(run.exit_code);
  } else if (run.exit_code != kRefused || run.err.find("unexpected failure") != std::string::npos ||
             run.err.find("clast: ") == std::string::npos) {
    given.failure = "exit code " + std::to_string(run.exit_code) + ": " + run.err;
  } else {
    given.refusal = run.err.substr(run.err.find("clast: ") + 7);
  }
  return given;
}

Verdict judge(const Given& given, const std::vector<Expected>& expected) {
  if (!given.failure.empty()) return {Outcome::kWrong, given.failure, {}, {}};
  if (!given.refusal.empty()) return {Outcome::kRefused, given.refusal, {}, {}};
  std::vector<Verdict> verdicts;
  for (const Expected& answer : expected) verdicts.push_back(Comparison(given, answer).verdict());
  return *std::min_element(verdicts.begin(), verdicts.end(),
                           [](const auto& a, const auto& b) { return a.outcome < b.outcome; });
}

}  // namespace clast::reliability
