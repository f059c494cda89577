#include "mesh/reference_system.hpp"

#include <proj.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"

namespace clast {
namespace {

/// Two units whose sizes differ by less are one: the US survey foot and the foot.
constexpr double kSameUnit = 1e-5;
/// Largest error of lengths that a projection may make.
constexpr double kMaxScaleError = 0.01;
/// Map coordinates nearer to the origin than this are rather local ones, m.
constexpr double kLocalReach = 1e5;

struct DestroyPj {
  void operator()(PJ* pj) const { proj_destroy(pj); }
};
using PjPointer = std::unique_ptr<PJ, DestroyPj>;

struct DestroyContext {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};

/// A system in a context of its own, which prints nothing.
struct ParsedSystem {
  std::unique_ptr<PJ_CONTEXT, DestroyContext> context;
  PjPointer system;

  explicit ParsedSystem(const std::string& crs) : context(proj_context_create()) {
    proj_log_level(context.get(), PJ_LOG_NONE);
    system.reset(proj_create(context.get(), crs.c_str()));
    if (system && !proj_is_crs(system.get())) system.reset();
  }
  /// The part of a compound or bound system that holds the plan.
  PjPointer plan_system() const {
    PjPointer part(proj_clone(context.get(), system.get()));
    for (PJ_TYPE type = proj_get_type(part.get());
         type == PJ_TYPE_BOUND_CRS || type == PJ_TYPE_COMPOUND_CRS;
         type = proj_get_type(part.get())) {
      part.reset(type == PJ_TYPE_BOUND_CRS ? proj_get_source_crs(context.get(), part.get())
                                           : proj_crs_get_sub_crs(context.get(), part.get(), 0));
      if (!part) break;
    }
    return part;
  }
};

struct SystemAxes {
  PJ_COORDINATE_SYSTEM_TYPE type = PJ_CS_TYPE_UNKNOWN;
  std::vector<DeclaredUnit> units;
};

SystemAxes axes_of_system(PJ_CONTEXT* context, const PJ* system) {
  SystemAxes axes;
  const PjPointer cs(proj_crs_get_coordinate_system(context, system));
  if (!cs) return axes;
  axes.type = proj_cs_get_type(context, cs.get());
  const int count = proj_cs_get_axis_count(context, cs.get());
  for (int i = 0; i < count; ++i) {
    double factor = 0.0;
    const char* name = nullptr;
    proj_cs_get_axis_info(context, cs.get(), i, nullptr, nullptr, nullptr, &factor, &name, nullptr,
                          nullptr);
    axes.units.push_back({factor, name ? name : "unit"});
  }
  return axes;
}

void describe_part(PJ_CONTEXT* context, const PJ* part, LengthUnitDeclaration& declared) {
  const PJ_TYPE type = proj_get_type(part);
  if (type == PJ_TYPE_BOUND_CRS) {
    const PjPointer source(proj_get_source_crs(context, part));
    if (source) describe_part(context, source.get(), declared);
    return;
  }
  if (type == PJ_TYPE_COMPOUND_CRS) {
    for (int i = 0; i < 2; ++i) {
      const PjPointer sub(proj_crs_get_sub_crs(context, part, i));
      if (sub) describe_part(context, sub.get(), declared);
    }
    return;
  }
  const SystemAxes axes = axes_of_system(context, part);
  if (axes.units.empty()) return;
  if (axes.type == PJ_CS_TYPE_VERTICAL) {
    declared.height = axes.units[0];
    if (declared.kind == ReferenceSystemKind::kUnknown)
      declared.kind = ReferenceSystemKind::kVertical;
    return;
  }
  declared.kind = type == PJ_TYPE_GEOCENTRIC_CRS        ? ReferenceSystemKind::kGeocentric
                  : axes.type == PJ_CS_TYPE_ELLIPSOIDAL ? ReferenceSystemKind::kGeographic
                                                        : ReferenceSystemKind::kProjected;
  if (declared.kind != ReferenceSystemKind::kGeographic) declared.plan = axes.units[0];
  if (axes.units.size() > 2) declared.height = axes.units[2];
}

/// End of the first system in a text; Esri programs append the vertical system.
std::size_t first_system_end(const std::string& wkt) {
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < wkt.size(); ++i) {
    if (wkt[i] == '"') quoted = !quoted;
    if (quoted) continue;
    if (wkt[i] == '[' || wkt[i] == '(') ++depth;
    if ((wkt[i] == ']' || wkt[i] == ')') && (depth == 0 || --depth == 0)) return i + 1;
  }
  return wkt.size();
}

bool same_unit(const DeclaredUnit& one, const DeclaredUnit& other) {
  return std::abs(one.metres - other.metres) <= kSameUnit * std::max(one.metres, other.metres);
}

/// "US survey foot (0.3048006 m)"
std::string unit_text(const DeclaredUnit& unit) {
  if (unit.metres == 0.0) return unit.name;
  return unit.name + (unit.metres == 1.0 ? "" : " (" + format_significant(unit.metres, 7) + " m)");
}

/// A unit and the declaration that says so.
struct SourcedUnit {
  DeclaredUnit unit;
  const std::string* source;
};

using UnitMember = std::optional<DeclaredUnit> LengthUnitDeclaration::*;

std::vector<SourcedUnit> units_declared(const std::vector<LengthUnitDeclaration>& declared,
                                        UnitMember member) {
  std::vector<SourcedUnit> units;
  for (const LengthUnitDeclaration& each : declared) {
    if (each.*member) units.push_back({*(each.*member), &each.source});
  }
  return units;
}

std::string relabelled(const LengthUnitRequirements& use) {
  return use.correction_command.empty()
             ? "correct the one that is wrong"
             : "correct the one that is wrong (" + use.correction_command + ")";
}

/// The one unit that is declared; none where there is none.
/// @param what  "x and y" or "heights"
std::optional<SourcedUnit> one_unit(const std::string& name, const char* what,
                                    const std::vector<SourcedUnit>& units,
                                    const LengthUnitRequirements& use) {
  if (units.empty()) return std::nullopt;
  for (const SourcedUnit& each : units) {
    if (same_unit(each.unit, units[0].unit)) continue;
    if (use.unit_given) {
      const auto as_given = std::find_if(units.begin(), units.end(), [&](const SourcedUnit& unit) {
        return same_unit(unit.unit, {use.unit, {}});
      });
      if (as_given != units.end()) return *as_given;
    }
    throw InputError(name + ": the unit of its " + what + " is the " + unit_text(units[0].unit) +
                     " according to its " + *units[0].source + ", but the " + unit_text(each.unit) +
                     " according to its " + *each.source + "; " + relabelled(use) +
                     (use.has_units_option ? ", or give `units`" : ""));
  }
  return units[0];
}

void refuse_kinds(const std::string& name, const std::vector<LengthUnitDeclaration>& declared,
                  const LengthUnitRequirements& use) {
  const auto of_kind = [&](ReferenceSystemKind kind) {
    const auto found = std::find_if(declared.begin(), declared.end(),
                                    [&](const LengthUnitDeclaration& d) { return d.kind == kind; });
    return found == declared.end() ? nullptr : &*found;
  };
  const LengthUnitDeclaration *map = of_kind(ReferenceSystemKind::kProjected),
                              *degrees = of_kind(ReferenceSystemKind::kGeographic);
  const LengthUnitDeclaration* geocentric = of_kind(ReferenceSystemKind::kGeocentric);
  if (map && degrees) {
    throw InputError(name + ": its coordinates are lengths according to its " + map->source +
                     ", but degrees according to its " + degrees->source + "; " + relabelled(use));
  }
  if (degrees) {
    throw InputError(name +
                     ": coordinates are degrees; project it to metres first, for example with " +
                     use.conversion_command + " (" + degrees->source + ")");
  }
  if (geocentric && use.needs_z_up) {
    throw InputError(name + ": coordinates are geocentric, so that z is not up (" +
                     geocentric->source + "); bring it into a map system first (" +
                     use.conversion_command + ")");
  }
  for (const LengthUnitDeclaration& each : declared) {
    if (each.world_projection.empty()) continue;
    throw InputError(
        name + ": its projection is " + each.world_projection + " (" + each.source +
        "), whose lengths differ from those on the ground almost everywhere; project it to "
        "a local system in metres first (" +
        use.conversion_command + ")");
  }
}

/// Advice on a unit: the option if it exists, otherwise conversion.
std::string unit_advice(const DeclaredUnit& unit, const LengthUnitRequirements& use) {
  if (use.has_units_option && unit.metres > 0.0) {
    return "give `units` " + format_significant(unit.metres, 10) + ", or bring it to metres (" +
           use.conversion_command + ")";
  }
  return "project it to a system in metres first (" + use.conversion_command + ")";
}

/// Along x and y: map over ground.
std::optional<Vec2> scale_at(const ParsedSystem& parsed, const PJ* plan, const Vec2& place,
                             Vec2* degrees) {
  PJ_CONTEXT* context = parsed.context.get();
  const PjPointer geodetic(proj_crs_get_geodetic_crs(context, plan));
  const PjPointer ellipsoid(geodetic ? proj_get_ellipsoid(context, geodetic.get()) : nullptr);
  double a = 0.0, b = 0.0;
  if (!ellipsoid ||
      !proj_ellipsoid_get_parameters(context, ellipsoid.get(), &a, &b, nullptr, nullptr)) {
    return std::nullopt;
  }
  const SystemAxes map = axes_of_system(context, plan),
                   angles = axes_of_system(context, geodetic.get());
  if (map.units.empty() || angles.units.empty()) return std::nullopt;
  const PjPointer as_stored(
      proj_create_crs_to_crs_from_pj(context, plan, geodetic.get(), nullptr, nullptr));
  const PjPointer to_angles(as_stored ? proj_normalize_for_visualization(context, as_stored.get())
                                      : nullptr);
  if (!to_angles) return std::nullopt;
  const double radians = angles.units[0].metres;
  const auto angles_at = [&](const Vec2& at) {
    const PJ_COORD c = proj_trans(to_angles.get(), PJ_FWD, proj_coord(at.x(), at.y(), 0.0, 0.0));
    return Vec2(c.xy.x * radians, c.xy.y * radians);
  };
  constexpr double kStep = 100.0;  // units of the map
  const Vec2 centre = angles_at(place);
  const double e2 = 1.0 - (b * b) / (a * a), sine = std::sin(centre.y());
  const double n = a / std::sqrt(1.0 - e2 * sine * sine);
  const double m = n * (1.0 - e2) / (1.0 - e2 * sine * sine);
  Vec2 scale;
  for (int axis = 0; axis < 2; ++axis) {
    Vec2 beside = place;
    beside[axis] += kStep;
    Vec2 turn = angles_at(beside) - centre;
    turn.x() = std::remainder(turn.x(), 2.0 * kPi);  // over the date line
    scale[axis] =
        kStep * map.units[0].metres / std::hypot(n * std::cos(centre.y()) * turn.x(), m * turn.y());
  }
  if (!scale.allFinite() || !(scale.minCoeff() > 0.0)) return std::nullopt;
  if (degrees) *degrees = centre * kDegreesPerRadian;
  return scale;
}

bool is_within_area(const ParsedSystem& parsed, const PJ* plan, const Vec2& degrees) {
  double west = 0.0, south = 0.0, east = 0.0, north = 0.0;
  if (!proj_get_area_of_use(parsed.context.get(), plan, &west, &south, &east, &north, nullptr) ||
      west < -200.0) {
    return true;  // it has none
  }
  const bool within_lengths = west <= east ? degrees.x() >= west && degrees.x() <= east
                                           : degrees.x() >= west || degrees.x() <= east;
  return within_lengths && degrees.y() >= south && degrees.y() <= north;
}

/// The zone of the UTM system of WGS 84 at a place.
std::string utm_code(const Vec2& degrees) {
  const int zone = std::clamp(static_cast<int>(std::floor((degrees.x() + 180.0) / 6.0)) + 1, 1, 60);
  return "EPSG:" + std::to_string((degrees.y() < 0.0 ? 32700 : 32600) + zone);
}

/// A command for the system with that code.
std::string with_code(std::string way, const std::string& code) {
  const std::string place = "EPSG:CODE";
  const std::size_t at = way.find(place);
  return at == std::string::npos ? way : way.replace(at, place.size(), code);
}

}  // namespace

LengthUnitDeclaration determine_crs_units(const std::string& crs, std::string source) {
  LengthUnitDeclaration declared{.source = std::move(source),
                                 .kind = ReferenceSystemKind::kUnknown};
  const std::size_t end = first_system_end(crs);
  const ParsedSystem parsed(crs.substr(0, end));
  if (!parsed.system) return declared;
  if (const char* name = proj_get_name(parsed.system.get()))
    declared.source += ", " + escape_nonprintable(name);
  describe_part(parsed.context.get(), parsed.system.get(), declared);
  const std::size_t second = crs.find_first_not_of(", \t\r\n", end);
  if (second == std::string::npos) return declared;
  const ParsedSystem heights(crs.substr(second));
  if (heights.system) {
    describe_part(heights.context.get(), heights.system.get(), declared);
  } else {
    declared.kind = ReferenceSystemKind::kUnknown;
  }
  return declared;
}

std::optional<DeclaredUnit> epsg_length_unit(int code) {
  // Works without the PROJ database.
  if (code == 9001) return DeclaredUnit{1.0, "metre"};
  if (code == 9002) return DeclaredUnit{0.3048, "foot"};
  if (code == 9003) return DeclaredUnit{1200.0 / 3937.0, "US survey foot"};
  const std::unique_ptr<PJ_CONTEXT, DestroyContext> context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  const char *name = nullptr, *category = nullptr;
  double factor = 0.0;
  if (!proj_uom_get_info_from_database(context.get(), "EPSG", std::to_string(code).c_str(), &name,
                                       &factor, &category) ||
      !name || std::string(category) != "linear") {
    return std::nullopt;
  }
  return DeclaredUnit{factor, name};
}

std::vector<std::string> check_length_units(const std::string& name,
                                            const std::vector<LengthUnitDeclaration>& declared,
                                            const LengthUnitRequirements& use) {
  std::vector<std::string> notes;
  for (const LengthUnitDeclaration& each : declared) {
    if (each.kind != ReferenceSystemKind::kUnknown) continue;
    notes.push_back("its " + each.source +
                    " names no known unit or reference system; its coordinates are assumed to be "
                    "in the given or default unit");
  }
  refuse_kinds(name, declared, use);
  const auto plan =
      one_unit(name, "x and y", units_declared(declared, &LengthUnitDeclaration::plan), use);
  const auto height =
      one_unit(name, "heights", units_declared(declared, &LengthUnitDeclaration::height), use);
  const DeclaredUnit metre{1.0, "metre"};
  if (plan && height && !same_unit(plan->unit, height->unit)) {
    throw InputError(name + ": its heights are in units of the " + unit_text(height->unit) + " (" +
                     *height->source + "), its x and y in units of the " + unit_text(plan->unit) +
                     " (" + *plan->source +
                     "); bring both to metres first, with a system of heights in metres (" +
                     use.conversion_command + "+CODE)");
  }
  for (const auto& [unit, what] : {std::pair(plan, "map unit"), {height, "unit of heights"}}) {
    if (!unit || same_unit(unit->unit, {use.unit, {}})) continue;
    const std::string text = std::string("its ") + what + " is the " + unit_text(unit->unit) +
                             " (" + *unit->source + ")";
    if (!use.unit_given) {
      throw InputError(name + ": " + text + "; " + unit_advice(unit->unit, use));
    }
    notes.push_back(text + "; lengths were read as " + format_significant(use.unit, 7) +
                    " m per unit, as requested");
  }
  return notes;
}

void check_map_scale(const std::string& name, const std::string& crs, const Vec2& place,
                     const std::string& conversion_command) {
  if (crs.empty() || place.cwiseAbs().maxCoeff() < kLocalReach) return;
  const ParsedSystem parsed(crs);
  if (!parsed.system) return;
  const PjPointer plan = parsed.plan_system();
  if (!plan || proj_get_type(plan.get()) != PJ_TYPE_PROJECTED_CRS) return;
  Vec2 degrees;
  const std::optional<Vec2> scale = scale_at(parsed, plan.get(), place, &degrees);
  if (!scale || !is_within_area(parsed, plan.get(), degrees)) return;
  const Vec2 off = (scale->array() - 1.0).abs();
  if (off.maxCoeff() <= kMaxScaleError) return;
  throw InputError(name + ": lengths on its map (" + reference_system_name(crs) + ") are " +
                   format_significant((*scale)[off.x() >= off.y() ? 0 : 1], 4) +
                   " times those on the ground; project it to a local system in metres first (" +
                   with_code(conversion_command, utm_code(degrees)) + ")");
}

std::optional<Vec2> map_scale_factor(const std::string& crs, const Vec2& place) {
  const ParsedSystem parsed(crs);
  const PjPointer plan = parsed.system ? parsed.plan_system() : nullptr;
  if (!plan || proj_get_type(plan.get()) != PJ_TYPE_PROJECTED_CRS) return std::nullopt;
  return scale_at(parsed, plan.get(), place, nullptr);
}

std::string reference_system_name(const std::string& crs) {
  constexpr std::size_t kMaxTextLength = 60;
  const ParsedSystem parsed(crs);
  const char* name = parsed.system ? proj_get_name(parsed.system.get()) : nullptr;
  if (!name) {
    return escape_nonprintable(
        crs.size() <= kMaxTextLength ? crs : crs.substr(0, kMaxTextLength) + "...");
  }
  const char* authority = proj_get_id_auth_name(parsed.system.get(), 0);
  const char* code = proj_get_id_code(parsed.system.get(), 0);
  return escape_nonprintable(name) +
         (authority && code ? std::string(" (") + authority + ":" + code + ")" : "");
}

}  // namespace clast
