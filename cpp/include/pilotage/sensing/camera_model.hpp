#pragma once
/// \file
/// From points to pixels and back, by OpenCV's camera: a pinhole with radial and tangential
/// distortion ("Camera Calibration and 3D Reconstruction", https://docs.opencv.org/4.x/d9/d0c).

#include <algorithm>
#include <cmath>
#include <limits>

#include "pilotage/angle.hpp"
#include "pilotage/sensing/intrinsics.hpp"
#include "pilotage/sensing/measurement.hpp"

namespace pilotage {

/// Points are in the level sensor frame: origin at the sensor, x along its forward axis in the
/// horizontal plane (the mounting's yaw), y left, z up. There the camera body is turned by
/// R = Ry(pitch) Rx(roll): a positive pitch looks down, a positive roll lowers the right side.
/// OpenCV's camera frame has x right, y down and z forward in the body.
///
/// The parameters are double, the arithmetic is in the scalar of its arguments. What is long is not
/// inlined, since its code counts for more than the call.
class CameraModel {
   public:
    CameraModel() = default;
    CameraModel(const Intrinsics& intrinsics, double roll_rad, double pitch_rad) noexcept
        : intrinsics_(intrinsics),
          roll_rad_(roll_rad),
          pitch_rad_(pitch_rad),
          widest_(find_widest()) {
        const double cr = std::cos(roll_rad), sr = std::sin(roll_rad);
        const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad);
        // The body's (forward, left, up) is the camera's (z, -x, -y).
        rotation_ << -sp * sr, -sp * cr, cp,  //
            -cr, sr, 0,                       //
            -cp * sr, -cp * cr, -sp;
    }

    [[nodiscard]] const Intrinsics& intrinsics() const noexcept { return intrinsics_; }
    [[nodiscard]] double roll_rad() const noexcept { return roll_rad_; }
    [[nodiscard]] double pitch_rad() const noexcept { return pitch_rad_; }
    /// From OpenCV's camera frame to the level sensor frame.
    [[nodiscard]] const Matrix<double, 3>& rotation() const noexcept { return rotation_; }
    /// Tangent of the angle to the optical axis within which the distortion is one-to-one.
    [[nodiscard]] double widest() const noexcept { return widest_; }

    template <typename Scalar>
    [[nodiscard]] bool in_image(const Vector<Scalar, 2>& pixel) const noexcept {
        return pixel[0] >= -0.5 && pixel[0] < intrinsics_.width_px - 0.5 && pixel[1] >= -0.5 &&
               pixel[1] < intrinsics_.height_px - 0.5;
    }

    /// (u, v) [px] of a point [m], with the derivative by the point. Not defined, and NaN, behind
    /// the camera and beyond `widest`.
    template <typename Scalar>
    [[nodiscard, gnu::noinline]] Measurement<Scalar, 2, 3> project(
        const Vector<Scalar, 3>& point) const noexcept {
        const Matrix<Scalar, 3> rotation = rotation_.template cast<Scalar>();
        const Vector<Scalar, 3> at = rotation.transpose() * point;
        const Scalar most = Scalar(widest_) * at[2];
        Measurement<Scalar, 2, 3> h;
        h.defined = at[2] > 0 && at[0] * at[0] + at[1] * at[1] <= most * most;
        if (!h.defined) return undefined<Scalar, 2, 3>();
        const Scalar per_depth = 1 / at[2];
        const Vector<Scalar, 2> straight(at[0] * per_depth, at[1] * per_depth);
        const Bent<Scalar> bent = bend(straight);
        Matrix<Scalar, 2, 3> by_camera;
        by_camera.template leftCols<2>() = bent.jacobian * per_depth;
        by_camera.col(2) = bent.jacobian * straight * -per_depth;
        h.jacobian = by_camera * rotation.transpose();
        h.value = bent.point;
        scale_rows(h, Scalar(intrinsics_.fx_px), Scalar(intrinsics_.fy_px));
        h.value[0] += Scalar(intrinsics_.cx_px);
        h.value[1] += Scalar(intrinsics_.cy_px);
        return h;
    }

    /// Unit vector towards what is seen at a pixel, with the derivative by the pixel. Not defined,
    /// and NaN, where no point within `widest` is seen.
    template <typename Scalar>
    [[nodiscard, gnu::noinline]] Measurement<Scalar, 3, 2> ray(
        const Vector<Scalar, 2>& pixel) const noexcept {
        const Vector<Scalar, 2> per_focal(1 / Scalar(intrinsics_.fx_px),
                                          1 / Scalar(intrinsics_.fy_px));
        const Vector<Scalar, 2> bent((pixel[0] - Scalar(intrinsics_.cx_px)) * per_focal[0],
                                     (pixel[1] - Scalar(intrinsics_.cy_px)) * per_focal[1]);
        Measurement<Scalar, 3, 2> h;
        Vector<Scalar, 2> straight;
        Matrix<Scalar, 2> by_bent;
        h.defined = straighten(bent, straight, by_bent);
        if (!h.defined) return undefined<Scalar, 3, 2>();
        const Matrix<Scalar, 3> rotation = rotation_.template cast<Scalar>();
        using std::sqrt;
        const Scalar per_length =
            1 / sqrt(1 + straight[0] * straight[0] + straight[1] * straight[1]);
        h.value = rotation * Vector<Scalar, 3>(straight[0], straight[1], Scalar(1)) * per_length;
        const Matrix<Scalar, 3> across =
            (Matrix<Scalar, 3>::Identity() - h.value * h.value.transpose()) * per_length;
        h.jacobian = across * rotation.template leftCols<2>() * by_bent;
        h.jacobian.col(0) *= per_focal[0];
        h.jacobian.col(1) *= per_focal[1];
        return h;
    }

    /// (azimuth left positive, elevation up positive) [rad] of what is seen at a pixel, with the
    /// derivative by the pixel: bearing and elevation of a sighting. Not defined as for `ray`, and
    /// straight above or below.
    template <typename Scalar>
    [[nodiscard]] Measurement<Scalar, 2, 2> angles(const Vector<Scalar, 2>& pixel) const noexcept {
        using std::sqrt;
        const Measurement<Scalar, 3, 2> r = ray(pixel);
        const Scalar x = r.value[0], y = r.value[1], z = r.value[2];
        const Scalar ground_squared = x * x + y * y;
        Measurement<Scalar, 2, 2> h;
        h.defined = r.defined && ground_squared > std::numeric_limits<float>::epsilon();
        if (!h.defined) return undefined<Scalar, 2, 2>();
        const Scalar ground = sqrt(ground_squared);
        h.value << direction_of(x, y), direction_of(ground, z);
        Matrix<Scalar, 2, 3> by_ray;
        by_ray << -y / ground_squared, x / ground_squared, Scalar(0),  //
            -x * z / ground, -y * z / ground, ground;
        h.jacobian = by_ray * r.jacobian;
        return h;
    }

   private:
    static constexpr double kMostTangent = 100;  // 89.4 degrees off the axis
    static constexpr int kMostSteps = 50;        // of Newton's method; four or five are usual
    static constexpr int kMostHalvings = 20;

    /// Image coordinates of focal length one as the lens bends them, and the derivative, which is
    /// symmetric.
    template <typename Scalar>
    struct Bent {
        Vector<Scalar, 2> point;
        Matrix<Scalar, 2> jacobian;
    };

    /// (1 + k1 s + k2 s^2 + k3 s^3) / (1 + k4 s + k5 s^2 + k6 s^3) and its derivative by s, the
    /// radius squared.
    template <typename Scalar>
    struct Radial {
        Scalar denominator, value, slope;

        Radial(const std::array<double, Intrinsics::kMostCoefficients>& k, Scalar s) noexcept
            : denominator(cubic(k[5], k[6], k[7], s)) {
            value = cubic(k[0], k[1], k[4], s) / denominator;
            slope = (cubic_slope(k[0], k[1], k[4], s) - value * cubic_slope(k[5], k[6], k[7], s)) /
                    denominator;
        }

       private:
        static Scalar cubic(double a, double b, double c, Scalar s) noexcept {
            return 1 + s * (Scalar(a) + s * (Scalar(b) + s * Scalar(c)));
        }
        static Scalar cubic_slope(double a, double b, double c, Scalar s) noexcept {
            return Scalar(a) + s * (Scalar(2 * b) + s * Scalar(3 * c));
        }
    };

    template <typename Scalar, int M, int States>
    [[nodiscard]] static Measurement<Scalar, M, States> undefined() noexcept {
        Measurement<Scalar, M, States> h;
        h.defined = false;
        h.value.setConstant(Scalar(std::numeric_limits<double>::quiet_NaN()));
        h.jacobian.setZero();
        return h;
    }

    template <typename Measured, typename Scalar>
    static void scale_rows(Measured& h, Scalar first, Scalar second) noexcept {
        h.value[0] *= first;
        h.value[1] *= second;
        h.jacobian.row(0) *= first;
        h.jacobian.row(1) *= second;
    }

    template <typename Scalar>
    [[nodiscard]] Bent<Scalar> bend(const Vector<Scalar, 2>& x) const noexcept {
        const auto& k = intrinsics_.distortion;
        const Scalar s = x[0] * x[0] + x[1] * x[1];
        const Radial<Scalar> radial(k, s);
        const Vector<Scalar, 2> q{Scalar(k[3]), Scalar(k[2])};
        const Scalar stretch = radial.value + 2 * (q[0] * x[0] + q[1] * x[1]);
        const Scalar mixed = 2 * (radial.slope * x[0] * x[1] + q[0] * x[1] + q[1] * x[0]);
        Bent<Scalar> bent;
        bent.point << stretch * x[0] + q[0] * s, stretch * x[1] + q[1] * s;
        bent.jacobian << stretch + 2 * radial.slope * x[0] * x[0] + 4 * q[0] * x[0], mixed,  //
            mixed, stretch + 2 * radial.slope * x[1] * x[1] + 4 * q[1] * x[1];
        return bent;
    }

    /// No less than it is stretched anywhere at a radius, in the direction that is stretched least:
    /// the tangential part takes 6 r |q| at most, where q = (p2, p1) points inwards.
    [[nodiscard]] double least_stretch(double radius) const noexcept {
        const auto& k = intrinsics_.distortion;
        const double s = radius * radius;
        const Radial<double> radial(k, s);
        if (!(radial.denominator > 0)) return -1;
        return std::min(radial.value, radial.value + 2 * s * radial.slope) -
               6 * radius * std::hypot(k[2], k[3]);
    }

    /// The radius of the disc in which the derivative is positive definite. As it is symmetric and
    /// a disc is convex, the distortion is one-to-one there: it is the gradient of a convex
    /// function.
    [[nodiscard]] double find_widest() const noexcept {
        constexpr int steps = 1000;  // of equal angles; then halved down to rounding
        const double step = std::atan(kMostTangent) / steps;
        double good = 0, bad = 0;
        for (int i = 1; i <= steps && bad == good; ++i) {
            bad = std::tan(i * step);
            if (least_stretch(bad) > 0) good = bad;
        }
        for (double middle = (good + bad) / 2; middle > good && middle < bad;
             middle = (good + bad) / 2)
            (least_stretch(middle) > 0 ? good : bad) = middle;
        return good;
    }

    /// Undoes `bend` within `widest`, by Newton's method with steps that are halved until they
    /// lead nearer, which they do as the derivative is positive definite.
    /// \return whether there is such a point
    template <typename Scalar>
    [[nodiscard]] bool straighten(const Vector<Scalar, 2>& bent, Vector<Scalar, 2>& straight,
                                  Matrix<Scalar, 2>& by_bent) const noexcept {
        constexpr auto rounding = std::numeric_limits<Scalar>::epsilon();
        const Scalar most_squared = Scalar(widest_) * Scalar(widest_);
        const Scalar size_squared = bent[0] * bent[0] + bent[1] * bent[1];
        straight.setZero();
        if (size_squared <= most_squared) straight = bent;
        Bent<Scalar> at = bend(straight);
        Vector<Scalar, 2> off = bent - at.point;
        Scalar off_squared = off[0] * off[0] + off[1] * off[1];
        by_bent = inverse(at.jacobian);
        const Scalar unit = rounding * rounding * (1 + size_squared);
        for (int i = 0; i < kMostSteps && off_squared > unit; ++i) {
            Vector<Scalar, 2> step = by_bent * off;
            bool nearer = false;
            for (int k = 0; k < kMostHalvings && !nearer; ++k, step *= Scalar(0.5)) {
                const Vector<Scalar, 2> next = straight + step;
                if (!(next[0] * next[0] + next[1] * next[1] <= most_squared)) continue;
                const Bent<Scalar> there = bend(next);
                const Vector<Scalar, 2> left = bent - there.point;
                const Scalar left_squared = left[0] * left[0] + left[1] * left[1];
                nearer = left_squared < off_squared;
                if (!nearer) continue;
                straight = next;
                off = left;
                off_squared = left_squared;
                by_bent = inverse(there.jacobian);
            }
            if (!nearer) break;
        }
        return off_squared <= 10000 * unit && size_squared < std::numeric_limits<Scalar>::max();
    }

    template <typename Scalar>
    [[nodiscard]] static Matrix<Scalar, 2> inverse(const Matrix<Scalar, 2>& m) noexcept {
        const Scalar per = 1 / (m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0));
        Matrix<Scalar, 2> i;
        i << m(1, 1) * per, -m(0, 1) * per, -m(1, 0) * per, m(0, 0) * per;
        return i;
    }

    Intrinsics intrinsics_;
    double roll_rad_ = 0, pitch_rad_ = 0;
    double widest_ = 0;
    Matrix<double, 3> rotation_ = Matrix<double, 3>::Identity();
};

}  // namespace pilotage
