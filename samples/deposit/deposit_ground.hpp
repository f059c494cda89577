#pragma once
/// Ground of virtual deposits: rough floor, fines between blocks, natural relief with soil fillets.
#include <span>
#include <vector>

#include "core/random.hpp"
#include "samples/deposit/deposit_block.hpp"
#include "samples/deposit/height_field.hpp"

namespace clast {

/// Rough height over the plan: plane waves of many lengths, their heights falling with the
/// wavelength to the power 0.8.
class GroundRelief {
 public:
  /// @param height  standard deviation of the longest waves, m
  /// @param longest  longest wavelength, m
  /// @param shortest  shortest wavelength, m
  GroundRelief(double height, double longest, double shortest, Random& random);
  double at(const Vec2& place) const;  ///< m, with mean 0

 private:
  struct Wave {
    Vec2 vector;
    double phase;
    double height;
  };
  std::vector<Wave> waves_;
};

/// Returns the plan of the blocks with a margin.
ScannedPlan find_scanned_plan(std::span<const VirtualBlock> blocks, std::span<const Pose> poses);

/// Makes the ground of a deposit of settled blocks: a floor with relief and gravel, and the fines
/// that fill the deposit to `recipe.fines` of its local height.
TriangleMesh make_floor_ground(const DepositRecipe& recipe, std::span<const VirtualBlock> blocks,
                               std::span<const Pose> poses, unsigned threads);

/// Isolated rocks on natural ground.
struct NaturalScene {
  std::vector<Pose> poses;  ///< world_from_body of each block
  TriangleMesh ground;
};
/// Places rocks, each buried to a drawn depth, on natural ground that has a fillet of soil against
/// them. Every rock rises at least ten spacings above the ground at its centre.
NaturalScene make_natural_scene(const DepositRecipe& recipe, std::span<const VirtualBlock> blocks,
                                unsigned threads);

}  // namespace clast
