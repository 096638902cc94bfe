#pragma once
/// \file
/// A frame of sightings without ids, and what an associator makes of it.

#include <vector>

#include "pilotage/association.hpp"
#include "support/robots.hpp"

namespace pilotage::test {

using Ids = std::vector<int>;  ///< of each sighting, or -1

/// A robot that takes itself to be at `pose`, before a map.
struct Scene {
    MarkerMap map;
    Pose<double> pose = {0, 0, 0};
    Vector<double, 3> sigma = {0.05, 0.05, 0.01};  ///< of the pose
    SensorParams sensor{};
    Policy policy = Policy::make(Fusion::student_t, 0.001, 4);
    std::vector<Sighting> frame{};
    int nodes = 0;  ///< of the last search

    /// What a robot that is `off` its pose sees of a marker; bearing and range unless told.
    Sighting see(std::int32_t id, const Pose<double>& off = {0, 0, 0}) const {
        return of(only(view(Pose<double>(pose + off), *map.find(id), sensor), true, false, true));
    }
    Sighting see_bearing(std::int32_t id, const Pose<double>& off = {0, 0, 0}) const {
        return of(only(view(Pose<double>(pose + off), *map.find(id), sensor), true, false, false));
    }
    static Sighting of(const Vector<double, 3>& values) {
        return {{values[0], values[1], values[2]}, {kNan, kNan, kNan}, kUnknownId, -1};
    }

    template <typename Scalar>
    Ids ids() {
        Ids ids;
        for (const Association& of : associate<Scalar>()) ids.push_back(of.id);
        return ids;
    }

    template <typename Scalar>
    std::vector<Association> associate() {
        Associator<Scalar> associator;
        return associate(associator);
    }

    template <typename Scalar>
    std::vector<Association> associate(Associator<Scalar>& associator) {
        associator.begin_frame();
        for (const Sighting& sighting : frame) associator.add(sighting);
        const Matrix<double, 3> covariance = sigma.cwiseAbs2().asDiagonal();
        associator.resolve(pose.template cast<Scalar>(), covariance.template cast<Scalar>(), map,
                           sensor, policy);
        nodes = associator.nodes();
        std::vector<Association> found;
        for (std::size_t i = 0; i < frame.size(); ++i) found.push_back(associator[i]);
        return found;
    }
};

}  // namespace pilotage::test
