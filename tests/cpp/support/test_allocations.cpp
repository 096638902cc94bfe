// The counter must count, or "no allocation" proves nothing.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "support/allocations.hpp"

namespace pilotage::test {
namespace {

/// Lets the compiler believe that someone looks at it: what nobody looks at need not be allocated.
void look_at(const void* memory) {
    asm volatile("" : : "g"(memory) : "memory");
}

TEST(AllocationCountTest, SeesWhatNewTakes) {
    const AllocationCount count;
    const auto one = std::make_unique<int>(1);
    look_at(one.get());
    EXPECT_EQ(count.since(), 1) << *one;
    std::vector<double> many(1000);
    look_at(many.data());
    EXPECT_EQ(count.since(), 2) << many.size();
    struct alignas(64) Wide {
        double values[8] = {};
    };
    const auto wide = std::make_unique<Wide>();
    look_at(wide.get());
    EXPECT_EQ(count.since(), 3) << wide->values[0];
}

#ifdef __GLIBC__
TEST(AllocationCountTest, SeesWhatEigenTakes) {
    const AllocationCount count;
    const Eigen::MatrixXd dynamic = Eigen::MatrixXd::Zero(20, 20);
    EXPECT_EQ(count.since(), 1) << dynamic(0, 0);
}
#endif

TEST(AllocationCountTest, SeesNothingWhereNothingIsTaken) {
    const AllocationCount count;
    Eigen::Matrix<double, 6, 6> fixed = Eigen::Matrix<double, 6, 6>::Identity();
    fixed = fixed * fixed;
    EXPECT_EQ(count.since(), 0) << fixed(0, 0);
}

}  // namespace
}  // namespace pilotage::test
