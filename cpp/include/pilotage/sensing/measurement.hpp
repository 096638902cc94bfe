#pragma once
/// \file
/// What a measurement model predicts.

#include "pilotage/state.hpp"

namespace pilotage {

/// h(x) with its Jacobian by the leading states.
template <typename Scalar, int M, int States>
struct Measurement {
    Vector<Scalar, M> value;
    Matrix<Scalar, M, States> jacobian;
    bool defined = true;  ///< whether there is anything to measure, and a derivative to trust
};

}  // namespace pilotage
