#include "pilotage/motion/unicycle.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(UnicycleTest);

template <typename Scalar>
using ArcUnicycle = Unicycle<Scalar, Chord::arc>;
template <typename Scalar>
using MidpointUnicycle = Unicycle<Scalar, Chord::midpoint>;

template <typename Scalar>
using Travel = Vector<Scalar, 2>;  // distance [m], turn [rad]

// The runnable example: a quarter of a circle of 2 m radius to the left, starting east.
TEST(Unicycle, QuarterCircleEndsBesideItsCentreLookingNorth) {
    const Unicycle<double, Chord::arc> model;
    const double turn = kPi<double> / 2;
    const auto step = model.linearize({10, 20, 0}, Travel<double>(2 * turn, turn));
    EXPECT_TRUE(same_pose<double>(step.next, {12, 22, turn}, 1e-12));
}

TYPED_TEST(UnicycleTest, StraightDriveKeepsHeading) {
    const Pose<TypeParam> start(1, 2, TypeParam(0.5));
    const Pose<TypeParam> end(1 + 3 * std::cos(TypeParam(0.5)), 2 + 3 * std::sin(TypeParam(0.5)),
                              TypeParam(0.5));
    EXPECT_TRUE(same_pose<TypeParam>(ArcUnicycle<TypeParam>{}.linearize(start, {3, 0}).next, end,
                                     kTight<TypeParam>));
    EXPECT_TRUE(same_pose<TypeParam>(MidpointUnicycle<TypeParam>{}.linearize(start, {3, 0}).next,
                                     end, kTight<TypeParam>));
}

TYPED_TEST(UnicycleTest, TurnOnTheSpotKeepsPosition) {
    const Pose<TypeParam> start(1, 2, 3);
    const auto next = ArcUnicycle<TypeParam>{}.linearize(start, {0, 1}).next;
    EXPECT_EQ(next.template head<2>(), start.template head<2>());
    EXPECT_NEAR(next[kHeading], 4 - 2 * kPi<TypeParam>, kTight<TypeParam>);
}

TYPED_TEST(UnicycleTest, MidpointIsThePaperToTheLetter) {  // eqs. 16 to 18
    for (const auto& x : poses<TypeParam>())
        for (const auto& u : travels<TypeParam>()) {
            const TypeParam middle = x[kHeading] + u[1] / 2;
            const Pose<TypeParam> expected(x[kX] + u[0] * std::cos(middle),
                                           x[kY] + u[0] * std::sin(middle), x[kHeading] + u[1]);
            EXPECT_TRUE(same_pose<TypeParam>(MidpointUnicycle<TypeParam>{}.linearize(x, u).next,
                                             expected, 50 * kTight<TypeParam>));
        }
}

TYPED_TEST(UnicycleTest, SlipTurnsTheDirectionOfTravelButNotTheRobot) {
    const TypeParam slip = TypeParam(0.2);
    const auto slipping =
        ArcUnicycle<TypeParam>{slip}.linearize({0, 0, 0}, {2, TypeParam(0.3)}).next;
    const auto turned = ArcUnicycle<TypeParam>{}.linearize({0, 0, slip}, {2, TypeParam(0.3)}).next;
    EXPECT_TRUE(close(slipping.template head<2>(), turned.template head<2>(), kTight<TypeParam>));
    EXPECT_NEAR(slipping[kHeading], 0.3, kTight<TypeParam>);
}

template <typename Model, typename Scalar>
Pose<Scalar> in_two_steps(const Model& model, const Pose<Scalar>& start, const Travel<Scalar>& u,
                          Scalar cut) {
    const auto middle = model.linearize(start, Travel<Scalar>(u * cut)).next;
    return model.linearize(middle, Travel<Scalar>(u * (1 - cut))).next;
}

TYPED_TEST(UnicycleTest, ArcCutInTwoEndsWhereTheWholeArcEnds) {
    const ArcUnicycle<TypeParam> model{TypeParam(-0.08)};
    for (const auto& u : travels<TypeParam>())
        for (const TypeParam cut : {TypeParam(0.25), TypeParam(0.5), TypeParam(0.9)}) {
            const Pose<TypeParam> start(1, 2, 3);
            EXPECT_TRUE(same_pose<TypeParam>(in_two_steps(model, start, u, cut),
                                             model.linearize(start, u).next, kTight<TypeParam>))
                << "u = " << u.transpose();
        }
}

TYPED_TEST(UnicycleTest, MidpointCutInTwoEndsElsewhere) {
    const Pose<TypeParam> start(0, 0, 0);
    const Travel<TypeParam> u(1, 1);
    const MidpointUnicycle<TypeParam> model;
    EXPECT_FALSE(same_pose<TypeParam>(in_two_steps(model, start, u, TypeParam(0.5)),
                                      model.linearize(start, u).next, 1e-2));
}

// The closed form 2 sin(t/2)/t in long double, on both sides of the switch at 0.1 rad.
TYPED_TEST(UnicycleTest, ChordSeriesJoinsTheClosedForm) {
    for (long double turn : {1e-3L, 0.05L, 0.0999999L, 0.1L, 0.1000001L, 0.15L, 0.5L}) {
        turn = TypeParam(turn);
        const auto step = ArcUnicycle<TypeParam>{}.linearize({0, 0, 0}, {1, TypeParam(turn)});
        const long double half = turn / 2, chord = std::sin(half) / half;
        const long double slope = (std::cos(half) - chord) / turn;
        const double digits = 10 * std::numeric_limits<TypeParam>::epsilon();
        EXPECT_NEAR(step.next.template head<2>().norm(), double(chord), digits);
        // Along the chord b's second column is its change by the turn, where the quotient cancels.
        const TypeParam along =
            step.b.col(1).template head<2>().dot(step.next.template head<2>().normalized());
        EXPECT_NEAR(along, double(slope), 10 * digits) << "turn " << double(turn);
    }
}

TYPED_TEST(UnicycleTest, JacobiansAreDerivatives) {
    for (const auto& x : poses<TypeParam>())
        for (const auto& u : travels<TypeParam>()) {
            expect_jacobians(ArcUnicycle<TypeParam>{}, x, u);
            expect_jacobians(ArcUnicycle<TypeParam>{TypeParam(-0.08)}, x, u);
            expect_jacobians(MidpointUnicycle<TypeParam>{}, x, u);
        }
}

}  // namespace
}  // namespace pilotage::test
