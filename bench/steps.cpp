/// \file
/// Races the steps of kernels.hpp and prints one line `name median_ns` each. With a name and a
/// count it runs that step alone, for callgrind.

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "kernels.hpp"
#include "race.hpp"

namespace bench {
namespace {

const auto cases = make_cases();
const Policy plain;

/// A chain of predictions as a drive makes it: every step waits for the one before.
template <typename Filter, typename Make, typename Step>
Contender chain(const char* name, Make make, Step step) {
    auto filter = std::make_shared<Filter>();
    return {name, [=] { *filter = make(cases[0]); },
            [=] {
                for (const Case& c : cases) step(*filter, c);
            }};
}

/// Updates of 64 filters, each from its own start.
template <typename Filter, typename Make, typename Step>
Contender field(const char* name, Make make, Step step) {
    auto filters = std::make_shared<std::array<Filter, kCases>>();
    return {name,
            [=] {
                for (int i = 0; i < kCases; ++i) (*filters)[i] = make(cases[i]);
            },
            [=] {
                for (int i = 0; i < kCases; ++i) step((*filters)[i], cases[i]);
            }};
}

Ekf<double, 3> three(const Case& c) {
    return {c.x.head<3>(), c.p.topLeftCorner<3, 3>()};
}
Ekf<double, 6> six(const Case& c) {
    return {c.x, c.p};
}
ScalarStep scalar(const Case& c) {
    return {c.x[0],    c.x[1],    c.x[2],    c.p(0, 0), c.p(1, 0),
            c.p(1, 1), c.p(2, 0), c.p(2, 1), c.p(2, 2)};
}

std::vector<Contender> contenders() {
    using E3 = Ekf<double, 3>;
    using E6 = Ekf<double, 6>;
    std::vector<Contender> all{
        chain<E3>("predict_pilotage", three, predict_pilotage),
        chain<ScalarStep>("predict_by_hand", scalar, predict_by_hand),
        chain<E3>("predict_pilotage_wheels", three, predict_pilotage_wheels),
        chain<E6>("predict6_pilotage", six, predict6_pilotage),
        field<E3>("update_pilotage", three,
                  [](E3& f, const Case& c) { update_pilotage(f, c, plain); }),
        field<ScalarStep>("update_by_hand", scalar, update_by_hand),
        field<E6>("update6_pilotage", six,
                  [](E6& f, const Case& c) { update6_pilotage(f, c, plain); }),
    };
#ifdef BENCH_SYMFORCE
    const auto make = [](const Case& c) {
        SymforceStep step;
        step.x[0] = c.x.head<3>();
        step.p[0] = c.p.topLeftCorner<3, 3>();
        return step;
    };
    all.push_back(chain<SymforceStep>("predict_symforce", make, predict_symforce));
    all.push_back(field<SymforceStep>("update_symforce", make, update_symforce));
#endif
    return all;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
    auto contenders = bench::contenders();
    if (argc == 3) {
        for (auto& c : contenders)
            if (c.name == argv[1])
                for (int i = 0; i < std::atoi(argv[2]); ++i) {
                    c.prepare();
                    c.turn();
                }
        return 0;
    }
    bench::race(contenders, bench::kCases, 3000);
    for (const auto& c : contenders) std::printf("%s %.2f\n", c.name.c_str(), bench::median(c.ns));
}
