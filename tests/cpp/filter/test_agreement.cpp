// Whether sightings confirm the estimate or contradict it: outliers do not, a run of them does.

#include "pilotage/filter/agreement.hpp"

#include <gtest/gtest.h>

#include "pilotage/filter/policy.hpp"
#include "support/random.hpp"

namespace pilotage::test {
namespace {

constexpr double kOutlier = 1e6;

/// An agreement with its gate, for measurements of so many components.
class Judge {
   public:
    Agreement agreement;

    explicit Judge(int dof) : dof_(dof), policy_(Policy::make(Fusion::student_t, 0.001, 4)) {}
    void add(double nis, int times = 1) {
        while (times-- > 0) agreement.add(nis, dof_, policy_.gate_nis[dof_ - 1]);
    }
    /// NIS of a measurement whose errors are so many times what the filter believes.
    void add_random(Draw& draw, double scale = 1) {
        double nis = 0;
        for (int i = 0; i < dof_; ++i) {
            const double e = scale * draw.normal<double, 1>()(0);
            nis += e * e;
        }
        add(nis);
    }
    [[nodiscard]] double typical() const { return dof_; }

   private:
    int dof_;
    Policy policy_;
};

TEST(AgreementTest, ConfirmsAfterThreeInARow) {
    for (const int dof : {1, 2, 3}) {
        Judge judge(dof);
        judge.add(judge.typical(), 2);
        EXPECT_FALSE(judge.agreement.confirms());
        EXPECT_EQ(judge.agreement.in_a_row(), 2);
        judge.add(kOutlier);
        EXPECT_FALSE(judge.agreement.last_agreed());
        judge.add(judge.typical(), 2);
        EXPECT_FALSE(judge.agreement.confirms()) << "the row was broken";
        judge.add(judge.typical());
        EXPECT_TRUE(judge.agreement.confirms());
        EXPECT_TRUE(judge.agreement.last_agreed());
        judge.add(kOutlier);
        EXPECT_FALSE(judge.agreement.confirms());
    }
}

TEST(AgreementTest, IsAboutOneWhereModelAndNoiseAreRight) {
    for (const int dof : {1, 2, 3}) {
        Draw draw(static_cast<unsigned>(dof));
        Judge judge(dof);
        double sum = 0;
        for (int i = 0; i < 10'000; ++i) {
            judge.add_random(draw);
            sum += judge.agreement.mean();
            ASSERT_FALSE(judge.agreement.disagrees()) << "draw " << i << " dof " << dof;
        }
        EXPECT_NEAR(sum / 10'000, 1, 0.2);
    }
}

/// \return the share of 10,000 draws during which the sightings count as contradicting the estimate
double disagreeing(int dof, double outliers, unsigned seed) {
    Draw draw(seed);
    Judge judge(dof);
    int count = 0;
    for (int i = 0; i < 10'000; ++i) {
        if (draw.uniform(0, 1) < outliers)
            judge.add(kOutlier);
        else
            judge.add_random(draw);
        count += judge.agreement.disagrees() ? 1 : 0;
    }
    return count / 10'000.0;
}

TEST(AgreementTest, GrossOutliersNowAndThenDoNotDisagree) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        for (const int dof : {1, 2, 3}) {
            EXPECT_EQ(disagreeing(dof, 0.05, seed), 0) << "dof " << dof;
            EXPECT_LE(disagreeing(dof, 0.20, seed), 0.05) << "dof " << dof;
        }
    }
}

TEST(AgreementTest, ARunOfOutliersDisagrees) {
    for (const int dof : {1, 2, 3}) {
        Judge judge(dof);
        judge.add(judge.typical(), 50);
        judge.add(kOutlier, 2);
        EXPECT_FALSE(judge.agreement.disagrees()) << "two prove nothing, dof " << dof;
        judge.add(kOutlier, 18);
        EXPECT_TRUE(judge.agreement.disagrees()) << "dof " << dof;
        EXPECT_GT(judge.agreement.mean(), Agreement::kTooMuch);
    }
}

/// No single one is an outlier, together they cannot be chance.
TEST(AgreementTest, ErrorsOfTwiceTheStatedSizeDisagree) {
    for (const int dof : {1, 2, 3}) {
        Draw draw(7);
        Judge judge(dof);
        bool disagreed = false;
        for (int i = 0; i < 300; ++i) {
            judge.add_random(draw, 2.5);
            disagreed |= judge.agreement.disagrees();
        }
        EXPECT_TRUE(disagreed) << "dof " << dof;
    }
}

TEST(AgreementTest, ADisagreementEndsWithTenInARow) {
    for (const int dof : {1, 2, 3}) {
        Judge judge(dof);
        judge.add(kOutlier, 30);
        ASSERT_TRUE(judge.agreement.disagrees());
        judge.add(judge.typical(), Agreement::kSettled - 1);
        EXPECT_TRUE(judge.agreement.disagrees());
        EXPECT_FALSE(judge.agreement.confirms()) << "a row during a disagreement confirms nothing";
        judge.add(kOutlier);
        judge.add(judge.typical(), Agreement::kSettled - 1);
        EXPECT_TRUE(judge.agreement.disagrees()) << "the row was broken";
        judge.add(judge.typical());
        EXPECT_FALSE(judge.agreement.disagrees());
        EXPECT_TRUE(judge.agreement.confirms());
        EXPECT_LE(judge.agreement.mean(), 1);
        judge.add(kOutlier);
        EXPECT_FALSE(judge.agreement.disagrees()) << "one outlier does not bring it back";
    }
}

TEST(AgreementTest, EightOutliersInARowAreEnough) {
    for (const int dof : {1, 2, 3}) {
        Judge judge(dof);
        judge.add(judge.typical(), 50);
        judge.add(kOutlier, 7);
        EXPECT_FALSE(judge.agreement.disagrees());
        judge.add(kOutlier);
        EXPECT_TRUE(judge.agreement.disagrees());
    }
}

TEST(AgreementTest, TwoOutliersOfTheLatestEightAreSuspicious) {
    Judge judge(2);
    judge.add(judge.typical(), 20);
    judge.add(kOutlier);
    judge.add(judge.typical(), 6);
    EXPECT_FALSE(judge.agreement.suspicious());
    judge.add(kOutlier);
    EXPECT_TRUE(judge.agreement.suspicious());
    judge.add(judge.typical());
    EXPECT_FALSE(judge.agreement.suspicious()) << "the first one is long past";
}

}  // namespace
}  // namespace pilotage::test
