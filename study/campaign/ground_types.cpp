#include "study/campaign/ground_types.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "core/comma_separated.hpp"
#include "core/error.hpp"

namespace clast {
namespace {

constexpr double kFittedRestitution = 0.01;  ///< e_n^2 of all grounds of Garcia et al.
constexpr double kImpactSpeed = 10.0;        ///< normal to the ground, m/s, of usual impacts
constexpr double kHalvingSpeed = 9.0;        ///< m/s, at which Rockyfor3D halves R_n

/// Returns e_n^2 from R_n at the usual impact speed, to two digits.
TypicalValue restitution_of(double r_n) {
  const double slowed = r_n / (1.0 + kImpactSpeed * kImpactSpeed / (kHalvingSpeed * kHalvingSpeed));
  const auto hundredths = [](double share) {
    return static_cast<double>(static_cast<int>(100.0 * share + 0.5)) / 100.0;
  };
  return {std::max(kFittedRestitution, hundredths(slowed * slowed)), kFittedRestitution,
          hundredths(r_n * r_n)};
}

const std::vector<GroundType>& types() {
  static const std::vector<GroundType> kTypes = {
      {"rock",
       "bare rock, rock walls, quarry floors",
       restitution_of(0.53),
       {0.30, 0.30, 0.70},
       {0.0, 0.0, 0.18},
       "mu and mu_R: rock walls and flat quarry floors in Garcia et al. (2022); e_n^2: R_n 0.53 of "
       "Rockyfor3D, bedrock",
       {"rock", "bedrock", "cliff", "wall", "face", "outcrop", "slab", "fels", "rocher", "falaise",
        "roccia"}},
      {"talus",
       "blocks above 10 cm, coarse debris",
       restitution_of(0.38),
       {0.70, 0.45, 0.80},
       {0.18, 0.10, 0.35},
       "mu and mu_R: rocky slopes in Garcia et al. (2022); e_n^2: R_n 0.38 of Rockyfor3D, talus "
       "slope",
       {"talus", "boulder", "block", "blockfield", "debris", "rocky", "blockschutt", "eboulis",
        "éboulis"}},
      {"scree",
       "stones below 10 cm, gravel",
       restitution_of(0.33),
       {0.70, 0.45, 0.80},
       {0.18, 0.10, 0.35},
       "mu and mu_R: rocky slopes in Garcia et al. (2022); e_n^2: R_n 0.33 of Rockyfor3D, scree",
       {"scree", "gravel", "stone", "stony", "schutt", "kies", "pierrier", "ghiaione"}},
      {"soil hard",
       "compact soil with stones, tracks",
       restitution_of(0.38),
       {0.70, 0.40, 0.80},
       {0.27, 0.18, 0.35},
       "mu: Garcia et al. (2022); mu_R: halfway between their rocky and vegetated slopes, not "
       "measured; e_n^2: R_n 0.38 of Rockyfor3D, compact soil with large rock fragments; lower "
       "limit of mu: medium hard ground of RAMMS::ROCKFALL",
       {"track", "path", "road", "asphalt", "weg", "strasse", "route", "chemin", "strada"}},
      {"soil medium",
       "meadow, forest floor, vegetated slope",
       restitution_of(0.33),
       {0.70, 0.35, 0.80},
       {0.35, 0.18, 0.50},
       "mu and mu_R: vegetated slopes in Garcia et al. (2022); e_n^2: R_n 0.33 of Rockyfor3D, "
       "medium compact soil; lower limit of mu: medium ground of RAMMS::ROCKFALL",
       {"soil", "earth", "meadow", "grass", "pasture", "forest", "wood", "vegetation", "vegetated",
        "boden", "wiese", "weide", "wald", "terre", "sol", "prairie", "prato", "terreno"}},
      {"soil soft",
       "deep wet meadow, moor, loose fill",
       restitution_of(0.23),
       {0.70, 0.25, 0.80},
       {0.45, 0.35, 0.60},
       "mu: Garcia et al. (2022); mu_R: more than on their vegetated slopes, extrapolated, not "
       "measured; e_n^2: R_n 0.23 of Rockyfor3D, fine soil deeper than 1 m; lower limit of mu: "
       "soft ground of RAMMS::ROCKFALL",
       {"moor", "bog", "swamp", "marsh", "mud", "sand", "sumpf", "marais"}}};
  return kTypes;
}

/// The words of a name in lower case; letters beyond ASCII are letters.
std::set<std::string> words_of(const std::string& name) {
  std::set<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (word.empty()) return;
    words.insert(word);
    if (word.size() > 3 && word.back() == 's') words.insert(word.substr(0, word.size() - 1));
    word.clear();
  };
  for (const char character : name) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte >= 0x80) {
      word += character;
    } else if (std::isalpha(byte)) {
      word += static_cast<char>(std::tolower(byte));
    } else {
      end_word();
    }
  }
  end_word();
  return words;
}

bool any_of(const std::set<std::string>& words, std::span<const std::string> names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return words.contains(name); });
}

}  // namespace

std::span<const GroundType> typical_ground_types() { return types(); }

const GroundType& ground_type(const std::string& name) {
  std::vector<std::string> names;
  for (const GroundType& type : types()) {
    if (type.name == name) return type;
    names.push_back(type.name);
  }
  throw InputError("\"" + name + "\" is not a ground type; there are " + comma_separated(names));
}

const GroundType* find_ground_type(const std::string& zone) {
  const std::set<std::string> words = words_of(zone);
  const GroundType* found = nullptr;
  for (const GroundType& type : types()) {
    if (!any_of(words, type.names)) continue;
    if (found) return nullptr;
    found = &type;
  }
  // "hard", "medium" and "soft" are said of soil; of rock they mean something else.
  const bool soil = !found || found == &ground_type("soil medium");
  static const std::array<std::string, 3> kGrades = {"hard", "medium", "soft"};
  for (const std::string& grade : kGrades) {
    if (soil && words.contains(grade)) return &ground_type("soil " + grade);
  }
  return found;
}

const GroundType& default_ground_type() { return ground_type("scree"); }

}  // namespace clast
