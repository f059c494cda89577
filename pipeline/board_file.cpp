#include "pipeline/board_file.hpp"

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/text_file.hpp"
#include "core/files/toml_reader.hpp"

namespace clast {

namespace {

constexpr NumberRange kPlace{-kBarLengthRange.high, kBarLengthRange.high, "m"};
constexpr std::uint64_t kMaxSquares = 100;
constexpr std::uint64_t kMaxIds = 100000;

BoardMarker read_marker(const TomlNode& node, const std::string& file) {
  const TomlTable table(node, file, "[[marker]]", {"id", "centre_m"});
  table.require_key("id", "the number of the marker");
  BoardMarker marker;
  marker.id = static_cast<int>(*table.read_count("id", 0, kMaxIds));
  const TomlNode& centre = table.require_key("centre_m", "[x, y] or [x, y, z] of its centre");
  const std::vector<double> at =
      table.read_numbers("centre_m", centre, 2, 3, "[x, y] or [x, y, z] of its centre, m", kPlace);
  marker.centre = {at[0], at[1], at.size() > 2 ? at[2] : 0.0};
  return marker;
}

CharucoBoard read_charuco(const TomlNode& node, const std::string& file,
                          const std::string& dictionary) {
  const TomlTable table(node, file, "[charuco]",
                        {"columns", "rows", "square_m", "marker_m", "older_pattern"});
  for (const char* key : {"columns", "rows"}) table.require_key(key, "how many squares");
  for (const char* key : {"square_m", "marker_m"})
    table.require_key(key, "the length of a side, m");
  CharucoBoard board;
  board.dictionary = dictionary;
  board.columns = static_cast<int>(*table.read_count("columns", 3, kMaxSquares));
  board.rows = static_cast<int>(*table.read_count("rows", 3, kMaxSquares));
  board.square = *table.read_number("square_m", kMarkerSideRange);
  board.marker = *table.read_number("marker_m", kMarkerSideRange);
  board.older_pattern = table.read_boolean("older_pattern").value_or(false);
  return board;
}

}  // namespace

ScaleBoard read_scale_board(const std::filesystem::path& file) {
  const std::string name = file.string();
  const TomlNode root = parse_toml(read_text_file(file), name);
  const TomlTable table(root, name, "", {"dictionary", "marker_side_m", "marker", "charuco"});
  table.require_key("dictionary", "the kind of its markers, such as \"4x4_50\"");
  ScaleBoard board;
  board.dictionary = *table.read_text("dictionary");
  board.marker_side = table.read_number("marker_side_m", kMarkerSideRange);
  if (const TomlNode* charuco = table.find("charuco")) {
    board.charuco = read_charuco(*charuco, name, board.dictionary);
  }
  if (const TomlNode* markers = table.find("marker")) {
    if (markers->kind != TomlNode::Kind::kList) {
      table.refuse("marker", *markers, "must be a table [[marker]] for each marker");
    }
    for (const TomlNode& marker : markers->list) board.markers.push_back(read_marker(marker, name));
  }
  with_error_context(name, [&] { board.check(); });
  return board;
}

}  // namespace clast
