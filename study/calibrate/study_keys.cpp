#include "study/calibrate/study_keys.hpp"

#include <algorithm>

#include "study/calibrate/observation.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/key_forms.hpp"
#include "study/campaign/unknown.hpp"

namespace clast {

using namespace study_detail;

namespace {

using Repeat = KeyTable::Repeat;

constexpr std::uint64_t kMostReleased = 1'000'000;

KeyTable design_table() {
  return {"design",
          "How the parameters are sought",
          Repeat::kOnce,
          {{"members", "", "sets of parameters that are simulated", {count(8, 4096)}},
           {"releases", "", "runs of each member at each site", {count(kFewestSeen, 100'000)}},
           {"seed", "", "of all that is drawn", {seed()}},
           {"draws", "", "from the posterior", {count(100, 100'000)}},
           {"kernel",
            "",
            "correlation of the surrogates",
            {words({"matern-5/2", "squared-exponential"})}}}};
}

KeyTable site_table() {
  return {"site",
          "A place where blocks were released",
          Repeat::kEither,
          {{"name", "", "of the site", {text()}, true},
           {"campaign", "", "campaign file, with [run] downslope", {text()}, true}},
          true};
}

/// Names of parameters, with any name in place of that of a zone or class.
std::string parameter_pattern() {
  std::string names;
  for (const auto& [name, range] : calibrated_parameters()) {
    names += names.empty() ? "" : "|";
    for (const char letter : name) names += letter == '.' ? "\\." : std::string(1, letter);
  }
  for (const std::string any : {"ZONE", "CLASS"}) {
    for (std::size_t at; (at = names.find(any)) != std::string::npos;) {
      names.replace(at, any.size(), ".+");
    }
  }
  return "^(" + names + ")$";
}

/// Holds the ranges of all parameters.
NumberRange any_parameter() {
  NumberRange all{0.0, 0.0};
  for (const auto& [name, range] : calibrated_parameters()) {
    all.low = std::min(all.low, range.allowed.low);
    all.high = std::max(all.high, range.allowed.high);
  }
  return all;
}

KeyTable unknown_table() {
  return {"unknown",
          "A parameter that is sought, the same at all sites that have it",
          Repeat::kEither,
          {{"parameter",
            "",
            "such as ground.ZONE.friction, release.height_m or blocks.mass_median_kg",
            {fitting(parameter_pattern())},
            true},
           {"range", "", "[low, high]", {list(number(any_parameter()), 2, 2)}, true},
           {"scale",
            "",
            "every value is as likely beforehand, or every logarithm",
            {words({"linear", "log"})}}},
          true};
}

/// A mean or a value with its standard error.
ValueForm measured_form(const NumberRange& range) { return list(number(range), 2, 2); }

KeyTable observation_table() {
  const ValueForm figure = fitting("^(mean|std|aside|speed|spin|p[0-9.+].*)$");
  const std::vector<std::string> moving = {"barrier", "impact"};
  KeyTable table = {
      "observation",
      "What was observed of blocks of a site",
      Repeat::kEither,
      {{"name", "", "of the observation", {text()}, true},
       {"site", "", "name of a site, where there are several", {text()}},
       {"use", "", "fitted, or kept to judge the prediction by", {words({"fit", "keep"})}, true},
       {"shape", "", "of these blocks only", {words({"compact", "elongated"})}},
       {"block", "", "id of the only block that it is of", {text()}},
       {"stops", "", "a table of stops", {text()}},
       {"figures",
        "",
        "of places: mean, std, aside, p1 to p99; of trajectories also speed and spin",
        {figure, list(figure, 1)},
        false,
        {"stops", "trajectories"}},
       {"beyond_m",
        "m",
        "places along downslope: the share of the stops beyond each",
        {list(number(kMapCoordinate), 1, 20)},
        false,
        {"stops"}},
       {"barrier", "", "name of a barrier of the campaign", {text()}},
       {"releases",
        "",
        "blocks that were released, or impacts that the values are the mean of",
        {count(1, kMostReleased)},
        false,
        moving},
       {"passed",
        "",
        "of the releases, how many passed",
        {count(0, kMostReleased)},
        false,
        {"barrier"}},
       {"speed_m_s",
        "m/s",
        "[value, standard error]",
        {measured_form({0.0, kMostSpeed, "m/s"})},
        false,
        moving},
       {"spin_rad_s",
        "rad/s",
        "[value, standard error]",
        {measured_form({0.0, kMostSpin, "rad/s"})},
        false,
        moving},
       {"height_m",
        "m",
        "of the centre above the ground, [value, standard error]",
        {measured_form({-1e4, 1e4, "m"})},
        false,
        {"barrier"}},
       {"energy_j",
        "J",
        "translational and rotational, [value, standard error]",
        {measured_form({0.0, 1e15, "J"})},
        false,
        moving},
       {"release", "", "name of the only [[release]] that it is of", {text()}},
       {"impact", "", "number of an impact of each run, from 1", {count(1, 1000)}},
       {"depth_m",
        "m",
        "of the scar, [value, standard error]",
        {measured_form({0.0, 1e3, "m"})},
        false,
        {"impact"}},
       {"trajectories", "", "a table of trajectories", {text()}},
       {"times_s",
        "s",
        "since the release",
        {list(number(kRunTime), 1, 100)},
        false,
        {"trajectories"}}},
      true};
  table.one_of = {"stops", "barrier", "impact", "trajectories"};
  return table;
}

}  // namespace

const std::vector<KeyTable>& calibration_tables() {
  static const std::vector<KeyTable> tables = {design_table(), site_table(), unknown_table(),
                                               observation_table()};
  return tables;
}

}  // namespace clast
