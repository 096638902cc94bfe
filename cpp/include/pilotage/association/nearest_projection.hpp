#pragma once
/// \file
/// Which markers an image's pixels are of, as Kiriy and Buehler 2002 have it (section 2): the map
/// is projected through the estimated pose, and a pixel is of the marker projected nearest, within
/// a radius. What the pose's uncertainty makes of it is not asked.

#include <cstddef>

#include "pilotage/held_pixel.hpp"

namespace pilotage {

/// What a pixel is of.
template <typename Scalar>
struct NearestProjection {
    std::int32_t id = kUnknownId;  ///< kUnknownId: no marker within the radius
    Scalar distance_squared = 0;   ///< px^2
};

/// Two pixels are never of one marker: the nearer one has it, the other is of none.
/// \param pixels (u, v) and label of each [px]; -1: any label
/// \param radius_px below which a projection is near
/// \param found one for each pixel
/// \param free whether a marker is to be found at all
template <typename Scalar, typename Free>
void find_nearest_projections(const Pose<Scalar>& robot, const MarkerMap& map,
                              const SensorParams& sensor, double radius_px,
                              const Sighting* const* pixels, std::size_t count,
                              NearestProjection<Scalar>* found, const Free& free) noexcept {
    for (std::size_t i = 0; i < count; ++i)
        found[i] = {kUnknownId, Scalar(radius_px) * Scalar(radius_px)};
    for (const Marker& marker : map.markers()) {
        if (!free(marker.id)) continue;
        const auto h = pixel_model<Scalar>(marker, sensor).linearize(robot);
        if (!h.defined) continue;
        for (std::size_t i = 0; i < count; ++i) {
            const std::int32_t label = map.wanted_label(pixels[i]->label);
            if (label >= 0 && marker.label != label) continue;
            const Scalar du = Scalar(pixels[i]->value[0]) - h.value[0];
            const Scalar dv = Scalar(pixels[i]->value[1]) - h.value[1];
            const Scalar distance_squared = du * du + dv * dv;
            if (distance_squared < found[i].distance_squared)
                found[i] = {marker.id, distance_squared};
        }
    }
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (found[i].id != found[j].id || found[i].id == kUnknownId) continue;
            const bool first = found[j].distance_squared <= found[i].distance_squared;
            found[first ? i : j].id = kUnknownId;
        }
}

}  // namespace pilotage
