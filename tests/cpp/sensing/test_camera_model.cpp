#include "pilotage/sensing/camera_model.hpp"

#include "support/jacobians.hpp"
#include "support/random.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(CameraModelTest);

constexpr Intrinsics kPinhole{640, 480, 610, 605, 322.5, 238, {}};

std::vector<CameraModel> cameras() {
    std::vector<CameraModel> result;
    for (const std::array<double, 8>& k : {std::array<double, 8>{},
                                           {-0.28, 0.09, 0.0012, -0.0007, 0, 0, 0, 0},
                                           {0.12, -0.25, -0.001, 0.0015, 0.11, 0, 0, 0},
                                           {0.8, -0.3, 0.0005, 0.001, 0.02, 1.1, 0.05, -0.01}}) {
        Intrinsics bent = kPinhole;
        bent.distortion = k;
        for (const double tilt : {0.0, 0.3}) result.emplace_back(bent, -0.4 * tilt, tilt);
    }
    return result;
}

template <typename Scalar>
std::vector<Vector<Scalar, 2>> image_pixels() {
    std::vector<Vector<Scalar, 2>> result{{Scalar(322.5), Scalar(238)}};
    Draw draw(3);
    for (int i = 0; i < 50; ++i)
        result.emplace_back(draw.uniform<Scalar>(0, 639), draw.uniform<Scalar>(0, 479));
    return result;
}

TYPED_TEST(CameraModelTest, JacobianOfProjectionIsTheDerivative) {
    using D = Dual<TypeParam>;
    for (const CameraModel& camera : cameras())
        for (const auto& pixel : image_pixels<TypeParam>()) {
            const Vector<TypeParam, 3> point = camera.ray(pixel).value * TypeParam(3);
            const auto h = camera.project(point);
            ASSERT_TRUE(h.defined);
            expect_rows_close(
                "by point", h.jacobian,
                derivative([&](const Vector<D, 3>& at) { return camera.project(at).value; },
                           point));
        }
}

TYPED_TEST(CameraModelTest, RayUndoesTheProjectionAndItsDerivative) {
    for (const CameraModel& camera : cameras())
        for (const auto& pixel : image_pixels<TypeParam>()) {
            const auto ray = camera.ray(pixel);
            ASSERT_TRUE(ray.defined);
            const auto back = camera.project(ray.value);
            EXPECT_TRUE(close(back.value, pixel, 20 * kTight<TypeParam>));
            const Matrix<TypeParam, 2> chain = back.jacobian * ray.jacobian;
            EXPECT_TRUE(close(chain, Matrix<TypeParam, 2>(Matrix<TypeParam, 2>::Identity()),
                              20 * kTight<TypeParam>));
        }
}

TYPED_TEST(CameraModelTest, DerivativeOfAnglesIsADifferenceQuotient) {
    const TypeParam step = std::is_same_v<TypeParam, float> ? TypeParam(1) : TypeParam(1e-3);
    for (const CameraModel& camera : cameras())
        for (const auto& pixel : image_pixels<TypeParam>()) {
            const auto h = camera.angles(pixel);
            for (int i = 0; i < 2; ++i) {
                Vector<TypeParam, 2> before = pixel, after = pixel;
                before[i] -= step;
                after[i] += step;
                const Vector<TypeParam, 2> slope =
                    (camera.angles(after).value - camera.angles(before).value) / (2 * step);
                EXPECT_NEAR((slope - h.jacobian.col(i)).norm(), 0, 2e-3 * h.jacobian.norm());
            }
        }
}

TYPED_TEST(CameraModelTest, LevelCameraLooksAlongX) {
    const CameraModel camera(kPinhole, 0, 0);
    const auto ahead = camera.project(Vector<TypeParam, 3>(2, 0, 0));
    EXPECT_TRUE(close(ahead.value, Vector<TypeParam, 2>(TypeParam(322.5), 238), kTight<TypeParam>));
    const auto aside = camera.project(Vector<TypeParam, 3>(1, TypeParam(0.1), TypeParam(0.2)));
    EXPECT_TRUE(close(aside.value, Vector<TypeParam, 2>(TypeParam(261.5), 117), kTight<TypeParam>));
}

TYPED_TEST(CameraModelTest, NoTwoPointsWithinTheLimitAreSeenAtOnePixel) {
    Draw draw(4);
    for (int i = 0; i < 200; ++i) {
        Intrinsics strange = kPinhole;
        for (double& k : strange.distortion) k = draw.uniform<double>(-0.5, 0.5);
        strange.distortion[2] *= 0.1;
        strange.distortion[3] *= 0.1;
        const CameraModel camera(strange, 0, 0);
        ASSERT_GT(camera.widest(), 0);
        const double radius = draw.uniform<double>(0, 0.98 * std::min(camera.widest(), 3.0));
        const double way = draw.uniform<double>(-3, 3);
        const Vector<TypeParam, 3> point(1, TypeParam(radius * std::cos(way)),
                                         TypeParam(radius * std::sin(way)));
        const auto seen = camera.project(point);
        ASSERT_TRUE(seen.defined);
        const auto ray = camera.ray(seen.value);
        ASSERT_TRUE(ray.defined);
        const TypeParam tolerance =
            std::is_same_v<TypeParam, float> ? TypeParam(0.02) : TypeParam(1e-7);
        EXPECT_NEAR((ray.value / ray.value[0] - point).norm(), 0, tolerance * (1 + radius));
    }
}

TYPED_TEST(CameraModelTest, WhatIsBehindOrFoldedOrNotANumberIsNotSeen) {
    using Point = Vector<TypeParam, 3>;
    using Pixel = Vector<TypeParam, 2>;
    Intrinsics barrel = kPinhole;
    barrel.distortion[0] = -0.3;
    const CameraModel camera(barrel, 0, 0);
    EXPECT_NEAR(camera.widest(), std::sqrt(1 / 0.9), 1e-12);  // where r - 0.3 r^3 turns
    const auto turn = TypeParam(camera.widest());
    EXPECT_TRUE(camera.project(Point(1, TypeParam(0.999) * turn, 0)).defined);
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    const TypeParam inf = std::numeric_limits<TypeParam>::infinity();
    for (const Point& point :
         {Point(1, TypeParam(1.001) * turn, 0), Point(-1, 0, 0), Point(0, 0, 0), Point(nan, 0, 0),
          Point(1, nan, 0), Point(1, inf, 0)}) {
        const auto h = camera.project(point);
        EXPECT_FALSE(h.defined) << point.transpose();
        EXPECT_TRUE(h.value.hasNaN());
        EXPECT_TRUE(h.jacobian.allFinite());
    }
    EXPECT_TRUE(camera.ray(Pixel(TypeParam(322.5 + 610 * 0.70), 238)).defined);
    for (const Pixel& pixel : {Pixel(TypeParam(322.5 + 610 * 0.71), 238), Pixel(nan, 0),
                               Pixel(0, inf), Pixel(-inf, inf)}) {
        EXPECT_FALSE(camera.ray(pixel).defined);
        EXPECT_FALSE(camera.angles(pixel).defined);
    }
    const CameraModel down(kPinhole, 0, kPi<double> / 2);
    EXPECT_FALSE(down.angles(Pixel(TypeParam(322.5), 238)).defined) << "straight below";
}

TYPED_TEST(CameraModelTest, ImageReachesHalfAPixelBeyondTheCentresOfItsPixels) {
    using Pixel = Vector<TypeParam, 2>;
    const CameraModel camera(kPinhole, 0, 0);
    EXPECT_TRUE(camera.in_image(Pixel(TypeParam(-0.5), TypeParam(479.4))));
    EXPECT_FALSE(camera.in_image(Pixel(TypeParam(-0.6), 0)));
    EXPECT_FALSE(camera.in_image(Pixel(TypeParam(639.5), 0)));
    EXPECT_FALSE(camera.in_image(Pixel(0, TypeParam(479.5))));
}

}  // namespace
}  // namespace pilotage::test
