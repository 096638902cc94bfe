// Ekf's equations, whose products are arranged for speed, against those of a textbook.

#include "support/filters.hpp"
#include "support/matchers.hpp"
#include "support/scalars.hpp"
#include "support/textbook_ekf.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(EkfTextbookTest);

template <typename Scalar, int N>
void expect_as_textbook(const Ekf<Scalar, N>& filter, const TextbookEkf& textbook) {
    EXPECT_TRUE(close(filter.state(), textbook.x, kTight<Scalar>));
    EXPECT_TRUE(close(filter.covariance(), textbook.p, kTight<Scalar>));
}

template <typename Scalar, int N>
void expect_textbook_prediction() {
    Draw draw(N);
    for (int i = 0; i < 200; ++i) {
        auto filter = random_filter<Scalar, N>(draw);
        auto dense = filter;
        auto textbook = TextbookEkf::of(filter);
        const Vector<Scalar, 2> u(draw.uniform<Scalar>(-1, 1), draw.uniform<Scalar>(-0.5, 0.5));
        const auto gamma = draw.covariance<Scalar, 2>(0.1);
        const Vector<Scalar, N> q = draw.normal<Scalar, N>().cwiseAbs2();
        const auto step = motion<Scalar, N>().linearize(filter.state(), u);  // before the step
        filter.predict(motion<Scalar, N>(), u, gamma, q);
        dense.propagate(step.next, step.a.dense(), step.b, gamma, q);
        textbook.predict(wide(step.next), wide(step.a.dense()), wide(step.b), wide(gamma), wide(q));
        expect_as_textbook(filter, textbook);
        expect_as_textbook(dense, textbook);
        EXPECT_EQ(filter.covariance(), (Matrix<Scalar, N>(filter.covariance().transpose())));
    }
}

TYPED_TEST(EkfTextbookTest, PredictionIsTheTextbooks) {
    expect_textbook_prediction<TypeParam, 3>();
    expect_textbook_prediction<TypeParam, 6>();
}

template <typename Sighting, typename Scalar, int N>
void expect_textbook_update() {
    constexpr int kRows = Sighting::kComponents;
    Draw draw(10 * N + kRows);
    for (int i = 0; i < 200; ++i) {
        auto filter = random_filter<Scalar, N>(draw);
        auto textbook = TextbookEkf::of(filter);
        const Sighting sighting{marker_in_sight(draw, filter)};
        const auto h = sighting.linearize(filter.state().template head<3>());
        const Vector<Scalar, kRows> z = h.value + draw.normal<Scalar, kRows>() * Scalar(0.3);
        const auto r = draw.covariance<Scalar, kRows>(0.05);
        const auto report = filter.update(sighting, z, r, Policy{});
        const double nis =
            textbook.correct(wide(sighting.minus(z, h.value)), wide(h.jacobian), wide(r));
        ASSERT_TRUE(report.accepted());
        EXPECT_EQ(report.weight, 1);
        EXPECT_NEAR(report.nis, nis, 10 * kTight<Scalar> * (1 + nis));
        expect_as_textbook(filter, textbook);
        EXPECT_EQ(filter.covariance(), (Matrix<Scalar, N>(filter.covariance().transpose())));
    }
}

TYPED_TEST(EkfTextbookTest, UpdateIsTheTextbooks) {
    expect_textbook_update<BearingOnly<TypeParam>, TypeParam, 3>();
    expect_textbook_update<BearingElevation<TypeParam>, TypeParam, 3>();
    expect_textbook_update<BearingElevationRange<TypeParam>, TypeParam, 3>();
    expect_textbook_update<BearingOnly<TypeParam>, TypeParam, 6>();
    expect_textbook_update<BearingElevation<TypeParam>, TypeParam, 6>();
    expect_textbook_update<BearingElevationRange<TypeParam>, TypeParam, 6>();
}

}  // namespace
}  // namespace pilotage::test
