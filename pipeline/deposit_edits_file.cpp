#include "pipeline/deposit_edits_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/text_file.hpp"
#include "core/printable.hpp"

namespace clast {

namespace {

using EditsJson = nlohmann::json;

constexpr const char* kEditsFormat = "clast deposit edits";

/// Refuses keys that an object of the file does not have.
void check_edit_keys(const EditsJson& object, const std::vector<std::string>& known) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    throw InputError("unknown key \"" + escape_nonprintable(key) + "\"; known keys: " + list);
  }
}

const EditsJson& require_edit_key(const EditsJson& object, const char* key, const char* meaning) {
  const auto found = object.find(key);
  if (found == object.end()) {
    throw InputError("the key \"" + std::string(key) + "\" is missing: " + meaning);
  }
  return *found;
}

/// Reads a point or direction.
/// @param fewest  2 if z may be missing, which is then 0; otherwise 3
Vec3 parse_edit_vector(const EditsJson& value, const char* key, std::size_t fewest) {
  const bool is_vector = value.is_array() && value.size() >= fewest && value.size() <= 3 &&
                         std::all_of(value.begin(), value.end(),
                                     [](const EditsJson& number) { return number.is_number(); });
  if (!is_vector) {
    throw InputError(std::string(key) + ": expected " +
                     (fewest == 2 ? "[x, y] or [x, y, z]" : "[x, y, z]") + " in metres, not " +
                     escape_nonprintable(value.dump(-1, ' ', true)).substr(0, 80));
  }
  Vec3 vector = Vec3::Zero();
  for (std::size_t i = 0; i < value.size(); ++i) {
    vector[static_cast<int>(i)] = value[i].get<double>();
  }
  return vector;
}

std::vector<Vec3> parse_edit_points(const EditsJson& value, const char* key, std::size_t fewest) {
  if (!value.is_array()) {
    throw InputError(std::string(key) + ": expected a list of points, such as [[1.2, 3.4, 0.5]]");
  }
  std::vector<Vec3> points;
  for (const EditsJson& point : value) points.push_back(parse_edit_vector(point, key, fewest));
  return points;
}

DepositEditKind parse_edit_kind(const EditsJson& value) {
  for (const DepositEditKind kind : {DepositEditKind::kAccept, DepositEditKind::kDrop,
                                     DepositEditKind::kMerge, DepositEditKind::kCut}) {
    if (value == name_of(kind)) return kind;
  }
  throw InputError("kind: expected \"accept\", \"drop\", \"merge\" or \"cut\", not " +
                   escape_nonprintable(value.dump(-1, ' ', true)).substr(0, 80));
}

DepositEdit parse_deposit_edit(const EditsJson& object) {
  if (!object.is_object()) throw InputError("expected an object with the keys kind and points");
  check_edit_keys(object, {"kind", "points", "line", "view"});
  DepositEdit edit;
  edit.kind = parse_edit_kind(require_edit_key(object, "kind", "accept, drop, merge or cut"));
  edit.points =
      parse_edit_points(require_edit_key(object, "points", "a point on each block"), "points", 3);
  const bool cuts = edit.kind == DepositEditKind::kCut;
  for (const char* key : {"line", "view"}) {
    if (!cuts && object.contains(key)) {
      throw InputError(std::string(key) + ": applies to a cut only; remove it");
    }
  }
  if (object.contains("view")) edit.view = parse_edit_vector(object["view"], "view", 3);
  if (cuts) {
    // Heights do not matter for a vertical cut.
    const bool vertical = edit.view.head<2>().isZero(0.0);
    edit.line = parse_edit_points(require_edit_key(object, "line", "the points of the cut line"),
                                  "line", vertical ? 2 : 3);
  }
  edit.check();
  return edit;
}

}  // namespace

std::vector<DepositEdit> read_deposit_edits(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  std::vector<DepositEdit> edits;
  with_error_context(file.string(), [&] {
    EditsJson root;
    try {
      root = EditsJson::parse(text);
    } catch (const EditsJson::exception& error) {
      throw InputError(std::string("is not valid JSON: ") + escape_nonprintable(error.what()));
    }
    if (!root.is_object() || root.value("format", EditsJson()) != kEditsFormat) {
      throw InputError(std::string("is no file of edits: expected an object with \"format\": \"") +
                       kEditsFormat + "\", as the page of a deposit saves it");
    }
    check_edit_keys(root, {"format", "edits"});
    const EditsJson& list = require_edit_key(root, "edits", "the list of edits");
    if (!list.is_array()) throw InputError("edits: expected a list of edits");
    for (const EditsJson& object : list) {
      with_error_context("edit " + std::to_string(edits.size() + 1),
                         [&] { edits.push_back(parse_deposit_edit(object)); });
    }
  });
  return edits;
}

}  // namespace clast
