#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "pilotage/setup_t.hpp"
#include "text_table.hpp"

namespace pilotage {

Run::Run(Config config, bool keep_messages)
    : keep_messages_(keep_messages), engine_(std::move(config), *this) {}

void Run::handle(const LogEvent& event) {
    ++messages_;
    received_ = event.received;
    if (event.channel == kSetupChannel) return restore(event);
    engine_.handle(event.channel, event.received, event.data, event.size);
}

/// Begins as the recorded run began.
void Run::restore(const LogEvent& event) {
    setup_t setup;
    if (setup.decode(event.data, 0, static_cast<int>(event.size)) < 0 || setup.n_checkpoint == 0)
        return;
    try {
        engine_.restore(Bytes(setup.checkpoint.begin(), setup.checkpoint.end()));
    } catch (const std::exception& error) {
        notice(std::string("the recorded checkpoint ") + error.what());
    }
}

void Run::replay(const Recording& recording, const Progress& progress) {
    poses_.reserve(recording.size() / 2);
    for (std::size_t i = 0; i < recording.size(); ++i) {
        handle(recording[i]);
        if (progress && i % kProgressEvery == 0)
            progress(static_cast<double>(i) / static_cast<double>(recording.size()));
    }
    finish(recording.damage());
}

void Run::replay(const std::string& path, const Progress& progress) {
    LogReader reader(path);
    LogEvent event;
    while (reader.next(event)) {
        handle(event);
        if (progress && messages_ % kProgressEvery == 0) progress(reader.done());
    }
    finish(reader.damage());
}

void Run::finish(const std::vector<std::string>& damage) {
    engine_.finish();
    damage_.insert(damage_.end(), damage.begin(), damage.end());
}

void Run::message(const std::string& channel, const std::uint8_t* data, std::size_t size) {
    if (keep_messages_) published_.add(received_, channel, data, size);
}

Run::PoseRow Run::row_of(const Estimate& e, std::int32_t resets) noexcept {
    PoseRow row{e.utime, e.pose[kX], e.pose[kY],    e.pose[kHeading],
                {},      e.v_m_s,    e.omega_rad_s, static_cast<std::int8_t>(e.status),
                resets};
    std::copy_n(e.covariance.data(), 9, &row.covariance[0][0]);
    return row;
}

void Run::pose(const Estimate& e, std::int32_t resets) {
    poses_.push_back(row_of(e, resets));
}

void Run::sighting(const SightingReport& report) {
    reports_.push_back(report);
}

void Run::notice(const std::string& text) {
    notices_.push_back(text);
}

std::vector<SightingReport> Run::final_reports() const {
    std::map<std::tuple<std::int64_t, std::uint8_t, std::int32_t, std::uint16_t, std::int32_t>,
             std::size_t>
        at;
    std::vector<SightingReport> rows;
    for (const SightingReport& report : reports_) {
        const auto key = std::make_tuple(report.utime, report.sensor, report.frame_seq,
                                         report.index, report.given_id);
        if (report.revision > 0) {
            rows[at.at(key)] = report;
            continue;
        }
        // What is refused at the door has no revisions; it may be a copy of a sighting that has.
        if (!refused_at_the_door(report.verdict)) at[key] = rows.size();
        rows.push_back(report);
    }
    return rows;
}

void Run::write_poses_csv(const std::string& path) const {
    TextTable out(path);
    out.line("utime,x,y,heading,xx,xy,xh,yy,yh,hh,v,omega,status,resets");
    for (const PoseRow& row : poses_) {
        const auto& p = row.covariance;
        out.integer(row.utime);
        for (const double v : {row.x, row.y, row.heading, p[0][0], p[0][1], p[0][2], p[1][1],
                               p[1][2], p[2][2], row.v, row.omega})
            out.number(v, ',');
        out.integer(row.status, ',');
        out.integer(row.resets, ',');
        out.line("");
    }
    out.close();
}

void Run::write_poses_tum(const std::string& path) const {
    TextTable out(path);
    for (const PoseRow& row : poses_) {
        out.seconds(row.utime);
        for (const double v :
             {row.x, row.y, 0.0, 0.0, 0.0, std::sin(row.heading / 2), std::cos(row.heading / 2)})
            out.number(v, ' ');
        out.line("");
    }
    out.close();
}

void Run::write_reports_csv(const std::string& path) const {
    TextTable out(path);
    out.line(
        "utime,sensor,frame_seq,index,id,revision,innovation_bearing,innovation_elevation,"
        "innovation_range,"
        "sigma_bearing,sigma_elevation,sigma_range,nis,dof,weight,verdict,value,limit,unit");
    for (const SightingReport& r : final_reports()) {
        out.integer(r.utime);
        out.word(engine_.config().sensor_names[r.sensor], ',');
        for (const std::int64_t v : {std::int64_t{r.frame_seq}, std::int64_t{r.index},
                                     std::int64_t{r.id}, std::int64_t{r.revision}})
            out.integer(v, ',');
        for (const double v : r.innovation) out.number(v, ',');
        for (const double v : r.sigma) out.number(v, ',');
        out.number(r.nis, ',');
        out.integer(r.dof, ',');
        out.number(r.weight, ',');
        out.word(name(r.verdict), ',');
        out.number(r.value, ',');
        out.number(r.limit, ',');
        out.word(unit(r.verdict), ',');
        out.line("");
    }
    out.close();
}

}  // namespace pilotage
