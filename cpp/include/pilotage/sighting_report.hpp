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

/// How many values a measurement has.
[[nodiscard]] inline int components_of(const Sample& sample) noexcept {
    if (sample.stream == Stream::beam) return 1;
    const double(&value)[3] =
        sample.stream == Stream::fix ? sample.payload.fix.value : sample.payload.sighting.value;
    int measured = 0;
    each<3>([&](int c) { measured += std::isnan(value[c]) ? 0 : 1; });
    return measured;
}

/// A report that says nothing yet but which measurement it is of.
[[nodiscard]] inline SightingReport blank_report(const Sample& sample, Verdict verdict) noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::int32_t id =
        sample.stream == Stream::sighting ? sample.payload.sighting.id : kUnknownId;
    return {sample.utime,
            sample.seq,
            0,
            id,
            id,
            sample.index,
            sample.source,
            verdict,
            false,
            components_of(sample),
            {nan, nan, nan},
            {nan, nan, nan},
            nan,
            0,
            nan,
            nan};
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
