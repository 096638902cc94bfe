#include "pilotage/filter/policy.hpp"

#include <cmath>

#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

struct TableRow {
    double tail;
    double quantile[3];  // for 1, 2 and 3 degrees of freedom
};

// Printed in every table of the chi-square distribution.
constexpr TableRow kTable[] = {
    {0.99, {0.000157088, 0.0201007, 0.114832}}, {0.5, {0.454936, 1.38629, 2.36597}},
    {0.1, {2.70554, 4.60517, 6.25139}},         {0.05, {3.84146, 5.99146, 7.81473}},
    {0.01, {6.63490, 9.21034, 11.3449}},        {0.001, {10.8276, 13.8155, 16.2662}},
};

TEST(ChiSquare, QuantilesAreThoseOfTheTable) {
    for (const auto& row : kTable)
        for (int dof = 1; dof <= 3; ++dof) {
            const double expected = row.quantile[dof - 1];
            EXPECT_NEAR(chi_square_quantile(row.tail, dof), expected, 1e-5 * expected)
                << "tail " << row.tail << ", dof " << dof;
        }
}

TEST(ChiSquare, QuantileUndoesTail) {
    for (int dof = 1; dof <= 3; ++dof)
        for (const double tail : {0.999, 0.3, 1e-3, 1e-9})
            EXPECT_NEAR(chi_square_tail(chi_square_quantile(tail, dof), dof) / tail, 1, 1e-9);
}

// Of more degrees of freedom, as they come together in a frame.
TEST(ChiSquare, TailIsThatOfTheTableForManyDegreesOfFreedomToo) {
    struct Entry {
        int dof;
        double quantile, tail;
    };
    for (const Entry& e :
         {Entry{4, 9.48773, 0.05}, Entry{5, 11.0705, 0.05}, Entry{7, 24.3219, 0.001},
          Entry{10, 23.2093, 0.01}, Entry{30, 43.7730, 0.05}, Entry{60, 99.6072, 0.001}})
        EXPECT_NEAR(chi_square_tail(e.quantile, e.dof) / e.tail, 1, 1e-4) << e.dof;
}

TEST(ChiSquare, ASumIsHeldAgainstTheGateOfItsDegreesOfFreedom) {
    const Policy policy = Policy::make(Fusion::student_t, 0.001, 4);
    for (const auto& [dof, limit] :
         {std::pair{1, 10.8276}, {2, 13.8155}, {3, 16.2662}, {7, 24.3219}, {60, 99.6072}}) {
        EXPECT_FALSE(policy.beyond_gate(limit - 0.001, dof)) << dof;
        EXPECT_TRUE(policy.beyond_gate(limit + 0.001, dof)) << dof;
        EXPECT_TRUE(policy.beyond_gate(NAN, dof)) << dof;
    }
}

PILOTAGE_SUITE(PolicyTest);

TYPED_TEST(PolicyTest, GateComparesNisWithTheQuantileItself) {
    const auto policy = Policy::make(Fusion::gate, 0.05, 4);
    const double limits[] = {3.84146, 5.99146, 7.81473};
    for (int dof = 1; dof <= 3; ++dof) {
        EXPECT_FALSE(policy.gated(TypeParam(limits[dof - 1] - 0.001), dof));
        EXPECT_TRUE(policy.gated(TypeParam(limits[dof - 1] + 0.001), dof));
    }
    EXPECT_TRUE(policy.gated(TypeParam(NAN), 1));
}

TYPED_TEST(PolicyTest, WhoeverAsksForItGatesByEveryRule) {
    for (const Fusion fusion : {Fusion::plain, Fusion::gate, Fusion::student_t}) {
        const auto policy = Policy::make(fusion, 0.05, 4);
        EXPECT_TRUE(policy.gated(TypeParam(6), 2, true));
        EXPECT_FALSE(policy.gated(TypeParam(5.9), 2, true));
    }
}

TYPED_TEST(PolicyTest, OnlyTheGateRejects) {
    EXPECT_FALSE(Policy::make(Fusion::plain, 0.05, 4).gated(TypeParam(1e6), 1));
    EXPECT_FALSE(Policy::make(Fusion::student_t, 0.05, 4).gated(TypeParam(1e6), 1));
}

TYPED_TEST(PolicyTest, StudentTWeightIsNuPlusDimensionOverNuPlusNis) {
    const auto policy = Policy::make(Fusion::student_t, 0.05, 4);
    EXPECT_NEAR(policy.weight(TypeParam(16), 1), 5.0 / 20, kTight<TypeParam>);
    EXPECT_NEAR(policy.weight(TypeParam(16), 2), 6.0 / 20, kTight<TypeParam>);
    EXPECT_NEAR(policy.weight(TypeParam(16), 3), 7.0 / 20, kTight<TypeParam>);
    EXPECT_NEAR(Policy::make(Fusion::student_t, 0.05, 1).weight(TypeParam(16), 1), 2.0 / 17,
                kTight<TypeParam>);
}

TYPED_TEST(PolicyTest, WeightNeverExceedsOne) {
    const auto policy = Policy::make(Fusion::student_t, 0.05, 4);
    EXPECT_EQ(policy.weight(TypeParam(0), 3), 1);
    EXPECT_EQ(policy.weight(TypeParam(3), 3), 1);
    EXPECT_LT(policy.weight(TypeParam(3.01), 3), 1);
}

TEST(UsualNisTest, IsWhatEveryRuleFusesWithFullWeight) {
    for (const Fusion fusion : {Fusion::gate, Fusion::student_t})
        for (const double false_reject : {0.5, 0.05, 0.001}) {
            const Policy policy = Policy::make(fusion, false_reject, 4);
            for (int dof = 1; dof <= 3; ++dof) {
                const double usual = policy.usual_nis[dof - 1];
                EXPECT_EQ(policy.weight(usual, dof), 1) << "dof " << dof;
                EXPECT_FALSE(policy.gated(usual, dof, true)) << "dof " << dof;
                EXPECT_TRUE(policy.weight(usual + 0.01, dof) < 1 ||
                            policy.gated(usual + 0.01, dof, true) || fusion == Fusion::gate)
                    << "dof " << dof << ": it is the largest such value";
            }
        }
}

TEST(UsualNisTest, IsTheGateWhereThatIsNarrow) {
    const Policy narrow = Policy::make(Fusion::gate, 0.5, 4);
    const Policy wide = Policy::make(Fusion::gate, 0.001, 4);
    for (int dof = 1; dof <= 3; ++dof) {
        EXPECT_EQ(narrow.usual_nis[dof - 1], narrow.gate_nis[dof - 1]);
        EXPECT_LT(narrow.usual_nis[dof - 1], dof);
        EXPECT_EQ(wide.usual_nis[dof - 1], dof);
    }
}

TEST(UsualNisTest, IsAnyForPlainFusion) {
    for (const Policy& policy : {Policy{}, Policy::make(Fusion::plain, 0.001, 4)})
        for (const double usual : policy.usual_nis) EXPECT_EQ(usual, Policy::kAny);
}

TYPED_TEST(PolicyTest, PlainAndGateFuseWithFullWeight) {
    EXPECT_EQ(Policy{}.weight(TypeParam(100), 2), 1);
    EXPECT_EQ(Policy::make(Fusion::gate, 0.05, 4).weight(TypeParam(100), 2), 1);
}

}  // namespace
}  // namespace pilotage::test
