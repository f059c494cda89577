#include "pipeline/deposit_edits_file.hpp"

#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class DepositEditsFile : public testing::Test {
 protected:
  std::vector<DepositEdit> read(const std::string& text) {
    write_text_file(folder_ / "edits.json", text);
    return read_deposit_edits(folder_ / "edits.json");
  }
  std::string refused(const std::string& text) {
    return refusal([&] { read(text); });
  }
  /// Refusal of a file with one edit.
  std::string refused_edit(const std::string& edit) {
    return refused(R"({"format": "clast deposit edits", "edits": [)" + edit + "]}");
  }
  ScratchFolder folder_;
};

TEST_F(DepositEditsFile, EveryKindIsRead) {
  const std::vector<DepositEdit> edits = read(R"({"format": "clast deposit edits", "edits": [
    {"kind": "accept", "points": [[1.5, 2, -0.25]]},
    {"kind": "drop", "points": [[652013.25, 5203000, 1824]]},
    {"kind": "merge", "points": [[1, 2, 3], [4, 5, 6], [7, 8, 9]]},
    {"kind": "cut", "points": [[1, 2, 3]], "line": [[0, 1], [2, 3, 4]]},
    {"kind": "cut", "points": [[1, 2, 3]], "line": [[0, 1, 5], [2, 3, 4]], "view": [0, 1, -1]}
  ]})");
  ASSERT_EQ(edits.size(), 5u);
  EXPECT_EQ(edits[0].kind, DepositEditKind::kAccept);
  EXPECT_EQ(edits[0].points, (std::vector<Vec3>{{1.5, 2.0, -0.25}}));
  EXPECT_EQ(edits[1].kind, DepositEditKind::kDrop);
  EXPECT_EQ(edits[1].points, (std::vector<Vec3>{{652013.25, 5203000.0, 1824.0}}));
  EXPECT_EQ(edits[2].kind, DepositEditKind::kMerge);
  EXPECT_EQ(edits[2].points.size(), 3u);
  EXPECT_EQ(edits[3].kind, DepositEditKind::kCut);
  EXPECT_EQ(edits[3].line, (std::vector<Vec3>{{0, 1, 0}, {2, 3, 4}}));
  EXPECT_EQ(edits[3].view, -Vec3::UnitZ());
  EXPECT_EQ(edits[4].view, Vec3(0, 1, -1));
  EXPECT_TRUE(read(R"({"format": "clast deposit edits", "edits": []})").empty());
}

TEST_F(DepositEditsFile, WhatIsNoFileOfEditsIsRefused) {
  EXPECT_TRUE(contains(refused("{\"format\": "), "edits.json: is not valid JSON"));
  for (const char* text : {"[]", "3", "{}", R"({"format": "other", "edits": []})"}) {
    EXPECT_TRUE(contains(refused(text), "is no file of edits")) << text;
  }
  EXPECT_TRUE(
      contains(refused(R"({"format": "clast deposit edits"})"), "the key \"edits\" is missing"));
  EXPECT_TRUE(contains(refused(R"({"format": "clast deposit edits", "edits": {}})"),
                       "edits: expected a list of edits"));
  EXPECT_TRUE(contains(refused(R"({"format": "clast deposit edits", "edits": [], "scan": 1})"),
                       "unknown key \"scan\""));
}

TEST_F(DepositEditsFile, AnEditIsRefusedByItsNumber) {
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "drop", "points": [[1, 2, 3]]}, 7)"),
                       "edits.json: edit 2: expected an object"));
  EXPECT_TRUE(
      contains(refused_edit(R"({"points": [[1, 2, 3]]})"), "edit 1: the key \"kind\" is missing"));
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "split", "points": [[1, 2, 3]]})"),
                       "kind: expected \"accept\", \"drop\", \"merge\" or \"cut\", not \"split\""));
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "drop", "points": [[1, 2]]})"),
                       "points: expected [x, y, z] in metres, not [1,2]"));
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "drop", "points": [1, 2, 3]})"),
                       "points: expected [x, y, z] in metres, not 1"));
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "drop", "points": [["1", "2", "3"]]})"),
                       "points: expected [x, y, z]"));
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "merge", "points": [[1, 2, 3]]})"),
                       "`merge` needs two or more"));
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "drop", "points": [[1, 2, 3]], "line": [[0, 0]]})"),
                       "line: applies to a cut only"));
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "drop", "points": [[1, 2, 3]], "id": "B_3"})"),
                       "unknown key \"id\"; known keys: kind, points, line, view"));
  EXPECT_TRUE(
      contains(refused_edit(R"({"kind": "cut", "points": [[1, 2, 3]], "line": [[0, 1], [2, 3]],
                       "view": [0, 1, 0]})"),
               "line: expected [x, y, z] in metres, not [0,1]"));
  EXPECT_TRUE(contains(refused_edit(R"({"kind": "drop", "points": [[1e999, 2, 3]]})"),
                       "is not valid JSON"));
}

}  // namespace
}  // namespace clast
