#pragma once
/// \file
/// What became of a sample, and of a sighting in full.

#include <cstdint>

namespace pilotage {

enum class Verdict : std::uint8_t {
    pending,  ///< waits for the motion around it
    fused,
    // Rejected, by reason:
    bad_value,        ///< not finite, nothing measured, or a sigma that is not positive
    implausible,      ///< faster than the robot can be
    outside_image,    ///< a pixel that the camera has not, or where its lens shows nothing
    not_initialized,  ///< there is no pose to fuse it with yet; it serves to find one
    before_motion,    ///< older than the first motion sample
    late,             ///< older than the history window
    clock,            ///< its stamp contradicts the sender's other stamps
    not_allowed,      ///< a pose reset that the configuration does not allow
    duplicate,        ///< the same sample is there already
    no_motion,        ///< no motion sample came while it could wait
    counter_reset,    ///< encoder counts jumped; the motion of this step is unknown
    unknown_marker,   ///< no such id in the map
    too_close,        ///< the marker has no usable direction
    out_of_view,      ///< the marker is where the camera cannot see it
    gate,             ///< NIS above the gate
    numeric,          ///< the update would not have been finite and positive semi-definite
    no_match,         ///< without an id, and no marker of the map explains it
    ambiguous_match,  ///< without an id, and of two markers that explain it nearly as well
};
inline constexpr int kVerdicts = static_cast<int>(Verdict::ambiguous_match) + 1;

[[nodiscard]] constexpr bool rejected(Verdict v) noexcept {
    return v > Verdict::fused;
}

/// Refused before it got a place in the history; such a sighting is never judged again.
[[nodiscard]] constexpr bool refused_at_the_door(Verdict v) noexcept {
    return v >= Verdict::bad_value && v <= Verdict::duplicate && v != Verdict::before_motion &&
           v != Verdict::not_initialized;
}

/// Word for reports, statistics and logs.
[[nodiscard]] constexpr const char* name(Verdict v) noexcept {
    constexpr const char* names[kVerdicts] = {
        "pending",         "fused",         "bad_value",     "implausible",    "outside_image",
        "not_initialized", "before_motion", "late",          "clock",          "not_allowed",
        "duplicate",       "no_motion",     "counter_reset", "unknown_marker", "too_close",
        "out_of_view",     "gate",          "numeric",       "no_match",       "ambiguous_match"};
    return names[static_cast<int>(v)];
}

/// Unit of the value and the limit that decided.
[[nodiscard]] constexpr const char* unit(Verdict v) noexcept {
    switch (v) {
        case Verdict::late:
        case Verdict::clock:
            return "s";
        case Verdict::too_close:
            return "m";
        default:
            return "";
    }
}

/// A sighting's full story. Components in the order bearing [rad], elevation [rad], range [m], of
/// pixels u, v [px]; NaN where not measured or not computed.
struct SightingReport {
    std::int64_t utime;  ///< us, time of capture
    std::int32_t frame_seq;
    std::int32_t revision;  ///< counts up each time the sighting is fused again
    std::int32_t id;        ///< of the marker it was held against
    std::int32_t given_id;  ///< as the sensor said; kUnknownId where a marker had to be found
    std::uint16_t index;    ///< position in its frame
    std::uint8_t sensor;
    Verdict verdict;
    bool agrees;           ///< with the estimate: NIS within the gate, whatever fuses
    std::int32_t dof;      ///< number of components judged together: but for a wrong elevation, all
    double innovation[3];  ///< measured less predicted
    double sigma[3];       ///< square root of the diagonal of S
    double nis;
    double weight;        ///< robust weight in [0, 1]
    double value, limit;  ///< what decided a rejection, NaN where nothing is compared
};

}  // namespace pilotage
