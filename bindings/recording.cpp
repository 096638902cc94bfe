#include "engine/recording.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <optional>

#include "arrays.hpp"
#include "bindings.hpp"
#include "engine/text_table.hpp"
#include "pilotage/encoders_t.hpp"
#include "pilotage/gyro_t.hpp"
#include "pilotage/marker_frame_t.hpp"
#include "pilotage/reference_t.hpp"
#include "pilotage/velocity_t.hpp"
#include "text.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

using Times = Array<std::int64_t>;
using Numbers = Array<double>;

/// Encodes `count` messages; seq counts from 0, the time of arrival is the stamp unless it is
/// given.
template <typename Message, typename Fill>
void add_all(Recording& recording, const std::string& channel, const Times& utime,
             const std::optional<Times>& received, const Fill& fill) {
    const py::ssize_t n = utime.size();
    expect_length(utime, n, "utime");
    if (received) expect_length(*received, n, "received");
    const std::int64_t* stamp = utime.data();
    const std::int64_t* arrival = received ? received->data() : stamp;
    const py::gil_scoped_release release;
    Message message{};
    for (py::ssize_t i = 0; i < n; ++i) {
        message.utime = stamp[i];
        message.seq = static_cast<std::int32_t>(i);
        fill(message, i);
        recording.add(arrival[i], channel, message);
    }
}

void add_encoders(Recording& recording, const std::string& channel, const Times& utime,
                  const Times& left, const Times& right, const std::optional<Times>& received) {
    expect_length(left, utime.size(), "left");
    expect_length(right, utime.size(), "right");
    add_all<encoders_t>(recording, channel, utime, received,
                        [l = left.data(), r = right.data()](encoders_t& m, py::ssize_t i) {
                            m.left = l[i];
                            m.right = r[i];
                        });
}

void add_gyro(Recording& recording, const std::string& channel, const Times& utime,
              const Numbers& rate, const std::optional<Times>& received) {
    expect_length(rate, utime.size(), "rate");
    add_all<gyro_t>(recording, channel, utime, received,
                    [r = rate.data()](gyro_t& m, py::ssize_t i) { m.rate = r[i]; });
}

void add_velocity(Recording& recording, const std::string& channel, const Times& utime,
                  const Numbers& v, const Numbers& omega, const std::optional<Times>& received) {
    expect_length(v, utime.size(), "v");
    expect_length(omega, utime.size(), "omega");
    add_all<velocity_t>(recording, channel, utime, received,
                        [a = v.data(), b = omega.data()](velocity_t& m, py::ssize_t i) {
                            m.v = a[i];
                            m.omega = b[i];
                        });
}

void add_reference(Recording& recording, const std::string& channel, const Times& utime,
                   const Numbers& x, const Numbers& y, const Numbers& heading,
                   const std::optional<Times>& received) {
    for (const Numbers* values : {&x, &y, &heading})
        expect_length(*values, utime.size(), "x, y and heading");
    add_all<reference_t>(
        recording, channel, utime, received,
        [a = x.data(), b = y.data(), c = heading.data()](reference_t& m, py::ssize_t i) {
            m.x = a[i];
            m.y = b[i];
            m.heading = c[i];
        });
}

void add_sightings(Recording& recording, const std::string& channel, const std::string& sensor,
                   const Times& utime, const Array<std::int32_t>& id, const Numbers& bearing,
                   const Numbers& elevation, const Numbers& range,
                   const std::optional<Times>& received) {
    const py::ssize_t n = utime.size();
    expect_length(utime, n, "utime");
    expect_length(id, n, "id");
    for (const Numbers* values : {&bearing, &elevation, &range})
        expect_length(*values, n, "bearing, elevation and range");
    if (received) expect_length(*received, n, "received");
    const std::int64_t* stamp = utime.data();
    const std::int64_t* arrival = received ? received->data() : stamp;
    marker_frame_t frame{};
    frame.sensor = sensor;
    for (py::ssize_t first = 0, i = 0; i < n; first = i) {
        frame.utime = stamp[first];
        frame.sightings.clear();
        for (; i < n && stamp[i] == stamp[first]; ++i)
            frame.sightings.push_back(
                {id.at(i), -1, bearing.at(i), elevation.at(i), range.at(i), NAN, NAN, NAN});
        frame.n = static_cast<std::int32_t>(frame.sightings.size());
        recording.add(arrival[first], channel, frame);
        ++frame.seq;
    }
}

struct ReferenceRow {
    std::int64_t utime;
    double x, y, heading;
};

py::array reference(const Recording& recording) {
    std::vector<ReferenceRow> rows;
    Decoded decoded;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const LogEvent event = recording[i];
        const Codec* codec = find_codec(fingerprint_of(event.data, event.size));
        if (codec == nullptr || codec->kind != Kind::reference ||
            !codec->decode(event.data, event.size, decoded))
            continue;
        rows.push_back(
            {decoded.utime, decoded.reference[0], decoded.reference[1], decoded.reference[2]});
    }
    return owning_array(std::move(rows));
}

}  // namespace

void bind_recording(py::module_& m) {
    PYBIND11_NUMPY_DTYPE(ReferenceRow, utime, x, y, heading);
    const auto received = py::arg("received") = py::none();
    py::class_<Recording>(m, "Recording",
                          R"(LCM messages in the order of their arrival, as a log file holds them.

The `add_*` methods encode whole arrays. Stamps are integer microseconds; the time of arrival is the
stamp unless `received` is given. Call `sort` once everything is added.
)")
        .def(py::init<>())
        .def("add_encoders", &add_encoders, py::arg("channel"), py::arg("utime"), py::arg("left"),
             py::arg("right"), received, "encoders_t: (n,) int64 absolute ticks.")
        .def("add_gyro", &add_gyro, py::arg("channel"), py::arg("utime"), py::arg("rate"), received,
             "gyro_t: (n,) mean yaw rate since the previous sample [rad/s].")
        .def("add_velocity", &add_velocity, py::arg("channel"), py::arg("utime"), py::arg("v"),
             py::arg("omega"), received,
             "velocity_t: (n,) means since the previous sample [m/s, rad/s].")
        .def("add_sightings", &add_sightings, py::arg("channel"), py::arg("sensor"),
             py::arg("utime"), py::arg("id"), py::arg("bearing"), py::arg("elevation"),
             py::arg("range"), received,
             "marker_frame_t: (n,) each, NaN where not measured [rad, rad, m]; rows of equal utime "
             "that follow "
             "each other make one frame.")
        .def("add_reference", &add_reference, py::arg("channel"), py::arg("utime"), py::arg("x"),
             py::arg("y"), py::arg("heading"), received, "reference_t: (n,) truth [m, m, rad].")
        .def(
            "add",
            [](Recording& r, std::int64_t at, const std::string& channel, const py::bytes& data) {
                const auto bytes = static_cast<std::string_view>(data);
                r.add(at, channel, reinterpret_cast<const std::uint8_t*>(bytes.data()),
                      bytes.size());
            },
            py::arg("received"), py::arg("channel"), py::arg("data"), "Any one encoded message.")
        .def("sort", &Recording::sort,
             "By time of arrival; equal times stay in the order of adding.")
        .def("save", &Recording::save, py::arg("path"), "Writes an LCM log file.")
        .def_static("load", &Recording::load, py::arg("path"),
                    "Reads an LCM log file, over damaged places; see `damage`.")
        .def("reference", &reference,
             "All reference_t in it: structured array of utime, x, y, heading.")
        .def_property_readonly("damage", &Recording::damage,
                               "A line for each damaged place of the file.")
        .def(
            "messages",
            [](const Recording& r, const std::string& channel) {
                std::vector<py::bytes> found;
                for (std::size_t i = 0; i < r.size(); ++i)
                    if (const LogEvent e = r[i]; e.channel == channel)
                        found.emplace_back(reinterpret_cast<const char*>(e.data), e.size);
                return found;
            },
            py::arg("channel"), "The encoded messages of a channel, in order.")
        .def("__len__", &Recording::size)
        .def(
            "__getitem__",
            [](const Recording& r, std::size_t i) {
                if (i >= r.size()) throw py::index_error();
                const LogEvent e = r[i];
                return py::make_tuple(e.received, readable(e.channel),
                                      py::bytes(reinterpret_cast<const char*>(e.data), e.size));
            },
            "(received, channel, data) of a message.");
    m.def(
        "read_table",
        [](const std::string& path, const std::vector<int>& columns) {
            std::vector<double> values;
            {
                const py::gil_scoped_release release;
                values = read_table(path, columns);
            }
            const auto width = static_cast<py::ssize_t>(columns.size());
            const auto rows = width == 0 ? 0 : static_cast<py::ssize_t>(values.size()) / width;
            return owning_array(std::move(values)).reshape({rows, width});
        },
        py::arg("path"), py::arg("columns"),
        R"(Columns (from 0) of a text table of numbers, as (rows, len(columns)) float.

Separators are blanks, tabs and commas; empty lines and lines that begin with # or % are passed over.
ValueError names file and line of a ragged row or of a word that is no number.
)");
}

}  // namespace pilotage::bindings
