#pragma once
/// Tables and JSON as Python values.
#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>

#include "core/files/table_values.hpp"
#include "study/campaign/key_table.hpp"

namespace clast::python_detail {

/// (values, units, meanings): dicts by the columns' names, of NumPy arrays (float64, int64, texts)
/// and of texts.
pybind11::tuple table_of(TableValues table);

/// dict, list, str, int, float, bool, None.
pybind11::object object_of(const nlohmann::ordered_json& json);

/// {table: its keys}
pybind11::dict keys_of(const std::vector<KeyTable>& tables);

}  // namespace clast::python_detail
