// A robot that pitches and rolls as it drives, and a filter that knows of it.

#include "pilotage/tilt.hpp"

#include "pilotage/dead_reckoning.hpp"
#include "pilotage/fuse_sighting.hpp"
#include "support/journeys.hpp"
#include "support/localizers.hpp"
#include "support/textbook_ekf.hpp"
#include "support/tilted.hpp"

namespace pilotage::test {
namespace {

const std::vector<Marker> kPosts{
    {1, 4, 1, 1.2, 0}, {2, -3, 3, 1, 0}, {3, 2, -5, 1.5, 0}, {4, -2, -4, 0.9, 0}};

/// Frames of all posts, fused one sighting after the other by the filter with tilt, and at once by
/// a textbook filter of the pose whose R has the tilt over the whole frame. The values are off by
/// so little that both are linear.
TEST(TiltedFrameTest, WithoutACorrelationTimeIsANoiseThatAFrameHasInCommon) {
    constexpr double tiny = 1e-6;
    Params params;
    params.tilt = {0.02, 0.03, 0};
    SensorParams sensor;
    sensor.z_m = 0.8;
    sensor.yaw_rad = 0.7;
    const MarkerMap map(kPosts);
    const Pose<double> start(0.3, -0.2, 0.4);
    const Matrix<double, 3> p = Pose<double>(0.04, 0.03, 0.01).asDiagonal();
    auto filter = start_filter<double, 8>(start, p, params);
    TextbookEkf textbook{start, p};
    Draw draw(6);
    for (int frame = 0; frame < 3; ++frame) {
        settle_tilt(filter, 0.1, params.tilt);
        const auto n = static_cast<Eigen::Index>(2 * kPosts.size());
        Eigen::MatrixXd h(n, 3), r = Eigen::MatrixXd::Zero(n, n), by_tilt(n, 2);
        Eigen::VectorXd innovation(n);
        for (std::size_t i = 0; i < kPosts.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(2 * i);
            const Point3 level = view(start, kPosts[i], sensor);
            const auto error = draw.normal<double, 2>();
            const Point3 seen = level + Point3(tiny * error[0], tiny * error[1], 0);
            const auto by_hand =
                hold_against<double>(start, kPosts[i], {{seen[0], seen[1], kNan}, {}, 1, -1},
                                     sensor, Bearing<double>{}, Elevation<double>{});
            h.middleRows(row, 2) = by_hand.jacobian;
            innovation.segment(row, 2) =
                by_hand.innovation - by_hand.jacobian * minus<double, 3>(textbook.x, start);
            r(row, row) = std::pow(sensor.sigma_bearing_rad, 2);
            r(row + 1, row + 1) = std::pow(sensor.sigma_elevation_rad, 2);
            Point3 robot = level;
            robot[0] += sensor.yaw_rad;
            constexpr double step = 1e-5;
            by_tilt.block(row, 0, 2, 1) =
                (tilted(robot, step, 0) - tilted(robot, -step, 0)).head<2>() / (2 * step);
            by_tilt.block(row, 1, 2, 1) =
                (tilted(robot, 0, step) - tilted(robot, 0, -step)).head<2>() / (2 * step);
            const Sample sample = sighting_at(frame, kPosts[i].id, only(seen, true, true, false));
            const auto report = fuse_sighting(filter, sample, map, sensor, Policy{});
            ASSERT_EQ(report.verdict, Verdict::fused);
        }
        r += by_tilt * Vector<double, 2>(4e-4, 9e-4).asDiagonal() * by_tilt.transpose();
        (void)textbook.correct(innovation, h, r);
        const Pose<double> moved = (filter.state().head<3>() - start) / tiny;
        EXPECT_GT(moved.norm(), 0.1) << "something was to be learnt";
        EXPECT_TRUE(close(moved, (textbook.x - start) / tiny, 1e-4)) << "frame " << frame;
        EXPECT_TRUE(close(1e4 * filter.covariance().topLeftCorner<3, 3>(), 1e4 * textbook.p, 1e-4));
    }
}

/// Pitch and roll of a degree, new in each frame or over 3 s.
class Rocking {
   public:
    explicit Rocking(double tau_s, unsigned seed)
        : keep_(tau_s > 0 ? std::exp(-0.1 / tau_s) : 0), draw_(seed) {
        tilt_ = kSigma * draw_.normal<double, 2>();
    }

    static constexpr double kSigma = 0.0175;

    void tilt(Sample& sample) {
        if (sample.stream != Stream::sighting) return;
        if (sample.seq != frame_) {
            frame_ = sample.seq;
            tilt_ =
                keep_ * tilt_ + std::sqrt(1 - keep_ * keep_) * kSigma * draw_.normal<double, 2>();
        }
        double* value = sample.payload.sighting.value;
        const Point3 seen = tilted({value[0], value[1], 1}, tilt_[0], tilt_[1]);
        value[0] = seen[0];
        value[1] = seen[1];
    }

   private:
    double keep_;
    Draw draw_;
    Vector<double, 2> tilt_;
    std::int32_t frame_ = 0;
};

struct Outcome {
    double nees = 0, square_m2 = 0;  ///< means
};

/// Of a journey, the wheels and the gyro of which are.
NoiseParams exact() {
    NoiseParams noise;
    noise.wheel_m_per_sqrt_m = noise.position_m_per_sqrt_m = noise.gyro_rad_per_sqrt_s = 0;
    return noise;
}

enum class Knows { bearing, level, tilt };

/// At the end of seeded drives among high posts.
template <int N>
Outcome drives(double tau_s, Knows knows) {
    constexpr int kRuns = 150;
    constexpr double kNoise = 0.5;
    const MarkerMap map(kPosts);
    Outcome mean;
    for (unsigned run = 0; run < kRuns; ++run) {
        Params params = gyro_params();
        if (knows == Knows::tilt) params.tilt = {Rocking::kSigma, Rocking::kSigma, tau_s};
        params.noise = exact();
        params.sensors[0].fusion = Fusion::plain;
        params.sensors[0].sigma_bearing_rad *= kNoise;
        params.sensors[0].sigma_elevation_rad *= kNoise;
        Draw draw(run + 2000);
        const Vector<double, 3> n = draw.normal<double, 3>();
        const InitialParams& initial = params.initial;
        Tally tally;
        Localizer<double, N> localizer(params, map, tally);
        Journey journey(map, run);
        journey.truth = {initial.sigma_position_m * n[0], initial.sigma_position_m * n[1],
                         initial.sigma_heading_rad * n[2]};
        journey.range = false;
        journey.noise = kNoise;
        journey.elevation = true;  // the same noise in the bearings, with and without
        Rocking rocking(tau_s, run + 1000);
        for (Sample& sample : journey.go(5, 0.3, 0.4)) {
            rocking.tilt(sample);
            if (knows == Knows::bearing && sample.stream == Stream::sighting)
                sample.payload.sighting.value[1] = kNan;
            localizer.add(sample);
        }
        const Estimate e = localizer.estimate();
        mean.nees += contradiction(e.pose, e.covariance, journey.truth) / kRuns;
        mean.square_m2 += (e.pose - journey.truth).template head<2>().squaredNorm() / kRuns;
    }
    return mean;
}

TEST(TiltedRobotTest, AFilterThatKnowsOfItIsConsistentAndNoWorseThanBearingsAlone) {
    for (const double tau_s : {0.0, 3.0}) {
        const Outcome alone = drives<3>(tau_s, Knows::bearing),
                      level = drives<3>(tau_s, Knows::level),
                      knowing = drives<8>(tau_s, Knows::tilt);
        EXPECT_NEAR(knowing.nees, 3, 0.6) << "tau " << tau_s;
        EXPECT_GT(level.nees, 4.5) << "the tilt was to matter, tau " << tau_s;
        EXPECT_LT(knowing.square_m2, 1.04 * alone.square_m2) << "tau " << tau_s;
    }
}

}  // namespace
}  // namespace pilotage::test
