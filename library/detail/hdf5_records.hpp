#pragma once
/// Checked reading and writing of vectors, tensors, points and indices as datasets. `where` is the
/// prefix of messages, such as "blocks.h5: block B017".
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/files/hdf5_file.hpp"
#include "core/types.hpp"

namespace clast::library_detail {

/// Checks a condition on a stored value.
/// @throws InputError  if it is false; the message consists of `where` and `what`
void check_stored_value(bool condition, const std::string& where, const std::string& what);

void write_matrix(Hdf5Group group, const std::string& name, const Eigen::MatrixXd& values,
                  const std::string& unit);
/// Reads an array of finite numbers with a given shape.
std::vector<double> read_array(const Hdf5Group& group, const std::string& name,
                               const std::vector<std::size_t>& shape, const std::string& where);
Vec3 read_vector(const Hdf5Group& group, const std::string& name, const std::string& where);
Mat3 read_matrix(const Hdf5Group& group, const std::string& name, const std::string& where);
/// Reads a finite number, at least `min_value`, from an attribute.
double read_scalar(const Hdf5Group& group, const std::string& name, double min_value,
                   const std::string& where);

void write_points(Hdf5Group group, const std::string& name, const std::vector<Vec3>& points);
std::vector<Vec3> read_points(const Hdf5Group& group, const std::string& name,
                              const std::string& where);

void check_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices,
                   const std::string& name, const std::string& where);

template <std::size_t N>
void write_indices(Hdf5Group group, const std::string& name,
                   const std::vector<std::array<std::uint32_t, N>>& rows) {
  std::vector<std::uint32_t> flat;
  flat.reserve(N * rows.size());
  for (const auto& row : rows) flat.insert(flat.end(), row.begin(), row.end());
  group.write<std::uint32_t>(name, flat, {rows.size(), N});
  group.set_unit(name, "1");
}

template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> read_indices(const Hdf5Group& group,
                                                       const std::string& name,
                                                       std::size_t vertices,
                                                       const std::string& where) {
  const std::vector<std::uint32_t> flat = group.read<std::uint32_t>(name);
  check_stored_value(group.shape(name) == std::vector<std::size_t>{flat.size() / N, N}, where,
                     name + " has the wrong shape");
  check_indices(flat, vertices, name, where);
  std::vector<std::array<std::uint32_t, N>> rows(flat.size() / N);
  for (std::size_t i = 0; i < flat.size(); ++i) rows[i / N][i % N] = flat[i];
  return rows;
}

}  // namespace clast::library_detail
