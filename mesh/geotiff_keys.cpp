// OGC GeoTIFF 1.1, 7; codes of projections: GeoTIFF 1.0, 6.3.3.3.
#include "mesh/geotiff_keys.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <string_view>

#include "core/printable.hpp"
#include "core/utf8.hpp"

namespace clast {
namespace {

constexpr int kUserDefined = 32767;

enum GeoKey : std::uint16_t {
  kModelType = 1024,
  kCitation = 1026,
  kGeographicType = 2048,
  kGeographicLinearUnits = 2052,
  kProjectedType = 3072,
  kProjectedCitation = 3073,
  kProjectionMethod = 3075,
  kLinearUnits = 3076,
  kLinearUnitSize = 3077,
  kVerticalType = 4096,
  kVerticalCitation = 4097,
  kVerticalUnits = 4099
};

template <class T>
T key_field(std::string_view bytes, std::size_t offset) {
  T value{};
  if (offset + sizeof(T) <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

/// Entries of a key directory: key, location of its value, number of values, and value or index.
class KeyDirectory {
 public:
  explicit KeyDirectory(const GeoTiffKeys& records) {
    const std::string_view keys = records.directory;
    for (std::size_t at = 8; at + 8 <= keys.size(); at += 8) {
      const auto key = key_field<std::uint16_t>(keys, at),
                 place = key_field<std::uint16_t>(keys, at + 2);
      const auto count = key_field<std::uint16_t>(keys, at + 4);
      const auto value = key_field<std::uint16_t>(keys, at + 6);
      if (place == 0) codes_[key] = value;
      if (place == 34736 && 8u * value + 8u <= records.doubles.size()) {
        doubles_[key] = key_field<double>(records.doubles, 8u * value);
      }
      if (place == 34737 && value < records.texts.size()) {
        texts_[key] = records.texts.substr(value, count);
      }
    }
  }

  /// 0 where the key is absent or undefined.
  int code(GeoKey key) const {
    const auto found = codes_.find(key);
    return found == codes_.end() ? 0 : found->second;
  }
  /// The code of a system in the EPSG register; 0 where there is none.
  int registered(GeoKey key) const { return code(key) == kUserDefined ? 0 : code(key); }
  double number(GeoKey key) const {
    const auto found = doubles_.find(key);
    return found == doubles_.end() ? 0.0 : found->second;
  }
  std::string text(GeoKey key) const {
    const auto found = texts_.find(key);
    return found == texts_.end() ? std::string() : found->second;
  }

 private:
  std::map<std::uint16_t, int> codes_;
  std::map<std::uint16_t, double> doubles_;
  std::map<std::uint16_t, std::string> texts_;
};

std::string key_source(GeoKey key, int value) {
  return "GeoTIFF key " + std::to_string(key) + " = " + std::to_string(value);
}

/// @param size  key that holds the metres of a user-defined unit, 0: none
std::optional<DeclaredUnit> unit_in_key(const KeyDirectory& keys, GeoKey key, double size) {
  const int code = keys.code(key);
  if (code == 0) return std::nullopt;
  if (code == kUserDefined) {
    return DeclaredUnit{size > 0.0 ? size : 0.0,
                        size > 0.0 ? "user-defined unit" : "user-defined unit of unstated length"};
  }
  if (const auto unit = epsg_length_unit(code)) return unit;
  return DeclaredUnit{
      0.0, "unit with the code " + std::to_string(code) + ", which is not a length unit"};
}

/// A foot that only the text of a citation names: "NAD_1983_..._Feet", "(ftUS)", "LUnits = Foot".
std::optional<DeclaredUnit> unit_in_citation(const std::string& citation) {
  const std::string text = lower_case_ascii(citation);
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  if (!has("foot") && !has("feet") && !has("ftus") && !has("us-ft") && !has("(ft)")) {
    return std::nullopt;
  }
  const bool us = has("us") || has("u.s.");
  return us ? DeclaredUnit{1200.0 / 3937.0, "US survey foot"} : DeclaredUnit{0.3048, "foot"};
}

/// Map projections of GeoTIFF 1.0, 6.3.3.3, that are of the whole world.
const char* world_projection(int method) {
  static const std::map<int, const char*> kMethods = {
      {7, "Mercator"},    {17, "Equirectangular"}, {20, "Miller Cylindrical"},    {23, "Robinson"},
      {24, "Sinusoidal"}, {25, "Van der Grinten"}, {28, "Cylindrical Equal Area"}};
  const auto found = kMethods.find(method);
  return found == kMethods.end() ? "" : found->second;
}

void declare_plan(const KeyDirectory& keys, GeoTiffReferenceSystem& system) {
  std::vector<LengthUnitDeclaration>& lengths = system.unit_declarations;
  const int model = keys.code(kModelType);
  if (model >= 1 && model <= 3) {
    constexpr ReferenceSystemKind kKinds[] = {ReferenceSystemKind::kProjected,
                                              ReferenceSystemKind::kGeographic,
                                              ReferenceSystemKind::kGeocentric};
    lengths.push_back({.source = key_source(kModelType, model), .kind = kKinds[model - 1]});
  }
  // The geographic system of a map is its base and says nothing of its coordinates.
  const bool map =
      model == 1 || keys.code(kProjectedType) != 0 || (model == 0 && keys.code(kLinearUnits) != 0);
  const GeoKey type = map ? kProjectedType : kGeographicType;
  if (const int code = keys.registered(type)) {
    system.crs = "EPSG:" + std::to_string(code);
    lengths.push_back(determine_crs_units(system.crs, key_source(type, code)));
  }
  if (map) {
    if (auto unit = unit_in_key(keys, kLinearUnits, keys.number(kLinearUnitSize))) {
      lengths.push_back(
          {.source = key_source(kLinearUnits, keys.code(kLinearUnits)), .plan = std::move(unit)});
    }
    const char* projection = world_projection(keys.code(kProjectionMethod));
    if (system.crs.empty() && *projection) {
      lengths.push_back({.source = key_source(kProjectionMethod, keys.code(kProjectionMethod)),
                         .world_projection = projection});
    }
  } else if (model == 3) {
    if (auto unit = unit_in_key(keys, kGeographicLinearUnits, 0.0)) {
      lengths.push_back(
          {.source = key_source(kGeographicLinearUnits, keys.code(kGeographicLinearUnits)),
           .plan = std::move(unit)});
    }
  }
}

void declare_heights(const KeyDirectory& keys, std::vector<LengthUnitDeclaration>& lengths) {
  if (const int code = keys.registered(kVerticalType)) {
    // Old codes of this key are of datums, and other systems have taken their numbers since.
    LengthUnitDeclaration declared =
        determine_crs_units("EPSG:" + std::to_string(code), key_source(kVerticalType, code));
    if (declared.kind == ReferenceSystemKind::kVertical) lengths.push_back(std::move(declared));
  }
  if (auto unit = unit_in_key(keys, kVerticalUnits, 0.0)) {
    lengths.push_back({.source = key_source(kVerticalUnits, keys.code(kVerticalUnits)),
                       .height = std::move(unit)});
  }
}

/// Citations count where nothing else says the unit.
void declare_citations(const KeyDirectory& keys, std::vector<LengthUnitDeclaration>& lengths) {
  const auto declares = [&](auto member) {
    return std::any_of(lengths.begin(), lengths.end(), [&](const LengthUnitDeclaration& declared) {
      return (declared.*member).has_value();
    });
  };
  const auto declare = [&](std::initializer_list<GeoKey> citations, auto member) {
    if (declares(member)) return;
    for (const GeoKey key : citations) {
      const auto unit = unit_in_citation(keys.text(key));
      if (!unit) continue;
      lengths.push_back({.source = "GeoTIFF key " + std::to_string(key) + " \"" +
                                   escape_nonprintable(keys.text(key).substr(0, 40)) + "\""});
      lengths.back().*member = unit;
      return;
    }
  };
  declare({kProjectedCitation, kCitation}, &LengthUnitDeclaration::plan);
  declare({kVerticalCitation}, &LengthUnitDeclaration::height);
}

}  // namespace

GeoTiffReferenceSystem parse_geotiff_keys(const GeoTiffKeys& records) {
  const KeyDirectory keys(records);
  GeoTiffReferenceSystem system;
  declare_plan(keys, system);
  declare_heights(keys, system.unit_declarations);
  declare_citations(keys, system.unit_declarations);
  return system;
}

}  // namespace clast
