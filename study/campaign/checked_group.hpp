#pragma once
/// Reading of datasets of an HDF5 file with checks.
#include <cstddef>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/files/hdf5_file.hpp"
#include "core/types.hpp"

namespace clast::study_detail {

/// HDF5 group of a results file, whose datasets are checked when they are read.
struct CheckedGroup {
  std::string file;
  std::string path;  ///< path in the file, such as "/runs"
  Hdf5Group group;

  [[noreturn]] void throw_damaged(const std::string& name, const std::string& what) const {
    throw InputError(file + ": " + path + "/" + name + " " + what +
                     "; the file is damaged: restore a backup, or run the campaign again");
  }

  /// Reads a dataset and checks that it has `rows` values.
  template <class T>
  std::vector<T> column(const std::string& name, std::size_t rows) const {
    std::vector<T> values = group.read<T>(name);
    if (values.size() != rows) {
      throw_damaged(name, "has " + std::to_string(values.size()) + " values where " +
                              std::to_string(rows) + " belong");
    }
    return values;
  }

  template <class Vector>
  std::vector<Vector> vectors(const std::string& name) const {
    constexpr auto kSize = static_cast<std::size_t>(Vector::SizeAtCompileTime);
    const std::vector<double> flat = group.read<double>(name);
    const std::vector<std::size_t> shape = group.shape(name);
    if (shape.size() != 2 || shape[1] != kSize) {
      throw_damaged(name, "is not a table of " + std::to_string(kSize) + " columns");
    }
    std::vector<Vector> result(shape[0]);
    for (std::size_t i = 0; i < flat.size(); ++i) {
      result[i / kSize][static_cast<Eigen::Index>(i % kSize)] = flat[i];
    }
    return result;
  }

  std::size_t length(const std::string& name) const {
    const std::vector<std::size_t> shape = group.shape(name);
    if (shape.size() != 1) throw_damaged(name, "is not a list");
    return shape[0];
  }

  template <class T>
  void check_values_below(const std::string& name, const std::vector<T>& values,
                          std::size_t limit) const {
    for (const T value : values) {
      if (static_cast<std::size_t>(value) >= limit) {
        throw_damaged(name, "holds " + std::to_string(value) + ", which must be below " +
                                std::to_string(limit));
      }
    }
  }

  CheckedGroup open_group(const std::string& name) const {
    return {file, path + "/" + name, group.open_group(name)};
  }
};

}  // namespace clast::study_detail
