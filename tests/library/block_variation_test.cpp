// Twins of a block, and series of them.
#include "library/block_variation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "classify/form_grid.hpp"
#include "classify/surface_indices.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/block_measures.hpp"
#include "library/block_series.hpp"
#include "library/make_block.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

const BlockSource kSource = {"blocks.h5", std::string(64, 'b'), "", ""};

Block rock(const std::string& id = "R 1%") {
  const SpheroPolyhedron body =
      make_sphero_polyhedron(rock_mesh(3, Vec3(1.0, 0.7, 0.5), 3, 0.3), 0.02);
  BlockOptions options;
  options.density = 2600.0;
  return make_block(id, body, {"rock.ply", std::string(64, 'a'), "", ""}, options);
}

Block ball_block() {
  SpheroPolyhedron body;
  body.vertices = {Vec3::Zero()};
  body.radius = 0.5;
  return make_block("ball", body, kSource, {});
}

Block varied(const Variation& variation, PreservedSize keep = PreservedSize::kMass) {
  return vary_block("V", rock(), variation, kSource, {.preserved_size = keep});
}

double convexity_of(const Block& block) { return convexity(block.body, block.mass.volume); }

void expect_near(double value, double target) {
  EXPECT_NEAR(value, target, kVariationTolerance * target);
}

TEST(BlockVariation, StretchesReachFormVolumeAndClass) {
  const Block parent = rock();
  for (const Axes& axes : sneed_folk_grid(4, 0.25)) {
    const Block twin = varied(StretchVariation{{axes.I / axes.L, axes.S / axes.L}});
    expect_near(twin.axes().I / twin.axes().L, axes.I);
    expect_near(twin.axes().S / twin.axes().L, axes.S);
    EXPECT_NEAR(twin.mass.volume / parent.mass.volume, 1.0, 5e-4);
    EXPECT_NEAR(twin.mass.mass / parent.mass.mass, 1.0, 5e-4);
    EXPECT_EQ(garcia_class(twin.axes()), garcia_class(axes));
    EXPECT_NEAR(convexity_of(twin), convexity_of(parent), 0.01) << "detail is kept";
  }
}

TEST(BlockVariation, AreTheBlockItselfAtItsOwnFigures) {
  const Block parent = rock();
  const double share = parent.body.radius / parent.axes().S;
  for (const Variation& own :
       {Variation{StretchVariation{box_ratios(parent.box)}},
        Variation{ConvexityVariation{convexity_of(parent)}}, Variation{RoundingVariation{share}},
        Variation{VertexCountVariation{parent.body.vertices.size()}},
        Variation{DetailVariation{.gain = 1.0, .degree = 4}}}) {
    const Block twin = varied(own);
    EXPECT_EQ(twin.body.vertices, parent.body.vertices) << name_of_variation(own);
    EXPECT_EQ(twin.body.radius, parent.body.radius) << name_of_variation(own);
    EXPECT_EQ(twin.mass.mass, parent.mass.mass) << name_of_variation(own);
    EXPECT_EQ(twin.mass.inertia, parent.mass.inertia) << name_of_variation(own);
  }
}

TEST(BlockVariation, FillHollowsToAConvexityAndKeepTheForm) {
  const Block parent = rock();
  ASSERT_LT(convexity_of(parent), 0.95);
  for (const double target : {0.95, 0.98, 0.995, 1.0}) {
    const Block twin = varied(ConvexityVariation{target});
    expect_near(convexity_of(twin), target);
    EXPECT_LT(max_ratio_difference(box_ratios(twin.box), box_ratios(parent.box)), 1e-6);
    EXPECT_NEAR(twin.mass.volume / parent.mass.volume, 1.0, 5e-4);
  }
  const std::string said = refusal<GeometryError>([] { varied(ConvexityVariation{0.5}); });
  EXPECT_TRUE(contains(said, "block R 1%: a convexity of 0.5 can't be reached")) << said;
  EXPECT_TRUE(contains(said, "from its own 0.8")) << said;
}

TEST(BlockVariation, RoundEdgesAtConstantVolumeAndForm) {
  const Block parent = rock();
  for (const double share : {0.02, 0.1, 0.2, 0.3}) {
    const Block twin = varied(RoundingVariation{share});
    expect_near(twin.body.radius / twin.axes().S, share);
    EXPECT_LT(max_ratio_difference(box_ratios(twin.box), box_ratios(parent.box)),
              kVariationTolerance);
    EXPECT_NEAR(twin.mass.volume / parent.mass.volume, 1.0, 5e-4);
  }
  EXPECT_EQ(varied(RoundingVariation{0.0}).body.radius, 0.0);
  EXPECT_TRUE(contains(refusal([] { varied(RoundingVariation{0.5}); }), "from 0 to 0.4"));
}

// A ball of any radius is one: facets of its skin are smaller than the mesh it is measured on.
TEST(BlockVariation, ASphereHasTheRoundnessOne) {
  const Block ball = varied(ReferenceVariation{ReferenceShape::kSphere});
  EXPECT_GT(block_roundness(ball, 0.1 * ball.axes().L).value, 0.93);
}

// As Wadell measures it, on one length of edges: of a convex block, and of one with hollows.
TEST(BlockVariation, AreRounderTheLargerTheRadiusIs) {
  const Block convex = varied(ConvexityVariation{1.0});
  for (const Block& parent : {convex, rock()}) {
    double before = 0.0;
    for (const double share : {0.15, 0.2, 0.3}) {
      const Block twin = vary_block("V", parent, RoundingVariation{share}, kSource);
      const double wadell = block_roundness(twin, 0.06 * twin.axes().L).value;
      EXPECT_GT(wadell, before) << share;
      before = wadell;
    }
  }
}

// At constant volume and form, measured on edges of the length that is stated.
TEST(BlockVariation, ReachARoundnessOrSayTheNearest) {
  const Block convex = varied(ConvexityVariation{1.0});
  const double edge = 0.1 * std::cbrt(6.0 * convex.mass.volume / kPi);
  for (const double target : {0.62, 0.65}) {
    const Block twin = vary_block("V", convex, RoundnessVariation{target, 0.1}, kSource);
    const double stated = *parse_number(format_significant(edge, 4));
    EXPECT_TRUE(
        contains(twin.source.options, "edge_m=" + format_significant(edge, 4) + " roundness=0."));
    EXPECT_NEAR(block_roundness(twin, stated).value / target, 1.0, kRoundnessTolerance);
    EXPECT_LT(max_ratio_difference(box_ratios(twin.box), box_ratios(convex.box)),
              kVariationTolerance);
    EXPECT_NEAR(twin.mass.volume / convex.mass.volume, 1.0, 5e-4);
    EXPECT_EQ(parse_variation(twin)->target_value, target);
  }
  const auto said = [&](double target) {
    return refusal<GeometryError>([&] {
      vary_block("V", convex, RoundnessVariation{target, 0.1}, kSource);
    });
  };
  EXPECT_TRUE(
      contains(said(0.99), "a roundness of 0.99 can't be reached: the largest radius, 0.4"));
  EXPECT_TRUE(contains(said(0.1), "a roundness of 0.1 can't be reached: with sharp edges it is"));
}

TEST(BlockVariation, SimplifyToAsManyVerticesAsAreAskedFor) {
  const Block parent = rock();
  for (const std::size_t count : {8u, 30u}) {
    const Block twin = varied(VertexCountVariation{count});
    EXPECT_EQ(twin.body.vertices.size(), count);
    EXPECT_LT(max_ratio_difference(box_ratios(twin.box), box_ratios(parent.box)),
              kVariationTolerance);
    EXPECT_NEAR(twin.mass.volume / parent.mass.volume, 1.0, 5e-4);
  }
  EXPECT_TRUE(contains(refusal([] { varied(VertexCountVariation{2000}); }),
                       "8 to the 92 of the block can"));
}

TEST(BlockVariation, ReferencesHaveMassAndFormOfTheBlock) {
  const Block parent = rock();
  for (const ReferenceShape form : {ReferenceShape::kBox, ReferenceShape::kEllipsoid}) {
    const Block twin = varied(ReferenceVariation{form});
    EXPECT_LT(max_ratio_difference(box_ratios(twin.box), box_ratios(parent.box)),
              kVariationTolerance);
    EXPECT_NEAR(twin.mass.mass / parent.mass.mass, 1.0, 5e-4);
    EXPECT_NEAR(convexity_of(twin), 1.0, 1e-9);
  }
  const Block ball = varied(ReferenceVariation{ReferenceShape::kSphere});
  EXPECT_NEAR(4.0 / 3.0 * kPi * std::pow(ball.body.radius, 3.0), parent.mass.volume, 1e-9);
  const Block long_box = varied(ReferenceVariation{ReferenceShape::kBox}, PreservedSize::kLength);
  EXPECT_NEAR(long_box.axes().L, parent.axes().L, 1e-9);
}

TEST(BlockVariation, TwinsOfEqualInertiaHaveMassAndPrincipalMoments) {
  const Block parent = rock();
  for (const ReferenceShape form : {ReferenceShape::kEllipsoid, ReferenceShape::kBox}) {
    const Block twin = varied(InertiaVariation{form});
    EXPECT_NEAR(twin.mass.mass / parent.mass.mass, 1.0, 1e-9);
    EXPECT_NEAR(twin.density * twin.mass.volume, parent.mass.mass, 1e-6);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(twin.principal.moments[k] / parent.principal.moments[k], 1.0, 1e-6);
    }
  }
}

TEST(BlockVariation, SayWhatWasDone) {
  const Block twin = varied(StretchVariation{{0.8, 0.5}});
  EXPECT_EQ(twin.source.file, "blocks.h5");
  EXPECT_EQ(twin.source.sha256, std::string(64, 'b'));
  EXPECT_TRUE(contains(twin.source.options,
                       "vary=stretch parent=R%201%25 parent_sha256=" + std::string(64, 'a') +
                           " keep=mass i_l=0.8 s_l=0.5 stretch="));
  const std::optional<VariationRecord> record = parse_variation(twin);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->kind, "stretch");
  EXPECT_EQ(record->parent, "R 1%");
  EXPECT_EQ(record->target_ratios->i_l, 0.8);
  EXPECT_EQ(parse_variation(varied(ConvexityVariation{0.97}))->target_value, 0.97);
  EXPECT_EQ(parse_variation(varied(ReferenceVariation{ReferenceShape::kEota221}))->reference,
            "eota-221");
  EXPECT_FALSE(parse_variation(rock()));
}

TEST(BlockVariation, BallsAndUnknownNamesAreRefused) {
  const Block ball = ball_block();
  EXPECT_TRUE(contains(
      refusal<GeometryError>([&] { vary_block("V", ball, RoundingVariation{0.1}, kSource); }),
      "block ball: it is a ball or a capsule"));
  EXPECT_TRUE(contains(refusal([] { parse_preserved_size("weight"); }), "\"weight\""));
  EXPECT_TRUE(contains(refusal([] {
                         varied(StretchVariation{{0.8, NAN}});
                       }),
                       "block R 1%: S/L = nan"));
}

TEST(BlockSeries, IsTheSameOnAnyNumberOfThreadsAndOneBadBodyCostsNoOther) {
  const Block parent = rock();
  const Block* const one = &parent;
  const std::vector<Variation> wanted = {StretchVariation{{0.9, 0.6}}, ConvexityVariation{0.2},
                                         VertexCountVariation{20}};
  const auto requests = combine_variations({&one, 1}, wanted);
  ASSERT_EQ(requests.size(), 3u);
  EXPECT_EQ(requests[0].id, "R 1%_il0.9_sl0.6");
  const VariedBlockSeries alone = make_variation_series(requests, kSource, {{}, 1});
  const VariedBlockSeries both = make_variation_series(requests, kSource, {{}, 2});
  ASSERT_EQ(alone.blocks.size(), 2u);
  ASSERT_EQ(alone.failures.size(), 1u);
  EXPECT_TRUE(contains(alone.failures[0], "convexity of 0.2"));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(alone.blocks[i].body.vertices, both.blocks[i].body.vertices);
    EXPECT_EQ(alone.blocks[i].mass.inertia, both.blocks[i].mass.inertia);
  }
}

TEST(BlockSeries, ASubstituteServesWhereTheParentCannotReachTheTarget) {
  const Block first = rock("A"), second = rock("B");
  const Block ball = ball_block();
  const Variation target = RoundingVariation{0.1};
  const std::vector<VariationRequest> requests = {{&ball, target, "V1", {&ball, &second, &first}},
                                                  {&ball, target, "V2", {&ball}}};
  const VariedBlockSeries made = make_variation_series(requests, kSource);
  ASSERT_EQ(made.blocks.size(), 1u);
  EXPECT_EQ(made.blocks[0].id, "V1");
  EXPECT_EQ(parse_variation(made.blocks[0]).value().parent, "B");
  ASSERT_EQ(made.failures.size(), 1u);
  EXPECT_TRUE(contains(made.failures[0], "block ball: it is a ball or a capsule"));
  EXPECT_TRUE(contains(made.failures[0], "nor can it be made from 1 other block"));
}

TEST(BlockSeries, DrawnBodiesHaveTheFiguresThatWereDrawn) {
  const Block parent = rock();
  const Block* const one = &parent;
  std::vector<BlockForm> population;
  for (int i = 0; i < 12; ++i) {
    population.push_back({{1.0 + 0.1 * i, 0.8 + 0.02 * i, 0.4 + 0.01 * i}, std::nullopt});
  }
  const SampledVariationRequests drawn =
      sample_variation_requests({&one, 1}, population, 5, 7, "D");
  const VariedBlockSeries series = make_variation_series(drawn.requests, kSource);
  ASSERT_EQ(series.blocks.size(), 5u) << series.failures.front();
  for (std::size_t i = 0; i < 5; ++i) {
    const auto& wanted = std::get<SampledFormVariation>(drawn.requests[i].variation);
    EXPECT_EQ(series.blocks[i].id, "D000" + std::to_string(i + 1));
    expect_near(series.blocks[i].axes().L, wanted.length);
    expect_near(series.blocks[i].axes().S / series.blocks[i].axes().L, wanted.ratios.s_l);
  }
  const SampledVariationRequests again =
      sample_variation_requests({&one, 1}, population, 5, 7, "D");
  EXPECT_EQ(std::get<SampledFormVariation>(again.requests[4].variation).length,
            std::get<SampledFormVariation>(drawn.requests[4].variation).length);
  EXPECT_TRUE(contains(refusal([&] {
                         sample_variation_requests({&one, 1}, {population.data(), 3}, 5, 7, "D");
                       }),
                       "but there are 3"));
}

}  // namespace
}  // namespace clast
