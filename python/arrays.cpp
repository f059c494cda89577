#include "python/arrays.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast::python_detail {

namespace py = pybind11;

namespace {

template <class T>
py::array view_of(const T* first, std::vector<py::ssize_t> shape, const py::handle& owner) {
  py::array_t<T> array(std::move(shape), first, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

std::string shape_of(const py::array& array) {
  std::string text;
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  }
  return "(" + text + (array.ndim() == 1 ? ",)" : ")");
}

/// Lists become arrays; arrays stay what they are.
py::array array_from(const py::object& object, const char* name) {
  py::array array = py::array::ensure(object);
  if (!array) PyErr_Clear();
  const char kind = array ? array.dtype().kind() : 'O';
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    throw py::type_error(std::string(name) + ": must be an array of numbers, not " +
                         std::string(py::str(py::type::of(object).attr("__name__"))));
  }
  return array;
}

/// Rows of three, each passed to `take(row, x, y, z)`.
template <class T, class Take>
void read_rows(const py::array& array, const Take& take) {
  const auto values = py::array_t<T>(array).template unchecked<2>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    take(i, values(i, 0), values(i, 1), values(i, 2));
  }
}

template <class... Types, class Take>
bool read_rows_as(const py::array& array, const Take& take) {
  return ((py::isinstance<py::array_t<Types>>(array) && (read_rows<Types>(array, take), true)) ||
          ...);
}

void check_rows(const py::array& array, const char* name) {
  if (array.ndim() == 2 && array.shape(1) == 3) return;
  throw InputError(std::string(name) + ": has the shape " + shape_of(array) +
                   " but must have (n, 3)");
}

std::vector<TriangleMesh::Triangle> triangles_from(const py::object& object, std::size_t vertices) {
  const py::array array = array_from(object, "triangles");
  check_rows(array, "triangles");
  if (array.dtype().kind() == 'f') {
    throw py::type_error("triangles: must be whole numbers, the indices of vertices");
  }
  std::vector<TriangleMesh::Triangle> triangles;
  triangles.reserve(static_cast<std::size_t>(array.shape(0)));
  const auto index = [&](py::ssize_t row, auto value) {
    if (value < 0 || static_cast<std::uint64_t>(value) >= vertices) {
      throw InputError("triangles: row " + std::to_string(row) + " has the index " +
                       std::to_string(value) + ", but there are " +
                       format_count(vertices, "vertex", "vertices"));
    }
    return static_cast<std::uint32_t>(value);
  };
  const auto take = [&](py::ssize_t row, auto a, auto b, auto c) {
    triangles.push_back({index(row, a), index(row, b), index(row, c)});
  };
  if (!read_rows_as<std::int32_t, std::uint32_t, std::int64_t, std::uint64_t>(array, take)) {
    read_rows<std::int64_t>(array, take);
  }
  return triangles;
}

}  // namespace

py::array make_array_view(const std::vector<Vec3>& points, const py::handle& owner) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  const double* first = points.empty() ? nullptr : points.front().data();
  return view_of(first, {static_cast<py::ssize_t>(points.size()), 3}, owner);
}

py::array make_array_view(const std::vector<TriangleMesh::Triangle>& triangles,
                          const py::handle& owner) {
  const std::uint32_t* first = triangles.empty() ? nullptr : triangles.front().data();
  return view_of(first, {static_cast<py::ssize_t>(triangles.size()), 3}, owner);
}

py::array make_array_view(const std::vector<std::uint32_t>& indices, const py::handle& owner) {
  return view_of(indices.data(), {static_cast<py::ssize_t>(indices.size())}, owner);
}

py::array_t<double> to_array(const Vec3& vector) { return py::array_t<double>(3, vector.data()); }

py::array_t<double> to_array(const Mat3& matrix) {
  py::array_t<double> array({3, 3});
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      array.mutable_at(row, column) = matrix(row, column);
    }
  }
  return array;
}

py::array_t<double> to_array(const Quat& turn) {
  const double values[] = {turn.w(), turn.x(), turn.y(), turn.z()};
  return py::array_t<double>(4, values);
}

py::tuple to_arrays(TriangleMesh mesh) {
  auto* kept = new TriangleMesh(std::move(mesh));
  const py::capsule owner(kept, [](void* pointer) { delete static_cast<TriangleMesh*>(pointer); });
  return py::make_tuple(make_array_view(kept->vertices, owner),
                        make_array_view(kept->triangles, owner));
}

std::vector<Vec3> parse_points(const py::object& object, const char* name) {
  const py::array array = array_from(object, name);
  check_rows(array, name);
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(array.shape(0)));
  const auto take = [&](py::ssize_t row, auto x, auto y, auto z) {
    points.emplace_back(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    if (points.back().allFinite()) return;
    throw InputError(std::string(name) + ": row " + std::to_string(row) + " is not finite");
  };
  if (!read_rows_as<double, float>(array, take)) read_rows<double>(array, take);
  return points;
}

TriangleMesh parse_mesh(const py::object& vertices, const py::object& triangles) {
  TriangleMesh mesh;
  mesh.vertices = parse_points(vertices, "vertices");
  mesh.triangles = triangles_from(triangles, mesh.vertices.size());
  return mesh;
}

Vec3 parse_vector(const py::object& object, const char* name) {
  const py::array array = array_from(object, name);
  if (array.ndim() != 1 || array.shape(0) != 3) {
    throw InputError(std::string(name) + ": has the shape " + shape_of(array) +
                     " but must have (3,)");
  }
  const auto values = py::array_t<double>(array).unchecked<1>();
  const Vec3 vector(values(0), values(1), values(2));
  if (!vector.allFinite()) throw InputError(std::string(name) + ": is not finite");
  return vector;
}

Quat parse_rotation(const py::object& object, const char* name) {
  const py::array array = array_from(object, name);
  const py::array_t<double> numbers(array);
  Quat turn;
  if (array.ndim() == 1 && array.shape(0) == 4) {
    const auto values = numbers.unchecked<1>();
    turn = Quat(values(0), values(1), values(2), values(3));
  } else if (array.ndim() == 2 && array.shape(0) == 3 && array.shape(1) == 3) {
    const auto values = numbers.unchecked<2>();
    Mat3 matrix;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) matrix(row, column) = values(row, column);
    }
    const bool turns = (matrix * matrix.transpose()).isApprox(Mat3::Identity(), 1e-6);
    if (!turns || matrix.determinant() < 0.0) {
      throw InputError(std::string(name) + ": is a matrix but not a rotation");
    }
    turn = Quat(matrix);
  } else {
    throw InputError(std::string(name) + ": has the shape " + shape_of(array) +
                     " but must have (4,), w x y z, or (3, 3)");
  }
  if (!(std::abs(turn.norm() - 1.0) <= 1e-3)) {
    throw InputError(std::string(name) + ": has the length " + format_significant(turn.norm(), 6) +
                     " but must have 1");
  }
  return turn.normalized();
}

}  // namespace clast::python_detail
