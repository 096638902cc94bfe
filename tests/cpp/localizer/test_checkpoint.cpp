// A restart with the pose of before: a hypothesis, until sightings agree or the wheels turn out not
// to have moved.

#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(CheckpointTest);

Params restart_params() {
    Params params = gyro_params();
    params.initial = {};
    params.gyro_bias.sigma = 0.01;
    params.distance_scale.sigma = 0.02;
    return params;
}

/// A drive with sightings, and where it ended.
struct Before {
    Journey journey{kAroundOrigin};
    Checkpoint checkpoint;
    Eigen::VectorXd state;
    Eigen::MatrixXd covariance;

    explicit Before(const LocalizerKind& kind) {
        Params params = restart_params();
        params.initial.x_m = params.initial.y_m = params.initial.heading_rad = 0;
        Robot robot(kind, params, kAroundOrigin);
        if (kind.states == kCalibratedStates) journey.gyro_bias = 0.005;
        robot.add(journey.go(3));
        robot.add(journey.go(7, 0.3, 0.3));
        checkpoint = robot.checkpoint();
        state = robot.state();
        covariance = robot.covariance();
    }
};

TEST_P(CheckpointTest, RestoresEveryBit) {
    const Before before(GetParam());
    EXPECT_EQ(before.checkpoint.utime, before.journey.utime);
    EXPECT_EQ(before.checkpoint.ticks.left, before.journey.left());
    EXPECT_EQ(before.checkpoint.ticks.right, before.journey.right());
    EXPECT_EQ(before.checkpoint.states, GetParam().states);
    Robot robot(GetParam(), restart_params(), kAroundOrigin);
    ASSERT_TRUE(robot.restore(before.checkpoint));
    EXPECT_TRUE(robot.has_pose());
    EXPECT_FALSE(robot.started());
    EXPECT_EQ(robot.state(), before.state);
    EXPECT_EQ(robot.covariance(), before.covariance);
    const Checkpoint again = robot.checkpoint();
    EXPECT_TRUE(same_bits(again.state, before.checkpoint.state));
    EXPECT_TRUE(same_bits(again.covariance, before.checkpoint.covariance));
    EXPECT_TRUE(again.ticks == before.checkpoint.ticks);
    EXPECT_EQ(robot.estimate().status, Status::waiting);
    EXPECT_EQ(robot.estimate().reason, Reason::no_motion);
}

TEST_P(CheckpointTest, UnmovedTicksConfirmIt) {
    Before before(GetParam());
    Robot robot(GetParam(), restart_params(), kAroundOrigin);
    ASSERT_TRUE(robot.restore(before.checkpoint));
    before.journey.camera = false;
    robot.add(before.journey.go(0.1));
    EXPECT_EQ(robot.estimate().status, Status::ok);
    EXPECT_TRUE(same_pose(robot.pose(), Pose<double>(before.state.head<3>()), 1e-3));
    EXPECT_NEAR(robot.covariance()(0, 0), before.covariance(0, 0), 1e-6);
}

TEST_P(CheckpointTest, MovedTicksDoNotAndItIsDoubted) {
    Before before(GetParam());
    before.journey.camera = false;
    (void)before.journey.go(0.1, 0.1, 0);  // while it was switched off
    Robot robot(GetParam(), restart_params(), kAroundOrigin);
    ASSERT_TRUE(robot.restore(before.checkpoint));
    robot.add(before.journey.go(0.1));
    EXPECT_EQ(robot.estimate().status, Status::initializing);
    EXPECT_EQ(robot.estimate().reason, Reason::unconfirmed);
    EXPECT_TRUE(same_pose(robot.pose(), Pose<double>(before.state.head<3>()), 1e-3))
        << "the ticks of before are not driven now";
    EXPECT_GT(robot.covariance()(0, 0), before.covariance(0, 0) + 0.01);
    EXPECT_GT(robot.covariance()(2, 2), before.covariance(2, 2) + 0.001);
    before.journey.camera = true;
    robot.add(before.journey.go(2));
    EXPECT_EQ(robot.estimate().status, Status::ok);
    EXPECT_TRUE(same_pose(robot.pose(), before.journey.truth, 0.1));
}

/// Counters that start at zero tell nothing.
TEST_P(CheckpointTest, ZeroTicksDoNot) {
    Before before(GetParam());
    before.checkpoint.ticks = {0, 0};
    Robot robot(GetParam(), restart_params(), kAroundOrigin);
    ASSERT_TRUE(robot.restore(before.checkpoint));
    robot.add(encoders_at(kSecond, 0, 0));
    EXPECT_EQ(robot.estimate().status, Status::initializing);
    EXPECT_GT(robot.covariance()(0, 0), before.covariance(0, 0) + 0.01);
}

TEST_P(CheckpointTest, OfAVelocityTellsNothingOfHavingMoved) {
    const Before before(GetParam());
    Params params = restart_params();
    params.motion.source = MotionSource::velocity;
    Robot robot(GetParam(), params, kAroundOrigin);
    ASSERT_TRUE(robot.restore(before.checkpoint));
    robot.add(velocity_at(kSecond, 0, 0));
    EXPECT_EQ(robot.estimate().status, Status::initializing);
}

TEST_P(CheckpointTest, WithAnotherNumberOfStatesGivesThePoseAlone) {
    const Before before(GetParam());
    for (const LocalizerKind& kind : kKinds) {
        if (kind.states == GetParam().states) continue;
        Robot robot(kind, restart_params(), kAroundOrigin);
        ASSERT_TRUE(robot.restore(before.checkpoint));
        EXPECT_TRUE(close(robot.state().head(3), before.state.head(3), 1e-6));
        EXPECT_TRUE(close(robot.covariance().topLeftCorner(3, 3),
                          before.covariance.topLeftCorner(3, 3), 1e-6));
        if (kind.states == kPoseStates) continue;
        EXPECT_EQ(robot.state()[kGyroBias], 0);
        EXPECT_NEAR(robot.covariance()(kGyroBias, kGyroBias), 1e-4, 1e-9);
        EXPECT_EQ(robot.covariance()(kX, kGyroBias), 0);
    }
}

TEST_P(CheckpointTest, OfNoFilterIsRefusedAndChangesNothing) {
    const Before before(GetParam());
    std::vector<Checkpoint> broken;
    const auto with = [&](auto change) {
        broken.push_back(before.checkpoint);
        change(broken.back());
    };
    for (const double bad : {kNan, kInf, -kInf, 1e11})
        for (int i = 0; i < 3; ++i) {
            with([&](Checkpoint& c) { c.state[i] = bad; });
            with([&](Checkpoint& c) { c.covariance(i, i) = bad; });
            with([&](Checkpoint& c) { c.covariance(i, (i + 1) % 3) = bad; });
        }
    for (int i = 0; i < 3; ++i) {
        with([&](Checkpoint& c) { c.covariance(i, i) *= -1; });
        with([&](Checkpoint& c) { c.covariance(i, i) = 0; });
        with([&](Checkpoint& c) { c.covariance(i, (i + 1) % 3) += 1; });
        with([&](Checkpoint& c) {
            c.covariance(i, (i + 1) % 3) = c.covariance((i + 1) % 3, i) = 1;
        });
    }
    with([](Checkpoint& c) {  // pairwise possible, together not
        c.covariance.setZero();
        c.covariance.topLeftCorner<3, 3>() << 1, 0.9, -0.9, 0.9, 1, 0.9, -0.9, 0.9, 1;
    });
    for (std::size_t i = 0; i < broken.size(); ++i) {
        Robot waiting(GetParam(), restart_params(), kAroundOrigin);
        EXPECT_FALSE(waiting.restore(broken[i])) << "case " << i;
        EXPECT_FALSE(waiting.has_pose());
        Robot configured(GetParam(), gyro_params(), kAroundOrigin);
        const Eigen::MatrixXd covariance = configured.covariance();
        EXPECT_FALSE(configured.restore(broken[i])) << "case " << i;
        EXPECT_TRUE(configured.has_pose());
        EXPECT_EQ(configured.state().head(3).norm(), 0);
        EXPECT_EQ(configured.covariance(), covariance);
    }
}

/// Carried away while switched off, wheels turned: whatever the sightings do to the pose, the
/// status is OK only when it is right.
TEST_P(CheckpointTest, ContradictedBySightingsIsNeverOk) {
    for (const double off : {1.0, 3.0, -2.0}) {
        SCOPED_TRACE(off);
        Before before(GetParam());
        Journey& journey = before.journey;
        journey.camera = false;
        (void)journey.go(0.1, 0.1, 0);
        journey.truth[kX] += off;
        journey.truth[kHeading] = wrap(journey.truth[kHeading] + 0.5 * off);
        journey.camera = true;
        Robot robot(GetParam(), restart_params(), kAroundOrigin);
        ASSERT_TRUE(robot.restore(before.checkpoint));
        for (int i = 0; i < 300; ++i) {
            robot.add(journey.go(0.1, 0.1, 0.1));
            const Estimate e = robot.estimate();
            if (e.status != Status::ok) continue;
            ASSERT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare) << "step " << i;
        }
        EXPECT_EQ(robot.estimate().status, Status::ok) << "found again";
    }
}

/// Carried away without a tick: confirmed by the wheels, until the first sightings.
TEST_P(CheckpointTest, CarriedWithoutATickIsNotOkOnceSightingsContradict) {
    Before before(GetParam());
    Journey& journey = before.journey;
    journey.truth[kX] += 3;
    Robot robot(GetParam(), restart_params(), kAroundOrigin);
    ASSERT_TRUE(robot.restore(before.checkpoint));
    robot.add(journey.go(1));
    for (int i = 0; i < 300; ++i) {
        robot.add(journey.go(0.1));
        const Estimate e = robot.estimate();
        if (e.status != Status::ok) continue;
        ASSERT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare) << "step " << i;
    }
}

}  // namespace
}  // namespace pilotage::test
