#pragma once
/// \file
/// What one marker shows at once: any list of components (bearing, elevation, range) as one
/// measurement.
///
/// A component is a value with `predict(LineOfSight)` and `kWraps`; a new one is a header like
/// bearing.hpp.

#include <tuple>
#include <utility>

#include "pilotage/angle.hpp"
#include "pilotage/sensing/line_of_sight.hpp"
#include "pilotage/sensing/measurement.hpp"

namespace pilotage {

/// What a marker shows from a sensor pose, and where it is.
template <typename Scalar, int M>
struct SightedMarker : Measurement<Scalar, M, kPoseStates> {
    Scalar dx = 0, dy = 0;  ///< to the marker over ground [m]
};

/// Components measured together from a sensor pose; runnable example:
/// tests/cpp/sensing/test_marker_sighting.cpp.
template <typename Scalar, typename... Components>
struct MarkerSighting {
    static constexpr int kStates = kPoseStates;
    static constexpr int kComponents = sizeof...(Components);
    using Values = Vector<Scalar, kComponents>;

    Vector<Scalar, 3> marker_above_sensor;  ///< m: x and y in frame map, z above the sensor
    std::tuple<Components...> components{};
    Scalar min_ground_m = Scalar(1e-6);  ///< nearer than this the marker has no usable direction

    /// Not defined nearer than min_ground_m.
    [[nodiscard]] SightedMarker<Scalar, kComponents> linearize(
        const Pose<Scalar>& sensor) const noexcept {
        const LineOfSight<Scalar> sight(sensor, marker_above_sensor);
        SightedMarker<Scalar, kComponents> h;
        h.defined = sight.ground >= min_ground_m;
        h.dx = sight.dx;
        h.dy = sight.dy;
        fill_rows(h, sight, std::make_index_sequence<sizeof...(Components)>{});
        return h;
    }

    /// Measured less predicted; bearings wrap here.
    [[nodiscard]] Values minus(const Values& z, const Values& predicted) const noexcept {
        constexpr bool wraps[] = {Components::kWraps...};
        return entries<Values>([&](int i, int) {
            const Scalar difference = z[i] - predicted[i];
            return wraps[i] ? wrap(difference) : difference;
        });
    }

   private:
    template <std::size_t... I>
    void fill_rows(SightedMarker<Scalar, kComponents>& h, const LineOfSight<Scalar>& sight,
                   std::index_sequence<I...>) const noexcept {
        (fill_row<static_cast<int>(I)>(h, std::get<I>(components).predict(sight)), ...);
    }

    template <int kRow>
    static void fill_row(SightedMarker<Scalar, kComponents>& h,
                         const Prediction<Scalar>& p) noexcept {
        h.value[kRow] = p.value;
        h.jacobian(kRow, kX) = p.by_x;
        h.jacobian(kRow, kY) = p.by_y;
        h.jacobian(kRow, kHeading) = p.by_heading;
    }
};

}  // namespace pilotage
