#pragma once
/// \file
/// A robot that goes as it is told, what its sensors say of it, and what may go wrong with them.

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/random.hpp"
#include "support/robots.hpp"

namespace pilotage::test {

/// Truth and samples: encoders and gyro at 50 Hz, all markers in each tenth of a second.
class Journey {
   public:
    explicit Journey(const MarkerMap& map, unsigned seed = 1) : map_(&map), draw_(seed) {}

    // Healthy, unless told otherwise.
    double gyro_bias = 0, gyro_scale = 1;          ///< scale 0: stuck at zero
    double left_spin_m_s = 0, right_spin_m_s = 0;  ///< of a wheel on ice
    bool encoders = true, gyro = true, camera = true;
    bool bearing = true, elevation = false, range = true;
    bool ids = true;               ///< the camera tells which marker it sees
    double noise = 1;              ///< times the camera's sigmas of 0.02 rad and 0.1 m
    double carried_m_s = 0;        ///< along x, without the wheels
    double carried_rad_s = 0;      ///< likewise
    Pose<double> lie = {0, 0, 0};  ///< the camera sees from here instead, relative to the truth

    Pose<double> truth = {0, 0, 0};
    std::int64_t utime = 0;
    std::int32_t seq = 0;

    /// \return the samples of so much time, in order; the first ever is from a robot at rest
    std::vector<Sample> go(double seconds, double v_m_s = 0, double omega_rad_s = 0);

    [[nodiscard]] std::int64_t left() const { return std::llround(1000 * left_m_); }
    [[nodiscard]] std::int64_t right() const { return std::llround(1000 * right_m_); }
    /// The wheels' counters start again.
    void reset_ticks() { left_m_ = right_m_ = 0; }

   private:
    void step(std::vector<Sample>& samples, double v_m_s, double omega_rad_s);
    void look(std::vector<Sample>& samples);

    const MarkerMap* map_;
    Draw draw_, gyro_draw_{99};
    double left_m_ = 0, right_m_ = 0;
    std::int32_t frames_ = 0;
};

/// Three markers around the origin.
inline const MarkerMap kAroundOrigin({{1, 6, 2, 0.4, 0}, {2, -3, 5, 0.3, 0}, {3, 4, -4, 0.2, 0}});

/// The robot of plain_params() with a gyro.
[[nodiscard]] inline Params gyro_params() {
    return params_with(HeadingSource::gyro);
}

/// (truth - estimate) against the covariance: chi-square of three where that is honest.
[[nodiscard]] double contradiction(const Pose<double>& estimate,
                                   const Matrix<double, 3>& covariance, const Pose<double>& truth);

inline constexpr double kRare = 25.0;  ///< chi-square of three exceeds it once in 60,000

}  // namespace pilotage::test
