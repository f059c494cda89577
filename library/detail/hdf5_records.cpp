#include "library/detail/hdf5_records.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast::library_detail {

void check_stored_value(bool condition, const std::string& where, const std::string& what) {
  if (!condition) {
    throw InputError(where + ": " + what +
                     "; the file is damaged: restore a backup, or make it again");
  }
}

void write_matrix(Hdf5Group group, const std::string& name, const Eigen::MatrixXd& values,
                  const std::string& unit) {
  std::vector<double> flat;
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index j = 0; j < values.cols(); ++j) flat.push_back(values(i, j));
  }
  std::vector<std::size_t> shape = {static_cast<std::size_t>(values.rows())};
  if (values.cols() > 1) shape.push_back(static_cast<std::size_t>(values.cols()));
  group.write<double>(name, flat, shape);
  group.set_unit(name, unit);
}

std::vector<double> read_array(const Hdf5Group& group, const std::string& name,
                               const std::vector<std::size_t>& shape, const std::string& where) {
  std::vector<double> values = group.read<double>(name);
  check_stored_value(group.shape(name) == shape, where, name + " has the wrong shape");
  for (const double value : values)
    check_stored_value(std::isfinite(value), where, name + " is not finite");
  return values;
}

Vec3 read_vector(const Hdf5Group& group, const std::string& name, const std::string& where) {
  const std::vector<double> v = read_array(group, name, {3}, where);
  return {v[0], v[1], v[2]};
}

Mat3 read_matrix(const Hdf5Group& group, const std::string& name, const std::string& where) {
  const std::vector<double> v = read_array(group, name, {3, 3}, where);
  Mat3 matrix;
  matrix << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
  return matrix;
}

double read_scalar(const Hdf5Group& group, const std::string& name, double min_value,
                   const std::string& where) {
  const double value = group.read_attribute<double>(name);
  check_stored_value(std::isfinite(value) && value >= min_value, where,
                     name + " can't be " + format_significant(value, 6));
  return value;
}

void write_points(Hdf5Group group, const std::string& name, const std::vector<Vec3>& points) {
  std::vector<double> flat;
  flat.reserve(3 * points.size());
  for (const Vec3& point : points) flat.insert(flat.end(), point.data(), point.data() + 3);
  group.write<double>(name, flat, {points.size(), 3});
  group.set_unit(name, "m");
}

std::vector<Vec3> read_points(const Hdf5Group& group, const std::string& name,
                              const std::string& where) {
  const std::vector<std::size_t> shape = group.shape(name);
  check_stored_value(shape.size() == 2, where, name + " has the wrong shape");
  const std::vector<double> flat = read_array(group, name, {shape[0], 3}, where);
  std::vector<Vec3> points(shape[0]);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
  }
  return points;
}

void check_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices,
                   const std::string& name, const std::string& where) {
  for (const std::uint32_t index : indices) {
    check_stored_value(index < vertices, where, name + " refers to a vertex that does not exist");
  }
}

}  // namespace clast::library_detail
