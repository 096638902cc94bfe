#pragma once
/// \file
/// The yardstick: the three-state step written out by hand, with the same guarantees as Ekf<3>
/// (Joseph form, nothing committed that is not a covariance) but no matrix, no report and no
/// choice: six doubles for the symmetric P, and the two angles fused one after the other as
/// scalars.

#include <cmath>

#include "pilotage/angle.hpp"

namespace bench {

struct ScalarStep {
    double x, y, heading;
    double xx, yx, yy, hx, hy, hh;  // P, lower triangle

    /// Midpoint model. (ll, tl, tt) is the covariance of distance and turn, q the variances added.
    void predict(double distance, double turn, double ll, double tl, double tt, const double* q) {
        const double direction = heading + turn / 2;
        const double c = std::cos(direction), s = std::sin(direction);
        const double dx = distance * c, dy = distance * s;
        const double bx = -0.5 * dy, by = 0.5 * dx;  // by turn; by distance it is (c, s)
        x += dx;
        y += dy;
        heading = pilotage::wrap(heading + turn);
        // A P A' with A = [1 0 -dy; 0 1 dx; 0 0 1]
        const double hx1 = hx - dy * hh, hy1 = hy + dx * hh;
        xx -= dy * (hx + hx1);
        yx += dx * hx - dy * hy1;
        yy += dx * (hy + hy1);
        // B Gamma B' + Q
        const double xl = c * ll + bx * tl, xt = c * tl + bx * tt;
        const double yl = s * ll + by * tl, yt = s * tl + by * tt;
        xx += xl * c + xt * bx + q[0];
        yx += yl * c + yt * bx;
        yy += yl * s + yt * by + q[1];
        hx = hx1 + xt;
        hy = hy1 + yt;
        hh += tt + q[2];
    }

    /// Bearing and elevation of a marker at (mx, my), mz above the sensor, with variances r. Both
    /// are linearised at the pose before the update.
    bool update(double mx, double my, double mz, const double* z, const double* r) {
        const double ex = mx - x, ey = my - y;
        const double d2 = ex * ex + ey * ey, d = std::sqrt(d2);
        const double per_d2 = 1 / d2, factor = mz / (d * (d2 + mz * mz));
        const double a = ex * factor, b = ey * factor;
        const double bearing = pilotage::wrap(z[0] - (pilotage::direction_of(ex, ey) - heading));
        const double elevation = z[1] - std::atan(mz / d);
        ScalarStep next = *this;
        next.fuse(bearing, ey * per_d2, -ex * per_d2, -1, r[0]);
        next.fuse(elevation - a * (next.x - x) - b * (next.y - y), a, b, 0, r[1]);
        if (!next.is_covariance()) return false;
        next.heading = pilotage::wrap(next.heading);
        *this = next;
        return true;
    }

   private:
    /// One scalar with H = (a, b, c), c known to the compiler: M1 = P - K (P H')', then
    /// M1 + (K r - M1 H') K'.
    [[gnu::always_inline]] void fuse(double innovation, double a, double b, int c, double r) {
        const double gx = xx * a + yx * b + c_times(c, hx), gy = yx * a + yy * b + c_times(c, hy),
                     gh = hx * a + hy * b + c_times(c, hh);
        const double per_s = 1 / (a * gx + b * gy + c_times(c, gh) + r);
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
        const double ux = kx * r - (xx * a + yx * b + c_times(c, hx)),
                     uy = ky * r - (yx * a + yy * b + c_times(c, hy)),
                     uh = kh * r - (hx * a + hy * b + c_times(c, hh));
        xx += ux * kx;
        yx += uy * kx;
        yy += uy * ky;
        hx += uh * kx;
        hy += uh * ky;
        hh += uh * kh;
    }

    /// -v or -0 (which adds for nothing).
    [[gnu::always_inline]] static double c_times(int c, double v) { return c == 0 ? -0.0 : -v; }

    [[nodiscard, gnu::always_inline]] bool is_covariance() const {
        constexpr double slack = 1e-13;
        if (!(xx > 0)) return false;
        const double per_xx = 1 / xx, ly = yx * per_xx, lh = hx * per_xx;
        const double yy1 = yy - ly * yx, hy1 = hy - lh * yx, hh1 = hh - lh * hx;
        return yy1 > slack * yy && hh1 - hy1 * hy1 / yy1 > slack * hh;
    }
};

}  // namespace bench
