#pragma once
/// \file
/// What is promised about the pose, and why not more.

#include <cstdint>

namespace pilotage {

/// What the status promises; the values are status_t's.
enum class Status : std::int8_t {
    waiting = 0,         ///< for a pose or for motion
    initializing = 1,    ///< a pose is assumed, sightings have not confirmed it
    ok = 2,              ///< the error is inside the covariance, and that is below the alert limit
    dead_reckoning = 3,  ///< no sighting for a while, or less sure than the alert limit asks
    ambiguous = 4,       ///< the sightings fit several poses alike
    lost = 5,            ///< not to be used: the sightings contradict it, or its error has no bound
};

/// Why the status is not ok.
enum class Reason : std::uint8_t {
    none,
    no_pose,
    no_motion,
    unconfirmed,   ///< sightings that agree, so far
    one_marker,    ///< sightings that agree, all of one marker
    found,         ///< frames that the pose found has held for, so far
    rival,         ///< nats by which the best pose explains the sightings better than the next
    elsewhere,     ///< nats by which another pose explains the sightings better
    disagreement,  ///< mean NIS per degree of freedom
    no_sighting,   ///< seconds without one that agrees
    unsure,        ///< 95 % radius [m]
    motion_gap,    ///< seconds without motion
};

struct Assessment {
    Status status = Status::waiting;
    Reason reason = Reason::no_pose;
    double value = 0, limit = 0;  ///< what decided, in the unit of the reason
};

}  // namespace pilotage
