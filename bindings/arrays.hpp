#pragma once
/// \file
/// numpy arrays in and out, with shapes checked and named in errors.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace pilotage::bindings {

/// Accepts anything that numpy can turn into a contiguous array of T.
template <typename T>
using Array = pybind11::array_t<T, pybind11::array::c_style | pybind11::array::forcecast>;

/// \throws ValueError unless the array is one-dimensional with `size` entries
template <typename T>
void expect_length(const Array<T>& array, pybind11::ssize_t size, const char* name) {
    if (array.ndim() != 1 || array.shape(0) != size)
        throw pybind11::value_error(std::string(name) + " must have shape (" +
                                    std::to_string(size) + ",)");
}

/// \throws ValueError unless the array has shape (rows, columns)
template <typename T>
void expect_shape(const Array<T>& array, pybind11::ssize_t rows, pybind11::ssize_t columns,
                  const char* name) {
    if (array.ndim() != 2 || array.shape(0) != rows || array.shape(1) != columns)
        throw pybind11::value_error(std::string(name) + " must have shape (" +
                                    std::to_string(rows) + ", " + std::to_string(columns) + ")");
}

/// A numpy array that owns the vector's memory.
template <typename T>
pybind11::array_t<T> owning_array(std::vector<T> values) {
    auto* kept = new std::vector<T>(std::move(values));
    const pybind11::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
    return pybind11::array_t<T>(static_cast<pybind11::ssize_t>(kept->size()), kept->data(), owner);
}

}  // namespace pilotage::bindings
