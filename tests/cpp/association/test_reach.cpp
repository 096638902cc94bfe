// The cheap look leaves out no marker that the gate would let in, and most of the others.

#include "pilotage/association/reach.hpp"

#include "pilotage/association/pairing.hpp"
#include "support/frames.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(ReachTest);

TYPED_TEST(ReachTest, HoldsAllThatTheGateLetsIn) {
    using Scalar = TypeParam;
    Draw draw(11);
    int held = 0, let_in = 0, total = 0;
    for (int round = 0; round < 20000; ++round) {
        SensorParams sensor;
        sensor.x_m = draw.uniform(-1, 1);
        sensor.y_m = draw.uniform(-1, 1);
        sensor.yaw_rad = draw.uniform(-3, 3);
        sensor.sigma_range_per_m = draw.uniform(0, 0.1);
        sensor.range_scale = draw.uniform(0.8, 1.2);
        const Policy policy = Policy::make(Fusion::student_t, 0.001, 4);
        const auto robot = draw.pose<Scalar>();
        const auto p = draw.covariance<Scalar, 3>(draw.log_uniform(1e-4, 1));
        const double away = draw.log_uniform(0.1, 20), to = draw.uniform(-3.1, 3.1);
        const Marker marker{1, double(robot[kX]) + away * std::cos(to),
                            double(robot[kY]) + away * std::sin(to), 0.5, 0.05};
        const Pose<double> from = robot.template cast<double>();
        Vector<double, 3> seen = view(from, marker, sensor);
        seen[0] += draw.uniform(-1, 1) * draw.log_uniform(0.01, 3);
        seen[2] += draw.uniform(-1, 1) * draw.log_uniform(0.01, 5);
        const Sighting sighting =
            Scene::of(only(seen, round % 3 != 0, round % 5 == 0, round % 3 != 1));

        const SensorPlace<Scalar> place(robot, p, sensor);
        const bool holds = Reach<Scalar>(place, sighting, sensor, policy).holds(marker);
        Deviation<Scalar> after(Vector<Scalar, 3>::Zero(), p);
        const auto pairing = pair_up(robot, marker, sighting, sensor);
        const auto fit = take(after, pairing);
        const bool in = fit.possible && !policy.beyond_gate(double(fit.nis), pairing.dof);
        ASSERT_TRUE(holds || !in) << "round " << round;
        held += holds;
        let_in += in;
        ++total;
    }
    EXPECT_GT(let_in, total / 5) << "the draws were to reach both sides";
    EXPECT_LT(let_in, 9 * total / 10);
    EXPECT_LT(held, let_in + (total - let_in) / 2);
}

}  // namespace
}  // namespace pilotage::test
