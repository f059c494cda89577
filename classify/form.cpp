#include "classify/form.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

Axes Axes::sorted(double a, double b, double c) {
  std::array<double, 3> values = {a, b, c};
  for (const double value : values) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw InputError("axes " + format_significant(a, 6) + ", " + format_significant(b, 6) + ", " +
                     format_significant(c, 6) + " m: each must be a positive, finite length");
  }
  std::sort(values.begin(), values.end());
  return {values[2], values[1], values[0]};
}

double elongation_index(const Axes& axes) { return axes.L / axes.I - 1.0; }

std::optional<double> disc_rod_index(const Axes& axes) {
  if (!(axes.L > axes.S)) return std::nullopt;
  return (axes.L - axes.I) / (axes.L - axes.S);
}

double maximum_projection_sphericity(const Axes& axes) {
  return std::cbrt(axes.S * axes.S / (axes.L * axes.I));
}

double intercept_sphericity(const Axes& axes) {
  return std::cbrt(axes.I * axes.S / (axes.L * axes.L));
}

double corey_shape_factor(const Axes& axes) { return axes.S / std::sqrt(axes.L * axes.I); }

double williams_shape_index(const Axes& axes) {
  const double ratio = axes.I * axes.I / (axes.L * axes.S);
  return ratio >= 1.0 ? 1.0 - 1.0 / ratio : ratio - 1.0;
}

double aschenbrenner_working_sphericity(const Axes& axes) {
  const double p = axes.S / axes.I, q = axes.I / axes.L;
  return 12.8 * std::cbrt(p * p * q) /
         (1.0 + p * (1.0 + q) + 6.0 * std::sqrt(1.0 + p * p * (1.0 + q * q)));
}

std::optional<double> oblate_prolate_index(const Axes& axes) {
  const auto index = disc_rod_index(axes);
  if (!index) return std::nullopt;
  return 10.0 * (*index - 0.5) * axes.L / axes.S;
}

TernaryCoordinates ternary_coordinates(const Axes& axes) {
  // (1 - q) d without the division by L - S, which L = S does not allow.
  return {axes.S / axes.L, (axes.L - axes.I) / axes.L, (axes.I - axes.S) / axes.L};
}

std::span<const FormIndex> form_index_definitions() {
  using A = Axes;
  using Value = std::optional<double>;
  static constexpr std::array kList = {
      FormIndex{"L/I", "L/I", "", [](const A& a) -> Value { return a.L / a.I; }},
      FormIndex{"I/L", "I/L", "zingg1935", [](const A& a) -> Value { return a.I / a.L; }},
      FormIndex{"S/I", "S/I", "zingg1935", [](const A& a) -> Value { return a.S / a.I; }},
      FormIndex{"S/L", "S/L", "sneed1958", [](const A& a) -> Value { return a.S / a.L; }},
      FormIndex{"L/S", "L/S", "en933-4", [](const A& a) -> Value { return a.L / a.S; }},
      FormIndex{"s_c", "L/I - 1", "garcia2022",
                [](const A& a) -> Value { return elongation_index(a); }},
      FormIndex{"disc_rod_index", "(L - I)/(L - S)", "sneed1958", disc_rod_index},
      FormIndex{"ternary_compact", "S/L", "graham2000",
                [](const A& a) -> Value { return ternary_coordinates(a).compact; }},
      FormIndex{"ternary_elongate", "(1 - S/L) (L - I)/(L - S) = (L - I)/L", "graham2000",
                [](const A& a) -> Value { return ternary_coordinates(a).elongate; }},
      FormIndex{"ternary_platy", "(1 - S/L) (I - S)/(L - S) = (I - S)/L", "graham2000",
                [](const A& a) -> Value { return ternary_coordinates(a).platy; }},
      FormIndex{"maximum_projection_sphericity", "(S^2/(L I))^(1/3)", "sneed1958",
                [](const A& a) -> Value { return maximum_projection_sphericity(a); }},
      FormIndex{"intercept_sphericity", "(I S/L^2)^(1/3)", "krumbein1941",
                [](const A& a) -> Value { return intercept_sphericity(a); }},
      FormIndex{"corey_shape_factor", "S/(L I)^(1/2)", "corey1949",
                [](const A& a) -> Value { return corey_shape_factor(a); }},
      FormIndex{"janke_form_factor", "S (3/(L^2 + I^2 + S^2))^(1/2)", "janke1966",
                [](const A& a) -> Value {
                  return a.S * std::sqrt(3.0 / (a.L * a.L + a.I * a.I + a.S * a.S));
                }},
      FormIndex{"aschenbrenner_shape_factor", "L S/I^2", "aschenbrenner1956",
                [](const A& a) -> Value { return a.L * a.S / (a.I * a.I); }},
      FormIndex{"aschenbrenner_working_sphericity",
                "12.8 (p^2 q)^(1/3)/(1 + p (1 + q) + 6 (1 + p^2 (1 + q^2))^(1/2)), p = S/I, "
                "q = I/L",
                "aschenbrenner1956",
                [](const A& a) -> Value { return aschenbrenner_working_sphericity(a); }},
      FormIndex{"oblate_prolate_index", "10 ((L - I)/(L - S) - 1/2)/(S/L)", "dobkins1970",
                oblate_prolate_index},
      FormIndex{"williams_w", "1 - L S/I^2 if I^2 >= L S, else I^2/(L S) - 1", "williams1965",
                [](const A& a) -> Value { return williams_shape_index(a); }},
      FormIndex{"cailleux_flatness", "(L + I)/(2 S)", "cailleux1945",
                [](const A& a) -> Value { return (a.L + a.I) / (2.0 * a.S); }},
      FormIndex{"kong_fonseca_elongation", "(L - I)/L", "kong2018",
                [](const A& a) -> Value { return (a.L - a.I) / a.L; }},
      FormIndex{"kong_fonseca_flatness", "(I - S)/I", "kong2018",
                [](const A& a) -> Value { return (a.I - a.S) / a.I; }},
      FormIndex{"potticary_elongation", "(L - I)/(L + I + S)", "potticary2015",
                [](const A& a) -> Value { return (a.L - a.I) / (a.L + a.I + a.S); }},
      FormIndex{"potticary_flatness", "2 (I - S)/(L + I + S)", "potticary2015",
                [](const A& a) -> Value { return 2.0 * (a.I - a.S) / (a.L + a.I + a.S); }},
      FormIndex{"angelidakis_elongation", "L S/(L S + I^2) - S/(L + S)", "angelidakis2022",
                [](const A& a) -> Value {
                  return a.L * a.S / (a.L * a.S + a.I * a.I) - a.S / (a.L + a.S);
                }},
      FormIndex{"angelidakis_flatness", "I^2/(L S + I^2) - S/(L + S)", "angelidakis2022",
                [](const A& a) -> Value {
                  return a.I * a.I / (a.L * a.S + a.I * a.I) - a.S / (a.L + a.S);
                }},
      FormIndex{"angelidakis_compactness", "2 S/(L + S)", "angelidakis2022",
                [](const A& a) -> Value { return 2.0 * a.S / (a.L + a.S); }},
  };
  return kList;
}

std::map<std::string, double> form_indices(const Axes& axes) {
  std::map<std::string, double> indices;
  for (const FormIndex& index : form_index_definitions()) {
    if (const auto value = index.value(axes)) indices[index.name] = *value;
  }
  return indices;
}

}  // namespace clast
