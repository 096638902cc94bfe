#pragma once
/// \file
/// The steps that are raced. Each is a function of its own, so that callgrind can count its
/// instructions.

#include "cases.hpp"
#include "pilotage/filter/ekf.hpp"
#include "pilotage/filter/ukf.hpp"
#include "scalar_step.hpp"

namespace bench {

using Report = UpdateReport<double, 2>;

void predict_pilotage(Ekf<double, 3>& filter, const Case& c);
void predict_pilotage_wheels(Ekf<double, 3>& filter, const Case& c);
void predict_by_hand(ScalarStep& filter, const Case& c);
void predict6_pilotage(Ekf<double, 6>& filter, const Case& c);

Report update_pilotage(Ekf<double, 3>& filter, const Case& c, const Policy& policy);
bool update_by_hand(ScalarStep& filter, const Case& c);
Report update6_pilotage(Ekf<double, 6>& filter, const Case& c, const Policy& policy);
SightingReport update_localizer(Ekf<double, 3>& filter, const Case& c, const Site& site);

void predict_ukf(Ukf<double, 3>& filter, const Case& c);
void predict6_ukf(Ukf<double, 6>& filter, const Case& c);
Report update_ukf(Ukf<double, 3>& filter, const Case& c, const Policy& policy);
Report update6_ukf(Ukf<double, 6>& filter, const Case& c, const Policy& policy);

#ifdef BENCH_SYMFORCE
/// Generated functions may not write over what they read: two places, used in turn.
struct SymforceStep {
    Vector<double, 3> x[2];
    Matrix<double, 3> p[2];
    int now = 0;
};
void predict_symforce(SymforceStep& filter, const Case& c);
void update_symforce(SymforceStep& filter, const Case& c);
#endif

}  // namespace bench
