#include "support/soundness.hpp"

#include <cmath>
#include <sstream>

namespace pilotage::test {

namespace {

bool wrapped(double heading) {
    constexpr double pi = 3.14159265358979324;
    return heading > -pi && heading <= pi;
}

/// What was measured was held against the map: all of it is there, and nothing else; an elevation
/// may have been left out of the NIS. A sender may state a sigma whose square is infinite.
bool fully_judged(const marker_report_t& report) {
    int measured = 0;
    for (int i = 0; i < 3; ++i) {
        if (std::isfinite(report.innovation[i]) != (report.sigma[i] >= 0)) return false;
        measured += std::isfinite(report.innovation[i]);
    }
    // An elevation that is wrong alone is left out.
    const bool apart = !std::isnan(report.innovation[1]) && report.dof == measured - 1;
    return std::isfinite(report.nis) && (measured == report.dof || apart);
}

bool not_judged(const marker_report_t& report) {
    for (int i = 0; i < 3; ++i)
        if (!std::isnan(report.innovation[i]) || !std::isnan(report.sigma[i])) return false;
    return std::isnan(report.nis);
}

std::string flaw_of(const marker_report_t& report) {
    const bool accepted = report.accepted != 0;
    if (accepted != report.reason.empty()) return "accepted with a reason, or rejected without";
    const bool judged = accepted || report.reason == "gate";
    // Of "numeric" anything may be missing: that is what it says.
    if (judged && !fully_judged(report)) return "a value is missing or not finite";
    if (!judged && report.reason != "numeric" && !not_judged(report)) return "values of no meaning";
    if (!(report.weight >= 0 && report.weight <= 1)) return "the weight is not in [0, 1]";
    if ((report.weight > 0) != accepted) return "a rejected sighting weighs, or an accepted none";
    return "";
}

std::string flaw_of_input(const input_status_t& input) {
    std::int64_t sum = input.fused + input.pending;
    for (const reason_count_t& r : input.rejected) {
        if (r.count <= 0) return "a count of none: " + r.reason;
        sum += r.count;
    }
    if (input.received != sum) return "received is not fused + pending + rejected";
    if (input.pending < 0) return "less than none are pending";
    if (std::isinf(input.rate_hz) || std::isinf(input.age_s)) return "an infinite rate or age";
    return "";
}

}  // namespace

std::string flaw_in(const pose_t& pose) {
    for (const double v : {pose.x, pose.y, pose.heading, pose.v, pose.omega})
        if (!std::isfinite(v)) return "the pose is not finite";
    for (const double v : pose.covariance)
        if (!std::isfinite(v)) return "the covariance is not finite";
    if (!wrapped(pose.heading)) return "the heading is not in (-pi, pi]";
    for (int i = 0; i < 3; ++i) {
        if (pose.covariance[4 * i] < 0) return "a variance is negative";
        for (int j = 0; j < i; ++j)
            if (pose.covariance[3 * i + j] != pose.covariance[3 * j + i])
                return "the covariance is not symmetric";
    }
    return "";
}

std::string flaw_in(const marker_report_t& report) {
    const std::string flaw = flaw_of(report);
    if (flaw.empty()) return flaw;
    std::ostringstream text;
    text << flaw << ": reason '" << report.reason << "', dof " << report.dof << ", nis "
         << report.nis << ", weight " << report.weight;
    for (int i = 0; i < 3; ++i) text << ", " << report.innovation[i] << " ± " << report.sigma[i];
    return text.str();
}

std::string flaw_in(const status_t& status) {
    if (status.n_inputs != static_cast<int>(status.inputs.size())) return "inputs are miscounted";
    if (status.version.empty()) return "the version is missing";
    for (const input_status_t& input : status.inputs)
        if (const std::string flaw = flaw_of_input(input); !flaw.empty())
            return input.name + ": " + flaw;
    return "";
}

std::string flaw_in(const odometry_t& o) {
    for (const double v : {o.x, o.y, o.heading, o.v, o.omega})
        if (!std::isfinite(v)) return "not finite";
    return wrapped(o.heading) ? "" : "the heading is not in (-pi, pi]";
}

std::string flaw_in(const pose_jump_t& jump) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(jump.before[i]) || !std::isfinite(jump.after[i])) return "not finite";
    const bool known = jump.cause == "correction" || jump.cause == "reset" ||
                       jump.cause == "found" || jump.cause == "clock";
    return known ? "" : "unknown cause '" + jump.cause + "'";
}

}  // namespace pilotage::test
