#include "pilotage/examine.hpp"

#include <cmath>

namespace pilotage {

namespace {

constexpr std::int64_t kLastTime = std::int64_t{1}
                                   << 60;   // differences of such times fit in 64 bits
constexpr double kFastestTurn_rad_s = 100;  // no ground robot turns faster

/// What is wrong with the numbers of a reset; `pending` if nothing.
Verdict examine_numbers(const PoseReset& reset) noexcept {
    bool finite = true, plausible = true;
    const auto look = [&](double v, double limit) {
        finite = finite && std::isfinite(v);
        plausible = plausible && std::abs(v) <= limit;
    };
    for (const double v : reset.pose) look(v, kFarthest);
    for (const double v : reset.covariance) look(v, kUnsurest);
    look(reset.covariance[5], kUnsurestHeading);
    return !finite ? Verdict::bad_value : plausible ? Verdict::pending : Verdict::implausible;
}

bool usable(const Sighting& sighting) noexcept {
    int measured = 0;
    for (int i = 0; i < 3; ++i) {
        if (std::isinf(sighting.value[i])) return false;
        if (std::isnan(sighting.value[i])) continue;
        ++measured;
        const double sigma = sighting.sigma[i];
        if (!std::isnan(sigma) && !(sigma > 0 && std::isfinite(sigma))) return false;
    }
    return measured > 0;
}

}  // namespace

Matrix<double, 3> covariance_of(const PoseReset& reset) noexcept {
    Matrix<double, 3> p;
    for (int i = 0, at = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) p(i, j) = p(j, i) = reset.covariance[at++];
    return p;
}

Verdict examine(const Sample& sample, const Params& params) noexcept {
    if (sample.utime < -kLastTime || sample.utime > kLastTime) return Verdict::bad_value;
    const Sample::Payload& payload = sample.payload;
    switch (sample.stream) {
        case Stream::reset: {
            if (const Verdict v = examine_numbers(payload.reset); v != Verdict::pending) return v;
            return is_covariance(covariance_of(payload.reset)) ? Verdict::pending
                                                               : Verdict::bad_value;
        }
        case Stream::gyro:
            if (!std::isfinite(payload.gyro.rate_rad_s)) return Verdict::bad_value;
            return std::abs(payload.gyro.rate_rad_s) > kFastestTurn_rad_s ? Verdict::implausible
                                                                          : Verdict::pending;
        case Stream::motion: {
            if (params.motion.source == MotionSource::encoders) return Verdict::pending;
            const BodyVelocity& velocity = payload.velocity;
            if (!std::isfinite(velocity.v_m_s) || !std::isfinite(velocity.omega_rad_s))
                return Verdict::bad_value;
            return std::abs(velocity.v_m_s) > params.wheels.max_speed_m_s ||
                           std::abs(velocity.omega_rad_s) > kFastestTurn_rad_s
                       ? Verdict::implausible
                       : Verdict::pending;
        }
        case Stream::sighting:
            if (!usable(payload.sighting)) return Verdict::bad_value;
            for (const double v : payload.sighting.value)
                if (std::abs(v) > kFarthest) return Verdict::implausible;
            return Verdict::pending;
    }
    return Verdict::bad_value;
}

}  // namespace pilotage
