#include "library/rock_mass_blocks.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {
namespace {

/// Thin pieces get a smaller radius, down to this share of what is asked for.
constexpr double kMinFraction = 0.125;

std::string options_text(const RockMassOptions& options) {
  std::string text = "joints=";
  for (const JointSet& set : options.joints) {
    if (text.back() != '=') text += ",";
    text += format_significant(set.dip * kDegreesPerRadian, 6) + "/" +
            format_significant(set.dip_direction * kDegreesPerRadian, 6) + "/" +
            format_significant(set.spacing, 6) + "/" + format_significant(set.spacing_deviation, 6);
  }
  return text + " least_volume_m3=" + format_significant(options.cutting.min_volume, 6) +
         " seed=" + std::to_string(options.cutting.seed);
}

std::string id_of(const std::string& prefix, std::size_t number, std::size_t count) {
  std::string digits = std::to_string(number);
  const std::size_t width = std::max<std::size_t>(4, std::to_string(count).size());
  return prefix + std::string(width - std::min(width, digits.size()), '0') + digits;
}

/// The piece with round edges, none of which comes out of it: neighbours touch and do not overlap.
SpheroPolyhedron rounded_piece(const TriangleMesh& piece, double radius_fraction) {
  const double side = smallest_box(piece.vertices).lengths[2];
  for (double share = radius_fraction; share >= kMinFraction * radius_fraction; share *= 0.5) {
    if (std::optional<SpheroPolyhedron> body = inscribed_rounded_body(piece, share * side))
      return *body;
  }
  throw GeometryError("the piece of S = " + format_significant(side, 3) +
                      " m is too thin to be rounded; give a larger least volume, or a smaller "
                      "`radius_share`");
}

/// Blocks cut from all masses that could be cut.
JointedRockMass cut_masses(std::span<const TriangleMesh> masses, const RockMassOptions& options,
                           std::vector<std::string>& failed) {
  JointedRockMass all;
  std::exception_ptr first;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    try {
      JointedRockMass cut = cut_by_joints(masses[i], options.joints, options.cutting);
      all.volume += cut.volume;
      for (TriangleMesh& block : cut.blocks) all.blocks.push_back(std::move(block));
    } catch (const Error& error) {
      if (!first) first = std::current_exception();
      failed.push_back("mass " + std::to_string(i + 1) + ": " + error.what());
      all.volume += std::max(0.0, signed_volume(masses[i]));
    }
  }
  if (all.blocks.empty() && first) std::rethrow_exception(first);
  return all;
}

}  // namespace

RockMassBlocks cut_rock_mass(const TriangleMesh& mass, const BlockSource& source,
                             const RockMassOptions& options) {
  return cut_rock_masses({&mass, 1}, source, options);
}

RockMassBlocks cut_rock_masses(std::span<const TriangleMesh> masses, const BlockSource& source,
                               const RockMassOptions& options) {
  RockMassBlocks result;
  const JointedRockMass cut = cut_masses(masses, options, result.failures);
  BlockSource of_block = source;
  of_block.options += (of_block.options.empty() ? "" : " ") + options_text(options);
  std::vector<std::optional<Block>> made(cut.blocks.size());
  std::vector<std::string> reasons(cut.blocks.size());
  std::size_t done = 0;
  std::mutex one_at_a_time;
  parallel_for(cut.blocks.size(), options.threads, [&](std::size_t i) {
    const std::string id = id_of(options.prefix, i + 1, cut.blocks.size());
    try {
      made[i] = make_block(id, rounded_piece(cut.blocks[i], options.block.radius_fraction),
                           of_block, options.block);
    } catch (const GeometryError& error) {
      const std::string reason = error.what();
      reasons[i] = reason.find(id) == std::string::npos ? "block " + id + ": " + reason : reason;
    }
    const std::lock_guard lock(one_at_a_time);
    ++done;
    if (options.progress) options.progress({.done = done, .total = cut.blocks.size()});
  });
  result.volume = cut.volume;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (!made[i]) {
      result.failures.push_back(reasons[i]);
      continue;
    }
    result.block_volume += made[i]->mass.volume;
    result.blocks.push_back(*std::move(made[i]));
  }
  return result;
}

}  // namespace clast
