#include "pilotage/sensing/echo_envelope.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(EchoEnvelopeTest);

template <typename Scalar>
using Echo = Vector<Scalar, kEchoStates>;

/// Amplitude 2, begins after 3 ms (a wall at half a metre), rises for alpha T = 0.3 ms.
template <typename Scalar>
Echo<Scalar> echo() {
    return {2, Scalar(3e-3), Scalar(1e-4), 3};
}

template <typename Scalar>
Scalar envelope(double time_s, const Echo<Scalar>& x = echo<Scalar>()) {
    return EchoEnvelope<Scalar>{Scalar(time_s)}.linearize(x).value[0];
}

// The runnable example: the envelope is highest at tau + alpha T, where it is A0 (alpha/e)^alpha.
TEST(EchoEnvelope, PeaksAlphaTimesTAfterItBegins) {
    const double peak = envelope<double>(3.3e-3);
    EXPECT_NEAR(peak, 2 * std::pow(3 / std::exp(1), 3), 1e-12);
    EXPECT_LT(envelope<double>(3.29e-3), peak);
    EXPECT_LT(envelope<double>(3.31e-3), peak);
}

TYPED_TEST(EchoEnvelopeTest, BeforeItBeginsThereIsNothing) {
    for (const double time_s : {-1.0, 0.0, 2e-3, 3e-3}) {
        const auto h = EchoEnvelope<TypeParam>{TypeParam(time_s)}.linearize(echo<TypeParam>());
        EXPECT_TRUE(h.defined);
        EXPECT_EQ(h.value[0], 0);
        EXPECT_TRUE(h.jacobian.isZero(0));
    }
}

TYPED_TEST(EchoEnvelopeTest, LongAfterwardsItHasFaded) {
    EXPECT_NEAR(envelope<TypeParam>(6e-3), 0, 1e-6);
    EXPECT_EQ(envelope<TypeParam>(1e6), 0);
}

TYPED_TEST(EchoEnvelopeTest, WithoutAShapeItIsNotDefined) {
    const EchoEnvelope<TypeParam> sample{TypeParam(3.2e-3)};
    for (const int index : {kEchoTime, kEchoShape})
        for (const TypeParam bad : {TypeParam(0), TypeParam(-1e-4), TypeParam(NAN)}) {
            auto x = echo<TypeParam>();
            x[index] = bad;
            const auto h = sample.linearize(x);
            EXPECT_FALSE(h.defined);
            EXPECT_EQ(h.value[0], 0);
        }
}

TYPED_TEST(EchoEnvelopeTest, ExtremeStatesStayFinite) {
    const TypeParam tiny = std::numeric_limits<TypeParam>::min();
    for (const TypeParam tau : {TypeParam(0), TypeParam(1) - tiny, TypeParam(-1e10)})
        for (const TypeParam time : {TypeParam(1e-10), TypeParam(1), TypeParam(1e10)})
            for (const TypeParam alpha : {TypeParam(1), TypeParam(30)}) {
                const auto h = EchoEnvelope<TypeParam>{1}.linearize({1, tau, time, alpha});
                EXPECT_TRUE(h.value.allFinite() && h.jacobian.allFinite())
                    << tau << ' ' << time << ' ' << alpha;
            }
}

TYPED_TEST(EchoEnvelopeTest, JacobianIsTheDerivative) {
    Draw draw(8);
    for (int i = 0; i < 300; ++i) {
        const auto x =
            Echo<TypeParam>(draw.uniform<TypeParam>(0.1, 5), draw.uniform<TypeParam>(0, 2),
                            draw.uniform<TypeParam>(0.5, 2), draw.uniform<TypeParam>(1.1, 4));
        const auto since = draw.log_uniform<TypeParam>(0.01, 10);
        expect_jacobians(EchoEnvelope<TypeParam>{x[kTimeOfFlight] + since}, x);
    }
}

}  // namespace
}  // namespace pilotage::test
