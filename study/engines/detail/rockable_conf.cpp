#include "study/engines/detail/rockable_conf.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"

namespace clast::study_detail {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

constexpr double kMaxBodies = 1e7;

/// The lines of a file of blank-separated words.
class WordLines {
 public:
  explicit WordLines(const fs::path& file) : file_(file.string()), lines_(read_text_file(file)) {}

  /// The words of the next line that has any and is no remark; none at the end.
  Words next() {
    for (std::string line; std::getline(lines_, line);) {
      ++line_;
      std::istringstream text(line);
      Words words;
      for (std::string word; text >> word;) words.push_back(word);
      if (!words.empty() && words.front()[0] != '#') return words;
    }
    return {};
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(file_ + ":" + std::to_string(line_) + ": " + what);
  }

  /// Parses a number; diverged values are "nan".
  double number(const Words& words, std::size_t at) const {
    const std::optional<double> value = at < words.size() ? parse_number(words[at]) : std::nullopt;
    if (!value) {
      refuse("a number was expected after " + std::to_string(at) + (at == 1 ? " word" : " words") +
             "; the file may be incomplete");
    }
    return *value;
  }

  std::size_t count(const Words& words, std::size_t at) const {
    const double value = number(words, at);
    if (!(value >= 0.0 && value <= kMaxBodies) || value != std::floor(value)) {
      refuse("a whole number was expected, not " + words[at]);
    }
    return static_cast<std::size_t>(value);
  }

  Vec3 vector(const Words& words, std::size_t at) const {
    return {number(words, at), number(words, at + 1), number(words, at + 2)};
  }

  /// @param place, turn, spin  where position and velocity, orientation, angular velocity begin
  RigidState state(const Words& words, std::size_t place, std::size_t turn,
                   std::size_t spin) const {
    RigidState state;
    state.position = vector(words, place);
    state.velocity = vector(words, place + 3);
    state.orientation = Quat(number(words, turn), number(words, turn + 1), number(words, turn + 2),
                             number(words, turn + 3))
                            .normalized();
    state.angular_velocity = vector(words, spin);
    return state;
  }

 private:
  std::string file_;
  std::istringstream lines_;
  std::size_t line_ = 0;
};

RockableBody read_body(WordLines& lines) {
  const Words words = lines.next();
  if (words.empty()) lines.refuse("ends before its last body; Rockable may have been stopped");
  RockableBody body;
  body.shape = words.front();
  body.group = static_cast<std::uint32_t>(lines.count(words, 1));
  body.scale = lines.number(words, 3);
  body.state = lines.state(words, 4, 13, 17);
  return body;
}

void take_line(WordLines& lines, const Words& words, RockableConf& conf) {
  const std::string& key = words.front();
  if (key == "t") conf.time = lines.number(words, 1);
  if (key == "tmax") conf.max_time = lines.number(words, 1);
  if (key == "dt") conf.time_step = lines.number(words, 1);
  if (key == "nDriven") conf.fixed_body_count = lines.count(words, 1);
  if (key.ends_with("Contact") && words.size() == 4) {
    const double value = lines.number(words, 3);
    conf.pair[key + " " + words[1] + " " + words[2]] = value;
    conf.pair[key + " " + words[2] + " " + words[1]] = value;
  }
  if (key != "Particles") return;
  for (std::size_t left = lines.count(words, 1); left > 0; --left) {
    conf.bodies.push_back(read_body(lines));
  }
}

/// The number of "conf12"; none of other names.
std::optional<std::uint64_t> conf_number(const std::string& name) {
  constexpr std::string_view kBegin = "conf";
  if (!name.starts_with(kBegin) || name.size() == kBegin.size()) return std::nullopt;
  const std::string digits = name.substr(kBegin.size());
  if (digits.size() > 18 || digits.find_first_not_of("0123456789") != std::string::npos) {
    return std::nullopt;
  }
  return std::stoull(digits);
}

}  // namespace

RockableConf read_rockable_conf(const fs::path& file) {
  WordLines lines(file);
  Words words = lines.next();
  if (words.empty() || words.front() != "Rockable") {
    lines.refuse("is not a conf file of Rockable, which begins with the word Rockable");
  }
  RockableConf conf;
  for (words = lines.next(); !words.empty(); words = lines.next()) {
    take_line(lines, words, conf);
    if (words.front() == "Particles") return conf;
  }
  lines.refuse("ends without Particles; Rockable may have been stopped while it wrote");
}

std::vector<fs::path> list_rockable_states(const fs::path& folder) {
  std::vector<std::pair<std::uint64_t, fs::path>> numbered;
  if (!fs::is_directory(folder)) return {};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::optional<std::uint64_t> number = conf_number(entry.path().filename().string());
    if (number && entry.is_regular_file()) numbered.emplace_back(*number, entry.path());
  }
  std::sort(numbered.begin(), numbered.end());
  std::vector<fs::path> files;
  for (const auto& [number, file] : numbered) files.push_back(file);
  return files;
}

std::optional<RockfallTracker> read_rockfall_tracker(const fs::path& folder) {
  const fs::path file = folder / "dataExtractors.txt";
  if (!fs::is_regular_file(file)) return std::nullopt;
  WordLines lines(file);
  for (Words words = lines.next(); !words.empty(); words = lines.next()) {
    if (words.front() != "TrackRockfall" || words.size() < 5) continue;
    return RockfallTracker{lines.count(words, 1), lines.number(words, 2), lines.number(words, 3),
                           words[4]};
  }
  return std::nullopt;
}

std::optional<TrackedState> read_last_tracked_state(const fs::path& file) {
  constexpr std::size_t kNumbers = 20;  // time, state, force and moment
  if (!fs::is_regular_file(file)) return std::nullopt;
  WordLines lines(file);
  std::optional<TrackedState> last;
  for (Words words = lines.next(); !words.empty(); words = lines.next()) {
    if (words.size() != kNumbers) continue;  // one that was not written to its end
    last = {lines.number(words, 0), lines.state(words, 1, 7, 11)};
  }
  return last;
}

}  // namespace clast::study_detail
