#pragma once
/// \file
/// The envelope of an ultrasonic echo: L. Tamas et al., "State Estimation Based on Kalman Filtering
/// Techniques in Navigation", 2008, after Angrisani.

#include <cmath>

#include "pilotage/sensing/measurement.hpp"

namespace pilotage {

/// Places in the state of an echo.
enum EchoIndex : int {
    kEchoAmplitude = 0,  ///< A0, in the unit of the samples
    kTimeOfFlight = 1,   ///< tau [s], where the echo begins
    kEchoTime = 2,       ///< T [s], of emitter and receiver
    kEchoShape = 3,      ///< alpha, of emitter and receiver
};

inline constexpr int kEchoStates = 4;

/// Eq. 38 with the sign of its exponent put right: A0 s^alpha exp(-s) with s = (t - tau)/T, zero
/// before tau, highest at s = alpha. Not defined unless T and alpha are positive.
template <typename Scalar>
struct EchoEnvelope {
    static constexpr int kStates = kEchoStates;
    using Values = Vector<Scalar, 1>;

    Scalar time_s;  ///< t, of the sample

    [[nodiscard]] Measurement<Scalar, 1, kStates> linearize(
        const Vector<Scalar, kStates>& x) const noexcept {
        using std::exp;
        using std::log;
        const Scalar tau = x[kTimeOfFlight], time = x[kEchoTime], alpha = x[kEchoShape];
        Measurement<Scalar, 1, kStates> h;
        h.value.setZero();
        h.jacobian.setZero();
        h.defined = time > 0 && alpha > 0;
        if (!h.defined || !(time_s > tau)) return h;
        const Scalar s = (time_s - tau) / time, log_s = log(s);
        const Scalar shape = exp(alpha * log_s - s);
        const Scalar envelope = x[kEchoAmplitude] * shape;
        const Scalar by_s = envelope * (alpha - s) / s;
        h.value << envelope;
        h.jacobian << shape, -by_s / time, -by_s * s / time, envelope * log_s;
        return h;
    }

    [[nodiscard]] Values minus(const Values& z, const Values& predicted) const noexcept {
        return z - predicted;
    }
};

}  // namespace pilotage
