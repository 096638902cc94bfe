/// The configuration's keys, each with its place, range and meaning: the one list that loading,
/// writing, looking up and documenting use. Defaults stand with the members.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "config.hpp"

namespace pilotage {

const char* default_channel(Measures measures) noexcept {
    constexpr const char* channels[] = {"MARKERS", "FIX", "WALLS", "PIXELS"};
    return channels[static_cast<int>(measures)];
}

namespace {

using Range = Field::Range;

template <typename Enum>
Field::Choice choice(Enum& value, std::vector<std::string> names) {
    static_assert(sizeof(Enum) == 1);
    return {reinterpret_cast<unsigned char*>(&value), std::move(names)};
}

void add_input(std::vector<Field>& list, const std::string& prefix, InputParams& input) {
    list.push_back({prefix + "channel", &input.channel, Range::any, "LCM channel"});
    list.push_back(
        {prefix + "time", choice(input.time, {"utime", "receive", "mapped"}), Range::any,
         "what dates a sample: the sender's stamp, its arrival, or the stamp mapped to our clock"});
    list.push_back({prefix + "latency_s", &input.latency_s, Range::any,
                    "how much later the stamp is than the moment it speaks of; may be negative"});
}

void add_calibration(std::vector<Field>& list, const std::string& name, CalibrationParams& c,
                     Range range) {
    const std::string prefix = "calibration." + name + ".";
    list.push_back({prefix + "initial", &c.initial, range, "value at the start"});
    list.push_back(
        {prefix + "sigma", &c.sigma, Range::not_negative, "of the initial value; 0 freezes it"});
    list.push_back({prefix + "walk", &c.walk, Range::not_negative,
                    "random walk: per root second (gyro_bias), metre (distance_scale), radian "
                    "(rotation_scale)"});
}

/// Only keys that have a meaning for what the sensor measures.
void add_sensor(std::vector<Field>& list, const std::string& name, InputParams& input,
                CameraSetup& camera, SensorParams& s) {
    const std::string prefix = "sensors." + name + ".";
    const auto add = [&](const char* key, auto value, Range range, const char* meaning) {
        list.push_back({prefix + key, value, range, meaning});
    };
    const bool markers = s.measures == Measures::markers, pose = s.measures == Measures::pose,
               walls = s.measures == Measures::walls, pixels = s.measures == Measures::pixels;
    add("measures", choice(s.measures, {"markers", "pose", "walls", "pixels"}), Range::any,
        "markers: their bearing, elevation and range (marker_frame_t); pose: its own position, "
        "heading or both (position_fix_t, heading_t, pose_fix_t); walls: their range along beams "
        "(wall_range_t); pixels: where a camera sees markers in its image (pixel_frame_t); to be "
        "said before what depends on it");
    // A channel that nobody named is that of what is measured.
    list.back().changed = [&input, &s, before = s.measures] {
        if (input.channel == default_channel(before)) input.channel = default_channel(s.measures);
    };
    add_input(list, prefix, input);
    add("x_m", &s.x_m, Range::any, "mounting, forward of the mid-axis");
    add("y_m", &s.y_m, Range::any, "mounting, left of the mid-axis");
    if (!walls) add("z_m", &s.z_m, Range::any, "mounting, above the ground");
    add("yaw_rad", &s.yaw_rad, Range::any, "mounting, left positive");
    if (!walls) {
        const auto turn = [&s, &camera] {
            s.camera = {s.camera.intrinsics(), camera.roll_rad, camera.pitch_rad};
        };
        add("roll_rad", &camera.roll_rad, Range::any, "of a camera, right side down positive");
        list.back().changed = turn;
        add("pitch_rad", &camera.pitch_rad, Range::any, "of a camera, down positive");
        list.back().changed = turn;
        add("intrinsics", &camera.intrinsics_file, Range::any,
            "a camera's calibration as OpenCV or ROS writes it, relative to this file; or its "
            "content");
        add("sigma_pixel", &s.sigma_pixel, Range::positive,
            "noise of u and of v where a camera sees something [px]");
    }
    if (pixels)
        add("association_radius_pixel", &s.association_radius_pixel, Range::not_negative,
            "without an id, of the marker projected nearest within this [px]; 0: of what the "
            "uncertainty of pose and pixel allows");
    if (pose) {
        add("sigma_position_m", &s.sigma_position_m, Range::positive, "noise of x and of y");
        add("sigma_heading_rad", &s.sigma_heading_rad, Range::positive, "noise of a heading");
    } else if (!pixels) {
        if (markers) {
            add("sigma_bearing_rad", &s.sigma_bearing_rad, Range::positive, "noise of a bearing");
            add("sigma_elevation_rad", &s.sigma_elevation_rad, Range::positive,
                "noise of an elevation");
        }
        add("sigma_range_m", &s.sigma_range_m, Range::positive, "noise of a range");
        add("sigma_range_per_m", &s.sigma_range_per_m, Range::not_negative,
            "noise of a range, times the range, added in quadrature");
        add("range_scale", &s.range_scale, Range::positive, "reported over true range");
        add("range_offset_m", &s.range_offset_m, Range::any, "reported at range zero");
    }
    if (markers)
        add("min_distance_m", &s.min_distance_m, Range::positive,
            "nearer markers are rejected as too_close");
    add("fusion", choice(s.fusion, {"plain", "gate", "student_t"}), Range::any,
        "full weight, rejection above the gate, or a weight that falls with the NIS");
    add("gate_false_reject", &s.gate_false_reject, Range::probability,
        "how often the gate may reject a good measurement");
    add("student_t_dof", &s.student_t_dof, Range::positive,
        "nu of the Student-t weight, smaller is more sceptical");
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[b.size()];
}

const char* expectation(Range range) {
    switch (range) {
        case Range::positive:
            return "a number above 0, at most 1e9";
        case Range::not_negative:
            return "a number of 0 or more, at most 1e9";
        case Range::not_zero:
            return "a number other than 0 between -1e9 and 1e9";
        case Range::probability:
            return "a number between 0 and 1";
        default:
            return "a number between -1e9 and 1e9";
    }
}

bool inside(double v, Range range) {
    constexpr double limit = 1e9;  // squares, and times in microseconds, stay far from overflow
    if (!(std::abs(v) <= limit)) return false;
    switch (range) {
        case Range::positive:
            return v > 0;
        case Range::not_negative:
            return v >= 0;
        case Range::not_zero:
            return v != 0;
        case Range::probability:
            return v > 0 && v < 1;
        default:
            return true;
    }
}

/// The shortest text that reads back as the same number.
std::string shortest(double v) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, v).ptr};
}

template <typename Number>
bool parse(const std::string& text, Number& number) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + (plus ? 1 : 0), last, number);
    return error == std::errc{} && end == last;
}

constexpr const char* kNameExpected = "1 to 60 bytes of readable text";

/// Length of the UTF-8 character at the front, 0 if there is none that people can read.
std::size_t readable(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return byte(0) >= ' ' && byte(0) <= '~' ? 1 : 0;
    const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return 0;
    unsigned code = byte(0) & (0xffU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3fU);
    }
    constexpr unsigned shortest[] = {0, 0, 0xa0, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    const bool special = code == 0xfeff || (code & 0xfffe) == 0xfffe;
    const bool breaks = code == 0x2028 || code == 0x2029;  // a line, a paragraph
    const bool none = code < shortest[length] || surrogate || code > 0x10ffff;
    return none || special || breaks ? 0 : length;
}

/// What stands on one line, in YAML and in a log.
bool is_name(std::string_view text) {
    constexpr std::size_t longest = 60;
    if (text.empty() || text.size() > longest) return false;
    while (!text.empty()) {
        const std::size_t length = readable(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

/// With a question mark for each byte that people cannot read.
std::string legible(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = readable(text);
        result += length == 0 ? "?" : text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

[[noreturn]] void fail(const std::string& where, const std::string& what) {
    throw ConfigError(where + ": " + legible(what));
}

}  // namespace

int Config::sensor(std::string_view name, const std::string& where) {
    const auto at = std::find(sensor_names.begin(), sensor_names.end(), name);
    if (at != sensor_names.end()) return static_cast<int>(at - sensor_names.begin());
    if (!is_name(name) || name.find('.') != std::string_view::npos)
        fail(where, "'" + std::string(name) + "' is no name for a sensor: expected " +
                        kNameExpected + ", none of them a dot");
    if (params.sensor_count == Params::kMaxSensors)
        fail(where, "sensors." + std::string(name) + ": there can be at most " +
                        std::to_string(Params::kMaxSensors) + " sensors");
    sensor_names.emplace_back(name);
    sensor_inputs.push_back({default_channel(Measures::markers)});
    sensor_cameras.emplace_back();
    return params.sensor_count++;
}

void Config::calibrate(const std::string& name, const Intrinsics& intrinsics) {
    const auto i = static_cast<std::size_t>(sensor(name));
    params.sensors[i].camera = {intrinsics, sensor_cameras[i].roll_rad,
                                sensor_cameras[i].pitch_rad};
}

std::vector<Field> fields(Config& c) {
    std::vector<Field> list;
    const auto add = [&](const char* key, auto value, Range range, const char* meaning) {
        list.push_back({key, value, range, meaning});
    };
    Params& p = c.params;
    add("map", &c.map_file, Range::any,
        "marker map file, relative to this file; or the list itself");
    add("walls", &c.walls_file, Range::any, "likewise, of walls, for sensors that measure them");
    add("filter", choice(p.filter, {"ekf", "ukf"}), Range::any,
        "extended Kalman filter, or unscented: for very wide noise, several times the work");
    add("motion.source", choice(p.motion.source, {"encoders", "velocity"}), Range::any,
        "which message carries the motion");
    add("motion.heading", choice(p.motion.heading, {"gyro", "wheels", "both"}), Range::any,
        "where the change of heading comes from; both: their inverse-variance mean");
    add("motion.slip_angle_rad", &p.motion.slip_angle_rad, Range::any,
        "direction of travel relative to the heading");
    add("motion.max_gap_s", &p.motion.max_gap_s, Range::positive,
        "a rate holds for no longer than this");
    add_input(list, "encoders.", c.encoders);
    add("encoders.left_m_per_tick", &p.wheels.left_m_per_tick, Range::not_zero,
        "negative where the encoder counts down when driving forward");
    add("encoders.right_m_per_tick", &p.wheels.right_m_per_tick, Range::not_zero, "likewise");
    add("encoders.track_width_m", &p.wheels.track_width_m, Range::positive,
        "between the wheels' contact points");
    add("encoders.max_speed_m_s", &p.wheels.max_speed_m_s, Range::positive,
        "motion that implies more is a counter's wrap or reset, or implausible");
    add_input(list, "velocity.", c.velocity);
    add_input(list, "gyro.", c.gyro);
    add_input(list, "pose_reset.", c.reset);
    add("pose_reset.accept", choice(c.reset_policy, {"always", "not_ok", "never"}), Range::any,
        "when a pose_reset_t is obeyed; not_ok: while the status is not OK");
    add("noise.wheel_m_per_sqrt_m", &p.noise.wheel_m_per_sqrt_m, Range::not_negative,
        "travel of each wheel");
    add("noise.gyro_rad_per_sqrt_s", &p.noise.gyro_rad_per_sqrt_s, Range::not_negative,
        "angle random walk of the gyro, or of a velocity message's omega");
    add("noise.position_m_per_sqrt_m", &p.noise.position_m_per_sqrt_m, Range::not_negative,
        "process noise of x and y per distance");
    add("noise.position_m_per_sqrt_s", &p.noise.position_m_per_sqrt_s, Range::not_negative,
        "process noise of x and y per time");
    add("noise.heading_rad_per_sqrt_m", &p.noise.heading_rad_per_sqrt_m, Range::not_negative,
        "process noise of the heading per distance");
    add("noise.heading_rad_per_sqrt_rad", &p.noise.heading_rad_per_sqrt_rad, Range::not_negative,
        "process noise of the heading per turn");
    add("noise.heading_rad_per_sqrt_s", &p.noise.heading_rad_per_sqrt_s, Range::not_negative,
        "process noise of the heading per time");
    add("noise.adaptation", choice(p.noise.adaptation, {"off", "on"}), Range::any,
        "on: the innovations scale the noise of each sensor and of the motion, by 1/4 to 4 in "
        "sigma");
    add_calibration(list, "gyro_bias", p.gyro_bias, Range::any);
    add_calibration(list, "distance_scale", p.distance_scale, Range::positive);
    add_calibration(list, "rotation_scale", p.rotation_scale, Range::positive);
    add("tilt.pitch_sigma_rad", &p.tilt.pitch_sigma_rad, Range::not_negative,
        "how far the body pitches against the ground; for elevations, 0: not at all");
    add("tilt.roll_sigma_rad", &p.tilt.roll_sigma_rad, Range::not_negative, "likewise, roll");
    add("tilt.tau_s", &p.tilt.tau_s, Range::not_negative,
        "for how long a tilt lasts; 0: new in every frame");
    for (std::size_t i = 0; i < c.sensor_names.size(); ++i)
        add_sensor(list, c.sensor_names[i], c.sensor_inputs[i], c.sensor_cameras[i], p.sensors[i]);
    add("initial.x_m", &p.initial.x_m, Range::unset_or_any,
        "start; without it the pose is found from sightings, or set by a pose_reset_t");
    add("initial.y_m", &p.initial.y_m, Range::unset_or_any, "start");
    add("initial.heading_rad", &p.initial.heading_rad, Range::unset_or_any, "start");
    add("initial.sigma_position_m", &p.initial.sigma_position_m, Range::not_negative,
        "of x and of y");
    add("initial.sigma_heading_rad", &p.initial.sigma_heading_rad, Range::not_negative,
        "of the heading");
    add("status.alert_limit_m", &p.status.alert_limit_m, Range::positive,
        "OK promises a 95 % radius below this");
    add("status.dead_reckoning_after_s", &p.status.dead_reckoning_after_s, Range::positive,
        "without a sighting that agrees for this long, OK ends");
    add("status.lost_limit_m", &p.status.lost_limit_m, Range::positive,
        "LOST where the 95 % radius is above this");
    add("status.lost_after_s", &p.status.lost_after_s, Range::positive,
        "LOST where no motion came for this long");
    add("history.window_s", &p.history.window_s, Range::not_negative, "later samples are rejected");
    add("history.capacity", &p.history.capacity, Range::positive, "samples held at most");
    add("output.pose", &c.output.pose, Range::any, "LCM channel of pose_t");
    add("output.report", &c.output.report, Range::any, "LCM channel of marker_report_t");
    add("output.status", &c.output.status, Range::any, "LCM channel of status_t");
    add("output.odometry", &c.output.odometry, Range::any,
        "LCM channel of odometry_t: dead reckoning alone, without jumps");
    add("output.jump", &c.output.jump, Range::any, "LCM channel of pose_jump_t");
    add("output.rate_hz", &c.output.rate_hz, Range::not_negative,
        "poses a second, predicted to now; 0: a pose at every motion sample");
    add("output.jump_m", &c.output.jump_m, Range::positive,
        "a correction of the position beyond this is counted and announced");
    add("output.jump_rad", &c.output.jump_rad, Range::positive,
        "a correction of the heading beyond this likewise");
    add("checkpoint.interval_s", &c.checkpoint_interval_s, Range::positive,
        "between checkpoints, where the node is given a file for them");
    return list;
}

Field field(Config& config, const std::string& key, const std::string& where) {
    const std::string sensors = "sensors.";
    const bool of_sensor = key.compare(0, sensors.size(), sensors) == 0;
    if (const auto dot = key.find('.', sensors.size()); of_sensor && dot != std::string::npos) {
        const std::string name = key.substr(sensors.size(), dot - sensors.size());
        const auto& known = config.sensor_names;
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            Config trial;  // a misspelt key must not add the sensor
            trial.sensor(name, where);
            (void)field(trial, key, where);
            config.sensor(name, where);
        }
    }
    std::vector<Field> list = fields(config);
    const auto known = [&](const Field& f) { return f.key == key; };
    if (const auto at = std::find_if(list.begin(), list.end(), known); at != list.end()) return *at;
    const auto nearest =
        std::min_element(list.begin(), list.end(), [&](const Field& a, const Field& b) {
            return edit_distance(a.key, key) < edit_distance(b.key, key);
        });
    fail(where, "unknown key '" + key + "'; the nearest known key is '" + nearest->key + "'");
}

std::string Field::text() const {
    if (const auto* number = std::get_if<double*>(&value)) return shortest(**number);
    if (const auto* integer = std::get_if<int*>(&value)) return std::to_string(**integer);
    if (const auto* string = std::get_if<std::string*>(&value)) return **string;
    const auto& choice = std::get<Choice>(value);
    return choice.names[*choice.value];
}

bool Field::unset() const {
    const auto* number = std::get_if<double*>(&value);
    return number != nullptr && std::isnan(**number);
}

void Field::set(const std::string& text, const std::string& where) const {
    const auto refuse = [&](const std::string& expected) {
        fail(where, key + " is '" + text + "', expected " + expected);
    };
    if (const auto* number = std::get_if<double*>(&value)) {
        double v = 0;
        if (!parse(text, v) || !inside(v, range)) refuse(expectation(range));
        **number = v;
    } else if (const auto* integer = std::get_if<int*>(&value)) {
        int v = 0;
        if (!parse(text, v) || v < 1 || v > 1'000'000) refuse("a whole number from 1 to 1000000");
        **integer = v;
    } else if (const auto* string = std::get_if<std::string*>(&value)) {
        const bool file = is_file(key);
        if (file ? text.empty() : !is_name(text)) refuse(file ? "a file" : kNameExpected);
        **string = text;
    } else {
        const auto& choice = std::get<Choice>(value);
        const auto at = std::find(choice.names.begin(), choice.names.end(), text);
        if (at == choice.names.end()) {
            std::string names;
            for (const std::string& name : choice.names)
                names += (names.empty() ? "" : ", ") + name;
            refuse("one of " + names);
        }
        *choice.value = static_cast<unsigned char>(at - choice.names.begin());
    }
    if (changed) changed();
}

void check(const Config& config, const std::string& where) {
    const InitialParams& start = config.params.initial;
    const int given =
        !std::isnan(start.x_m) + !std::isnan(start.y_m) + !std::isnan(start.heading_rad);
    if (given != 0 && given != 3)
        fail(where, "initial needs x_m, y_m and heading_rad together, or none of them");
    std::set<std::string> channels;
    const auto take = [&](const std::string& name, const std::string& channel) {
        if (!channels.insert(channel).second)
            fail(where, name + ".channel '" + channel + "' is another input's channel as well");
    };
    if (config.params.motion.source == MotionSource::encoders)
        take("encoders", config.encoders.channel);
    else
        take("velocity", config.velocity.channel);
    take("gyro", config.gyro.channel);
    take("pose_reset", config.reset.channel);
    std::set<std::string> shared;  // by sensors, whose frames name them
    for (std::size_t i = 0; i < config.sensor_inputs.size(); ++i) {
        const std::string& channel = config.sensor_inputs[i].channel;
        if (shared.insert(channel).second) take("sensors." + config.sensor_names[i], channel);
    }
    const OutputParams& out = config.output;
    if (out.rate_hz != 0 && !(out.rate_hz >= 0.1 && out.rate_hz <= 1000))
        fail(where, "output.rate_hz is " + shortest(out.rate_hz) +
                        ", expected 0 or a number from 0.1 to 1000");
    for (const auto& [name, channel] : {std::pair{"pose", out.pose},
                                        {"report", out.report},
                                        {"status", out.status},
                                        {"odometry", out.odometry},
                                        {"jump", out.jump}})
        if (channels.count(channel) != 0)
            fail(where, std::string("output.") + name + " '" + channel + "' is an input's channel");
}

std::string missing(const Config& config) {
    const auto measures = [&](Measures what) {
        const auto& sensors = config.params.sensors;
        return std::any_of(sensors.begin(), sensors.begin() + config.params.sensor_count,
                           [&](const SensorParams& s) { return s.measures == what; });
    };
    if (config.params.sensor_count == 0) return "'sensors' is missing: name at least one";
    if ((measures(Measures::markers) || measures(Measures::pixels)) && config.map.markers().empty())
        return "'map' is missing: name a file of markers";
    if (measures(Measures::walls) && config.walls.walls().empty())
        return "'walls' is missing: name a file of walls";
    for (std::size_t i = 0; i < config.sensor_names.size(); ++i)
        if (const SensorParams& s = config.params.sensors[i];
            s.measures == Measures::pixels && !s.camera.intrinsics().any())
            return "'sensors." + config.sensor_names[i] +
                   ".intrinsics' is missing: name the file of the camera's calibration";
    return "";
}

}  // namespace pilotage
