#include <pybind11/pybind11.h>

#include <stdexcept>

#include "bindings.hpp"
#include "engine/config.hpp"
#include "text.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

/// Errors quote what stands in files.
void raise(const py::handle& type, const std::exception& error) {
    PyErr_SetObject(type.ptr(), readable(error.what()).ptr());
}

void translate(std::exception_ptr pointer) {
    try {
        std::rethrow_exception(pointer);
    } catch (const py::builtin_exception&) {
        throw;  // pybind11's own
    } catch (const ConfigError& error) {
        raise(py::module_::import("pilotage._core").attr("ConfigError"), error);
    } catch (const std::invalid_argument& error) {
        raise(PyExc_ValueError, error);
    } catch (const std::runtime_error& error) {
        raise(PyExc_RuntimeError, error);
    }
}

}  // namespace

void bind_errors(py::module_& m) {
    py::exception<ConfigError>(m, "ConfigError", PyExc_ValueError).doc() =
        "A configuration or map that cannot be used; names file, line, key, value and what was "
        "expected.";
    py::register_exception_translator(&translate);
}

}  // namespace pilotage::bindings
