#include "classify/form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/error.hpp"

namespace clast {
namespace {

// Two stones of a public laboratory sheet (mm), to the digits it can be checked to by hand.
TEST(Form, IndicesOfTwoMeasuredStones) {
  const Axes round{56.0, 49.5, 39.0};
  EXPECT_NEAR(maximum_projection_sphericity(round), 0.819, 5e-4);
  EXPECT_NEAR(corey_shape_factor(round), 0.741, 5e-4);
  const Axes flat{46.0, 36.0, 13.0};
  EXPECT_NEAR(maximum_projection_sphericity(flat), 0.467, 5e-4);
  EXPECT_NEAR(corey_shape_factor(flat), 0.319, 5e-4);
}

TEST(Form, IndicesOfACuboidByHand) {
  const Axes axes{4.0, 2.0, 1.0};
  EXPECT_EQ(elongation_index(axes), 1.0);
  EXPECT_NEAR(*disc_rod_index(axes), 2.0 / 3.0, 1e-16);
  EXPECT_NEAR(maximum_projection_sphericity(axes), 0.5, 1e-16);
  EXPECT_NEAR(intercept_sphericity(axes), 0.5, 1e-16);
  EXPECT_NEAR(corey_shape_factor(axes), 1.0 / std::sqrt(8.0), 1e-16);
}

TEST(Form, EveryIndexOfACuboidByHand) {
  // L, I, S = 4, 2, 1: q = 1/4, d = 2/3, L S = I^2.
  const std::map<std::string, double> expected = {
      {"L/I", 2.0},
      {"I/L", 0.5},
      {"S/I", 0.5},
      {"S/L", 0.25},
      {"L/S", 4.0},
      {"s_c", 1.0},
      {"disc_rod_index", 2.0 / 3.0},
      {"ternary_compact", 0.25},
      {"ternary_elongate", 0.75 * 2.0 / 3.0},
      {"ternary_platy", 0.75 / 3.0},
      {"maximum_projection_sphericity", 0.5},
      {"intercept_sphericity", 0.5},
      {"corey_shape_factor", 1.0 / std::sqrt(8.0)},
      {"janke_form_factor", std::sqrt(3.0 / 21.0)},
      {"aschenbrenner_shape_factor", 1.0},
      {"aschenbrenner_working_sphericity",
       12.8 * 0.5 / (1.0 + 0.5 * 1.5 + 6.0 * std::sqrt(1.0 + 0.25 * 1.25))},
      {"oblate_prolate_index", 10.0 * (2.0 / 3.0 - 0.5) / 0.25},
      {"williams_w", 0.0},
      {"cailleux_flatness", 3.0},
      {"kong_fonseca_elongation", 0.5},
      {"kong_fonseca_flatness", 0.5},
      {"potticary_elongation", 2.0 / 7.0},
      {"potticary_flatness", 2.0 / 7.0},
      {"angelidakis_elongation", 0.5 - 0.2},
      {"angelidakis_flatness", 0.5 - 0.2},
      {"angelidakis_compactness", 0.4},
  };
  const auto indices = form_indices({4.0, 2.0, 1.0});
  EXPECT_EQ(indices.size(), expected.size());
  for (const auto& [name, value] : expected) EXPECT_NEAR(indices.at(name), value, 1e-15) << name;
}

// Measured on a cube, every sphericity is 1, but for Aschenbrenner's, whose body of reference has
// 14 faces; every elongation and flatness is 0.
TEST(Form, IndicesOfACube) {
  const auto indices = form_indices({2.0, 2.0, 2.0});
  for (const char* name : {"maximum_projection_sphericity", "intercept_sphericity",
                           "corey_shape_factor", "janke_form_factor", "aschenbrenner_shape_factor",
                           "cailleux_flatness", "angelidakis_compactness", "ternary_compact"}) {
    EXPECT_NEAR(indices.at(name), 1.0, 1e-15) << name;
  }
  for (const char* name :
       {"kong_fonseca_elongation", "kong_fonseca_flatness", "potticary_elongation",
        "potticary_flatness", "angelidakis_elongation", "angelidakis_flatness", "williams_w",
        "ternary_platy", "ternary_elongate"}) {
    EXPECT_NEAR(indices.at(name), 0.0, 1e-15) << name;
  }
  EXPECT_NEAR(indices.at("aschenbrenner_working_sphericity"), 12.8 / (3.0 + 6.0 * std::sqrt(3.0)),
              1e-15);
  EXPECT_EQ(indices.count("oblate_prolate_index"), 0u);
}

TEST(Form, LimitsOfDiscsAndRods) {
  const Axes disc{1.0, 1.0, 1e-9}, rod{1.0, 1e-9, 1e-9};
  EXPECT_NEAR(williams_shape_index(disc), 1.0, 1e-8);
  EXPECT_NEAR(williams_shape_index(rod), -1.0, 1e-8);
  EXPECT_LT(*oblate_prolate_index(disc), 0.0);
  EXPECT_GT(*oblate_prolate_index(rod), 0.0);
  EXPECT_NEAR(ternary_coordinates(disc).platy, 1.0, 1e-8);
  EXPECT_NEAR(ternary_coordinates(rod).elongate, 1.0, 1e-8);
}

TEST(Form, PartsOfAWholeAddUpToOne) {
  for (double I = 0.1; I <= 1.0; I += 0.1) {
    for (double S = 0.05; S <= I; S += 0.1) {
      const Axes axes{1.0, I, S};
      const TernaryCoordinates place = ternary_coordinates(axes);
      EXPECT_NEAR(place.compact + place.elongate + place.platy, 1.0, 1e-15);
      EXPECT_NEAR(place.elongate, (1.0 - S) * *disc_rod_index(axes), 1e-15);
      const auto indices = form_indices(axes);
      EXPECT_NEAR(indices.at("angelidakis_elongation") + indices.at("angelidakis_flatness") +
                      indices.at("angelidakis_compactness"),
                  1.0, 1e-15);
    }
  }
}

// "Compactness" alone means at least four things.
TEST(Form, NamesAreSingleAndNeverTheBareWordCompactness) {
  std::set<std::string> names;
  for (const FormIndex& index : form_index_definitions()) {
    EXPECT_TRUE(names.insert(index.name).second) << index.name;
    EXPECT_STRNE(index.name, "compactness");
    EXPECT_FALSE(std::string(index.formula).empty()) << index.name;
  }
}

TEST(Form, EqualAxesHaveNoDiscRodIndex) {
  const Axes cube{2.0, 2.0, 2.0};
  EXPECT_FALSE(disc_rod_index(cube).has_value());
  const auto indices = form_indices(cube);
  EXPECT_EQ(indices.count("disc_rod_index"), 0u);
  for (const char* name : {"maximum_projection_sphericity", "intercept_sphericity",
                           "corey_shape_factor", "L/I", "I/L", "S/I", "S/L"}) {
    EXPECT_NEAR(indices.at(name), 1.0, 1e-15) << name;
  }
  EXPECT_EQ(indices.at("s_c"), 0.0);
}

TEST(Form, IndicesDoNotDependOnTheUnit) {
  const auto metres = form_indices({1.3, 0.9, 0.4});
  const auto millimetres = form_indices({1300.0, 900.0, 400.0});
  EXPECT_EQ(metres.size(), form_index_definitions().size());
  for (const auto& [name, value] : metres) {
    EXPECT_NEAR(value, millimetres.at(name), 1e-14) << name;
  }
}

TEST(Axes, AnyOrderIsSorted) {
  for (const auto& [a, b, c] : {std::tuple{3.0, 2.0, 1.0}, {1.0, 2.0, 3.0}, {2.0, 3.0, 1.0}}) {
    const Axes axes = Axes::sorted(a, b, c);
    EXPECT_EQ(axes.L, 3.0);
    EXPECT_EQ(axes.I, 2.0);
    EXPECT_EQ(axes.S, 1.0);
  }
}

TEST(Axes, WhatIsNoLengthIsRefused) {
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(Axes::sorted(1.0, bad, 1.0), InputError);
  }
}

}  // namespace
}  // namespace clast
