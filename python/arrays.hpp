#pragma once
/// Between NumPy arrays and vectors: views where an owner keeps the numbers, one copy where the
/// library needs its own, none in Python.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::python_detail {

/// Read-only view of shape (n, 3); `owner` lives as long as the view does.
pybind11::array view(const std::vector<Vec3>& points, const pybind11::handle& owner);
/// Read-only view of shape (n, 3).
pybind11::array view(const std::vector<TriangleMesh::Triangle>& triangles,
                     const pybind11::handle& owner);
/// Read-only view of shape (n,).
pybind11::array view(const std::vector<std::uint32_t>& indices, const pybind11::handle& owner);

/// An array that owns the numbers, which are not copied.
template <class T>
pybind11::array_t<T> owned(std::vector<T> values) {
  auto* kept = new std::vector<T>(std::move(values));
  const pybind11::capsule owner(
      kept, [](void* pointer) { delete static_cast<std::vector<T>*>(pointer); });
  return pybind11::array_t<T>(static_cast<pybind11::ssize_t>(kept->size()), kept->data(), owner);
}

pybind11::array_t<double> to_array(const Vec3& vector);  ///< of shape (3,)
pybind11::array_t<double> to_array(const Mat3& matrix);  ///< of shape (3, 3)
pybind11::array_t<double> to_array(const Quat& turn);    ///< of shape (4,): w, x, y, z

/// (vertices (n, 3) float64, triangles (m, 3) uint32); the arrays own the mesh.
pybind11::tuple to_arrays(TriangleMesh mesh);

/// @param name  for messages
/// @throws TypeError   no array of numbers; InputError  of another shape, or not finite
std::vector<Vec3> parse_points(const pybind11::object& array, const char* name);
/// Vertices of shape (n, 3) and triangles of shape (m, 3), of any kind of float and integer, in any
/// order in memory; read where they are.
/// @throws TypeError, InputError  as `parse_points`; an index without a vertex
TriangleMesh mesh_from(const pybind11::object& vertices, const pybind11::object& triangles);
/// Three numbers.
Vec3 parse_vector(const pybind11::object& array, const char* name);
/// Four numbers w, x, y, z of length 1 within 1e-3, normalised; or a matrix of shape (3, 3).
Quat rotation_from(const pybind11::object& array, const char* name);

}  // namespace clast::python_detail
