#pragma once
/// \file
/// What an update did, in full: nothing is rejected silently.

#include "pilotage/state.hpp"

namespace pilotage {

/// Why the filter did not take an update.
enum class UpdateFault : unsigned char {
    none,
    gated,      ///< NIS above the gate
    undefined,  ///< the model has no prediction here (a marker at the sensor's own position)
    numeric,    ///< S not positive definite, or the result not finite and positive semi-definite
};

template <typename Scalar, int M>
struct UpdateReport {
    Vector<Scalar, M> innovation;  ///< minus(z, h(x))
    Matrix<Scalar, M> s;           ///< H P H' + R
    Scalar nis = 0;                ///< innovation' S^-1 innovation
    Scalar weight = 0;             ///< robust weight, 0 when not taken
    UpdateFault fault = UpdateFault::none;

    /// Of an update that came to no innovation.
    [[nodiscard]] static UpdateReport refused(UpdateFault fault) noexcept {
        UpdateReport report;
        report.innovation.setZero();
        report.s.setZero();
        report.fault = fault;
        return report;
    }

    [[nodiscard]] bool accepted() const noexcept { return fault == UpdateFault::none; }
};

}  // namespace pilotage
