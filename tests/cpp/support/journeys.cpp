#include "support/journeys.hpp"

#include <Eigen/Cholesky>

namespace pilotage::test {

namespace {

constexpr double kPeriod_s = 0.02;

}  // namespace

std::vector<Sample> Journey::go(double seconds, double v_m_s, double omega_rad_s) {
    std::vector<Sample> samples;
    if (seq == 0) step(samples, 0, 0);  // from the first sample on, motion counts
    for (long i = std::lround(seconds / kPeriod_s); i > 0; --i) step(samples, v_m_s, omega_rad_s);
    return samples;
}

void Journey::step(std::vector<Sample>& samples, double v, double omega) {
    constexpr double half_track_m = 0.25;
    left_m_ += (v - omega * half_track_m + left_spin_m_s) * kPeriod_s;
    right_m_ += (v + omega * half_track_m + right_spin_m_s) * kPeriod_s;
    const double turn = (omega + carried_rad_s) * kPeriod_s;
    truth = after_arc(truth, v * kPeriod_s, turn);
    truth[kX] += carried_m_s * kPeriod_s;
    truth[kHeading] = wrap(truth[kHeading]);
    utime += kPeriod;
    ++seq;
    const double alive = gyro_scale != 0 ? 1e-7 * gyro_draw_.normal<double, 1>()(0) : 0;
    const double rate = gyro_scale * turn / kPeriod_s + gyro_bias + alive;
    if (gyro) samples.push_back(gyro_at(utime, rate, seq));
    if (encoders) samples.push_back(encoders_at(utime, left(), right(), seq));
    if (camera && seq % 5 == 0) look(samples);
}

void Journey::look(std::vector<Sample>& samples) {
    std::uint16_t index = 0;
    for (const Marker& marker : map_->markers()) {
        Vector<double, 3> seen = view(Pose<double>(truth + lie), marker);
        seen += noise * Vector<double, 3>(0.02, 0.02, 0.1).cwiseProduct(draw_.normal<double, 3>());
        Sample sample = sighting_at(utime, ids ? marker.id : kUnknownId,
                                    only(seen, bearing, elevation, range), index++);
        sample.seq = frames_;
        samples.push_back(sample);
    }
    ++frames_;
}

double contradiction(const Pose<double>& estimate, const Matrix<double, 3>& covariance,
                     const Pose<double>& truth) {
    const Pose<double> off = minus<double, 3>(truth, estimate);
    return off.dot(covariance.ldlt().solve(off));
}

}  // namespace pilotage::test
