#include "explain.hpp"

#include <cmath>

#include "words.hpp"

namespace pilotage {

namespace {

/// A name from outside as it may stand in a line for a person.
std::string printable(std::string name) {
    constexpr std::size_t enough = 60;
    if (name.size() > enough) name = name.substr(0, enough) + "...";
    for (char& c : name)
        if (c < ' ' || c > '~') c = '?';
    return name;
}

}  // namespace

const char* name(Status status) noexcept {
    constexpr const char* names[] = {"WAITING",        "INITIALIZING", "OK",
                                     "DEAD_RECKONING", "AMBIGUOUS",    "LOST"};
    return names[static_cast<int>(status)];
}

const char* name(MotionState state) noexcept {
    constexpr const char* names[] = {"driving", "standing", "slipping", "lifted"};
    return names[static_cast<int>(state)];
}

std::string explain(const Assessment& a) {
    switch (a.reason) {
        case Reason::none:
        case Reason::no_pose:  // the engine names what it waits for
        case Reason::no_motion:
            return "";
        case Reason::unconfirmed:
            return words("%.0f of the %.0f sightings in a row that confirm the pose", a.value,
                         a.limit);
        case Reason::one_marker:
            return words("%.0f sightings agree, all of one marker: another one confirms the pose",
                         a.value);
        case Reason::found:
            return words("a pose is found; it has held for %.0f of %.0f frames: drive on", a.value,
                         a.limit);
        case Reason::rival:
            return words(
                "the sightings fit another pose nearly as well (%.1f nats, %.1f decide): drive on, "
                "or set the pose",
                a.value, a.limit);
        case Reason::elsewhere:
            return words(
                "another pose explains the latest sightings better by %.1f nats (limit %.1f): the "
                "robot was moved, or encoders, gyro or markers are wrong",
                a.value, a.limit);
        case Reason::disagreement:
            return words(
                "the sightings contradict the motion (mean NIS %.1f per degree of freedom, limit "
                "%.1f): encoders, gyro or markers are wrong",
                a.value, a.limit);
        case Reason::no_sighting:
            return words("no sighting that agrees for %.1f s, limit %.1f s", a.value, a.limit);
        case Reason::unsure:
            return words("95 %% radius %.2f m, limit %.2f m", a.value, a.limit);
        case Reason::motion_gap:
            return words("no motion for %.1f s, limit %.1f s", a.value, a.limit);
    }
    return "";
}

std::string disagreement(const Estimate& e) {
    const double off_rad = std::abs(e.disagreement_rad);
    if (e.gyro_left_out)
        return words("the gyro is off the encoders by %.2f rad in half a second and left out",
                     off_rad);
    if (e.motion == MotionState::slipping)
        return words("slipping: the encoders are off the gyro by %.2f rad in half a second",
                     off_rad);
    if (e.motion == MotionState::lifted)
        return words(
            "lifted: the encoders stand still, the gyro turned by %.2f rad in half a "
            "second",
            off_rad);
    return "";
}

std::string found_elsewhere(const Pose<double>& before, const Pose<double>& after) {
    const Pose<double> off = minus<double, 3>(after, before);
    return words("found elsewhere by the sightings: %.2f m and %.0f deg away",
                 std::hypot(off[kX], off[kY]), off[kHeading] * 180 / kPi<double>);
}

std::string wrong_type(const std::string& channel, const std::string& expected,
                       const std::string& got, std::int64_t fingerprint) {
    return channel + ": expected " + expected + ", got " + got +
           words(" with fingerprint %016llx", static_cast<unsigned long long>(fingerprint)) +
           "; is this the right channel, and is the sender built with the same .lcm files?";
}

std::string unknown_sensor(const std::string& channel, const std::string& sensor) {
    const std::string name = printable(sensor);
    return channel + ": a frame of sensor '" + name +
           "', which the configuration does not name; add sensors." + name;
}

}  // namespace pilotage
