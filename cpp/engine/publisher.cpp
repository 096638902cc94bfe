#include "publisher.hpp"

#include <algorithm>

#include "codecs.hpp"
#include "pilotage/pose_jump_t.hpp"

namespace pilotage {

Publisher::Publisher(const Config& config, EngineOutput& output)
    : channels_(config.output), sensor_names_(config.sensor_names), output_(&output) {}

template <typename Message>
void Publisher::publish(const std::string& channel, const Message& message) {
    encode(message, buffer_);
    output_->message(channel, buffer_.data(), buffer_.size());
}

void Publisher::pose(const Estimate& e, std::int32_t resets) {
    output_->pose(e, resets);
    pose_.utime = e.utime;
    pose_.seq = poses_++;
    pose_.x = e.pose[kX];
    pose_.y = e.pose[kY];
    pose_.heading = e.pose[kHeading];
    std::copy_n(e.covariance.data(), 9, pose_.covariance);
    pose_.v = e.v_m_s;
    pose_.omega = e.omega_rad_s;
    pose_.status = static_cast<std::int8_t>(e.status);
    pose_.resets = resets;
    publish(channels_.pose, pose_);
}

void Publisher::odometry(const Estimate& e, const Pose<double>& pose) {
    odometry_.utime = e.utime;
    odometry_.seq = odometries_++;
    odometry_.x = pose[kX];
    odometry_.y = pose[kY];
    odometry_.heading = pose[kHeading];
    odometry_.v = e.v_m_s;
    odometry_.omega = e.omega_rad_s;
    publish(channels_.odometry, odometry_);
}

void Publisher::jump(const Jump& jump, std::int64_t utime, std::int32_t resets) {
    pose_jump_t message;
    message.utime = utime;
    message.seq = jumps_++;
    message.resets = resets;
    std::copy_n(jump.before.data(), 3, message.before);
    std::copy_n(jump.after.data(), 3, message.after);
    message.cause = jump.cause;
    publish(channels_.jump, message);
}

void Publisher::report(const SightingReport& report) {
    output_->sighting(report);
    report_.utime = report.utime;
    report_.seq = reports_++;
    report_.revision = report.revision;
    report_.sensor = sensor_names_[report.sensor];
    report_.frame_seq = report.frame_seq;
    report_.index = report.index;
    report_.id = report.id;
    std::copy_n(report.innovation, 3, report_.innovation);
    std::copy_n(report.sigma, 3, report_.sigma);
    report_.nis = report.nis;
    report_.dof = report.dof;
    report_.weight = report.weight;
    report_.accepted = report.verdict == Verdict::fused;
    report_.reason = report_.accepted ? "" : name(report.verdict);
    report_.value = report.value;
    report_.limit = report.limit;
    report_.unit = unit(report.verdict);
    publish(channels_.report, report_);
}

void Publisher::status(status_t& status) {
    status.seq = statuses_++;
    publish(channels_.status, status);
}

}  // namespace pilotage
