#pragma once
/// \file
/// The list of what is bound; one file a concept.

#include <pybind11/pybind11.h>

namespace pilotage::bindings {

void bind_errors(pybind11::module_& m);
void bind_marker_map(pybind11::module_& m);
void bind_config(pybind11::module_& m);
void bind_recording(pybind11::module_& m);
void bind_run(pybind11::module_& m);
void bind_motion(pybind11::module_& m);
void bind_sensing(pybind11::module_& m);
void bind_camera_model(pybind11::module_& m);
void bind_measurements(pybind11::module_& m);
void bind_wall_map(pybind11::module_& m);
void bind_filter(pybind11::module_& m);
void bind_linear_kalman(pybind11::module_& m);
void bind_ukf(pybind11::module_& m);
void bind_localizer(pybind11::module_& m);

}  // namespace pilotage::bindings
