#include "kernels.hpp"

#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/differential_drive.hpp"

#ifdef BENCH_SYMFORCE
#include "symforce_step.hpp"
#endif

namespace bench {
[[gnu::flatten]] void predict_pilotage(Ekf<double, 3>& filter, const Case& c) {
    filter.predict(Unicycle<double, Chord::midpoint>{}, c.u, c.gamma, c.q);
}

/// The same from two wheels, whose noise enters through a full B.
[[gnu::flatten]] void predict_pilotage_wheels(Ekf<double, 3>& filter, const Case& c) {
    filter.predict(DifferentialDrive<double>{1.4}, c.u, c.gamma, c.q);
}

void predict_by_hand(ScalarStep& filter, const Case& c) {
    filter.predict(c.u[0], c.u[1], c.gamma(0, 0), c.gamma(1, 0), c.gamma(1, 1), c.q.data());
}

[[gnu::flatten]] void predict6_pilotage(Ekf<double, 6>& filter, const Case& c) {
    const Calibrated<Unicycle<double, Chord::arc>, double> model{{}, 0.02};
    filter.predict(model, c.u, c.gamma, c.q6);
}

[[gnu::flatten]] Report update_pilotage(Ekf<double, 3>& filter, const Case& c,
                                        const Policy& policy) {
    return filter.update(c.sighting, c.z, diagonal(c.variances), policy);
}

bool update_by_hand(ScalarStep& filter, const Case& c) {
    const auto& m = c.sighting.marker_above_sensor;
    return filter.update(m[0], m[1], m[2], c.z.data(), c.variances.data());
}

[[gnu::flatten]] Report update6_pilotage(Ekf<double, 6>& filter, const Case& c,
                                         const Policy& policy) {
    return filter.update(c.sighting, c.z, diagonal(c.variances), policy);
}

SightingReport update_localizer(Ekf<double, 3>& filter, const Case& c, const Site& site) {
    return fuse_sighting(filter, c.sample, site.map, site.sensor, site.policy);
}

void predict_ukf(Ukf<double, 3>& filter, const Case& c) {
    filter.predict(Unicycle<double, Chord::midpoint>{}, c.u, c.gamma, c.q);
}

void predict6_ukf(Ukf<double, 6>& filter, const Case& c) {
    const Calibrated<Unicycle<double, Chord::arc>, double> model{{}, 0.02};
    filter.predict(model, c.u, c.gamma, c.q6);
}

Report update_ukf(Ukf<double, 3>& filter, const Case& c, const Policy& policy) {
    return filter.update(c.sighting, c.z, diagonal(c.variances), policy);
}

Report update6_ukf(Ukf<double, 6>& filter, const Case& c, const Policy& policy) {
    return filter.update(c.sighting, c.z, diagonal(c.variances), policy);
}

#ifdef BENCH_SYMFORCE
void predict_symforce(SymforceStep& filter, const Case& c) {
    const int now = filter.now, next = filter.now = 1 - now;
    sym::Predict<double>(filter.x[now], filter.p[now], c.u, c.gamma, c.q, &filter.x[next],
                         &filter.p[next]);
}

void update_symforce(SymforceStep& filter, const Case& c) {
    const int now = filter.now, next = filter.now = 1 - now;
    sym::Update<double>(filter.x[now], filter.p[now], c.sighting.marker_above_sensor, c.z,
                        c.variances, &filter.x[next], &filter.p[next]);
}
#endif

}  // namespace bench
