#include "robots.hpp"

#include <cstdint>
#include <string>

namespace pilotage::test {

namespace {

/// Sets any key to some value, if the configuration is one with it.
void set_any_key(Config& config, Draws& draws) {
    static const char* const values[] = {"0",     "1",    "-1",    "100",    "-100",     "1e-9",
                                         "0.001", "3.2",  "1e-12", "1e-300", "0.999999", "1e-3",
                                         "plain", "gate", "both",  "wheels"};
    Config trial = config;
    const std::vector<Field> all = fields(trial);
    const Field& field = draws.one_of(all);
    // What is allocated at the start would only cost time, and names would only lose messages.
    const bool names = std::holds_alternative<std::string*>(field.value);
    if (names || field.key == "history.capacity") return;
    try {
        field.set(draws.one_of(values), "fuzz");
        check(trial, "fuzz");
        config = trial;
    } catch (const ConfigError&) {
    }
}

/// Such as send something else than angles and ranges of markers.
void add_other_sensors(Config& c, Draws& draws) {
    field(c, "sensors.gps.measures", "fuzz").set("pose", "fuzz");
    field(c, "sensors.gps.x_m", "fuzz").set("0.5", "fuzz");
    field(c, "sensors.laser.measures", "fuzz").set("walls", "fuzz");
    field(c, "sensors.film.measures", "fuzz").set("pixels", "fuzz");
    field(c, "sensors.film.z_m", "fuzz").set("1", "fuzz");
    field(c, "sensors.film.pitch_rad", "fuzz").set("0.2", "fuzz");
    if (draws.below(2) == 1)
        field(c, "sensors.film.association_radius_pixel", "fuzz").set("64", "fuzz");
    c.calibrate("film", {640, 480, 400, 400, 320, 240, {-0.2, 0.05, 0.001, 0, 0, 0, 0, 0}});
    c.walls = WallMap({{-5, -3, 5, -3}, {5, -3, 5, 3}, {5, 3, -5, 3}, {-5, 3, -5, -3}});
}

}  // namespace

Config some_robot(Draws& draws) {
    static constexpr int capacities[] = {1, 2, 3, 5, 16, 64, 200, 2048};
    static constexpr double windows_s[] = {0, 0.05, 0.5, 2};
    static constexpr double latencies_s[] = {0, 0, 0.04, -0.04};
    Config c;
    Params& p = c.params;
    const int kind = draws.byte();
    if (kind & 1) p.gyro_bias.sigma = 0.01, p.distance_scale.walk = 0.1;
    if (kind & 2) p.motion.source = MotionSource::velocity;
    if (!(kind & 4)) p.initial.x_m = p.initial.y_m = p.initial.heading_rad = 0;
    p.motion.heading = static_cast<HeadingSource>(draws.below(3));
    p.history.capacity = draws.one_of(capacities);
    p.history.window_s = draws.one_of(windows_s);
    c.sensor("camera");
    if (kind & 8) c.sensor("lidar");
    if (kind & 64) add_other_sensors(c, draws);
    if (kind & 128) p.filter = Filter::ukf;
    for (int i = 0; i < p.sensor_count; ++i)
        p.sensors[static_cast<std::size_t>(i)].fusion = static_cast<Fusion>(draws.below(3));
    if (kind & 16) c.sensor_inputs.back().channel = "OTHER_MARKERS";
    for (InputParams* input : {&c.encoders, &c.velocity, &c.gyro, &c.reset, &c.sensor_inputs[0]}) {
        const int timing = draws.below(12);
        input->time = static_cast<TimePolicy>(timing % 3);
        input->latency_s = latencies_s[timing / 3];
    }
    if (kind & 32)
        for (int i = draws.below(4); i > 0; --i) set_any_key(c, draws);
    c.map = MarkerMap({{0, 3, 0, 0.5, 0}, {1, 6, 2, 0.4, 0.05}, {2, 4, -4, 0, 0}, {3, 0, 0, 0, 0}});
    return c;
}

}  // namespace pilotage::test
