#pragma once
/// \file
/// Telling the story of a measurement.

#include <cmath>
#include <limits>

#include "pilotage/filter/policy.hpp"
#include "pilotage/filter/update_report.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

/// How many are measured; NaN is not.
[[nodiscard]] inline int components_of(const double (&values)[3]) noexcept {
    int measured = 0;
    each<3>([&](int c) { measured += std::isnan(values[c]) ? 0 : 1; });
    return measured;
}

/// A report that says nothing yet but which measurement it is of.
[[nodiscard]] inline SightingReport blank_report(const Sample& sample, Verdict verdict,
                                                 std::int32_t id, int dof) noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {sample.utime,
            sample.seq,
            0,
            id,
            id,
            sample.index,
            sample.source,
            verdict,
            false,
            dof,
            {nan, nan, nan},
            {nan, nan, nan},
            nan,
            0,
            nan,
            nan};
}

[[nodiscard]] inline SightingReport blank_report(const Sample& sample, Verdict verdict) noexcept {
    const Sample::Payload& payload = sample.payload;
    switch (sample.stream) {
        case Stream::sighting:
            return blank_report(sample, verdict, payload.sighting.id,
                                components_of(payload.sighting.value));
        case Stream::fix:
            return blank_report(sample, verdict, kUnknownId, components_of(payload.fix.value));
        default:
            return blank_report(sample, verdict, kUnknownId, 1);
    }
}

/// Writes down what became of it.
/// \param which place in the report of each component
template <typename Scalar, int M, typename Place>
[[gnu::always_inline]] inline void describe_update(const UpdateReport<Scalar, M>& update,
                                                   const Place (&which)[M], const Policy& policy,
                                                   SightingReport& report) noexcept {
    each<M>([&](int i) {
        report.innovation[which[i]] = double(update.innovation[i]);
        report.sigma[which[i]] = std::sqrt(double(update.s(i, i)));
    });
    report.nis = double(update.nis);
    report.agrees = report.nis <= policy.gate_nis[M - 1];
    report.weight = double(update.weight);
    switch (update.fault) {
        case UpdateFault::none:
            report.verdict = Verdict::fused;
            break;
        case UpdateFault::gated:
            report.verdict = Verdict::gate;
            report.value = report.nis;
            report.limit = policy.gate_nis[M - 1];
            break;
        default:
            report.verdict = Verdict::numeric;
    }
}

}  // namespace pilotage
