#pragma once
/// \file
/// Text from files, which need not be UTF-8, for Python, whose text always is.

#include <pybind11/pybind11.h>

#include <string_view>

namespace pilotage::bindings {

/// What is not UTF-8 comes as \x80.
[[nodiscard]] inline pybind11::str readable(std::string_view text) {
    PyObject* decoded = PyUnicode_DecodeUTF8(
        text.data(), static_cast<pybind11::ssize_t>(text.size()), "backslashreplace");
    if (decoded == nullptr) throw pybind11::error_already_set();
    return pybind11::reinterpret_steal<pybind11::str>(decoded);
}

}  // namespace pilotage::bindings
