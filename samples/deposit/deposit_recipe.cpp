#include "samples/deposit/deposit_recipe.hpp"

#include <array>
#include <utility>

#include "core/error.hpp"
#include "core/number_range.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

constexpr std::array<std::pair<DepositKind, const char*>, 4> kKindNames = {
    {{DepositKind::kHeap, "heap"},
     {DepositKind::kScattered, "scattered"},
     {DepositKind::kSlope, "slope"},
     {DepositKind::kNatural, "natural"}}};
constexpr std::array<std::pair<ScanStations, const char*>, 2> kStationNames = {
    {{ScanStations::kDrone, "drone"}, {ScanStations::kTripod, "tripod"}}};

template <class Value, std::size_t kCount>
Value parse_name(const std::array<std::pair<Value, const char*>, kCount>& names,
                 const std::string& what, const std::string& name) {
  std::string known;
  for (const auto& [value, known_name] : names) {
    if (name == known_name) return value;
    known += (known.empty() ? "" : ", ") + std::string(known_name);
  }
  throw InputError(what + " \"" + name + "\" is unknown; known are " + known);
}

template <class Value, std::size_t kCount>
std::string find_name(const std::array<std::pair<Value, const char*>, kCount>& names, Value value) {
  for (const auto& [known, name] : names) {
    if (known == value) return name;
  }
  return {};
}

void check_range(const std::string& field, double value, const NumberRange& range) {
  if (range.contains(value)) return;
  throw InputError(field + " is " + format_significant(value, 6) + "; it must be " +
                   range.describe());
}

}  // namespace

DepositKind parse_deposit_kind(const std::string& name) {
  return parse_name(kKindNames, "kind of deposit", name);
}
std::string name_of(DepositKind kind) { return find_name(kKindNames, kind); }

ScanStations parse_scan_stations(const std::string& name) {
  return parse_name(kStationNames, "kind of stations", name);
}
std::string name_of(ScanStations stations) { return find_name(kStationNames, stations); }

void DepositRecipe::check() const {
  check_range("blocks", static_cast<double>(blocks), {1, 2000});
  check_range("size_ratio", size_ratio, {1, 16});
  check_range("spacings_per_block", spacings_per_block, {5, 60});
  check_range("noise", noise, {0, 2});
  check_range("fines", fines, {0, 1.5});
  if (fines > 0.0 && kind == DepositKind::kNatural) {
    throw InputError("fines is " + format_significant(fines, 6) +
                     ", but natural ground has soil of its own; leave it at 0");
  }
}

}  // namespace clast
