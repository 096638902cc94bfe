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
#include "pilotage/tick_t.hpp"
#include "pilotage/velocity_t.hpp"
#include "text.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

using Times = Array<std::int64_t>;
using Numbers = Array<double>;
using Sequence = Array<std::int32_t>;

/// What every message has: the time of arrival is the stamp and seq counts from 0, unless given.
struct Headers {
    Headers(const Times& utime, const std::optional<Times>& received,
            const std::optional<Sequence>& seq)
        : size(utime.size()),
          utime(utime.data()),
          received(received ? received->data() : utime.data()),
          seq(seq ? seq->data() : nullptr) {
        expect_length(utime, size, "utime");
        if (received) expect_length(*received, size, "received");
        if (seq) expect_length(*seq, size, "seq");
    }
    [[nodiscard]] std::int32_t seq_of(py::ssize_t row, std::int32_t counted) const {
        return seq != nullptr ? seq[row] : counted;
    }
    /// Whether the row belongs to the message of the row before it.
    [[nodiscard]] bool continues(py::ssize_t row) const {
        return utime[row] == utime[row - 1] && received[row] == received[row - 1] &&
               (seq == nullptr || seq[row] == seq[row - 1]);
    }

    py::ssize_t size;
    const std::int64_t *utime, *received;
    const std::int32_t* seq;
};

template <typename Message, typename Fill>
void add_all(Recording& recording, const std::string& channel, const Headers& headers,
             const Fill& fill) {
    const py::gil_scoped_release release;
    Message message{};
    for (py::ssize_t i = 0; i < headers.size; ++i) {
        message.utime = headers.utime[i];
        message.seq = headers.seq_of(i, static_cast<std::int32_t>(i));
        fill(message, i);
        recording.add(headers.received[i], channel, message);
    }
}

void add_encoders(Recording& recording, const std::string& channel, const Times& utime,
                  const Times& left, const Times& right, const std::optional<Times>& received,
                  const std::optional<Sequence>& seq) {
    expect_length(left, utime.size(), "left");
    expect_length(right, utime.size(), "right");
    add_all<encoders_t>(recording, channel, {utime, received, seq},
                        [l = left.data(), r = right.data()](encoders_t& m, py::ssize_t i) {
                            m.left = l[i];
                            m.right = r[i];
                        });
}

void add_gyro(Recording& recording, const std::string& channel, const Times& utime,
              const Numbers& rate, const std::optional<Times>& received,
              const std::optional<Sequence>& seq) {
    expect_length(rate, utime.size(), "rate");
    add_all<gyro_t>(recording, channel, {utime, received, seq},
                    [r = rate.data()](gyro_t& m, py::ssize_t i) { m.rate = r[i]; });
}

void add_velocity(Recording& recording, const std::string& channel, const Times& utime,
                  const Numbers& v, const Numbers& omega, const std::optional<Times>& received,
                  const std::optional<Sequence>& seq) {
    expect_length(v, utime.size(), "v");
    expect_length(omega, utime.size(), "omega");
    add_all<velocity_t>(recording, channel, {utime, received, seq},
                        [a = v.data(), b = omega.data()](velocity_t& m, py::ssize_t i) {
                            m.v = a[i];
                            m.omega = b[i];
                        });
}

void add_reference(Recording& recording, const std::string& channel, const Times& utime,
                   const Numbers& x, const Numbers& y, const Numbers& heading,
                   const std::optional<Times>& received, const std::optional<Sequence>& seq) {
    for (const Numbers* values : {&x, &y, &heading})
        expect_length(*values, utime.size(), "x, y and heading");
    add_all<reference_t>(
        recording, channel, {utime, received, seq},
        [a = x.data(), b = y.data(), c = heading.data()](reference_t& m, py::ssize_t i) {
            m.x = a[i];
            m.y = b[i];
            m.heading = c[i];
        });
}

void add_sightings(Recording& recording, const std::string& channel, const std::string& sensor,
                   const Times& utime, const Array<std::int32_t>& id, const Numbers& bearing,
                   const Numbers& elevation, const Numbers& range,
                   const std::optional<Times>& received, const std::optional<Sequence>& seq) {
    const Headers headers(utime, received, seq);
    expect_length(id, headers.size, "id");
    for (const Numbers* values : {&bearing, &elevation, &range})
        expect_length(*values, headers.size, "bearing, elevation and range");
    marker_frame_t frame{};
    frame.sensor = sensor;
    std::int32_t frames = 0;
    for (py::ssize_t i = 0; i < headers.size; ++frames) {
        const py::ssize_t first = i;
        frame.utime = headers.utime[first];
        frame.seq = headers.seq_of(first, frames);
        frame.sightings.clear();
        do {
            frame.sightings.push_back(
                {id.at(i), -1, bearing.at(i), elevation.at(i), range.at(i), NAN, NAN, NAN});
            ++i;
        } while (i < headers.size && headers.continues(i));
        frame.n = static_cast<std::int32_t>(frame.sightings.size());
        recording.add(headers.received[first], channel, frame);
    }
}

void add_ticks(Recording& recording, const Times& utime) {
    add_all<tick_t>(recording, kTickChannel, {utime, std::nullopt, std::nullopt},
                    [](tick_t&, py::ssize_t) {});
}

py::array_t<std::int64_t> arrivals(const Recording& recording, const std::string& channel) {
    std::vector<std::int64_t> received;
    for (std::size_t i = 0; i < recording.size(); ++i)
        if (const LogEvent event = recording[i]; event.channel == channel)
            received.push_back(event.received);
    return owning_array(std::move(received));
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
    const auto seq = py::arg("seq") = py::none();
    py::class_<Recording>(m, "Recording",
                          R"(LCM messages in the order of their arrival, as a log file holds them.

The `add_*` methods encode whole arrays. Stamps are integer microseconds; the time of arrival is the
stamp unless `received` is given, and seq counts from 0 unless `seq` is. Call `sort` once everything is added.
)")
        .def(py::init<>())
        .def("add_encoders", &add_encoders, py::arg("channel"), py::arg("utime"), py::arg("left"),
             py::arg("right"), received, seq, "encoders_t: (n,) int64 absolute ticks.")
        .def("add_gyro", &add_gyro, py::arg("channel"), py::arg("utime"), py::arg("rate"), received,
             seq, "gyro_t: (n,) mean yaw rate since the previous sample [rad/s].")
        .def("add_velocity", &add_velocity, py::arg("channel"), py::arg("utime"), py::arg("v"),
             py::arg("omega"), received, seq,
             "velocity_t: (n,) means since the previous sample [m/s, rad/s].")
        .def("add_sightings", &add_sightings, py::arg("channel"), py::arg("sensor"),
             py::arg("utime"), py::arg("id"), py::arg("bearing"), py::arg("elevation"),
             py::arg("range"), received, seq,
             "marker_frame_t: (n,) each, NaN where not measured [rad, rad, m]; rows that follow "
             "each other with equal utime, time of arrival and seq make one frame.")
        .def("add_reference", &add_reference, py::arg("channel"), py::arg("utime"), py::arg("x"),
             py::arg("y"), py::arg("heading"), received, seq,
             "reference_t: (n,) truth [m, m, rad].")
        .def("add_ticks", &add_ticks, py::arg("utime"),
             "tick_t, as `pilotage-node` records them: (n,) times at which the status is due.")
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
        .def("arrivals", &arrivals, py::arg("channel"),
             "(n,) times of arrival of a channel's messages, in order [us].")
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
