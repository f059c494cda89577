#include "library/block_variation.hpp"

#include <cmath>
#include <map>
#include <sstream>
#include <type_traits>
#include <utility>

#include "classify/surface_indices.hpp"
#include "core/error.hpp"
#include "core/in_context.hpp"
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

std::string number(double value) { return with_digits(value, 6); }

std::string ratios_text(const BoxRatios& ratios) {
  return "i_l=" + number(ratios.i_l) + " s_l=" + number(ratios.s_l);
}

/// The targets of a variation as "key=value" pairs.
std::string targets_of(const Variation& variation) {
  return std::visit(
      Overloaded{[](const StretchTo& v) { return ratios_text(v.ratios); },
                 [](const ConvexityOf& v) { return "step=" + number(v.convexity); },
                 [](const RoundingOf& v) { return "step=" + number(v.radius_share); },
                 [](const RoundnessOf& v) { return "step=" + number(v.roundness); },
                 [](const VertexCount& v) { return "step=" + std::to_string(v.vertices); },
                 [](const DetailTimes& v) {
                   return "step=" + number(v.gain) + " degree=" + std::to_string(v.degree);
                 },
                 [](const ReferenceTo& v) { return "reference=" + name_of(v.form); },
                 [](const InertiaTwin& v) { return "reference=inertia-" + name_of(v.form); },
                 [](const DrawnForm& v) {
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
  if (std::holds_alternative<InertiaTwin>(variation)) return body;
  const auto* drawn = std::get_if<DrawnForm>(&variation);
  double factor = 1.0;
  if (drawn || options.keep == KeptSize::kLength) {
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

/// Is the body the parent's, to the bit? Then its size is, too.
bool same_body(const SpheroPolyhedron& a, const SpheroPolyhedron& b) {
  return a.radius == b.radius && a.vertices == b.vertices && a.faces == b.faces;
}

void check_reached(const std::string& what, double value, double target) {
  if (std::abs(value / target - 1.0) <= kVariationTolerance) return;
  throw GeometryError(what + " = " + with_digits(target, 4) + " can't be reached; the nearest is " +
                      with_digits(value, 4));
}

/// Refuses a body that missed its target.
void check_targets(const Block& block, const Variation& variation) {
  const BoxRatios ratios = box_ratios(block.box);
  const auto check_form = [&](const BoxRatios& wanted) {
    check_reached("I/L", ratios.i_l, wanted.i_l);
    check_reached("S/L", ratios.s_l, wanted.s_l);
  };
  if (const auto* stretch = std::get_if<StretchTo>(&variation)) check_form(stretch->ratios);
  if (const auto* drawn = std::get_if<DrawnForm>(&variation)) {
    check_form(drawn->ratios);
    check_reached("L in m", block.axes().L, drawn->length);
  }
  if (const auto* filled = std::get_if<ConvexityOf>(&variation)) {
    check_reached("convexity", convexity(block.body, block.mass.volume), filled->convexity);
  }
}

/// The body of a variation in its final size.
template <class Wanted>
VariedBody sized_body(const Block& parent, const Wanted& wanted, const VariationOptions& options) {
  VariedBody varied = varied_body(parent, wanted);
  if (std::is_same_v<Wanted, DrawnForm> || !same_body(varied.body, parent.body)) {
    varied.body = sized(varied.body, parent, wanted, options);
  }
  return varied;
}

/// Roundness is measured on the final body: on another place and size it differs by about a
/// percent, since the mesh it is measured on does.
VariedBody sized_body(const Block& parent, const RoundnessOf& wanted,
                      const VariationOptions& options) {
  const double diameter = std::cbrt(6.0 * parent.mass.volume / kPi);
  const double edge = *number_in(with_digits(wanted.edge_share * diameter, 4));
  RoundedBody found = body_of_roundness(
      [&](double share) { return sized_body(parent, RoundingOf{share}, options).body; },
      wanted.roundness, edge);
  return {std::move(found.body), "edge_m=" + with_digits(edge, 4) +
                                     " roundness=" + with_digits(found.roundness, 4) +
                                     " radius_share=" + with_digits(found.radius_share, 4)};
}

Block varied_block(const std::string& id, const Block& parent, const Variation& variation,
                   BlockSource source, const VariationOptions& options) {
  options.check();
  const VariedBody varied = std::visit(
      [&](const auto& wanted) { return sized_body(parent, wanted, options); }, variation);
  source.unscaled = parent.source.unscaled;
  source.options += (source.options.empty() ? "" : " ") + std::string("vary=") +
                    kind_of(variation) + " parent=" + without_blanks(parent.id) +
                    " parent_sha256=" + parent.source.sha256 + " keep=" + name_of(options.keep) +
                    " " + targets_of(variation) +
                    (varied.figures.empty() ? "" : " " + varied.figures);
  BlockOptions making;
  making.density = parent.density;
  making.accuracy = options.accuracy;
  if (std::holds_alternative<InertiaTwin>(variation)) making.mass = parent.mass.mass;
  Block block = make_block(id, varied.body, std::move(source), making);
  block.field.weighed_mass.reset();
  check_targets(block, variation);
  return block;
}

}  // namespace

std::string kind_of(const Variation& variation) {
  static constexpr const char* kKinds[] = {"stretch",   "convexity", "rounding",
                                           "roundness", "vertices",  "detail",
                                           "reference", "inertia",   "drawn"};
  static_assert(std::size(kKinds) == std::variant_size_v<Variation>);
  return kKinds[variation.index()];
}

std::string label_of(const Variation& variation) {
  const auto form = [](const BoxRatios& ratios) {
    return "il" + with_digits(ratios.i_l, 4) + "_sl" + with_digits(ratios.s_l, 4);
  };
  return std::visit(
      Overloaded{[&](const StretchTo& v) { return form(v.ratios); },
                 [](const ConvexityOf& v) { return "convexity" + with_digits(v.convexity, 4); },
                 [](const RoundingOf& v) { return "radius" + with_digits(v.radius_share, 4); },
                 [](const RoundnessOf& v) { return "roundness" + with_digits(v.roundness, 4); },
                 [](const VertexCount& v) { return "vertices" + std::to_string(v.vertices); },
                 [](const DetailTimes& v) { return "detail" + with_digits(v.gain, 4); },
                 [](const ReferenceTo& v) { return name_of(v.form); },
                 [](const InertiaTwin& v) { return "inertia-" + name_of(v.form); },
                 [&](const DrawnForm& v) { return form(v.ratios); }},
      variation);
}

KeptSize kept_size(const std::string& name) {
  if (name == "mass") return KeptSize::kMass;
  if (name == "volume") return KeptSize::kVolume;
  if (name == "L") return KeptSize::kLength;
  throw InputError("`keep` = \"" + name + "\": must be mass, volume or L");
}

std::string name_of(KeptSize kept) {
  switch (kept) {
    case KeptSize::kMass:
      return "mass";
    case KeptSize::kVolume:
      return "volume";
    case KeptSize::kLength:
      break;
  }
  return "L";
}

void VariationOptions::check() const {
  if (!(accuracy >= 1e-6 && accuracy <= 1e-2)) {
    throw InputError("accuracy is " + with_digits(accuracy, 4) +
                     "; it must be between 1e-6 and 1e-2");
  }
}

Block vary_block(const std::string& id, const Block& parent, const Variation& variation,
                 BlockSource source, const VariationOptions& options) {
  return in_context("block " + parent.id, [&] {
    return varied_block(id, parent, variation, std::move(source), options);
  });
}

std::optional<VariationRecord> read_variation(const Block& block) {
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
  record.step = number_in(values["step"]).value_or(0.0);
  const std::optional<double> i_l = number_in(values["i_l"]), s_l = number_in(values["s_l"]);
  if (i_l && s_l) record.form = BoxRatios{*i_l, *s_l};
  return record;
}

std::string in_words(const VariationRecord& record) {
  if (!record.reference.empty()) return record.reference;
  if (record.form) {
    return record.kind + " to " + with_digits(record.form->i_l, 4) + ", " +
           with_digits(record.form->s_l, 4);
  }
  return record.kind + " " + with_digits(record.step, 4);
}

}  // namespace clast
