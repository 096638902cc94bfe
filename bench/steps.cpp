/// \file
/// Races the steps of kernels.hpp and prints one line `name median_ns` each. With a name and a
/// count it runs that step alone, for callgrind.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "kernels.hpp"
#include "race.hpp"

namespace bench {
namespace {

Site site;
const auto cases = make_cases(site);
const Policy plain;

using E3 = Ekf<double, 3>;
using E6 = Ekf<double, 6>;
using U3 = Ukf<double, 3>;
using U6 = Ukf<double, 6>;

E3 three(const Case& c) {
    return {c.x.head<3>(), c.p.topLeftCorner<3, 3>()};
}

E6 six(const Case& c) {
    return {c.x, c.p};
}

U3 unscented_three(const Case& c) {
    return {c.x.head<3>(), c.p.topLeftCorner<3, 3>()};
}

U6 unscented_six(const Case& c) {
    return {c.x, c.p};
}

ScalarStep scalar(const Case& c) {
    return {c.x[0],    c.x[1],    c.x[2],    c.p(0, 0), c.p(1, 0),
            c.p(1, 1), c.p(2, 0), c.p(2, 1), c.p(2, 2)};
}

#ifdef BENCH_SYMFORCE
SymforceStep generated(const Case& c) {
    return {{c.x.head<3>(), {}}, {c.p.topLeftCorner<3, 3>(), {}}, 0};
}
#endif

/// A chain of predictions as a drive makes it: every step waits for the one before.
template <typename Filter, typename Step>
Contender chain(const char* name, Filter (*make)(const Case&), Step step) {
    auto filter = std::make_shared<Filter>();
    return {name, [=] { *filter = make(cases[0]); },
            [=] {
                for (const Case& c : cases) step(*filter, c);
            }};
}

/// Updates of 64 filters, each from its own start.
template <typename Filter, typename Step>
Contender field(const char* name, Filter (*make)(const Case&), Step step) {
    auto filters = std::make_shared<std::array<Filter, kCases>>();
    return {name,
            [=] {
                for (int i = 0; i < kCases; ++i) (*filters)[i] = make(cases[i]);
            },
            [=] {
                for (int i = 0; i < kCases; ++i) step((*filters)[i], cases[i]);
            }};
}

std::vector<Contender> contenders() {
    return {
        chain("predict_pilotage", three, predict_pilotage),
        chain("predict_by_hand", scalar, predict_by_hand),
        chain("predict_pilotage_wheels", three, predict_pilotage_wheels),
        chain("predict6_pilotage", six, predict6_pilotage),
        field("update_pilotage", three, [](E3& f, const Case& c) { update_pilotage(f, c, plain); }),
        field("update_by_hand", scalar, update_by_hand),
        field("update6_pilotage", six, [](E6& f, const Case& c) { update6_pilotage(f, c, plain); }),
        field("update_localizer", three,
              [](E3& f, const Case& c) { update_localizer(f, c, site); }),
        chain("predict_ukf", unscented_three, predict_ukf),
        chain("predict6_ukf", unscented_six, predict6_ukf),
        field("update_ukf", unscented_three, [](U3& f, const Case& c) { update_ukf(f, c, plain); }),
        field("update6_ukf", unscented_six, [](U6& f, const Case& c) { update6_ukf(f, c, plain); }),
#ifdef BENCH_SYMFORCE
        chain("predict_symforce", generated, predict_symforce),
        field("update_symforce", generated, update_symforce),
#endif
    };
}

/// The largest difference in state and covariance between the contenders after a step of each kind:
/// they do the same work.
double difference() {
    double worst = 0;
    for (const Case& c : cases) {
        E3 ours = three(c);
        predict_pilotage(ours, c);
        update_pilotage(ours, c, plain);
        const auto compare = [&](const Vector<double, 3>& x, const Matrix<double, 3>& p) {
            worst = std::max({worst, minus<double, 3>(ours.state(), x).cwiseAbs().maxCoeff(),
                              (ours.covariance() - p).cwiseAbs().maxCoeff()});
        };
        ScalarStep hand = scalar(c);
        predict_by_hand(hand, c);
        update_by_hand(hand, c);
        Matrix<double, 3> p;
        p << hand.xx, hand.yx, hand.hx, hand.yx, hand.yy, hand.hy, hand.hx, hand.hy, hand.hh;
        compare({hand.x, hand.y, hand.heading}, p);
#ifdef BENCH_SYMFORCE
        SymforceStep sym = generated(c);
        predict_symforce(sym, c);
        update_symforce(sym, c);
        compare(sym.x[sym.now], sym.p[sym.now]);
#endif
    }
    return worst;
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
    constexpr int kRounds = 3000;
    bench::race(contenders, bench::kCases, kRounds);
    for (const auto& c : contenders) std::printf("%s %.2f\n", c.name.c_str(), bench::median(c.ns));
    std::printf("difference %.1e\n", bench::difference());
}
