// An update is a transaction: what cannot be fused is refused with its reason, and nothing changes.

#include "support/filters.hpp"
#include "support/linear_measurement.hpp"
#include "support/matchers.hpp"
#include "support/samples.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(EkfRefusalTest);

template <typename Model, typename Filter, typename Scalar, int M>
void expect_update_refused(UpdateFault reason, const Filter& filter, const Model& model,
                           const Vector<Scalar, M>& z, const Matrix<Scalar, M>& r) {
    for (const Fusion fusion : {Fusion::plain, Fusion::gate, Fusion::student_t}) {
        Filter after = filter;
        const auto report = after.update(model, z, r, Policy::make(fusion, 0.001, 4));
        EXPECT_FALSE(report.accepted());
        EXPECT_EQ(report.fault, reason) << "fusion " << int(fusion);
        EXPECT_EQ(report.weight, 0);
        EXPECT_TRUE(same_bits(after.state(), filter.state()));
        EXPECT_TRUE(same_bits(after.covariance(), filter.covariance()));
    }
}

/// A filter of N states with a sighting that it would take.
template <typename Scalar, int N>
struct EkfScene {
    Draw draw{7};
    Ekf<Scalar, N> filter = random_filter<Scalar, N>(draw);
    BearingElevationRange<Scalar> sighting{marker_in_sight(draw, filter)};
    Vector<Scalar, 3> z = sighting.linearize(filter.state().template head<3>()).value +
                          Vector<Scalar, 3>::Constant(Scalar(0.01));
    Matrix<Scalar, 3> r = Matrix<Scalar, 3>::Identity() * Scalar(0.01);

    void expect_refused_as(UpdateFault reason) const {
        expect_update_refused(reason, filter, sighting, z, r);
    }
};

template <typename Scalar, int N>
void expect_bad_values_refused() {
    EkfScene<Scalar, N> good;
    EXPECT_TRUE(Ekf(good.filter).update(good.sighting, good.z, good.r, Policy{}).accepted());
    for (const double bad : {kNan, kInf, -kInf})
        for (int i = 0; i < 3; ++i) {
            SCOPED_TRACE(::testing::Message() << bad << " in component " << i);
            auto scene = good;
            scene.z[i] = Scalar(bad);
            scene.expect_refused_as(UpdateFault::numeric);
            scene = good;
            scene.r(i, i) = Scalar(bad);
            scene.expect_refused_as(UpdateFault::numeric);
        }
}

TYPED_TEST(EkfRefusalTest, ValuesAndNoiseThatAreNotFinite) {
    expect_bad_values_refused<TypeParam, 3>();
    expect_bad_values_refused<TypeParam, 6>();
}

template <typename Scalar, int N>
void expect_impossible_noise_refused() {
    const EkfScene<Scalar, N> good;
    for (const double variance : {0.0, -1e-9, -0.01, -1e6})
        for (int i = 0; i < 3; ++i) {
            SCOPED_TRACE(::testing::Message() << "variance " << variance << " of component " << i);
            auto scene = good;
            scene.r(i, i) = Scalar(variance);
            scene.expect_refused_as(UpdateFault::numeric);
            const BearingOnly<Scalar> bearing{good.sighting.marker_above_sensor};
            expect_update_refused(UpdateFault::numeric, good.filter, bearing,
                                  Vector<Scalar, 1>(good.z[0]),
                                  Matrix<Scalar, 1>(Scalar(variance)));
        }
}

TYPED_TEST(EkfRefusalTest, NoiseThatIsZeroOrNegative) {
    expect_impossible_noise_refused<TypeParam, 3>();
    expect_impossible_noise_refused<TypeParam, 6>();
}

TYPED_TEST(EkfRefusalTest, NoiseThatIsCorrelatedByMoreThanOne) {
    EkfScene<TypeParam, 3> scene;
    scene.r(1, 0) = scene.r(0, 1) = TypeParam(0.011);
    scene.expect_refused_as(UpdateFault::numeric);
}

TYPED_TEST(EkfRefusalTest, NoNoiseOnACertainState) {
    EkfScene<TypeParam, 3> scene;
    scene.filter = {scene.filter.state(), Matrix<TypeParam, 3>::Zero()};
    scene.r.setZero();
    scene.expect_refused_as(UpdateFault::numeric);
}

TYPED_TEST(EkfRefusalTest, MarkerAtTheSensorItself) {
    EkfScene<TypeParam, 3> scene;
    scene.sighting.marker_above_sensor.template head<2>() = scene.filter.state().template head<2>();
    scene.expect_refused_as(UpdateFault::undefined);
    scene.sighting.min_ground_m = 0;  // the model lets it through, the filter does not
    scene.expect_refused_as(UpdateFault::numeric);
}

TYPED_TEST(EkfRefusalTest, ModelThatSaysItIsNotDefined) {
    Draw draw(8);
    const auto filter = random_filter<TypeParam, 3>(draw);
    const LinearMeasurement<TypeParam, 2, 3> model{draw.normal<TypeParam, 2, 3>(), false};
    expect_update_refused(UpdateFault::undefined, filter, model, Vector<TypeParam, 2>(0, 0),
                          Matrix<TypeParam, 2>(Matrix<TypeParam, 2>::Identity()));
}

TYPED_TEST(EkfRefusalTest, JacobianOrCovarianceThatIsNotFinite) {
    Draw draw(9);
    const auto filter = random_filter<TypeParam, 3>(draw);
    LinearMeasurement<TypeParam, 1, 3> model{draw.normal<TypeParam, 1, 3>()};
    const Matrix<TypeParam, 1> r(TypeParam(0.1));
    model.h(0, 1) = TypeParam(kNan);
    expect_update_refused(UpdateFault::numeric, filter, model, Vector<TypeParam, 1>(TypeParam(0)),
                          r);
    for (const double bad : {kNan, kInf}) {
        Matrix<TypeParam, 3> p = filter.covariance();
        p(1, 1) = TypeParam(bad);
        const EkfScene<TypeParam, 3> good;
        expect_update_refused(UpdateFault::numeric, Ekf<TypeParam, 3>(filter.state(), p),
                              good.sighting, good.z, good.r);
    }
}

TYPED_TEST(EkfRefusalTest, InnovationBeyondTheGateIsRefusedWithItsNis) {
    Draw draw(10);
    auto filter = random_filter<TypeParam, 3>(draw);
    const auto before = filter;
    const BearingOnly<TypeParam> sighting{marker_in_sight(draw, filter)};
    const Vector<TypeParam, 1> z =
        sighting.linearize(filter.state()).value + Vector<TypeParam, 1>(TypeParam(3));
    const Matrix<TypeParam, 1> r(TypeParam(1e-4));
    const auto report = filter.update(sighting, z, r, Policy::make(Fusion::gate, 0.5, 4));
    EXPECT_EQ(report.fault, UpdateFault::gated);
    EXPECT_GT(report.nis, 0.454937);
    EXPECT_NEAR(report.innovation[0], 3, 10 * kTight<TypeParam>);
    EXPECT_TRUE(same_bits(filter.state(), before.state()));
    EXPECT_TRUE(same_bits(filter.covariance(), before.covariance()));
}

}  // namespace
}  // namespace pilotage::test
