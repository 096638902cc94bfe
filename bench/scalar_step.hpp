#pragma once
/// \file
/// The yardstick: the three-state step written out by hand, as one would for the last nanosecond. No matrix
/// type, six doubles for the symmetric P, the two angles fused one after the other as scalars.

#include <cmath>

namespace bench {

struct ScalarStep {
    double x, y, heading;
    double xx, yx, yy, hx, hy, hh;  // P, lower triangle

    static double wrap(double a) {
        constexpr double pi = 3.14159265358979323846;
        if (a > pi) return a - 2 * pi;
        if (a <= -pi) return a + 2 * pi;
        return a;
    }

    /// Midpoint model; (ll, tl, tt) is the covariance of distance and turn, q the variances added.
    void predict(double distance, double turn, double ll, double tl, double tt, const double q[3]) {
        const double direction = heading + turn / 2;
        const double c = std::cos(direction), s = std::sin(direction);
        const double dx = distance * c, dy = distance * s;
        const double bx = -dy / 2, by = dx / 2;  // by turn; by distance it is (c, s)
        x += dx;
        y += dy;
        heading = wrap(heading + turn);
        // A P A' with A = [1 0 -dy; 0 1 dx; 0 0 1]
        const double hx1 = hx - dy * hh, hy1 = hy + dx * hh;
        xx -= dy * (hx + hx1);
        yx += dx * hx - dy * hy1;
        yy += dx * (hy + hy1);
        // B Gamma B' + Q
        const double gx_l = c * ll + bx * tl, gx_t = c * tl + bx * tt;
        const double gy_l = s * ll + by * tl, gy_t = s * tl + by * tt;
        xx += gx_l * c + gx_t * bx + q[0];
        yx += gy_l * c + gy_t * bx;
        yy += gy_l * s + gy_t * by + q[1];
        hx = hx1 + gx_t;
        hy = hy1 + gy_t;
        hh += tt + q[2];
    }

    /// Bearing and elevation of the marker at (mx, my, mz above the sensor), variances r.
    /// Both are linearised at the pose before the update. False, and nothing changed, unless the result is
    /// finite and its variances are not negative.
    bool update(double mx, double my, double mz, double bearing, double elevation, const double r[2]) {
        const double ex = mx - x, ey = my - y;
        const double d2 = ex * ex + ey * ey, d = std::sqrt(d2);
        const double per_d2 = 1 / d2, factor = mz / (d * (d2 + mz * mz));
        ScalarStep next = *this;
        const double dz0 = wrap(bearing - (std::atan2(ey, ex) - heading));
        next.fuse_bearing(dz0, ey * per_d2, -ex * per_d2, r[0]);
        const double a = ex * factor, b = ey * factor;
        const double dz1 = elevation - std::atan(mz / d) - a * (next.x - x) - b * (next.y - y);
        next.fuse_elevation(dz1, a, b, r[1]);
        next.heading = wrap(next.heading);
        if (!(next.xx >= 0 && next.yy >= 0 && next.hh >= 0 &&
              std::isfinite(next.x + next.y + next.heading)))
            return false;
        *this = next;
        return true;
    }

   private:
    // Scalar update with H = (a, b, -1). With g = P H' and K = g / s the Joseph form is
    // P - K g' + (K s - g) K', whose last term is only what rounding leaves of it.
    void fuse_bearing(double innovation, double a, double b, double r) {
        const double gx = xx * a + yx * b - hx, gy = yx * a + yy * b - hy, gh = hx * a + hy * b - hh;
        apply(innovation, gx, gy, gh, a * gx + b * gy - gh + r);
    }

    void fuse_elevation(double innovation, double a, double b, double r) {
        const double gx = xx * a + yx * b, gy = yx * a + yy * b, gh = hx * a + hy * b;
        apply(innovation, gx, gy, gh, a * gx + b * gy + r);
    }

    void apply(double innovation, double gx, double gy, double gh, double s) {
        const double per_s = 1 / s;
        const double kx = gx * per_s, ky = gy * per_s, kh = gh * per_s;
        x += kx * innovation;
        y += ky * innovation;
        heading += kh * innovation;
        xx -= kx * gx;
        yx -= ky * gx;
        yy -= ky * gy;
        hx -= kh * gx;
        hy -= kh * gy;
        hh -= kh * gh;
    }
};

}  // namespace bench
