#include "python/options.hpp"

#include <algorithm>

namespace clast::python_detail {

namespace py = pybind11;

namespace {

std::string type_name(const py::handle& object) {
  return py::str(py::type::handle_of(object).attr("__name__"));
}

/// A text, or what `os.fspath` makes of a path.
std::optional<std::string> text_from(const py::handle& object) {
  if (py::isinstance<py::str>(object)) return py::cast<std::string>(object);
  if (!py::hasattr(object, "__fspath__")) return std::nullopt;
  const py::object path = object.attr("__fspath__")();
  if (!py::isinstance<py::str>(path)) return std::nullopt;
  return py::cast<std::string>(path);
}

}  // namespace

Keywords::Keywords(const py::dict& given) {
  for (const auto& [name, value] : given) {
    if (!value.is_none()) given_[name] = value;
  }
}

bool Keywords::has(const char* name) {
  if (!given_.contains(name)) return false;
  taken_.emplace_back(name);
  return true;
}

std::vector<std::string> Keywords::read_texts(const char* name) {
  return has(name) ? parse_texts(given_[name], name) : std::vector<std::string>();
}

void Keywords::check_all_used() const {
  for (const auto& [name, value] : given_) {
    if (std::find(taken_.begin(), taken_.end(), py::cast<std::string>(name)) == taken_.end()) {
      throw py::type_error("unexpected keyword argument '" + py::cast<std::string>(name) + "'");
    }
  }
}

void Keywords::refuse(const char* name) const {
  throw py::type_error(std::string(name) + ": can't be a " + type_name(given_[name]));
}

std::vector<std::string> parse_texts(const py::handle& object, const char* name) {
  if (std::optional<std::string> text = text_from(object)) return {*text};
  std::vector<std::string> texts;
  if (py::isinstance<py::iterable>(object) && !py::isinstance<py::bytes>(object)) {
    for (const py::handle& item : object) {
      const std::optional<std::string> text = text_from(item);
      if (!text) {
        throw py::type_error(std::string(name) + ": must be texts or paths, but one is a " +
                             type_name(item));
      }
      texts.push_back(*text);
    }
    return texts;
  }
  throw py::type_error(std::string(name) + ": must be a text, a path or several, not a " +
                       type_name(object));
}

}  // namespace clast::python_detail
