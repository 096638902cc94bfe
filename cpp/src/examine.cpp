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

/// Whether numbers that are finite or NaN are such as a robot may meet.
Verdict near(const double (&values)[3]) noexcept {
    for (const double v : values)
        if (std::abs(v) > kFarthest) return Verdict::implausible;
    return Verdict::pending;
}

template <int N>
bool is_definite(const Matrix<double, N>& p) noexcept {
    return p.allFinite() && is_covariance<N>(p) && Ldlt<double, N>(p).positive();
}

/// A sigma or variance from outside; NaN: as configured.
bool usable_spread(double spread) noexcept {
    return std::isnan(spread) || (spread > 0 && std::isfinite(spread));
}

bool usable(const Fix& fix) noexcept {
    const bool position = std::isfinite(fix.value[kX]) && std::isfinite(fix.value[kY]);
    const bool heading = std::isfinite(fix.value[kHeading]);
    const bool whole = (position || (std::isnan(fix.value[kX]) && std::isnan(fix.value[kY]))) &&
                       (heading || std::isnan(fix.value[kHeading]));
    if (!whole || !(position || heading)) return false;
    const Matrix<double, 3> p = symmetric_of(fix.covariance);
    if (p.array().isNaN().all()) return true;
    if (!position) return usable_spread(p(kHeading, kHeading));
    return heading ? is_definite<3>(p) : is_definite<2>(p.topLeftCorner<2, 2>());
}

bool usable(const Sighting& sighting) noexcept {
    int measured = 0;
    for (int i = 0; i < 3; ++i) {
        if (std::isinf(sighting.value[i])) return false;
        if (std::isnan(sighting.value[i])) continue;
        ++measured;
        if (!usable_spread(sighting.sigma[i])) return false;
    }
    return measured > 0;
}

/// Of a sensor of pixels.
Verdict examine_pixel(const Sighting& pixel, const CameraModel& camera) noexcept {
    for (int i = 0; i < 2; ++i)
        if (!std::isfinite(pixel.value[i]) || !usable_spread(pixel.sigma[i]))
            return Verdict::bad_value;
    const Vector<double, 2> at(pixel.value[0], pixel.value[1]);
    return camera.in_image(at) && camera.ray(at).defined ? Verdict::pending
                                                         : Verdict::outside_image;
}

}  // namespace

Matrix<double, 3> symmetric_of(const double (&lower)[6]) noexcept {
    Matrix<double, 3> p;
    for (int i = 0, at = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) p(i, j) = p(j, i) = lower[at++];
    return p;
}

Verdict examine(const Sample& sample, const Params& params) noexcept {
    if (sample.utime < -kLastTime || sample.utime > kLastTime) return Verdict::bad_value;
    if (is_measurement(sample.stream) && sample.source >= params.sensor_count)
        return Verdict::bad_value;
    const Sample::Payload& payload = sample.payload;
    switch (sample.stream) {
        case Stream::reset: {
            if (const Verdict v = examine_numbers(payload.reset); v != Verdict::pending) return v;
            return is_covariance(symmetric_of(payload.reset.covariance)) ? Verdict::pending
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
            if (const SensorParams& sensor = params.sensors[sample.source];
                sensor.measures == Measures::pixels)
                return examine_pixel(payload.sighting, sensor.camera);
            if (!usable(payload.sighting)) return Verdict::bad_value;
            return near(payload.sighting.value);
        case Stream::fix:
            return usable(payload.fix) ? near(payload.fix.value) : Verdict::bad_value;
        case Stream::beam: {
            const Beam& beam = payload.beam;
            if (!std::isfinite(beam.angle_rad) || !(beam.range_m > 0) ||
                !usable_spread(beam.sigma_m))
                return Verdict::bad_value;
            return near({beam.angle_rad, beam.range_m, 0});
        }
    }
    return Verdict::bad_value;
}

}  // namespace pilotage
