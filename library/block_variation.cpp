#include "library/block_variation.hpp"

#include <cmath>
#include <map>
#include <sstream>
#include <type_traits>
#include <utility>

#include "classify/surface_indices.hpp"
#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "library/detail/roundness_search.hpp"
#include "library/detail/varied_body.hpp"
#include "library/make_block.hpp"
#include "massprops/sphero.hpp"

namespace clast {

using namespace library_detail;

namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

std::string number(double value) { return format_significant(value, 6); }

std::string ratios_text(const BoxRatios& ratios) {
  return "i_l=" + number(ratios.i_l) + " s_l=" + number(ratios.s_l);
}

/// The targets of a variation as "key=value" pairs.
std::string targets_of(const Variation& variation) {
  return std::visit(
      Overloaded{[](const StretchVariation& v) { return ratios_text(v.ratios); },
                 [](const ConvexityVariation& v) { return "step=" + number(v.convexity); },
                 [](const RoundingVariation& v) { return "step=" + number(v.radius_fraction); },
                 [](const RoundnessVariation& v) { return "step=" + number(v.roundness); },
                 [](const VertexCountVariation& v) { return "step=" + std::to_string(v.vertices); },
                 [](const DetailVariation& v) {
                   return "step=" + number(v.gain) + " degree=" + std::to_string(v.degree);
                 },
                 [](const ReferenceVariation& v) { return "reference=" + name_of(v.form); },
                 [](const InertiaVariation& v) { return "reference=inertia-" + name_of(v.form); },
                 [](const SampledFormVariation& v) {
                   return ratios_text(v.ratios) + " l_m=" + number(v.length) +
                          (v.convexity ? " convexity=" + number(*v.convexity) : "");
                 }},
      variation);
}

/// An id may hold blanks, which end a value.
std::string without_blanks(const std::string& id) {
  std::string text;
  for (const char c : id) {
    if (c == ' ') {
      text += "%20";
    } else if (c == '%') {
      text += "%25";
    } else {
      text += c;
    }
  }
  return text;
}

std::string with_blanks(const std::string& text) {
  std::string id;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string code = text.substr(i, 3);
    if (code == "%20" || code == "%25") {
      id += code == "%20" ? ' ' : '%';
      i += 2;
    } else {
      id += text[i];
    }
  }
  return id;
}

/// The body in the size that its twin, or the draw, gives it.
SpheroPolyhedron sized(const SpheroPolyhedron& body, const Block& parent,
                       const Variation& variation, const VariationOptions& options) {
  if (std::holds_alternative<InertiaVariation>(variation)) return body;
  const auto* drawn = std::get_if<SampledFormVariation>(&variation);
  double factor = 1.0;
  if (drawn || options.preserved_size == PreservedSize::kLength) {
    factor = (drawn ? drawn->length : parent.axes().L) / smallest_box(body).lengths[0];
  } else {
    const double volume = sphero_mass_properties(body, 1.0, options.accuracy).volume;
    factor = std::cbrt(parent.mass.volume / volume);
  }
  const Vec3 centre = parent.mass.centre;
  SpheroPolyhedron result = body;
  for (Vec3& vertex : result.vertices) vertex = centre + factor * (vertex - centre);
  result.radius *= factor;
  return result;
}

/// If the body is bit-identical to that of the parent, its size is too.
bool same_body(const SpheroPolyhedron& a, const SpheroPolyhedron& b) {
  return a.radius == b.radius && a.vertices == b.vertices && a.faces == b.faces;
}

void check_reached(const std::string& what, double value, double target) {
  if (std::abs(value / target - 1.0) <= kVariationTolerance) return;
  throw GeometryError(what + " = " + format_significant(target, 4) +
                      " can't be reached; the nearest is " + format_significant(value, 4));
}

/// Refuses a body that missed its target.
void check_targets(const Block& block, const Variation& variation) {
  const BoxRatios ratios = box_ratios(block.box);
  const auto check_form = [&](const BoxRatios& wanted) {
    check_reached("I/L", ratios.i_l, wanted.i_l);
    check_reached("S/L", ratios.s_l, wanted.s_l);
  };
  if (const auto* stretch = std::get_if<StretchVariation>(&variation)) check_form(stretch->ratios);
  if (const auto* drawn = std::get_if<SampledFormVariation>(&variation)) {
    check_form(drawn->ratios);
    check_reached("L in m", block.axes().L, drawn->length);
  }
  if (const auto* filled = std::get_if<ConvexityVariation>(&variation)) {
    check_reached("convexity", convexity(block.body, block.mass.volume), filled->convexity);
  }
}

/// The body of a variation in its final size.
template <class Wanted>
VariationResult sized_body(const Block& parent, const Wanted& wanted,
                           const VariationOptions& options) {
  VariationResult varied = apply_variation(parent, wanted);
  if (std::is_same_v<Wanted, SampledFormVariation> || !same_body(varied.body, parent.body)) {
    varied.body = sized(varied.body, parent, wanted, options);
  }
  return varied;
}

/// Roundness is measured on the final body: on another place and size it differs by about a
/// percent, since the mesh it is measured on does.
VariationResult sized_body(const Block& parent, const RoundnessVariation& wanted,
                           const VariationOptions& options) {
  const double diameter = std::cbrt(6.0 * parent.mass.volume / kPi);
  const double edge = *parse_number(format_significant(wanted.edge_fraction * diameter, 4));
  RoundnessSearchResult found = find_body_with_roundness(
      [&](double share) { return sized_body(parent, RoundingVariation{share}, options).body; },
      wanted.roundness, edge);
  return {std::move(found.body),
          "edge_m=" + format_significant(edge, 4) +
              " roundness=" + format_significant(found.roundness, 4) +
              " radius_share=" + format_significant(found.radius_fraction, 4)};
}

Block varied_block(const std::string& id, const Block& parent, const Variation& variation,
                   BlockSource source, const VariationOptions& options) {
  options.check();
  const VariationResult varied = std::visit(
      [&](const auto& wanted) { return sized_body(parent, wanted, options); }, variation);
  source.unscaled = parent.source.unscaled;
  source.options += (source.options.empty() ? "" : " ") + std::string("vary=") +
                    name_of_variation(variation) + " parent=" + without_blanks(parent.id) +
                    " parent_sha256=" + parent.source.sha256 +
                    " keep=" + name_of(options.preserved_size) + " " + targets_of(variation) +
                    (varied.record.empty() ? "" : " " + varied.record);
  BlockOptions making;
  making.density = parent.density;
  making.accuracy = options.accuracy;
  if (std::holds_alternative<InertiaVariation>(variation)) making.mass = parent.mass.mass;
  Block block = make_block(id, varied.body, std::move(source), making);
  block.field.weighed_mass.reset();
  check_targets(block, variation);
  return block;
}

}  // namespace

std::string name_of_variation(const Variation& variation) {
  static constexpr const char* kKinds[] = {"stretch",   "convexity", "rounding",
                                           "roundness", "vertices",  "detail",
                                           "reference", "inertia",   "drawn"};
  static_assert(std::size(kKinds) == std::variant_size_v<Variation>);
  return kKinds[variation.index()];
}

std::string variation_label(const Variation& variation) {
  const auto form = [](const BoxRatios& ratios) {
    return "il" + format_significant(ratios.i_l, 4) + "_sl" + format_significant(ratios.s_l, 4);
  };
  return std::visit(
      Overloaded{
          [&](const StretchVariation& v) { return form(v.ratios); },
          [](const ConvexityVariation& v) {
            return "convexity" + format_significant(v.convexity, 4);
          },
          [](const RoundingVariation& v) {
            return "radius" + format_significant(v.radius_fraction, 4);
          },
          [](const RoundnessVariation& v) {
            return "roundness" + format_significant(v.roundness, 4);
          },
          [](const VertexCountVariation& v) { return "vertices" + std::to_string(v.vertices); },
          [](const DetailVariation& v) { return "detail" + format_significant(v.gain, 4); },
          [](const ReferenceVariation& v) { return name_of(v.form); },
          [](const InertiaVariation& v) { return "inertia-" + name_of(v.form); },
          [&](const SampledFormVariation& v) { return form(v.ratios); }},
      variation);
}

PreservedSize parse_preserved_size(const std::string& name) {
  if (name == "mass") return PreservedSize::kMass;
  if (name == "volume") return PreservedSize::kVolume;
  if (name == "L") return PreservedSize::kLength;
  throw InputError("`keep` = \"" + name + "\": must be mass, volume or L");
}

std::string name_of(PreservedSize preserved) {
  switch (preserved) {
    case PreservedSize::kMass:
      return "mass";
    case PreservedSize::kVolume:
      return "volume";
    case PreservedSize::kLength:
      break;
  }
  return "L";
}

void VariationOptions::check() const {
  if (!(accuracy >= 1e-6 && accuracy <= 1e-2)) {
    throw InputError("accuracy is " + format_significant(accuracy, 4) +
                     "; it must be between 1e-6 and 1e-2");
  }
}

Block vary_block(const std::string& id, const Block& parent, const Variation& variation,
                 BlockSource source, const VariationOptions& options) {
  return with_error_context("block " + parent.id, [&] {
    return varied_block(id, parent, variation, std::move(source), options);
  });
}

std::optional<VariationRecord> parse_variation(const Block& block) {
  std::map<std::string, std::string> values;
  std::istringstream words(block.source.options);
  for (std::string word; words >> word;) {
    const std::size_t equal = word.find('=');
    if (equal != word.npos) values.emplace(word.substr(0, equal), word.substr(equal + 1));
  }
  if (!values.contains("vary") || !values.contains("parent")) return std::nullopt;
  VariationRecord record;
  record.kind = values["vary"];
  record.parent = with_blanks(values["parent"]);
  record.reference = values["reference"];
  record.target_value = parse_number(values["step"]).value_or(0.0);
  const std::optional<double> i_l = parse_number(values["i_l"]), s_l = parse_number(values["s_l"]);
  if (i_l && s_l) record.target_ratios = BoxRatios{*i_l, *s_l};
  return record;
}

std::string describe_variation(const VariationRecord& record) {
  if (!record.reference.empty()) return record.reference;
  if (record.target_ratios) {
    return record.kind + " to " + format_significant(record.target_ratios->i_l, 4) + ", " +
           format_significant(record.target_ratios->s_l, 4);
  }
  return record.kind + " " + format_significant(record.target_value, 4);
}

}  // namespace clast
