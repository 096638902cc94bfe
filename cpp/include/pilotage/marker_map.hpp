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
    std::int32_t label = -1;           ///< class of look-alike markers, -1 none
};

/// Markers sorted by id; built once, then only read.
class MarkerMap {
   public:
    MarkerMap() = default;
    /// \pre ids are unique and not negative, coordinates finite (the map file's loader checks)
    explicit MarkerMap(std::vector<Marker> markers) : markers_(std::move(markers)) {
        std::sort(markers_.begin(), markers_.end(),
                  [](const Marker& a, const Marker& b) { return a.id < b.id; });
        if (!markers_.empty()) first_id_ = markers_.front().id;
        labelled_ = std::any_of(markers_.begin(), markers_.end(),
                                [](const Marker& m) { return m.label >= 0; });
        while (in_row_ < markers_.size() && place_of(markers_[in_row_].id) == in_row_) ++in_row_;
    }

    /// The marker, or nullptr.
    [[nodiscard]] const Marker* find(std::int32_t id) const noexcept {
        if (place_of(id) < in_row_) return &markers_[place_of(id)];
        const auto at =
            std::lower_bound(markers_.begin(), markers_.end(), id,
                             [](const Marker& m, std::int32_t key) { return m.id < key; });
        return at != markers_.end() && at->id == id ? &*at : nullptr;
    }

    [[nodiscard]] const std::vector<Marker>& markers() const noexcept { return markers_; }

    /// The label that a detection's marker must have, -1 for any: where no marker has one, labels
    /// of detections tell nothing.
    [[nodiscard]] std::int32_t wanted_label(std::int32_t label) const noexcept {
        return labelled_ && label >= 0 ? label : -1;
    }

   private:
    /// If ids count up by one, as they mostly do.
    [[nodiscard]] std::uint64_t place_of(std::int32_t id) const noexcept {
        return static_cast<std::uint64_t>(id - first_id_);
    }

    std::vector<Marker> markers_;
    std::int64_t first_id_ = 0;
    bool labelled_ = false;
    std::uint64_t in_row_ = 0;  // so many markers at the front are at the place of their id
};

}  // namespace pilotage
