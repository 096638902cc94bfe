// A start that is given, honestly but unsurely, to a robot that sees no ids: it finds its place, or
// says that it cannot tell, but is never sure of another.

#include "support/journeys.hpp"
#include "support/localizers.hpp"
#include "support/sanitized.hpp"
#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

/// Twelve markers; symmetric ones look the same from the other side.
MarkerMap site(Draw& draw, bool symmetric) {
    std::vector<Marker> markers;
    for (std::int32_t id = 0; id < 12; id += 2) {
        const double x_m = draw.uniform(-12, 12), y_m = draw.uniform(-12, 12);
        markers.push_back({id, x_m, y_m, 0.5, 0});
        if (symmetric)
            markers.push_back({id + 1, -x_m, -y_m, 0.5, 0});
        else
            markers.push_back({id + 1, draw.uniform(-12, 12), draw.uniform(-12, 12), 0.5, 0});
    }
    return MarkerMap(markers);
}

/// The three nearest.
MarkerMap in_view(const MarkerMap& map, const Pose<double>& from) {
    std::vector<Marker> seen = map.markers();
    std::sort(seen.begin(), seen.end(), [&](const Marker& a, const Marker& b) {
        const auto far = [&](const Marker& m) {
            return std::hypot(m.x_m - from[kX], m.y_m - from[kY]);
        };
        return far(a) < far(b);
    });
    seen.resize(3);
    return MarkerMap(seen);
}

struct End {
    bool misled = false, right = false;
};

End drive_unsurely(bool symmetric, double sigma_m, unsigned seed) {
    Draw draw(seed);
    const MarkerMap map = site(draw, symmetric);
    MarkerMap seen;
    Journey journey(seen, seed);
    journey.ids = false;
    journey.truth = {draw.uniform(-6, 6), draw.uniform(-6, 6), draw.uniform(-3, 3)};
    Params params = gyro_params();
    const double sigma_rad = 0.2 + 0.1 * sigma_m;
    const Vector<double, 3> off = draw.normal<double, 3>();
    params.initial = {};
    params.initial.x_m = journey.truth[kX] + sigma_m * off[kX];
    params.initial.y_m = journey.truth[kY] + sigma_m * off[kY];
    params.initial.heading_rad = wrap(journey.truth[kHeading] + sigma_rad * off[kHeading]);
    params.initial.sigma_position_m = sigma_m;
    params.initial.sigma_heading_rad = sigma_rad;
    Robot robot(kKinds[0], params, map);
    End end;
    for (int frame = 0; frame < 100; ++frame) {
        seen = in_view(map, journey.truth);
        robot.add(journey.go(0.1, 0.4, 0.4));
        const bool there = (robot.pose() - journey.truth).head<2>().norm() < 1;
        const bool ok = robot.estimate().status == Status::ok;
        end.misled = end.misled || (ok && !there);
        end.right = ok && there;
    }
    return end;
}

TEST(UnsureStartTest, WithoutIdsIsRightOrUndecided) {
    const int runs = runs_of(repeats(30));
    for (const bool symmetric : {true, false})
        for (const double sigma_m : {1.0, 2.0, 4.0, 6.0}) {
            int misled = 0, right = 0;
            for (int run = 1; run <= runs; ++run) {
                const End end = drive_unsurely(symmetric, sigma_m, static_cast<unsigned>(run));
                misled += end.misled;
                right += end.right;
            }
            EXPECT_EQ(misled, 0) << sigma_m << " m, symmetric " << symmetric;
            EXPECT_GE(right, symmetric ? 0 : runs * 29 / 30) << sigma_m << " m";
            std::printf("%s, sigma %.0f m: misled %d, right %d of %d\n",
                        symmetric ? "symmetric" : "irregular", sigma_m, misled, right, runs);
        }
}

}  // namespace
}  // namespace pilotage::test
