#include "bindings.hpp"

PYBIND11_MODULE(_core, m) {
    using namespace pilotage::bindings;
    m.doc() = "Pilotage's C++ core and engine.";
    m.attr("__version__") = PILOTAGE_VERSION;
    bind_errors(m);
    bind_marker_map(m);
    bind_camera_model(m);
    bind_wall_map(m);
    bind_config(m);
    bind_recording(m);
    bind_motion(m);
    bind_sensing(m);
    bind_measurements(m);
    bind_filter(m);
    bind_linear_kalman(m);
    bind_ukf(m);
    bind_run(m);
    bind_localizer(m);
}
