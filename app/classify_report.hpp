#pragma once
/// What is printed of classified blocks and of the population they are.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "classify/population.hpp"

namespace clast {

/// A block to be classified.
struct ClassifiedBlock {
  std::string name;
  Axes axes;
  std::optional<double> mass;   ///< kg
  double axis_error = 0.0;      ///< m
  nlohmann::ordered_json more;  ///< of a library's block: surface indices, equilibria
};

/// Blocks, and how to look at them.
struct Classification {
  std::vector<ClassifiedBlock> blocks;
  std::vector<std::string> notes;    ///< rows skipped, axes sorted
  std::size_t skipped = 0;           ///< rows
  std::string box = "as measured";   ///< convention of the axes
  std::vector<std::string> schemes;  ///< as listed in the tables
  SchemeOptions options;

  std::vector<Axes> axes() const;
  /// Of every block, or none when one has no mass.
  std::vector<double> masses() const;
};

std::string classification_text(const Classification& all);
nlohmann::ordered_json classification_json(const Classification& all);

/// Sentences: how two populations differ. The first scheme's classes are compared.
std::vector<std::string> comparison_lines(const Classification& a, const Classification& b);
nlohmann::ordered_json comparison_json(const Classification& a, const Classification& b);

}  // namespace clast
