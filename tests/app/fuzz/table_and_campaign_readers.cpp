#include "classify/dimension_table.hpp"
#include "pipeline/board_file.hpp"
#include "pipeline/deposit_edits_file.hpp"
#include "study/campaign/campaign.hpp"
#include "study/campaign/release_points.hpp"
#include "study/compare/measured_stops.hpp"
#include "tests/app/fuzz/readers.hpp"
#include "tests/study/campaign_file.hpp"

namespace clast {

namespace {

void read_dimensions(const std::filesystem::path& path) {
  for (const MeasuredBlock& block : read_dimension_table(path).blocks) {
    ASSERT_GT(block.axes.S, 0.0);
    ASSERT_GE(block.axes.L, block.axes.I);
    ASSERT_GE(block.axes.I, block.axes.S);
  }
}

std::string dimensions(const std::string& separator, bool decimal_comma) {
  std::string text = "name" + separator + "L" + separator + "I" + separator + "S\n";
  for (int i = 1; i <= 30; ++i) {
    for (const std::string& cell :
         {"\"B " + std::to_string(i) + "\"", std::to_string(0.9 + 0.05 * i),
          std::to_string(0.8 + 0.01 * i), std::to_string(0.5)}) {
      text += cell + separator;
    }
    text.back() = '\n';
  }
  if (decimal_comma) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

/// Everything that the campaign names is beside it.
NamedReader campaign_reader(const std::string& file, const std::string& text) {
  return {file, [=]() -> FuzzedReader {
            return {file,
                    file,
                    {{file, text},
                     {"blocks.h5", "stand-in"},
                     {"blue.stl", "stand-in"},
                     {"gray.stl", "stand-in"},
                     {"points.xyz", "1 2 3\n4 5 6\n"},
                     {"turns.txt", "q0 q1 q2 q3\n1 0 0 0\n0 1 0 0\n"}},
                    [=](const auto& folder) { read_campaign(folder / file); }};
          }};
}

/// The campaign with a rock mass in place of its releases.
std::string of_a_mass(std::string text) {
  const std::size_t begin = text.find("[release]");
  const std::size_t end = text.find("\n[", begin);
  text.replace(begin, end - begin,
               "[[mass]]\npolygon = [[0, 0], [4, 0], [4.5, 3], [0, 3]]\nthickness_m = 2.5\n"
               "realisations = 3\nseed = 7\n\n[contact.blocks]\nenergy_restitution = 0.1\n"
               "friction = 0.5\nrolling_friction = 0.2\n");
  return text;
}

std::string many_points() {
  std::string text = "x y z\n";
  for (int i = 0; i < 40; ++i) text += std::to_string(i) + ".25 -3.5 1e2\n";
  return text;
}

std::string many_turns() {
  std::string text = "q0 q1 q2 q3\n";
  Random random(8);
  for (int i = 0; i < 40; ++i) {
    const Quat q = random.rotation();
    for (const double value : {q.w(), q.x(), q.y(), q.z()}) text += std::to_string(value) + " ";
    text.back() = '\n';
  }
  return text;
}

constexpr const char* kBoard =
    "dictionary = \"4x4_50\"\nmarker_side_m = 0.05\n[[marker]]\nid = 0\ncentre_m = [0.0, 0.0]\n"
    "[[marker]]\nid = 1\ncentre_m = [0.6, 0.0]\n";

constexpr const char* kEdits =
    "{\"format\": \"clast deposit edits\", \"edits\": [\n"
    "{\"kind\": \"merge\", \"points\": [[1, 2.5, -3e-2], [4, 5, 6]]},\n"
    "{\"kind\": \"cut\", \"points\": [[1, 2, 3]], \"line\": [[0, 0], [1, 1, 2]], "
    "\"view\": [0, 0, -1]}]}\n";

}  // namespace

std::vector<NamedReader> table_and_campaign_readers() {
  return {
      reader_of(
          "comma.csv", [] { return dimensions(",", false); }, read_dimensions),
      reader_of(
          "semicolon.csv", [] { return dimensions(";", true); }, read_dimensions),
      reader_of(
          "seen.csv",
          [] {
            std::string text = "x_m,y_m,shape,block\n";
            for (int i = 0; i < 30; ++i) {
              text += std::to_string(900000.25 + i) + ",6500000.5,compact,B1\n";
            }
            return text;
          },
          [](const auto& path) {
            for (const MeasuredStop& stop : read_measured_stops(path).stops) {
              ASSERT_TRUE(stop.position.allFinite());
            }
          }),
      campaign_reader("campaign.toml", kCampaign),
      campaign_reader("mass.toml", of_a_mass(kCampaign)),
      reader_of("release.xyz", many_points,
                [](const auto& path) {
                  for (const Vec3& p : read_point_table(path)) ASSERT_TRUE(p.allFinite());
                }),
      reader_of("turns.txt", many_turns,
                [](const auto& path) {
                  for (const Quat& q : read_orientation_table(path))
                    ASSERT_NEAR(q.norm(), 1.0, 1e-12);
                }),
      reader_of(
          "board.toml", [] { return std::string(kBoard); },
          [](const auto& path) { read_scale_board(path); }),
      reader_of(
          "edits.json", [] { return std::string(kEdits); },
          [](const auto& path) {
            for (const DepositEdit& edit : read_deposit_edits(path)) edit.check();
          }),
  };
}

}  // namespace clast
