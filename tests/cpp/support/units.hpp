#pragma once
/// \file
/// The units of people in those of the code.

#include <cstdint>

#include "pilotage/angle.hpp"

namespace pilotage::test {

inline constexpr std::int64_t kSecond = 1'000'000;    ///< us
inline constexpr double kDegree = kPi<double> / 180;  ///< rad

}  // namespace pilotage::test
