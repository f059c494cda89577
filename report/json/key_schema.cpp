#include "report/json/key_schema.hpp"

#include <string>
#include <vector>

#include "core/version.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/campaign_keys.hpp"

namespace clast {
namespace {

using Json = nlohmann::ordered_json;

Json schema_of(const ValueFormat& form);

/// Returns the JSON schema of a number range; 0 is also allowed if it has a meaning.
Json number_schema(const NumberRange& range) {
  Json json = {{"type", "number"}};
  if (range.zero_meaning != nullptr) {
    json["minimum"] = 0.0;
    json["maximum"] = range.high;
    json["anyOf"] = {{{"maximum", 0.0}}, {{"minimum", range.low}}};
    return json;
  }
  json["minimum"] = range.low;
  json["maximum"] = range.high;
  return json;
}

Json key_schema(const TableKey& key) {
  Json json = {{"description", key.meaning + (key.unit.empty() ? "" : ", " + key.unit)}};
  if (!key.unit.empty()) json["unit"] = key.unit;
  json.update(schema_of(key.format));
  return json;
}

/// One of these keys is there.
Json any_of_keys(const std::vector<std::string>& names) {
  Json any = Json::array();
  for (const std::string& name : names) any.push_back({{"required", {name}}});
  return any;
}

Json keys_schema(const std::vector<TableKey>& keys) {
  Json json = {{"type", "object"}, {"additionalProperties", false}};
  Json required = Json::array();
  for (const TableKey& key : keys) {
    json["properties"][key.name] = key_schema(key);
    if (key.is_required()) required.push_back(key.name);
    if (!key.required_with.empty())
      json["dependencies"][key.name] = {{"anyOf", any_of_keys(key.required_with)}};
  }
  if (!required.empty()) json["required"] = std::move(required);
  return json;
}

Json list_schema(Json items, std::uint64_t minimum, std::uint64_t maximum) {
  Json json = {{"type", "array"}, {"items", std::move(items)}, {"minItems", minimum}};
  if (maximum != INT64_MAX) json["maxItems"] = maximum;
  return json;
}

Json named_schema(Json value) {
  return {{"type", "object"}, {"minProperties", 1}, {"additionalProperties", std::move(value)}};
}

Json schema_of(const ValueFormat& form) {
  switch (form.kind) {
    case ValueFormat::Kind::kText:
      if (!form.pattern.empty()) return {{"type", "string"}, {"pattern", form.pattern}};
      if (form.words.empty()) return {{"type", "string"}, {"minLength", 1}};
      return {{"enum", form.words}};
    case ValueFormat::Kind::kFlag:
      return {{"type", "boolean"}};
    case ValueFormat::Kind::kCount:
      return {{"type", "integer"}, {"minimum", form.minimum}, {"maximum", form.maximum}};
    case ValueFormat::Kind::kNumber:
      return number_schema(form.range);
    case ValueFormat::Kind::kList:
      return list_schema(schema_of(form.items.front()), form.minimum, form.maximum);
    case ValueFormat::Kind::kTable:
      return keys_schema(form.keys);
    case ValueFormat::Kind::kNamed:
      return named_schema(schema_of(form.items.front()));
    case ValueFormat::Kind::kEither:
      break;
  }
  Json any = Json::array();
  for (const ValueFormat& one : form.items) any.push_back(schema_of(one));
  return {{"anyOf", std::move(any)}};
}

Json table_schema(const KeyTable& table) {
  Json one = keys_schema(table.keys);
  if (!table.exactly_one_of.empty()) one["oneOf"] = any_of_keys(table.exactly_one_of);
  Json json = {{"description", table.meaning}};
  switch (table.repeat) {
    case KeyTable::Repeat::kOnce:
      json.update(one);
      break;
    case KeyTable::Repeat::kMany:
      json.update(list_schema(one, 1, INT64_MAX));
      break;
    case KeyTable::Repeat::kEither:
      json["anyOf"] = {one, list_schema(one, 1, INT64_MAX)};
      break;
    case KeyTable::Repeat::kNamed:
      json.update(named_schema(one));
  }
  return json;
}

/// @param either  of these tables there must be one; empty: no matter
Json file_schema(const std::string& title, const std::vector<KeyTable>& tables,
                 const std::vector<std::string>& either) {
  Json json = {{"$schema", "http://json-schema.org/draft-07/schema#"},
               {"title", title},
               {"description", std::string("Written by clast ") + version()},
               {"type", "object"},
               {"additionalProperties", false}};
  Json required = Json::array();
  for (const KeyTable& table : tables) {
    if (table.name.find('.') != std::string::npos) continue;  // a key of another table
    json["properties"][table.name] = table_schema(table);
    if (table.required) required.push_back(table.name);
  }
  json["required"] = std::move(required);
  if (!either.empty()) json["anyOf"] = any_of_keys(either);
  return json;
}

}  // namespace

Json campaign_schema() {
  return file_schema("clast campaign", campaign_key_tables(), {"release", "mass"});
}

Json calibration_schema() {
  return file_schema("clast calibration study", calibration_key_tables(), {});
}

}  // namespace clast
