#include "pilotage/association/nearest_projection.hpp"

#include "pilotage/association.hpp"
#include "support/frames.hpp"
#include "support/images.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(NearestProjectionTest);

const MarkerMap kFourMarkers(
    {{1, 6, 2, 0.4, 0}, {2, 6, 1, 0.4, 0, 7}, {3, 5, -1, 0.2, 0}, {4, -5, 0, 0, 0}});

SensorParams paper_sensor() {
    SensorParams sensor = camera_sensor();
    sensor.association_radius_pixel = 64;
    return sensor;
}

Sighting near_marker(int id, double du, double dv, int label = -1, double heading_rad = 0) {
    const SensorParams sensor = paper_sensor();
    const Vector<double, 2> at =
        sensor.camera.project(in_sensor({0, 0, heading_rad}, *kFourMarkers.find(id), sensor)).value;
    return {{at[0] + du, at[1] + dv, kNan}, {kNan, kNan, kNan}, kUnknownId, label};
}

template <typename Scalar>
Ids ids_of(const std::vector<Sighting>& frame) {
    Associator<Scalar> associator;
    associator.begin_frame();
    for (const Sighting& sighting : frame) associator.add(sighting);
    const SensorParams sensor = paper_sensor();
    associator.resolve(Pose<Scalar>::Zero(), Matrix<Scalar, 3>::Identity() * Scalar(1e-6),
                       kFourMarkers, sensor, Policy::make(Fusion::student_t, 0.001, 4));
    Ids ids;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        ids.push_back(associator[i].id);
        EXPECT_EQ(associator[i].verdict == Verdict::no_match, ids.back() == kUnknownId);
    }
    return ids;
}

TYPED_TEST(NearestProjectionTest, APixelIsOfTheMarkerProjectedNearest) {
    EXPECT_EQ(ids_of<TypeParam>({near_marker(3, 40, -45), near_marker(1, -8, 9)}), (Ids{3, 1}));
    EXPECT_EQ(ids_of<TypeParam>({near_marker(3, 46, -46)}), Ids{-1}) << "65 pixels away";
}

TYPED_TEST(NearestProjectionTest, OfTwoPixelsTheNearerHasTheMarker) {
    EXPECT_EQ(
        ids_of<TypeParam>({near_marker(3, 5, 0), near_marker(3, 0, -4), near_marker(3, 9, 0)}),
        (Ids{-1, 3, -1}));
}

TYPED_TEST(NearestProjectionTest, AMarkerThatIsNamedIsNoChoiceForOthers) {
    Sighting named = near_marker(3, 0, 0);
    named.id = 3;
    EXPECT_EQ(ids_of<TypeParam>({near_marker(3, 5, 0), named}), (Ids{-1, 3}));
}

TYPED_TEST(NearestProjectionTest, LabelsSayWhichMarkersThereAre) {
    const double gap = near_marker(2, 0, 0).value[0] - near_marker(1, 0, 0).value[0];
    ASSERT_GT(std::abs(gap), 20);
    ASSERT_LT(std::abs(gap), 64);
    EXPECT_EQ(ids_of<TypeParam>({near_marker(1, 1, 1, 7)}), Ids{2});
    EXPECT_EQ(ids_of<TypeParam>({near_marker(1, 1, 1, -1)}), Ids{1});
}

TYPED_TEST(NearestProjectionTest, WithoutARadiusTheUncertaintyDecides) {
    SensorParams sensor = camera_sensor();
    Associator<TypeParam> associator;
    const Sighting right = near_marker(3, 0.6, -0.5, -1, 0.03),
                   left = near_marker(1, 0, 1, -1, 0.03);
    associator.begin_frame();
    associator.add(right);
    associator.add(left);
    const Policy policy = Policy::make(Fusion::student_t, 0.001, 4);
    const auto resolve = [&](double sigma) {
        associator.resolve(Pose<TypeParam>::Zero(),
                           Matrix<TypeParam, 3>::Identity() * TypeParam(sigma * sigma),
                           kFourMarkers, sensor, policy);
    };
    resolve(1e-3);
    for (std::size_t i : {0U, 1U}) EXPECT_EQ(associator[i].verdict, Verdict::no_match);
    resolve(0.03);
    EXPECT_EQ(associator[0].id, 3) << "the heading may be as wrong as that";
    EXPECT_EQ(associator[1].id, 1);
}

}  // namespace
}  // namespace pilotage::test
