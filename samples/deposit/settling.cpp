#include "samples/deposit/settling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "core/statistics/statistics.hpp"
#include "dem/contact/stiffness.hpp"
#include "dem/simulation/world.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {
namespace {

constexpr double kSlope = 25.0 * kPi / 180.0;
constexpr double kFloorHalf = 60.0;       // m
constexpr double kGravity = 9.81;         // m/s^2
constexpr double kMaxSpeed = 4.0;         // m/s, after a fall of 0.8 m
constexpr double kImpactDepth = 0.03;     // m; small blocks are not pressed through the floor
constexpr double kBetweenBatches = 0.2;   // s
constexpr double kLongestSettling = 8.0;  // s, after the last release
constexpr std::size_t kBlocksPerStraggler = 8;
constexpr double kSlow = 0.15;         // m/s, of a block at rest
constexpr double kAfterRemoval = 8.0;  // s
constexpr double kClearance = 0.01;    // m, between bounding spheres of released blocks

/// Soft soil, on which rolling blocks soon stop, also on a slope.
GroundParameters make_soil(DepositKind kind) {
  return {.energy_restitution = 0.02,
          .friction = 0.9,
          .rolling_friction = kind == DepositKind::kSlope ? 0.6 : 0.3};
}
constexpr GroundParameters kBetweenBlocks{
    .energy_restitution = 0.02, .friction = 0.8, .rolling_friction = 0.1};

/// Bodies whose mass grows with the square of their size and not with its cube: as at rest only
/// their shapes matter, time steps may be longer (density scaling).
std::vector<RigidBody> make_shapes(std::span<const VirtualBlock> blocks) {
  std::vector<RigidBody> shapes;
  for (const VirtualBlock& block : blocks) {
    RigidBody& shape = shapes.emplace_back(block.core);
    const double factor = kSmallestBlock / block.size;
    shape.mass *= factor;
    shape.moments *= factor;
  }
  return shapes;
}

TerrainSurface make_floor(double slope) {
  TriangleMesh mesh;
  for (const double y : {-kFloorHalf, kFloorHalf}) {
    for (const double x : {-kFloorHalf, kFloorHalf}) {
      mesh.vertices.emplace_back(x, y, -std::tan(slope) * x);
    }
  }
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}};
  return TerrainSurface(std::move(mesh), {0, 0});
}

/// Vertical slabs along a circle, which hold a heap together while blocks are released.
class RingWall {
 public:
  explicit RingWall(double radius) : radius_(radius) {
    const Vec3 half = 0.5 * Vec3(kThickness, 2.1 * (radius + kThickness) * std::tan(0.5 * kAngle),
                                 kHeight * radius);
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
      corners.push_back(
          half.cwiseProduct(Vec3(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0)));
    }
    slab_.shape = make_sphero_polyhedron(convex_hull(corners), 0.0);
    slab_.mass = 1.0;  // slabs are fixed
    slab_.moments = Vec3::Ones();
    slab_.smallest_side = kThickness;
  }

  const RigidBody& slab() const { return slab_; }
  std::vector<std::size_t> add_to(World& world, std::size_t shape, std::size_t blocks) const {
    std::vector<std::size_t> slabs;
    for (int i = 0; i < kSlabs; ++i) {
      RigidState state;
      state.orientation = Quat(Eigen::AngleAxisd(i * kAngle, Vec3::UnitZ()));
      state.position = state.orientation * Vec3(radius_ + 0.5 * kThickness, 0.0, 0.0);
      slabs.push_back(world.add_confining_wall(shape, state, kSlabs, kSlabs + blocks));
    }
    return slabs;
  }

  static constexpr int kSlabs = 16;

 private:
  static constexpr double kThickness = 1.0, kHeight = 8.0;  // m; over the radius
  static constexpr double kAngle = 2.0 * kPi / kSlabs;
  double radius_;
  RigidBody slab_;
};

/// Where in plan blocks are released.
class ReleasePlan {
 public:
  ReleasePlan(const DepositRecipe& recipe, std::span<const VirtualBlock> blocks, Random& random)
      : kind_(recipe.kind) {
    double volume = 0.0, plan_area = 0.0, largest_reach = 0.0;
    for (const VirtualBlock& block : blocks) {
      volume += block.core.mass / kRockDensity;
      plan_area += block.size * block.size;
      largest_reach = std::max(largest_reach, block.core.bounding_radius());
    }
    // A heap a third as high as its radius, with 40 % of voids; else blocks on about 70 % of the
    // area.
    radius_ = kind_ == DepositKind::kHeap ? std::cbrt(volume / 0.6 / (0.35 * kPi))
                                          : 0.5 * std::sqrt(2.0 * plan_area);
    radius_ =
        std::max(radius_, 1.1 * largest_reach + kClearance);  // the largest fits into the ring
    for (std::size_t i = 0; i < 1 + blocks.size() / 40; ++i) clusters_.push_back(draw_even(random));
  }

  double radius() const { return radius_; }

  /// @param reach  radius of the released block
  Vec2 draw(double reach, Random& random) const {
    if (kind_ == DepositKind::kHeap) {
      const double angle = random.uniform(0.0, 2.0 * kPi);
      const double largest = std::max(0.0, radius_ - reach - kClearance);
      return largest * std::sqrt(random.uniform()) * Vec2(std::cos(angle), std::sin(angle));
    }
    if (kind_ == DepositKind::kSlope && random.uniform() < 0.5) {
      const Vec2 scatter(random.normal(), random.normal());
      return clusters_[random.uniform_index(clusters_.size())] + 0.12 * radius_ * scatter;
    }
    return draw_even(random);
  }

 private:
  Vec2 draw_even(Random& random) const {
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
    return radius_ * Vec2(x, y);
  }

  DepositKind kind_;
  double radius_ = 0.0;
  std::vector<Vec2> clusters_;
};

/// Lowest position over a place at which the bounding sphere touches neither floor nor any block.
/// @param first  body of the first block
Vec3 position_above(const World& world, std::size_t first, std::size_t released,
                    std::span<const VirtualBlock> blocks, double slope, const Vec2& place,
                    double radius) {
  double height = -std::tan(slope) * place.x() + (radius + kClearance) / std::cos(slope);
  for (std::size_t i = 0; i < released; ++i) {
    const std::size_t body = first + i;
    if (world.is_inactive(body)) continue;
    const Vec3& other = world.state(body).position;
    const double reach = radius + blocks[i].core.bounding_radius() + kClearance;
    const double aside = (other.head<2>() - place).squaredNorm();
    if (aside < reach * reach) {
      height = std::max(height, other.z() + std::sqrt(reach * reach - aside));
    }
  }
  return {place.x(), place.y(), height};
}

WorldSettings make_settings(const std::vector<RigidBody>& shapes, const GroundParameters& soil,
                            unsigned threads) {
  WorldSettings settings;
  settings.law = SpringDashpotLaw();
  settings.between_bodies = kBetweenBlocks;
  settings.threads = threads;
  double heaviest = 0.0;
  for (const RigidBody& shape : shapes) heaviest = std::max(heaviest, shape.mass);
  StiffnessOptions options;
  options.law = settings.law;
  options.multi_block = true;
  options.normal = heaviest * std::pow(kMaxSpeed / kImpactDepth, 2.0);
  settings.stiffness =
      choose_stiffness(shapes, std::span(&soil, 1), kMaxSpeed, kGravity, options).stiffness;
  return settings;
}

/// Blocks that lie farthest from the middle of the deposit in plan, beyond the wanted number.
std::vector<std::size_t> find_stragglers(const World& world, std::size_t wanted) {
  std::vector<double> x, y;
  std::vector<std::size_t> bodies;
  for (std::size_t i = 0; i < world.body_count(); ++i) {
    if (world.is_fixed(i) || world.is_inactive(i)) continue;
    bodies.push_back(i);
    x.push_back(world.state(i).position.x());
    y.push_back(world.state(i).position.y());
  }
  if (bodies.size() <= wanted) return {};
  const Vec2 middle(upper_median(x), upper_median(y));
  std::stable_sort(bodies.begin(), bodies.end(), [&](std::size_t a, std::size_t b) {
    return (world.state(a).position.head<2>() - middle).squaredNorm() <
           (world.state(b).position.head<2>() - middle).squaredNorm();
  });
  return {bodies.begin() + static_cast<std::ptrdiff_t>(wanted), bodies.end()};
}

}  // namespace

std::size_t count_released_blocks(const DepositRecipe& recipe) {
  if (recipe.kind == DepositKind::kNatural) return recipe.blocks;
  return recipe.blocks + 1 + recipe.blocks / kBlocksPerStraggler;
}

double floor_slope(DepositKind kind) { return kind == DepositKind::kSlope ? kSlope : 0.0; }

std::vector<std::optional<Pose>> settle_blocks(const DepositRecipe& recipe,
                                               std::span<const VirtualBlock> blocks,
                                               unsigned threads) {
  Random random(recipe.seed + 1);
  const double slope = floor_slope(recipe.kind);
  const TerrainSurface floor = make_floor(slope);
  const ReleasePlan plan(recipe, blocks, random);
  const RingWall ring(plan.radius());
  std::vector<RigidBody> shapes = make_shapes(blocks);
  const GroundParameters soil = make_soil(recipe.kind);
  const WorldSettings settings = make_settings(shapes, soil, threads);
  shapes.push_back(ring.slab());
  World world(shapes, settings, floor, {soil});
  std::vector<std::size_t> slabs;
  if (recipe.kind == DepositKind::kHeap) slabs = ring.add_to(world, blocks.size(), blocks.size());
  const std::size_t first = slabs.size();
  const std::size_t batch = std::max<std::size_t>(1, blocks.size() / 20);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double reach = blocks[i].core.bounding_radius();
    RigidState state;
    state.orientation = random.rotation();
    const Vec2 place = plan.draw(reach, random);
    state.position = position_above(world, first, i, blocks, slope, place, reach);
    world.add_body(i, state);
    if ((i + 1) % batch == 0) world.run_to_time(world.time() + kBetweenBatches);
  }
  world.run_until_rest(world.time() + kLongestSettling);
  for (const std::size_t slab : slabs) world.remove_body(slab);
  world.run_until_rest(world.time() + kLongestSettling);
  for (const std::size_t straggler : find_stragglers(world, recipe.blocks)) {
    world.remove_body(straggler);
  }
  world.run_until_rest(world.time() + kAfterRemoval);

  std::vector<std::optional<Pose>> poses(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::size_t body = first + i;
    const bool is_slow = world.state(body).velocity.norm() < kSlow;  // it may rock a little
    if (!world.is_inactive(body) && is_slow) poses[i] = world.state(body).world_from_body();
  }
  return poses;
}

}  // namespace clast
