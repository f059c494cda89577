#include "dem/contact/contact_law.hpp"

#include <optional>

#include "core/error.hpp"

namespace clast {

namespace {

/// Calls `visit` with a default-constructed law of each type.
template <std::size_t Index = 0, class Visit>
void for_each_law(const Visit& visit) {
  if constexpr (Index < std::variant_size_v<ContactLaw>) {
    visit(std::variant_alternative_t<Index, ContactLaw>());
    for_each_law<Index + 1>(visit);
  }
}

}  // namespace

ContactLaw parse_contact_law(const std::string& name) {
  std::optional<ContactLaw> found;
  std::string known;
  for_each_law([&](const auto& law) {
    if (name == law.kName) found = law;
    known += (known.empty() ? "" : " or ") + std::string(law.kName);
  });
  if (!found) throw InputError("contact law \"" + name + "\" is unknown; use " + known);
  return *found;
}

std::string name_of(const ContactLaw& law) {
  return std::visit([](const auto& one) { return std::string(one.kName); }, law);
}

std::vector<std::string> contact_law_names() {
  std::vector<std::string> names;
  for_each_law([&](const auto& law) { names.emplace_back(law.kName); });
  return names;
}

ContactWeighting parse_contact_weighting(const std::string& name) {
  if (name == "patch") return ContactWeighting::kPatch;
  if (name == "overlap") return ContactWeighting::kOverlap;
  if (name == "count") return ContactWeighting::kCount;
  if (name == "none") return ContactWeighting::kNone;
  throw InputError("contact weights \"" + name +
                   "\" are unknown; use patch, overlap, count or none");
}

std::string name_of(ContactWeighting weighting) {
  switch (weighting) {
    case ContactWeighting::kPatch:
      return "patch";
    case ContactWeighting::kOverlap:
      return "overlap";
    case ContactWeighting::kCount:
      return "count";
    case ContactWeighting::kNone:
      return "none";
  }
  return "patch";
}

}  // namespace clast
