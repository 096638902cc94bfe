// Headings in closed form, against exact geometry and against the published algorithm.

#include "pilotage/search/heading_equation.hpp"

#include "support/geometry.hpp"
#include "support/matchers.hpp"
#include "support/random.hpp"

namespace pilotage::test {
namespace {

/// True if one of the solutions is the heading.
bool finds(const HeadingEquation& equation, double heading) {
    const Headings found = equation.solve();
    for (int i = 0; i < found.count; ++i)
        if ((found.direction[i] - direction(heading)).norm() < 1e-6) return true;
    return false;
}

Point point_of(Draw& draw) {
    return {draw.uniform(-20, 20), draw.uniform(-20, 20)};
}

View bearing_view(const Clue& clue, const Pose<double>& place) {
    View view;
    view.measured = 1 << kBearing;
    view.place = place;
    view.along = clue.along;
    return view;
}

/// ToTal as published, algorithm 1: the robot's place, and D.
std::pair<Point, double> total(const Point m[3], const double bearing[3]) {
    const auto cot = [](double angle) { return 1 / std::tan(angle); };
    const Point one = m[0] - m[1], three = m[2] - m[1];
    const double t12 = cot(bearing[1] - bearing[0]), t23 = cot(bearing[2] - bearing[1]);
    const double t31 = (1 - t12 * t23) / (t12 + t23);
    const Point c12(one[0] + t12 * one[1], one[1] - t12 * one[0]);
    const Point c23(three[0] - t23 * three[1], three[1] + t23 * three[0]);
    const Point c31(three[0] + one[0] + t31 * (three[1] - one[1]),
                    three[1] + one[1] - t31 * (three[0] - one[0]));
    const double k31 = one.dot(three) + t31 * cross(one, three);
    const double d = (c12[0] - c23[0]) * (c23[1] - c31[1]) - (c12[1] - c23[1]) * (c23[0] - c31[0]);
    return {m[1] + k31 / d * Point(c12[1] - c23[1], c23[0] - c12[0]), d};
}

TEST(HeadingEquationTest, BothSolutionsSolveIt) {
    const HeadingEquation equation{3, -4, 2};
    const Headings found = equation.solve();
    ASSERT_EQ(found.count, 2);
    for (const Point& d : found.direction) {
        EXPECT_NEAR(d.norm(), 1, 1e-12);
        EXPECT_NEAR(3 * d[0] - 4 * d[1], 2, 1e-12);
    }
}

TEST(HeadingEquationTest, NoiseMayLeaveItJustWithoutASolutionButNotFar) {
    EXPECT_EQ((HeadingEquation{3, 4, 5.1}.solve().count), 1);
    EXPECT_EQ((HeadingEquation{3, 4, 6}.solve().count), 0);
    EXPECT_EQ((HeadingEquation{0, 0, 0}.solve().count), 0);
    EXPECT_EQ((HeadingEquation{kNan, 1, 0}.solve().count), 0);
}

TEST(HeadingEquationTest, ThreeBearingsFromThreePlacesGiveTheHeading) {
    Draw draw(1);
    for (int run = 0; run < 200; ++run) {
        const auto robot = draw.pose<double>();
        View views[3];
        Point markers[3];
        for (int i = 0; i < 3; ++i) {
            const Pose<double> place(draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-3, 3));
            markers[i] = robot.head<2>() + point_of(draw);
            views[i] = bearing_view(exact_clue(robot, place, markers[i], true, false), place);
        }
        const ThreeBearings three(views[0], views[1], views[2]);
        if (three.spread() < 0.05) continue;
        EXPECT_TRUE(finds(three.of(markers[0], markers[1], markers[2]), robot[kHeading])) << run;
    }
}

TEST(HeadingEquationTest, FromOnePlaceItIsTotalWithItsD) {
    Draw draw(2);
    for (int run = 0; run < 100; ++run) {
        const auto robot = draw.pose<double>();
        View views[3];
        Point markers[3];
        double bearings[3];
        for (int i = 0; i < 3; ++i) {
            markers[i] = robot.head<2>() + point_of(draw);
            const Clue clue = exact_clue(robot, {0, 0, 0}, markers[i], true, false);
            views[i] = bearing_view(clue, {0, 0, 0});
            bearings[i] = std::atan2(clue.along[1], clue.along[0]);
        }
        const ThreeBearings three(views[0], views[1], views[2]);
        if (three.spread() < 0.05) continue;
        const auto [place, d] = total(markers, bearings);
        EXPECT_TRUE(close(place, robot.head<2>(), 1e-6));
        const auto equation = three.of(markers[0], markers[1], markers[2]);
        const double lambdas = cross(views[1].along, views[2].along) *
                               cross(views[2].along, views[0].along) *
                               cross(views[0].along, views[1].along);
        const double squared = equation.a * equation.a + equation.b * equation.b;
        EXPECT_NEAR(squared, d * lambdas, 1e-9 * squared);
        EXPECT_EQ(equation.c, 0);
    }
}

TEST(HeadingEquationTest, OnTheCircleThroughTheMarkersThereIsNone) {
    View views[3];
    Point markers[3];
    for (int i = 0; i < 3; ++i) {
        markers[i] = 5 * direction(0.3 + 1.1 * i);
        const Pose<double> robot(5 * std::cos(-2.0), 5 * std::sin(-2.0), 0.4);
        views[i] = bearing_view(exact_clue(robot, {0, 0, 0}, markers[i], true, false), {0, 0, 0});
    }
    const auto equation =
        ThreeBearings(views[0], views[1], views[2]).of(markers[0], markers[1], markers[2]);
    EXPECT_NEAR(std::hypot(equation.a, equation.b), 0, 1e-12);
}

TEST(HeadingEquationTest, APointAndAnotherBearingOrDistanceGiveIt) {
    Draw draw(3);
    for (int run = 0; run < 200; ++run) {
        const auto robot = draw.pose<double>();
        const Pose<double> place(draw.uniform(-1, 1), draw.uniform(-1, 1), 0);
        const Point a = robot.head<2>() + point_of(draw), b = robot.head<2>() + point_of(draw);
        const Clue point = exact_clue(robot, {0.1, 0.2, 0}, a, true, true);
        EXPECT_TRUE(
            finds(point_and(point, exact_clue(robot, place, b, true, false)), robot[kHeading]));
        EXPECT_TRUE(
            finds(point_and(point, exact_clue(robot, place, b, false, true)), robot[kHeading]));
    }
}

}  // namespace
}  // namespace pilotage::test
