// Keys of tables that are bound to what they set.
#include "study/campaign/member_table.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusal.hpp"

namespace clast::study_detail {
namespace {

struct Inner {
  double step = 0.5;
};

enum class Colour { kRed, kBlue };

struct Settings {
  double length = 1.0;
  std::optional<double> width;
  int rounds = 3;
  bool open = false;
  Inner inner;
  Colour colour = Colour::kRed;
  std::size_t letters = 0;
  std::vector<Vec2> polygon;
};

Colour colour_named(const std::string& word) {
  return word == "blue" ? Colour::kBlue : Colour::kRed;
}
std::size_t letters_of(const DeclaredTable& table) {
  return table.value<std::string>("word")->size();
}

const MemberTable<Settings>& settings_keys() {
  static const MemberTable<Settings> keys(
      {"settings", "Of a test", KeyTable::Repeat::kEither},
      {{"length_m", "m", "of it", required_format("a length", number_format({0.1, 10.0})),
        &Settings::length},
       {"width_m", "m", "of it", number_format({0.1, 10.0}), &Settings::width},
       {"rounds", "", "of it", count_format(1, 9), &Settings::rounds},
       {"open", "", "or not", flag_format(), &Settings::open},
       {"step_s", "s", "of time", number_format({0.1, 1.0}), &Settings::inner, &Inner::step},
       {"colour", "", "of it", word_format({"red", "blue"}), &colour_named, &Settings::colour},
       {"word", "", "of it", text_format(), &letters_of, &Settings::letters},
       {"polygon", "m", "in the plan", list_format(point_format(), 3), &Settings::polygon},
       {"rule", "", "read by a rule", table_format({{"seed", "", "of it", seed_format()}})}});
  return keys;
}

Settings read(const std::string& text) {
  const TomlNode root = parse_toml(text, "a.toml");
  const TomlTable top(root, "a.toml", "", {"settings"});
  Settings settings;
  for (const DeclaredTable& table : find_tables(top, settings_keys())) {
    settings_keys().read(table, settings);
  }
  return settings;
}

std::string refusal_of(const std::string& text) {
  return refusal([&] { read(text); });
}

TEST(MemberTable, EachKeySetsItsMember) {
  const Settings settings = read(
      "[settings]\nlength_m = 2\nwidth_m = 3\nrounds = 4\nopen = true\nstep_s = 0.25\n"
      "colour = \"blue\"\nword = \"four\"\npolygon = [[0, 0], [1, 0, 9], [0, 1]]\n");
  EXPECT_EQ(settings.length, 2.0);
  EXPECT_EQ(settings.width, 3.0);
  EXPECT_EQ(settings.rounds, 4);
  EXPECT_TRUE(settings.open);
  EXPECT_EQ(settings.inner.step, 0.25);
  EXPECT_EQ(settings.colour, Colour::kBlue);
  EXPECT_EQ(settings.letters, 4u);
  ASSERT_EQ(settings.polygon.size(), 3u);
  EXPECT_EQ(settings.polygon[1], Vec2(1.0, 0.0));
}

TEST(MemberTable, AbsentKeysLeaveTheirMembers) {
  const Settings settings = read("[settings]\nlength_m = 2\n");
  EXPECT_FALSE(settings.width);
  EXPECT_EQ(settings.rounds, 3);
  EXPECT_EQ(settings.inner.step, 0.5);
}

TEST(MemberTable, RefusalsHaveTheRangeTheUnitAndTheTableAsItIsWritten) {
  EXPECT_EQ(refusal_of("[settings]\nlength_m = 20\n"),
            "a.toml:2: [settings] length_m = 20: must be from 0.1 to 10 m");
  EXPECT_EQ(refusal_of("[[settings]]\nrounds = 3\n"),
            "a.toml:1: [[settings]]: length_m is missing; it must be a length");
  EXPECT_EQ(refusal_of("[settings]\nlength_m = 1\ncolour = \"green\"\n"),
            "a.toml:3: [settings] colour = \"green\": must be \"red\" or \"blue\"");
  EXPECT_EQ(refusal_of("[settings]\nlength_m = 1\npolygon = [[0, 0]]\n"),
            "a.toml:3: [settings] polygon = [[0, 0]]: must be a list of at least 3 points");
  EXPECT_EQ(refusal_of("settings = 3\n"),
            "a.toml:1: settings = 3: must be a table [settings], or several [[settings]]");
}

TEST(DeclaredTable, KnowsTheKeysOfTablesWithinIt) {
  const TomlNode root = parse_toml("rule = { seed = 3, moss = 1 }", "a.toml");
  const DeclaredTable table(root, "a.toml", "[settings]", settings_keys());
  EXPECT_EQ(refusal([&] { table.inner_table("rule"); }),
            "a.toml:1: [settings] rule moss = 1: unknown key; known here are seed");
}

TEST(TomlTable, RefusesAKeyByTheMessageOfWhatItsValueIsUsedFor) {
  const TomlNode root = parse_toml("unit = \"ell\"\n\"a\\u001bb\" = 1", "a.toml");
  const TomlTable table(root, "a.toml", "[t]",
                        {"unit",
                         "a\x1b"
                         "b"});
  EXPECT_EQ(table.run_check("unit", [] { return 3; }), 3);
  EXPECT_EQ(refusal([&] {
              table.run_check(
                  "unit", []() -> int { throw InputError("`unit` is old"); }, "x: ");
            }),
            "a.toml:1: [t] unit = \"ell\": x: unit is old");
  table.refuse_if_present("moss", "is not for this");
  EXPECT_EQ(refusal([&] { table.refuse_if_present("unit", "is not for this"); }),
            "a.toml:1: [t] unit = \"ell\": is not for this");
  EXPECT_EQ(refusal([&] {
              table.refuse(
                  "a\x1b"
                  "b",
                  "is odd");
            }),
            "a.toml:2: [t] a\\u001bb = 1: is odd");
}

}  // namespace
}  // namespace clast::study_detail
