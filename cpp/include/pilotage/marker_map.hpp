#pragma once
/// \file
/// The surveyed markers.

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "pilotage/state.hpp"

namespace pilotage {

struct Marker {
    std::int32_t id = 0;
    double x_m = 0, y_m = 0, z_m = 0;  ///< frame map, z above the ground
    double sigma_m = 0;                ///< of the survey, each coordinate
};

/// Markers sorted by id; built once, then only read.
class MarkerMap {
   public:
    MarkerMap() = default;
    /// \pre ids are unique and not negative, coordinates finite (the map file's loader checks)
    explicit MarkerMap(std::vector<Marker> markers) : markers_(std::move(markers)) {
        std::sort(markers_.begin(), markers_.end(),
                  [](const Marker& a, const Marker& b) { return a.id < b.id; });
    }

    /// The marker, or nullptr.
    [[nodiscard]] const Marker* find(std::int32_t id) const noexcept {
        const auto at =
            std::lower_bound(markers_.begin(), markers_.end(), id,
                             [](const Marker& m, std::int32_t key) { return m.id < key; });
        return at != markers_.end() && at->id == id ? &*at : nullptr;
    }

    [[nodiscard]] const std::vector<Marker>& markers() const noexcept { return markers_; }

   private:
    std::vector<Marker> markers_;
};

}  // namespace pilotage
