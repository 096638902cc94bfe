#include "engine/run.hpp"

#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <optional>

#include "arrays.hpp"
#include "bindings.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

/// A report as numpy row: verdicts split into accepted and the reason's number.
struct ReportRow {
    std::int64_t utime;
    std::int32_t sensor, frame_seq, index, id, revision;
    double innovation[3], sigma[3];
    double nis;
    std::int32_t dof;
    double weight;
    bool accepted;
    std::uint8_t reason;
    double value, limit;
};

ReportRow row_of(const SightingReport& r) {
    ReportRow row{r.utime,
                  r.sensor,
                  r.frame_seq,
                  r.index,
                  r.id,
                  r.revision,
                  {},
                  {},
                  r.nis,
                  r.dof,
                  r.weight,
                  r.verdict == Verdict::fused,
                  static_cast<std::uint8_t>(r.verdict),
                  r.value,
                  r.limit};
    std::copy_n(r.innovation, 3, row.innovation);
    std::copy_n(r.sigma, 3, row.sigma);
    return row;
}

struct TimedRun {
    Run run;
    double wall_s = 0;
    TimedRun(const Config& config, bool keep) : run(config, keep) {}
};

template <typename Source>
std::unique_ptr<TimedRun> replay(
    const Config& config, const Source& source, bool keep_messages,
    const std::optional<py::typing::Callable<void(double)>>& progress) {
    Run::Progress report;
    if (progress)
        report = [&](double done) {
            const py::gil_scoped_acquire acquire;
            (*progress)(done);
        };
    const py::gil_scoped_release release;
    auto result = std::make_unique<TimedRun>(config, keep_messages);
    const auto start = std::chrono::steady_clock::now();
    result->run.replay(source, report);
    result->wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

py::typing::Dict<py::str, py::object> counts(const TimedRun& timed) {
    std::map<std::string, int> rejected_by;
    int samples = 0, accepted = 0;
    for (const SightingReport& report : timed.run.final_reports()) {
        const int components =
            std::max(report.dof, 1);  // a sighting that measured nothing counts as well
        samples += components;
        (rejected(report.verdict) ? rejected_by[name(report.verdict)] : accepted) += components;
    }
    py::typing::Dict<py::str, py::object> result;
    result["messages"] = timed.run.messages();
    result["samples"] = samples;
    result["accepted"] = accepted;
    result["rejected"] = rejected_by;
    return result;
}

py::typing::List<py::typing::Dict<py::str, py::object>> inputs(const TimedRun& timed) {
    py::typing::List<py::typing::Dict<py::str, py::object>> rows;
    for (const Input& input : timed.run.engine().inputs()) {
        py::dict by_reason;
        for (int v = 0; v < kVerdicts; ++v)
            if (const auto n = input.count(static_cast<Verdict>(v)); n != 0)
                by_reason[name(static_cast<Verdict>(v))] = n;
        for (int f = 0; f < kMessageFaults; ++f)
            if (const auto n = input.count(static_cast<MessageFault>(f)); n != 0)
                by_reason[name(static_cast<MessageFault>(f))] = n;
        py::dict row;
        row["name"] = input.name();
        row["channel"] = input.channel();
        row["received"] = input.samples();
        row["counts"] = by_reason;
        rows.append(row);
    }
    return rows;
}

std::vector<std::string> verdict_names() {
    std::vector<std::string> names;
    for (int v = 0; v < kVerdicts; ++v) names.emplace_back(name(static_cast<Verdict>(v)));
    return names;
}

/// Keeps the messages of one call, to hand them to Python.
class Collector final : public EngineOutput {
   public:
    std::vector<std::pair<std::string, py::bytes>> messages;
    std::vector<std::string> notices;
    std::optional<py::bytes> checkpoint_made;

   private:
    void message(const std::string& channel, const std::uint8_t* data, std::size_t size) override {
        messages.emplace_back(channel, py::bytes(reinterpret_cast<const char*>(data), size));
    }
    void notice(const std::string& text) override { notices.push_back(text); }
    void checkpoint(const Bytes& bytes) override {
        checkpoint_made = py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
};

/// The content of a checkpoint file, in Python's own types.
py::typing::Dict<py::str, py::object> read_checkpoint(const std::string& path) {
    const Bytes bytes = read_bytes(path);
    if (bytes.empty()) throw std::runtime_error(path + ": no such file, or an empty one");
    checkpoint_t message;
    try {
        message = unpack(bytes);
    } catch (const std::exception& error) {
        throw std::runtime_error(path + " " + error.what());
    }
    std::vector<double> covariance;
    for (const std::vector<double>& row : message.covariance)
        covariance.insert(covariance.end(), row.begin(), row.end());
    py::typing::Dict<py::str, py::object> content;
    content["utime"] = message.utime;
    content["seq"] = message.seq;
    content["made"] = message.made;
    content["version"] = message.version;
    content["ticks"] = py::make_tuple(message.left, message.right);
    content["state"] = owning_array(std::move(message.state));
    content["covariance"] = owning_array(std::move(covariance)).reshape({message.n, message.n});
    return content;
}

/// An engine fed message by message from Python.
class PyEngine {
   public:
    explicit PyEngine(const Config& config) : engine_(config, output_) {}

    auto handle(const std::string& channel, std::int64_t received, const py::bytes& data) {
        const auto bytes = static_cast<std::string_view>(data);
        output_.messages.clear();
        engine_.handle(channel, received, reinterpret_cast<const std::uint8_t*>(bytes.data()),
                       bytes.size());
        return output_.messages;
    }
    auto tick(std::int64_t now, std::int64_t drops) {
        output_.messages.clear();
        engine_.tick(now, drops);
        return output_.messages;
    }
    void restore(const py::bytes& checkpoint) {
        const auto bytes = static_cast<std::string_view>(checkpoint);
        engine_.restore(Bytes(bytes.begin(), bytes.end()));
    }
    [[nodiscard]] const auto& checkpoint() const { return output_.checkpoint_made; }
    [[nodiscard]] std::int64_t tick_period() const { return engine_.tick_period(); }
    [[nodiscard]] const std::vector<std::string>& notices() const { return output_.notices; }
    [[nodiscard]] std::string waiting_for() const { return engine_.waiting_for(); }

   private:
    Collector output_;
    Engine engine_;
};

}  // namespace

void bind_run(py::module_& m) {
    using PoseRow = Run::PoseRow;
    PYBIND11_NUMPY_DTYPE(PoseRow, utime, x, y, heading, covariance, v, omega, status, resets);
    PYBIND11_NUMPY_DTYPE(ReportRow, utime, sensor, frame_seq, index, id, revision, innovation,
                         sigma, nis, dof, weight, accepted, reason, value, limit);
    py::class_<TimedRun>(m, "Run",
                         "A recording that went through the engine, with all that came out.")
        .def_property_readonly(
            "poses", [](const TimedRun& t) { return py::array(owning_array(t.run.poses())); },
            "Structured array, one row a published pose: utime, x, y, heading, covariance (3, 3), "
            "v, omega, "
            "status, resets.")
        .def_property_readonly(
            "reports",
            [](const TimedRun& t) {
                std::vector<ReportRow> rows;
                for (const SightingReport& report : t.run.final_reports())
                    rows.push_back(row_of(report));
                return py::array(owning_array(std::move(rows)));
            },
            "Structured array, one row a sighting with its newest revision: utime, sensor (into "
            "`sensors`), "
            "frame_seq, index, id, revision, innovation (3,), sigma (3,), nis, dof, weight, "
            "accepted, reason "
            "(into `reasons`), value, limit. Components are bearing [rad], elevation [rad], range "
            "[m].")
        .def_property_readonly(
            "sensors", [](const TimedRun& t) { return t.run.engine().config().sensor_names; })
        .def_property_readonly("reasons", [](const TimedRun&) { return verdict_names(); })
        .def_property_readonly("counts", &counts,
                               "messages that went in, and of measured components: samples = "
                               "accepted + sum of rejected by reason.")
        .def_property_readonly("inputs", &inputs,
                               "Per input: name, channel, received, counts by verdict.")
        .def_property_readonly(
            "messages", [](const TimedRun& t) { return t.run.messages(); },
            "Number of messages that went in.")
        .def_property_readonly(
            "wall_s", [](const TimedRun& t) { return t.wall_s; }, "Time that the replay took [s].")
        .def_property_readonly("notices", [](const TimedRun& t) { return t.run.notices(); })
        .def_property_readonly(
            "damage", [](const TimedRun& t) { return t.run.damage(); },
            "Damaged places of the log file.")
        .def_property_readonly(
            "waiting_for", [](const TimedRun& t) { return t.run.engine().waiting_for(); },
            "What the localizer lacked to the end; empty if nothing.")
        .def_property_readonly(
            "published", [](const TimedRun& t) -> const Recording& { return t.run.published(); },
            "Recording of the published messages, if they were kept.")
        .def(
            "write_poses_csv",
            [](const TimedRun& t, const std::string& p) { t.run.write_poses_csv(p); },
            py::arg("path"))
        .def(
            "write_poses_tum",
            [](const TimedRun& t, const std::string& p) { t.run.write_poses_tum(p); },
            py::arg("path"), "TUM trajectory: time [s] x y z qx qy qz qw.")
        .def(
            "write_reports_csv",
            [](const TimedRun& t, const std::string& p) { t.run.write_reports_csv(p); },
            py::arg("path"));
    const auto keep = py::arg("keep_messages") = false;
    const auto progress = py::arg("progress") = py::none();
    m.def(
        "replay", &replay<Recording>, py::arg("config"), py::arg("recording"), keep, progress,
        R"(Feeds a recording to an engine, in the order and with the times in which its messages arrived.

Parameters
----------
config : Config
recording : Recording, or the path of an LCM log file, which is then not held in memory
keep_messages : keep what was published, as `Run.published`
progress : called now and then with the part that is done, 0 to 1
)");
    m.def("replay", &replay<std::string>, py::arg("config"), py::arg("path"), keep, progress);
    m.def("read_checkpoint", &read_checkpoint, py::arg("path"),
          R"(Reads the file that `pilotage-node --checkpoint` keeps; RuntimeError if it is damaged.

Returns
-------
utime, made : us, of the newest motion sample and of the checkpoint
seq, version : count of checkpoints since the node's start, and the node's version
ticks : (left, right) at utime
state, covariance : (n,) and (n, n) float; x, y [m], heading [rad], and calibration if it is estimated
)");
    py::class_<PyEngine>(m, "Engine", "Bytes in, messages out, one message a call.")
        .def(py::init<const Config&>(), py::arg("config"))
        .def("handle", &PyEngine::handle, py::arg("channel"), py::arg("received"), py::arg("data"),
             "Takes an encoded message with its time of arrival [us]; the (channel, data) to "
             "publish.")
        .def("tick", &PyEngine::tick, py::arg("now"), py::arg("drops") = 0,
             "Time passes [us]; the (channel, data) to publish.")
        .def("restore", &PyEngine::restore, py::arg("checkpoint"),
             "Begins with a checkpoint's pose, as a hypothesis; before anything else. RuntimeError "
             "says why it cannot be used.")
        .def_property_readonly("checkpoint", &PyEngine::checkpoint,
                               "The newest checkpoint that a tick made, as its file holds it.")
        .def_property_readonly("tick_period", &PyEngine::tick_period,
                               "As `tick` wants to be called [us].")
        .def_property_readonly("waiting_for", &PyEngine::waiting_for)
        .def_property_readonly("notices", &PyEngine::notices);
}

}  // namespace pilotage::bindings
