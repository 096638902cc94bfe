// The search is bounded, the same each time, takes nothing from the heap, and finds what trying all
// assignments finds.

#include <Eigen/LU>

#include "support/allocations.hpp"
#include "support/frames.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(JointSearchTest);

/// Rows of markers before a robot that hardly knows where it is.
Scene rows(int count) {
    std::vector<Marker> markers;
    for (int i = 0; i < count; ++i) markers.push_back({i, 4.0 + i % 3, 0.4 * i - 6, 0, 0});
    Scene scene{MarkerMap(markers)};
    scene.sigma = {0.15, 0.15, 0.05};
    Draw draw(4);
    for (int i = 0; i < count; ++i) {
        scene.frame.push_back(scene.see(i, {0.05, -0.05, 0.02}));
        scene.frame.back().value[0] += 0.02 * draw.normal<double, 1>()(0);
        scene.frame.back().value[2] += 0.1 * draw.normal<double, 1>()(0);
    }
    return scene;
}

TYPED_TEST(JointSearchTest, IsBounded) {
    Scene scene = rows(Associator<TypeParam>::kMaxSightings);
    const auto found = scene.associate<TypeParam>();
    EXPECT_EQ(scene.nodes, JointSearch<TypeParam>::kMaxNodes);
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_TRUE(found[i].id == kUnknownId || found[i].id == int(i))
            << "what could not be searched is left out";
}

TYPED_TEST(JointSearchTest, SaysTheSameEachTime) {
    Scene scene = rows(12);
    Associator<TypeParam> used;
    const auto first = scene.associate<TypeParam>(used);
    Scene other = rows(5);
    (void)other.associate<TypeParam>(used);
    const int nodes = scene.nodes;
    const auto second = scene.associate<TypeParam>(used);
    EXPECT_EQ(scene.nodes, nodes);
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].id, second[i].id);
        EXPECT_EQ(first[i].verdict, second[i].verdict);
    }
}

TYPED_TEST(JointSearchTest, TakesNothingFromTheHeap) {
    Scene scene = rows(20);
    Associator<TypeParam> associator;
    const Matrix<double, 3> covariance = scene.sigma.cwiseAbs2().asDiagonal();
    const AllocationCount allocations;
    associator.begin_frame();
    for (const Sighting& sighting : scene.frame) associator.add(sighting);
    associator.resolve(scene.pose.template cast<TypeParam>(), covariance.cast<TypeParam>(),
                       scene.map, scene.sensor, scene.policy);
    EXPECT_EQ(allocations.since(), 0);
}

/// log N(z - h; 0, H P H' + R) of all pairings as one vector of bearings and ranges, less the
/// strays' density: what the sequence of updates has to add up to.
double log_odds_at_once(const std::vector<const Pairing<double>*>& pairings,
                        const Matrix<double, 3>& covariance) {
    const auto rows = 2 * static_cast<Eigen::Index>(pairings.size());
    if (rows == 0) return 0;
    Eigen::MatrixXd h(rows, 3), r = Eigen::MatrixXd::Zero(rows, rows);
    Eigen::VectorXd innovation(rows);
    double stray = 0;
    Eigen::Index at = 0;
    for (const auto* p : pairings) {
        stray += p->stray;
        const int measured[] = {kBearing, kRange};
        for (int i = 0; i < 2; ++i) {
            h.row(at + i) = p->jacobian.row(measured[i]);
            innovation[at + i] = p->innovation[measured[i]];
            for (int j = 0; j < 2; ++j) r(at + i, at + j) = p->noise(measured[i], measured[j]);
        }
        at += 2;
    }
    const Eigen::MatrixXd s = h * covariance * h.transpose() + r;
    return -(innovation.dot(s.inverse() * innovation) + std::log(s.determinant())) / 2 - stray;
}

TEST(JointSearchOracleTest, FindsTheLikeliestOfAllAssignments) {
    Draw draw(3);
    for (int round = 0; round < 100; ++round) {
        Scene scene{MarkerMap(
            {{1, 4, 0, 0, 0.01}, {2, 4, 0.5, 0, 0}, {3, 4.5, 1, 0, 0}, {4, 5, -0.5, 0, 0}})};
        const Matrix<double, 3> covariance = draw.covariance<double, 3>(0.01);
        std::vector<Contender<double>> contenders(3);
        std::vector<Contender<double>*> order;
        for (Contender<double>& c : contenders) {
            Sighting seen = scene.see(draw.uniform(0, 1) < 0.5 ? 1 : 2);
            seen.value[0] += draw.uniform(-0.2, 0.2);
            seen.value[2] += draw.uniform(-0.4, 0.4);
            for (const Marker& marker : scene.map.markers())
                c.pairings[c.size++] = pair_up(scene.pose, marker, seen, scene.sensor);
            order.push_back(&c);
        }
        Policy wide = scene.policy;
        for (double& gate : wide.gate_nis) gate = 1e4;  // likelihood alone decides
        JointSearch<double> search(order.data(), 3, wide);
        search.run(covariance);
        ASSERT_TRUE(search.complete());

        double best = -1e9;
        std::vector<std::int32_t> best_ids;
        const auto each_of = [&](const auto& body) {
            for (int k = -1; k < 4; ++k) body(k);
        };
        each_of([&](int a) {
            each_of([&](int b) {
                each_of([&](int c) {
                    if ((a >= 0 && (a == b || a == c)) || (b >= 0 && b == c)) return;
                    std::vector<const Pairing<double>*> taken;
                    const int chosen[] = {a, b, c};
                    for (std::size_t i = 0; i < 3; ++i)
                        if (chosen[i] >= 0) taken.push_back(&contenders[i].pairings[chosen[i]]);
                    const double odds = log_odds_at_once(taken, covariance);
                    if (odds <= best) return;
                    best = odds;
                    best_ids = {contenders[0].id(a), contenders[1].id(b), contenders[2].id(c)};
                });
            });
        });
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(contenders[i].id(contenders[i].best), best_ids[i]) << "round " << round;
            const int k = contenders[i].best;
            if (k < 0) continue;
            EXPECT_NEAR(contenders[i].reached[k], best, 1e-6);
        }
    }
}

}  // namespace
}  // namespace pilotage::test
