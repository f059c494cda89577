#include "core/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace clast {
namespace {

struct Lens {
  double focal = 0.1;
  std::vector<std::string> names = {};
};
template <class Visit>
void visit_fields(const Lens& lens, Visit&& visit) {
  const auto& [focal, names] = lens;
  visit("focal", focal), visit("names", names);
}

struct Camera {
  Lens lens = {};
  std::optional<int> shots = {};
  bool is_old = false;
  unsigned threads = 0;
  std::array<Vec3, 2> ends = {Vec3::Zero(), Vec3::Ones()};
};
template <class Visit>
void visit_fields(const Camera& camera, Visit&& visit) {
  const auto& [lens, shots, is_old, threads, ends] = camera;
  visit("lens", lens), visit("shots", shots), visit("is_old", is_old);
  visit("threads", ExcludedField{threads}), visit("ends", ends);
}

TEST(Fields, AreWrittenByNameWithTheStructsInside) {
  EXPECT_EQ(format_field(Camera{}),
            "{lens={focal=0.10000000000000001, names=[]}, shots=none, is_old=0, ends=[0 0 0, 1 1 "
            "1]}");
}

TEST(Fields, TextChangesWithEveryFieldThatHasAnInfluence) {
  const std::string before = format_field(Camera{});
  EXPECT_NE(format_field(Camera{.lens = {.focal = std::nextafter(0.1, 1.0)}}), before);
  EXPECT_NE(format_field(Camera{.lens = {.names = {"a"}}}), before);
  EXPECT_NE(format_field(Camera{.lens = {.names = {"a", "b"}}}),
            format_field(Camera{.lens = {.names = {"a, b"}}}));
  EXPECT_NE(format_field(Camera{.lens = {.names = {"a", "b"}}}),
            format_field(Camera{.lens = {.names = {"a\", \"b"}}}));
  EXPECT_NE(format_field(Camera{.shots = 0}), before);
  EXPECT_NE(format_field(Camera{.is_old = true}), before);
  EXPECT_NE(format_field(Camera{.ends = {Vec3::Zero(), Vec3::Zero()}}), before);
  EXPECT_EQ(format_field(Camera{.threads = 4}), before);
}

}  // namespace
}  // namespace clast
