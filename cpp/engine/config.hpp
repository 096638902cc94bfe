#pragma once
/// \file
/// Everything that a run needs besides its input: parameters of the core, channels and times of the
/// inputs, names of the sensors, and the map.

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pilotage/marker_map.hpp"
#include "pilotage/params.hpp"
#include "pilotage/wall_map.hpp"

namespace pilotage {

/// Which clock dates a sample.
enum class TimePolicy : unsigned char {
    utime,    ///< the sender's stamp
    receive,  ///< the time of arrival
    mapped,   ///< the sender's stamp moved by the smallest delay of the last minute
};

struct InputParams {
    std::string channel;
    TimePolicy time = TimePolicy::utime;
    double latency_s =
        0;  ///< the stamp is this much later than the moment it speaks of; may be negative
};

struct OutputParams {
    std::string pose = "POSE";
    std::string report = "MARKER_REPORT";
    std::string status = "STATUS";
    std::string odometry = "ODOMETRY";
    std::string jump = "POSE_JUMP";
    double rate_hz = 0;      ///< of poses; 0: one at every motion sample
    double jump_m = 0.3;     ///< a correction beyond this is announced
    double jump_rad = 0.15;  ///< likewise
};

/// When a pose_reset_t is obeyed.
enum class ResetPolicy : unsigned char {
    always,
    not_ok,  ///< while the status is not OK
    never,
};

/// Where a sensor's messages come if nothing is said.
[[nodiscard]] const char* default_channel(Measures measures) noexcept;

/// What the configuration tells of a sensor's camera besides its calibration.
struct CameraSetup {
    double roll_rad = 0, pitch_rad = 0;  ///< of the camera body, as CameraModel has them
    std::string intrinsics_file;         ///< as Config::map_file
};

struct Config {
    Params params;  ///< sensors in the order of sensor_names
    InputParams encoders{"ENCODERS"};
    InputParams velocity{"VELOCITY"};
    InputParams gyro{"GYRO"};
    InputParams reset{"POSE_RESET"};
    ResetPolicy reset_policy = ResetPolicy::always;
    OutputParams output;
    double checkpoint_interval_s = 5;
    std::vector<std::string> sensor_names;
    std::vector<InputParams> sensor_inputs;
    std::vector<CameraSetup> sensor_cameras;
    MarkerMap map;
    WallMap walls;
    /// As written in the configuration, empty if the map stands in it or is missing.
    std::string map_file, walls_file;
    /// A section that is not ours, as YAML: what a camera program looks for. Empty if missing.
    std::string detectors;

    /// The sensor's number, added with defaults if it is new. \throws ConfigError, with `where` in
    /// front, past Params::kMaxSensors and for a name that no key could hold
    int sensor(std::string_view name, const std::string& where = "configuration");
    /// Gives a sensor's camera its calibration, and it stays turned as it is.
    void calibrate(const std::string& name, const Intrinsics& intrinsics);
};

/// A configuration, map or key that cannot be used. what() names file, line, key, value and what
/// was expected.
class ConfigError : public std::runtime_error {
   public:
    using std::runtime_error::runtime_error;
};

/// One place in the configuration: a dotted key, the member behind it, what it may be and what it
/// means.
struct Field {
    /// Names of an enumeration's values, and access to it as a number.
    struct Choice {
        unsigned char* value;
        std::vector<std::string> names;
    };
    enum class Range { any, positive, not_negative, not_zero, probability, unset_or_any };

    std::string key;
    std::variant<double*, int*, std::string*, Choice> value;
    Range range;
    const char* meaning;
    std::function<void()> changed = {};  ///< to be called after `value` was set

    /// The value as text, as YAML would write it.
    [[nodiscard]] std::string text() const;
    /// \throws ConfigError with `where` in front if the text is not a value in the range
    void set(const std::string& text, const std::string& where) const;
    [[nodiscard]] bool unset() const;  ///< NaN: not written to files
};

/// Whether the key names a file of a map, or stands for the list written in its place.
[[nodiscard]] constexpr bool is_map(std::string_view key) noexcept {
    return key == "map" || key == "walls";
}

/// Likewise of any file: a map's or a camera's.
[[nodiscard]] constexpr bool is_file(std::string_view key) noexcept {
    constexpr std::string_view intrinsics = ".intrinsics";
    return is_map(key) || (key.size() > intrinsics.size() &&
                           key.substr(key.size() - intrinsics.size()) == intrinsics);
}

/// Every field of the configuration, in the order of the file. The pointers are into `config`.
[[nodiscard]] std::vector<Field> fields(Config& config);

/// The field of a key; creates the sensor that a `sensors.NAME.` key speaks of.
/// \throws ConfigError naming the nearest key
[[nodiscard]] Field field(Config& config, const std::string& key, const std::string& where);

/// Checks what no single field can: that the parts fit together. \throws ConfigError
void check(const Config& config, const std::string& where);

/// What a robot cannot do without, in words; empty if all is there.
[[nodiscard]] std::string missing(const Config& config);

}  // namespace pilotage
