// Which marker each sighting of a frame is of: what is plain, what is not, and what is of none.

#include "support/frames.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(AssociationTest);

/// Six markers, far apart as seen from the origin.
Scene around() {
    return {MarkerMap({{1, 6, 2, 0, 0},
                       {2, -3, 5, 0, 0},
                       {3, 4, -4, 0, 0},
                       {4, -5, -3, 0, 0},
                       {5, 1, 7, 0, 0},
                       {6, -7, 1, 0, 0}})};
}

TYPED_TEST(AssociationTest, FindsEachMarkerWhereTheyAreFarApart) {
    Scene scene = around();
    for (const int id : {4, 1, 6, 3}) scene.frame.push_back(scene.see(id, {0.05, -0.05, 0.01}));
    EXPECT_EQ(scene.ids<TypeParam>(), (Ids{4, 1, 6, 3}));
}

TYPED_TEST(AssociationTest, TakesEveryMixOfComponents) {
    Scene scene = around();
    for (int mix = 1; mix < 8; ++mix) {
        const auto seen = view(scene.pose, *scene.map.find(3), scene.sensor);
        scene.frame = {Scene::of(only(seen, mix & 1, mix & 2, mix & 4))};
        // All markers are on the ground, and so is the sensor; and 2, 4 and 3 are as far.
        const bool plain = (mix & 1) != 0;
        EXPECT_EQ(scene.ids<TypeParam>(), Ids{plain ? 3 : -1}) << mix;
    }
}

TYPED_TEST(AssociationTest, SightingsOfNoMarkerAreOfNone) {
    Scene scene = around();
    scene.frame = {scene.see(1), Scene::of({1.6, kNan, 3}), scene.see(2), Scene::of({-2, kNan, 9}),
                   Scene::of({0.32, kNan, 4.0})};
    EXPECT_EQ(scene.ids<TypeParam>(), (Ids{1, -1, 2, -1, -1}));
    EXPECT_EQ(scene.associate<TypeParam>()[1].verdict, Verdict::no_match);
    EXPECT_EQ(scene.associate<TypeParam>()[4].verdict, Verdict::no_match);
}

TYPED_TEST(AssociationTest, AnEmptyMapExplainsNothing) {
    Scene scene{MarkerMap()};
    scene.frame = {Scene::of({0, kNan, 3})};
    EXPECT_EQ(scene.associate<TypeParam>()[0].verdict, Verdict::no_match);
}

/// A heading error shifts all bearings alike: two of three come to lie on the next marker.
TYPED_TEST(AssociationTest, JointlyBeatsTheNearestNeighbour) {
    Scene scene{
        MarkerMap({{1, 3, -1.5, 0, 0}, {2, 3, -0.9, 0, 0}, {3, 3, 0.5, 0, 0}, {4, 3, 1.1, 0, 0}})};
    scene.sigma = {0.02, 0.02, 0.15};
    for (const int id : {1, 2, 3}) scene.frame.push_back(scene.see_bearing(id, {0, 0, -0.17}));
    const auto off = [&](std::size_t i, int id) {
        return std::abs(scene.frame[i].value[0] - view(scene.pose, *scene.map.find(id))[0]);
    };
    EXPECT_LT(off(0, 2), 0.1 * off(0, 1));
    EXPECT_LT(off(2, 4), 0.1 * off(2, 3));
    EXPECT_EQ(scene.ids<TypeParam>(), (Ids{1, 2, 3}));
}

TYPED_TEST(AssociationTest, OneSightingAloneOfTheSameIsAmbiguous) {
    Scene scene{MarkerMap({{1, 3, -1.5, 0, 0}, {2, 3, -0.6, 0, 0}})};
    scene.sigma = {0.02, 0.02, 0.15};
    scene.frame = {scene.see_bearing(1, {0, 0, -0.2})};
    EXPECT_EQ(scene.associate<TypeParam>()[0].verdict, Verdict::ambiguous_match);
    EXPECT_EQ(scene.ids<TypeParam>(), Ids{-1});
}

TYPED_TEST(AssociationTest, TwinsAreLeftOutAndOthersAreNot) {
    Scene scene{MarkerMap({{1, 4, 0, 0, 0}, {2, 4, 0.1, 0, 0}, {3, 0, 5, 0, 0}})};
    scene.frame = {scene.see(1), scene.see(3)};
    const auto found = scene.associate<TypeParam>();
    EXPECT_EQ(found[0].verdict, Verdict::ambiguous_match);
    EXPECT_EQ(found[1].id, 3);
}

TYPED_TEST(AssociationTest, TwinsSeenTogetherAreToldApartByTheirOrder) {
    Scene scene{MarkerMap({{1, 4, 0, 0, 0}, {2, 4, 0.3, 0, 0}})};
    scene.sensor.sigma_bearing_rad = 0.01;
    scene.sigma = {0.1, 0.1, 0.1};  // either alone may be of either
    scene.frame = {scene.see(2, {0, 0, 0.05}), scene.see(1, {0, 0, 0.05})};
    EXPECT_EQ(scene.ids<TypeParam>(), (Ids{2, 1}));
    scene.frame.pop_back();
    EXPECT_EQ(scene.ids<TypeParam>(), Ids{-1});
}

TYPED_TEST(AssociationTest, OfTwoSightingsOfOneMarkerNeitherIsRisked) {
    Scene scene = around();
    Sighting reflection = scene.see(1);
    reflection.value[0] += 0.01;
    scene.frame = {scene.see(1), scene.see(2), reflection};
    EXPECT_EQ(scene.ids<TypeParam>(), (Ids{-1, 2, -1}));
    scene.frame[2].value[2] += 0.35;  // far enough from it to be of none
    EXPECT_EQ(scene.ids<TypeParam>(), (Ids{1, 2, -1}));
}

TYPED_TEST(AssociationTest, AnIdTakesItsMarkerOutOfTheChoice) {
    Scene scene{MarkerMap({{1, 4, 0, 0, 0}, {2, 4, 0.1, 0, 0}})};
    scene.frame = {scene.see(1), scene.see(2)};
    scene.frame[1].id = 2;
    const auto found = scene.associate<TypeParam>();
    EXPECT_EQ(found[0].id, 1);
    EXPECT_EQ(found[1].id, 2);
    EXPECT_EQ(found[1].verdict, Verdict::pending);
}

TYPED_TEST(AssociationTest, AnIdThatTheMapDoesNotKnowStaysWhatItIs) {
    Scene scene = around();
    scene.frame = {scene.see(1), scene.see(2)};
    scene.frame[1].id = 77;
    EXPECT_EQ(scene.ids<TypeParam>(), (Ids{1, 77}));
}

TYPED_TEST(AssociationTest, ALabelLeavesItsMarkersOnly) {
    Scene scene{MarkerMap({{1, 4, 0, 0, 0, 5}, {2, 4, 0.1, 0, 0, 6}, {3, 0, 5, 0, 0}})};
    scene.frame = {scene.see(2), scene.see(3), scene.see(3)};
    scene.frame[0].label = 6;
    scene.frame[1].label = 6;  // where no marker of it stands
    EXPECT_EQ(scene.ids<TypeParam>(), (Ids{2, -1, 3}));
    scene.frame[0].label = -1;
    EXPECT_EQ(scene.ids<TypeParam>()[0], -1) << "without a label either may be meant";
}

TYPED_TEST(AssociationTest, AMapWithoutLabelsKnowsNoneOfThem) {
    Scene scene = around();
    scene.frame = {scene.see(1)};
    scene.frame[0].label = 6;
    EXPECT_EQ(scene.ids<TypeParam>(), Ids{1});
}

TYPED_TEST(AssociationTest, AMarkerTooCloseIsNoChoice) {
    Scene scene{MarkerMap({{1, 0.03, 0, 0, 0}})};
    scene.frame = {scene.see(1)};
    EXPECT_EQ(scene.associate<TypeParam>()[0].verdict, Verdict::no_match);
}

TYPED_TEST(AssociationTest, AMoreThanCrowdedSightingIsAmbiguous) {
    std::vector<Marker> heap;
    for (int i = 0; i < 40; ++i) heap.push_back({i, 5, 0.01 * i, 0, 0});
    Scene scene{MarkerMap(heap)};
    scene.frame = {scene.see(7)};
    EXPECT_EQ(scene.associate<TypeParam>()[0].verdict, Verdict::ambiguous_match);
}

/// Drawn scenes with the noise that is stated: hardly ever wrong, mostly found.
TYPED_TEST(AssociationTest, IsRightWhereItSpeaks) {
    Draw draw(5);
    int right = 0, wrong = 0, strays_taken = 0, strays = 0, total = 0;
    for (int round = 0; round < 1000; ++round) {
        std::vector<Marker> markers;
        for (int i = 0; i < 12; ++i)
            markers.push_back({i, draw.uniform(-10, 10), draw.uniform(-10, 10), 0, 0});
        Scene scene{MarkerMap(markers)};
        scene.sigma = {0.1, 0.1, 0.03};
        const Pose<double> off = scene.sigma.cwiseProduct(draw.normal<double, 3>());
        std::vector<int> truth;
        for (int i = 0; i < 5; ++i) {
            const bool stray = draw.uniform(0, 1) < 0.2;
            scene.frame.push_back(stray
                                      ? Scene::of({draw.uniform(-3, 3), kNan, draw.uniform(0, 10)})
                                      : scene.see(2 * i, off));
            scene.frame.back().value[0] += 0.02 * draw.normal<double, 1>()(0);
            scene.frame.back().value[2] += 0.1 * draw.normal<double, 1>()(0);
            truth.push_back(stray ? -1 : 2 * i);
        }
        const std::vector<int> ids = scene.ids<TypeParam>();
        for (std::size_t i = 0; i < ids.size(); ++i) {
            ++(truth[i] < 0 ? strays : total);
            if (truth[i] < 0)
                strays_taken += ids[i] >= 0;
            else if (ids[i] >= 0)
                ++(ids[i] == truth[i] ? right : wrong);
        }
    }
    SCOPED_TRACE(::testing::Message() << right << " right, " << wrong << " wrong of " << total
                                      << ", " << strays_taken << " of " << strays << " strays");
    EXPECT_GE(right, 0.9 * total);
    EXPECT_LE(wrong, 0.003 * total);
    EXPECT_LE(strays_taken, 0.05 * strays) << "of those that fell near a marker";
}

}  // namespace
}  // namespace pilotage::test
