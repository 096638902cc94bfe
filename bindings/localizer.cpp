#include "pilotage/any_localizer.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <memory>
#include <optional>
#include <variant>

#include "arrays.hpp"
#include "bindings.hpp"
#include "engine/run.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

using Times = Array<std::int64_t>;
using Numbers = Array<double>;

class Silence final : public Listener {
    void on_verdict(const Sample&, Verdict, Verdict) override {}
    void on_sighting(const SightingReport&) override {}
};

/// Samples in time order from three sorted streams: what the localizer sees of a recording held as
/// arrays.
struct Streams {
    Times motion_utime;
    Numbers motion;  // (n, 2): ticks or velocity
    Times gyro_utime;
    Numbers gyro_rate;
    Times sighting_utime;
    Array<std::int32_t> sighting_id;
    Numbers sighting;  // (k, 3)
};

class PyLocalizer {
   public:
    explicit PyLocalizer(const Config& config)
        : encoders_(config.params.motion.source == MotionSource::encoders),
          localizer_(make_localizer(config.params, config.map, config.walls, silence_)) {}
    PyLocalizer(const PyLocalizer&) = delete;
    PyLocalizer& operator=(const PyLocalizer&) = delete;

    // Untyped, since a signature cannot name the rows' fields.
    py::array run(const Streams& s, int sensor) {
        const py::ssize_t n = s.motion_utime.size(), g = s.gyro_utime.size(),
                          k = s.sighting_utime.size();
        expect_length(s.motion_utime, n, "motion_utime");
        expect_shape(s.motion, n, 2, "motion");
        expect_length(s.gyro_rate, g, "gyro_rate");
        expect_length(s.sighting_id, k, "sighting_id");
        if (k > 0) expect_shape(s.sighting, k, 3, "sighting");
        std::vector<Run::PoseRow> rows;
        {
            const py::gil_scoped_release release;
            rows.reserve(static_cast<std::size_t>(n));
            std::visit([&](auto& localizer) { feed(localizer, s, n, g, k, sensor, rows); },
                       localizer_);
        }
        return owning_array(std::move(rows));
    }

   private:
    template <typename Localizer>
    void feed(Localizer& localizer, const Streams& s, py::ssize_t n, py::ssize_t g, py::ssize_t k,
              int sensor, std::vector<Run::PoseRow>& rows) const {
        const std::int64_t *tm = s.motion_utime.data(), *tg = s.gyro_utime.data(),
                           *ts = s.sighting_utime.data();
        const double *motion = s.motion.data(), *rate = s.gyro_rate.data(),
                     *seen = s.sighting.data();
        for (py::ssize_t i = 0, j = 0, l = 0; i < n; ++i) {
            for (; j < g && tg[j] <= tm[i]; ++j)
                localizer.add(Sample::make(tg[j], static_cast<std::int32_t>(j), Stream::gyro,
                                           GyroRate{rate[j]}));
            for (; l < k && ts[l] <= tm[i]; ++l) {
                const Sighting sighting{{seen[3 * l], seen[3 * l + 1], seen[3 * l + 2]},
                                        {NAN, NAN, NAN},
                                        s.sighting_id.data()[l],
                                        -1};
                localizer.add(Sample::make(ts[l], static_cast<std::int32_t>(l), Stream::sighting,
                                           sighting, static_cast<std::uint8_t>(sensor)));
            }
            const auto seq = static_cast<std::int32_t>(i);
            const double* u = motion + 2 * i;
            const Sample sample =
                encoders_ ? Sample::make(tm[i], seq, Stream::motion,
                                         EncoderTicks{std::llround(u[0]), std::llround(u[1])})
                          : Sample::make(tm[i], seq, Stream::motion, BodyVelocity{u[0], u[1]});
            if (localizer.add(sample)) {
                const Estimate e = localizer.estimate();
                rows.push_back(Run::row_of(e, e.resets));
            }
        }
    }

    bool encoders_;
    Silence silence_;
    AnyLocalizer localizer_;
};

}  // namespace

void bind_localizer(py::module_& m) {
    py::class_<PyLocalizer>(m, "Localizer", R"(The localizer itself, without messages and channels.

Takes whole recordings held as arrays, in one call, with the GIL released. The configuration's map and at
least one sensor must be set; times are taken as they are (no time policy, no latency).
)")
        .def(py::init<const Config&>(), py::arg("config"))
        .def(
            "run",
            [](PyLocalizer& localizer, const Times& motion_utime, const Numbers& motion,
               const Times& gyro_utime, const Numbers& gyro_rate, const Times& sighting_utime,
               const Array<std::int32_t>& sighting_id, const Numbers& sighting, int sensor) {
                return localizer.run({motion_utime, motion, gyro_utime, gyro_rate, sighting_utime,
                                      sighting_id, sighting},
                                     sensor);
            },
            py::arg("motion_utime"), py::arg("motion"), py::arg("gyro_utime") = Times(0),
            py::arg("gyro_rate") = Numbers(0), py::arg("sighting_utime") = Times(0),
            py::arg("sighting_id") = Array<std::int32_t>(0), py::arg("sighting") = Numbers(0),
            py::arg("sensor") = 0,
            R"(Feeds samples in the order of their times.

Parameters
----------
motion_utime : (n,) int, us, not decreasing
motion : (n, 2) float, absolute ticks (left, right), or (v [m/s], omega [rad/s]) by `motion.source`
gyro_utime, gyro_rate : (g,) int us and float [rad/s], mean since the previous sample
sighting_utime, sighting_id : (k,) int us and marker ids
sighting : (k, 3) float, bearing [rad], elevation [rad], range [m]; NaN where not measured
sensor : number of the sensor in the configuration

Returns
-------
Structured array like `Run.poses`, one row a motion sample.
)");
}

}  // namespace pilotage::bindings
