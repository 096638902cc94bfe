#include "pilotage/fixer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pilotage/examine.hpp"
#include "pilotage/fuse_fix.hpp"
#include "pilotage/fuse_pixel.hpp"
#include "pilotage/fuse_sighting.hpp"
#include "pilotage/search/occam.hpp"
#include "pilotage/sighting_report.hpp"

namespace pilotage {

namespace {

constexpr std::int64_t kSearchPeriod_us = 90'000;
constexpr double kNowhere = 1e9;  // NIS of a sighting that no marker is near
// A restored pose is from before the robot was switched off; so many nats speak against it.
constexpr double kRestored = 3;
constexpr double kDearest = -50;  // nats, of a pose that was given without any doubt

/// Of one component's innovation. What else there is, as of the survey and of a bend, is neither's.
struct Variances {
    double sensor, pose;
};

/// H P H'
double variance_by_pose(int component, const Pose<double>& robot,
                        const Matrix<double, 3>& covariance, const Marker& marker,
                        const Sighting& sighting, const SensorParams& sensor) noexcept {
    const auto of_pose = [&](const auto& held) {
        const auto h = held.jacobian.row(component);
        return h.dot(h * covariance);
    };
    if (sensor.measures == Measures::pixels)
        return of_pose(hold_pixel_against(robot, marker, sighting, sensor));
    return of_pose(hold_against<double>(robot, marker, sighting, sensor, Bearing<double>{},
                                        Elevation<double>{},
                                        Range<double>{sensor.range_scale, sensor.range_offset_m}));
}

/// R
double variance_by_sensor(int component, const Sighting& sighting, const SensorParams& sensor,
                          double predicted) noexcept {
    return sensor.measures == Measures::pixels
               ? pixel_variance(sighting, component, sensor)
               : sensor_variance(sighting, ComponentIndex(component), sensor, predicted);
}

}  // namespace

template <typename Scalar, int N>
Fixer<Scalar, N>::Fixer(const Params& params, MarkerMap map, WallMap walls)
    : params_(params), map_(std::move(map)), walls_(std::move(walls)) {
    for (int i = 0; i < params.sensor_count; ++i) {
        const SensorParams& sensor = params.sensors[i];
        policies_[i] = Policy::make(sensor.fusion, sensor.gate_false_reject, sensor.student_t_dof);
    }
}

template <typename Scalar, int N>
void Fixer<Scalar, N>::recognise(const Track& track, int sensor,
                                 Associator<Scalar>& frame) const noexcept {
    if (!track.located || !frame.any_unknown()) return;
    const auto resolve = [&](const SensorParams& params, double stated_scale) {
        frame.resolve(track.filter.state().template head<kPoseStates>(),
                      track.filter.covariance().template topLeftCorner<kPoseStates, kPoseStates>(),
                      map_, params, policies_[sensor], Scalar(params_.tilt.variance_rad2()),
                      stated_scale);
    };
    if (!params_.noise.adapts()) return resolve(params_.sensors[sensor], 1);
    const double scale = track.noise.sensor(sensor);
    resolve(scaled(params_.sensors[sensor], scale), scale);
}

template <typename Scalar, int N>
SightingReport Fixer<Scalar, N>::sight(Track& track, const Sample& sample,
                                       const Association& of) const noexcept {
    if (!track.located) return blank_report(sample, Verdict::not_initialized);
    if (rejected(of.verdict)) {
        const SightingReport report = blank_report(sample, of.verdict);
        if (of.verdict == Verdict::no_match)
            track.agreement.add(kNowhere, report.dof, policies_[sample.source].gate_nis[2]);
        return report;
    }
    if constexpr (N == kTiltedStates) {
        settle_tilt(track.filter, seconds_between<Scalar>(track.tilt_utime, sample.utime),
                    params_.tilt);
        track.tilt_utime = sample.utime;
    }
    Sample known = sample;
    known.payload.sighting.id = of.id;
    const Pose<double> odometry = track.odometry();
    const SightingReport report = fuse(track, known);
    follow(track, odometry, report, sample.payload.sighting.id);
    return report;
}

/// What a measurement that met the estimate tells of it.
/// \param odometry as it was before
/// \param told of which marker it says to be
template <typename Scalar, int N>
void Fixer<Scalar, N>::follow(Track& track, const Pose<double>& odometry,
                              const SightingReport& report, std::int32_t told) const noexcept {
    if (report.verdict == Verdict::out_of_view)
        track.agreement.add(kNowhere, report.dof,
                            policies_[report.sensor].gate_nis[report.dof - 1]);
    if (report.verdict != Verdict::fused && report.verdict != Verdict::gate) return;
    track.keep_odometry(odometry);
    track.agreement.add(report.nis, report.dof, policies_[report.sensor].gate_nis[report.dof - 1]);
    if (track.agreement.last_agreed()) track.agreed_utime = report.utime;
    if (!track.confirmed) agree(track, told);
}

/// Counts the markers that agree with an estimate that has to prove itself. Where it is not told
/// which marker it is, a search has poses for all of them, and any of them may be a rival.
template <typename Scalar, int N>
void Fixer<Scalar, N>::agree(Track& track, std::int32_t told) const noexcept {
    const int row = track.agreement.in_a_row();
    if (row == 0) return;
    if (row == 1) track.agreeing = {};
    const int before = track.agreeing.count();
    const Marker* marker = map_.find(told);
    track.agreeing.add(marker == nullptr ? MarkerSet::all()
                                         : MarkerSet::of(marker - map_.markers().data()));
    const bool one_more = row == Agreement::kConfirming || track.agreeing.count() > before;
    if (one_more && confirms(track)) track.search_due_utime = track.utime;  // at once
}

template <typename Scalar, int N>
bool Fixer<Scalar, N>::confirms(const Track& track) const noexcept {
    const int markers = static_cast<int>(map_.markers().size());
    return track.agreement.confirms() &&
           track.agreeing.count() >= std::min(judging::kConfirmingMarkers, markers);
}

template <typename Scalar, int N>
SightingReport Fixer<Scalar, N>::fix(Track& track, const Sample& sample) const noexcept {
    const SensorParams& sensor = params_.sensors[sample.source];
    if (!track.located) {
        SightingReport report = blank_report(sample, Verdict::not_initialized);
        if (sample.stream != Stream::fix || report.dof < 3) return report;
        const FixedPose robot = robot_of(sample.payload.fix, sensor);
        place(track, robot.pose, robot.covariance);
        track.agreed_utime = sample.utime;
        report.verdict = Verdict::fused;
        report.weight = 1;
        report.agrees = true;
        report.dof = 0;  // there was no pose to hold it against
        report.nis = 0;
        return report;
    }
    const Pose<double> odometry = track.odometry();
    const double scale = params_.noise.adapts() ? track.noise.sensor(sample.source) : 1;
    const auto fuse = params_.filter == Filter::ukf ? &fuse_fix<Filter::ukf, Scalar, N>
                                                    : &fuse_fix<Filter::ekf, Scalar, N>;
    const SightingReport report =
        fuse(track.filter, sample, walls_, sensor, scale, policies_[sample.source]);
    if (params_.noise.adapts())
        learn(track, report, [&](int c) {
            const double of_sensor = scale * scale * variance_of(sample, sensor, c);
            return Variances{of_sensor, report.sigma[c] * report.sigma[c] - of_sensor};
        });
    follow(track, odometry, report, kUnknownId);
    return report;
}

template <typename Scalar, int N>
SightingReport Fixer<Scalar, N>::fuse(Track& track, const Sample& sample) const noexcept {
    const SensorParams& sensor = params_.sensors[sample.source];
    const Policy& policy = policies_[sample.source];
    const bool pixels = sensor.measures == Measures::pixels;
    const auto fuse =
        params_.filter == Filter::ukf
            ? pixels ? &fuse_pixel<Filter::ukf, Scalar, N> : &fuse_sighting<Filter::ukf, Scalar, N>
        : pixels ? &fuse_pixel<Filter::ekf, Scalar, N>
                 : &fuse_sighting<Filter::ekf, Scalar, N>;
    if (!params_.noise.adapts()) return fuse(track.filter, sample, map_, sensor, policy);
    const double scale = track.noise.sensor(sample.source);
    Sample noisy = sample;
    noisy.payload.sighting = scaled(sample.payload.sighting, scale);
    const SensorParams noisy_sensor = scaled(sensor, scale);
    const Pose<double> robot = track.pose();
    const Matrix<double, 3> covariance = track.covariance();
    const SightingReport report = fuse(track.filter, noisy, map_, noisy_sensor, policy);
    learn(track, report, [&](int c) {
        const Sighting& sighting = noisy.payload.sighting;
        return Variances{
            variance_by_sensor(c, sighting, noisy_sensor, sighting.value[c] - report.innovation[c]),
            variance_by_pose(c, robot, covariance, *map_.find(sighting.id), sighting,
                             noisy_sensor)};
    });
    return report;
}

/// What an innovation tells of the noise. That of a pose which is not confirmed tells of the pose.
/// \param variance_of Variances of a component, as it was fused
template <typename Scalar, int N>
template <typename Variance>
void Fixer<Scalar, N>::learn(Track& track, const SightingReport& report,
                             const Variance& variance_of) const noexcept {
    if (!track.confirmed || std::isnan(report.nis)) return;
    const Measures measures = params_.sensors[report.sensor].measures;
    const bool pixels = measures == Measures::pixels;
    const bool tilts = params_.tilt.any() && (pixels || measures == Measures::markers);
    each<3>([&](int c) {
        if (std::isnan(report.sigma[c])) return;
        const double variance = report.sigma[c] * report.sigma[c];
        const double squared = report.innovation[c] * report.innovation[c] / variance;
        const Variances of = variance_of(c);
        const bool by_tilt = tilts && (pixels || c == kElevation);
        track.noise.learn(report.sensor, squared, of.sensor / variance,
                          by_tilt ? 0 : of.pose / variance);
    });
}

template <typename Scalar, int N>
Evidence Fixer<Scalar, N>::evidence(const Track& track, const Sample& sample,
                                    const PoseSearch& search) const noexcept {
    const SensorParams& sensor = params_.sensors[sample.source];
    const Sighting sighting = sensor.measures == Measures::pixels
                                  ? angles_of(sample.payload.sighting, sensor)
                                  : sample.payload.sighting;
    const double log_likelihood =
        track.located
            ? search.log_likelihood(track.pose(), track.covariance(), sighting, sample.source)
            : NAN;
    return {track.odometry(), track.drift.position_m2, track.drift.heading_rad2,
            sighting,         sample.source,           log_likelihood};
}

template <typename Scalar, int N>
bool Fixer<Scalar, N>::doubtful(const Track& track) const noexcept {
    const bool sure = track.confirmed && !track.agreement.suspicious() &&
                      !track.agreement.disagrees() && track.judgement.finding == Finding::fine;
    return !sure && track.utime >= track.search_due_utime;
}

template <typename Scalar, int N>
void Fixer<Scalar, N>::search(Track& track, const Evidence* newest_first, int count,
                              PoseSearch& search) const noexcept {
    track.search_due_utime = track.utime + kSearchPeriod_us;
    // What is vague foretells nothing that a better pose could be held against.
    Claim claim{track.located && !judging::vague(track.covariance()),
                track.confirmed,
                track.pose(),
                track.covariance(),
                track.restored ? -kRestored : 0,
                std::min(judging::kMarkers, static_cast<int>(map_.markers().size()))};
    Evidence evidence[Evidence::kMost];
    count = std::min(count, Evidence::kMost);
    for (int i = 0; i < count; ++i) {
        claim.log_evidence += newest_first[i].log_likelihood;
        evidence[i] = newest_first[i];
        // Of an estimate that has to prove itself, what explains as much is a rival as well.
        if (!track.confirmed) evidence[i].log_likelihood = NAN;
    }
    // What made the estimate sure is no longer among them, and without it it is one of many poses.
    if (count == Evidence::kMost)
        claim.log_evidence += std::fmax(kDearest, log_occam(track.covariance(), Site(map_)));
    const Pose<double> odometry = track.odometry();
    Pose<double> guesses[Ideas::kMost];
    const int guessed = track.judgement.ideas.recall(odometry, guesses);
    const Hypotheses found =
        search.run(evidence, count, guesses, guessed, static_cast<std::uint64_t>(track.utime));
    const Hypothesis* winner = judge(track.judgement, claim, found, odometry);
    track.judgement.ideas.remember(found, odometry);
    if (winner != nullptr) {
        if (track.located) {
            ++track.resets;
            ++track.found;
        }
        Matrix<double, 3> covariance = winner->covariance;
        covariance.diagonal() += winner->drift;
        place(track, winner->pose, covariance);
        track.confirmed = true;
        track.agreed_utime = track.utime;
    } else if (track.located && track.judgement.finding == Finding::fine && confirms(track)) {
        track.confirmed = true;
    }
}

template <typename Scalar, int N>
void Fixer<Scalar, N>::reset(Track& track, const PoseReset& to) const noexcept {
    if (track.located) ++track.resets;
    place(track, Pose<double>(to.pose), symmetric_of(to.covariance));
    track.evidence_since = track.utime;  // what is seen at its time is seen from there
}

/// What is known of the calibration stays, what was known of the pose does not.
template <typename Scalar, int N>
void Fixer<Scalar, N>::place(Track& track, const Pose<double>& pose,
                             const Matrix<double, 3>& covariance) const noexcept {
    const Pose<double> odometry = track.odometry();
    Vector<Scalar, N> x = track.filter.state();
    Matrix<Scalar, N> p = track.filter.covariance();
    x.template head<3>() = pose.template cast<Scalar>();
    x[kHeading] = wrap(x[kHeading]);
    p.template topRows<3>().setZero();
    p.template leftCols<3>().setZero();
    p.template topLeftCorner<3, 3>() = covariance.template cast<Scalar>();
    track.filter = Ekf<Scalar, N>(x, p);
    track.keep_odometry(odometry);
    track.located = true;
    track.confirmed = track.restored = false;
    track.agreement = {};
    track.agreeing = {};
    track.judgement = {};
    track.evidence_since = track.utime + 1;
}

template class Fixer<double, kPoseStates>;
template class Fixer<double, kCalibratedStates>;
template class Fixer<double, kTiltedStates>;
template class Fixer<float, kPoseStates>;
template class Fixer<float, kCalibratedStates>;

}  // namespace pilotage
