#pragma once
/// Conversion between NumPy arrays and vectors. Data are copied at most once, or kept by an owner.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::python_detail {

/// Returns a read-only NumPy view of points, of shape (n, 3). It keeps `owner` alive.
pybind11::array make_array_view(const std::vector<Vec3>& points, const pybind11::handle& owner);
/// Returns a read-only NumPy view of triangles, of shape (n, 3). It keeps `owner` alive.
pybind11::array make_array_view(const std::vector<TriangleMesh::Triangle>& triangles,
                                const pybind11::handle& owner);
/// Returns a read-only NumPy view of indices, of shape (n,). It keeps `owner` alive.
pybind11::array make_array_view(const std::vector<std::uint32_t>& indices,
                                const pybind11::handle& owner);

/// Returns a NumPy array that takes over the values without copying.
template <class T>
pybind11::array_t<T> make_owning_array(std::vector<T> values) {
  auto* kept = new std::vector<T>(std::move(values));
  const pybind11::capsule owner(
      kept, [](void* pointer) { delete static_cast<std::vector<T>*>(pointer); });
  return pybind11::array_t<T>(static_cast<pybind11::ssize_t>(kept->size()), kept->data(), owner);
}

pybind11::array_t<double> to_array(const Vec3& vector);  ///< returns an array of shape (3,)
pybind11::array_t<double> to_array(const Mat3& matrix);  ///< returns an array of shape (3, 3)
/// Returns an array of shape (4,): w, x, y, z.
pybind11::array_t<double> to_array(const Quat& turn);

/// Returns vertices and triangles of a mesh as two NumPy arrays, which own the data.
pybind11::tuple to_arrays(TriangleMesh mesh);

/// Converts an array of shape (n, 3) to points.
/// @param name  name of the argument in messages
/// @throws TypeError  if the argument is not an array of numbers
/// @throws InputError  if the shape is wrong or a value is not finite
std::vector<Vec3> parse_points(const pybind11::object& array, const char* name);
/// Makes a mesh from vertices of shape (n, 3) and triangles of shape (m, 3). They may have any
/// float and integer type and memory layout.
/// @throws TypeError, InputError  if `parse_points` would throw, or if an index has no vertex
TriangleMesh parse_mesh(const pybind11::object& vertices, const pybind11::object& triangles);
/// Converts a NumPy array of three numbers to a vector.
Vec3 parse_vector(const pybind11::object& array, const char* name);
/// Converts a quaternion (w, x, y, z) or a rotation matrix of shape (3, 3) to a unit quaternion.
Quat parse_rotation(const pybind11::object& array, const char* name);

}  // namespace clast::python_detail
