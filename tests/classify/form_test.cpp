#include "classify/form.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_EQ(elongation_s_c(axes), 1.0);
  EXPECT_NEAR(*disc_rod_index(axes), 2.0 / 3.0, 1e-16);
  EXPECT_NEAR(maximum_projection_sphericity(axes), 0.5, 1e-16);
  EXPECT_NEAR(intercept_sphericity(axes), 0.5, 1e-16);
  EXPECT_NEAR(corey_shape_factor(axes), 1.0 / std::sqrt(8.0), 1e-16);
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
  EXPECT_EQ(metres.size(), 9u);
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
